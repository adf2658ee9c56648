// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/history/history_strip.hpp"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QWheelEvent>

#include <algorithm>

#include "client-qt/model/cad_words.hpp"
#include "client-qt/model/document_name.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/tools/history/version_editor.hpp"
#include "client-qt/widgets/small_picture.hpp"

namespace tedit::desktop {

namespace {

constexpr QSize thumbnail(132, 84);  // As it is kept.
constexpr QSize small_thumbnail(84, 54);
constexpr int border = 6;
constexpr int way = 44;  // From one to the next.
constexpr int words_height = 60;
constexpr int words_beside = 164;  // Their width, where they stand beside the picture.
constexpr int small_height = 64;

constexpr int cad_role = Qt::UserRole + 1;  // `client::cad_status`, of a part that came from CAD.

/// Where branches share the room, words stand beside their picture.
class card_delegate : public QStyledItemDelegate {
public:
  card_delegate(const bool& beside, const theme& look, QObject* parent)
      : QStyledItemDelegate(parent), beside_(beside), look_(look) {}

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    if (const auto status = index.data(cad_role); status.isValid()) {
      QStyleOptionViewItem full = option;
      initStyleOption(&full, index);
      const auto* style = full.widget->style();
      paint_mark(*painter,
                 style->subElementRect(QStyle::SE_ItemViewItemDecoration, &full, full.widget),
                 static_cast<client::cad_status>(status.toInt()));
    }
  }

protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (!beside_)
      return;
    option->decorationPosition = QStyleOptionViewItem::Left;
    option->decorationAlignment = Qt::AlignVCenter | Qt::AlignLeft;
    option->displayAlignment = Qt::AlignVCenter | Qt::AlignLeft;
  }

private:
  /// In the picture's corner, on a ground of its own: readable over a part of any colour. Only what
  /// the CAD model lacks stands out.
  void paint_mark(QPainter& painter, const QRect& picture, client::cad_status status) const {
    const QString words = cad_mark_words({status, {}, 0});
    if (words.isEmpty())
      return;
    const bool lacks =
      status == client::cad_status::mesh_only || status == client::cad_status::failed;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QFont small = painter.font();
    small.setBold(lacks);
    small.setPixelSize(std::max(9, QFontInfo(small).pixelSize() * 4 / 5));
    painter.setFont(small);
    const QSize room = QFontMetrics(small).size(Qt::TextSingleLine, words) + QSize(10, 2);
    const QRectF pill(QRectF(picture.topLeft() + QPoint(4, 4), room).adjusted(.5, .5, -.5, -.5));
    QColor ground = look_.palette.color(QPalette::Base);
    ground.setAlpha(225);
    QColor ink = lacks ? look_.warning : look_.palette.color(QPalette::Text);
    if (status == client::cad_status::pending)
      ink.setAlpha(150);
    painter.setBrush(ground);
    painter.setPen(QPen(lacks ? look_.warning : look_.frame, 1));
    painter.drawRoundedRect(pill, 3, 3);
    painter.setPen(ink);
    painter.drawText(pill, Qt::AlignCenter, words);
    painter.restore();
  }

  const bool& beside_;
  const theme& look_;
};

double largest_stress(const version_record& version) {
  if (!version.outcome)
    return 0;
  double result = 0;
  for (const auto& one : version.outcome->cases)
    result = std::max(result, one.max_von_mises_pa);
  return result;
}

std::optional<double> mass(const version_record& version) {
  return version.outcome ? version.outcome->cases.front().mass_kg : std::nullopt;
}

}  // namespace

history_strip::history_strip(document& part, QWidget* parent) : QListWidget(parent), part_(part) {
  setViewMode(QListView::IconMode);
  setMovement(QListView::Free);  // Else places cannot be given; nothing is moved by hand.
  setWordWrap(true);
  setTextElideMode(Qt::ElideRight);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setItemDelegate(new card_delegate(branches_, look_, this));
  setAccessibleName(tr("Versions"));
  setMinimumHeight(thumbnail.height() + words_height + 16);
  connect(&part_, &document::history_changed, this, &history_strip::refresh);
  connect(&part_, &document::head_changed, this, &history_strip::refresh);
  connect(&part_, &document::closed, this, &history_strip::refresh);
  connect(this, &QListWidget::itemDoubleClicked, this, [this](const QListWidgetItem* row) {
    emit version_wanted(row->data(Qt::UserRole).toUInt());
  });
}

void history_strip::set_theme(const theme& look) {
  look_ = look;
  viewport()->update();
}

void history_strip::keep(const std::string& version_id, const QImage& picture) {
  auto pixmap = QPixmap::fromImage(small_picture(picture, thumbnail * devicePixelRatioF()));
  pixmap.setDevicePixelRatio(devicePixelRatioF());
  pictures_[version_id] = std::move(pixmap);
}

void history_strip::find_thumbnails(const std::map<std::string, QImage>& kept) {
  for (const auto& [id, picture] : kept)
    if (!pictures_.contains(id))
      keep(id, picture);
  refresh();
}

void history_strip::set_thumbnail(const std::string& version_id, const QImage& picture,
                                  bool with_field) {
  keep(version_id, picture);
  if (with_field)
    plain_.erase(version_id);
  else
    plain_.insert(version_id);
  refresh();
}

QPixmap history_strip::picture_of(const version_record& version) const {
  if (const auto found = pictures_.find(version.info.version_id); found != pictures_.end())
    return found->second;
  QPixmap empty(thumbnail);
  empty.fill(palette().color(QPalette::AlternateBase));
  return empty;
}

QString history_strip::describe(const version_record& version) const {
  const auto* offered = part_.operations().find(QString::fromStdString(version.info.operation));
  const QString made = version.info.operation == "import" ? tr("Import")
                       : offered ? QString::fromStdString(offered->about.name)
                                 : QString::fromStdString(version.info.operation);
  const QString name = QString::fromStdString(version.info.name);
  QString text = QString("v%1  %2").arg(version.info.number).arg(name.isEmpty() ? made : name);
  const double stress = largest_stress(version);
  if (stress > 0) {
    text += "\n" + quantity(stress, "Pa");
    const auto& all = part_.versions();
    const auto parent = version.info.parent ? all.find(*version.info.parent) : all.end();
    if (parent != all.end() && largest_stress(parent->second) > 0)
      text += "  " + change(largest_stress(parent->second), stress);
  }
  auto widest = font();
  widest.setBold(true);  // As the head is written.
  const QFontMetrics metrics(widest);
  QStringList lines = text.split('\n');
  if (!version.info.note.empty())
    lines << QString::fromStdString(version.info.note).section('\n', 0, 0);
  for (auto& line : lines)
    line = metrics.elidedText(line, Qt::ElideRight,
                              branches_ ? words_beside - 20 : cell().width() - way / 2 - 16);
  return lines.join('\n');
}

QString history_strip::details(const version_record& version) const {
  QStringList lines{describe(version).section('\n', 0, 1)};
  if (!version.info.name.empty())
    lines.prepend(QString::fromStdString(version.info.name));
  if (!version.info.note.empty())
    lines << QString::fromStdString(version.info.note);
  if (!version.info.made_by.empty())
    lines << tr("made by %1, %2")
               .arg(QString::fromStdString(version.info.made_by), moment_of(version.info.made_at));
  if (const auto cad = cad_words(version.info); !cad.isEmpty())
    lines << cad;
  lines << tr("%1 tets").arg(desktop::count(static_cast<double>(version.info.tets)));
  if (const auto m = mass(version))
    lines << tr("mass %1").arg(desktop::mass(*m));
  if (version.report) {
    lines << tr("volume %1").arg(change_by(version.report->volume_change, "m3"));
    if (const auto& ratios = version.report->ratios)
      lines << tr("worst tet where it changed: %1 before, %2 now")
                 .arg(number(ratios->min_before), number(ratios->min_after));
  }
  return lines.join("\n");
}

void history_strip::refresh() {
  const auto* chosen = currentItem();
  const auto before = chosen ? std::optional(chosen->data(Qt::UserRole).toUInt()) : std::nullopt;
  const auto* head = part_.head();
  const auto shown_head = head ? std::optional(head->info.number) : std::nullopt;
  // What was chosen stays so, unless the head moves: then that one is.
  const auto wanted = before && head_ == shown_head ? before : shown_head;
  head_ = shown_head;
  clear();
  rows_.clear();
  std::map<std::uint32_t, std::optional<std::uint32_t>> parents;
  for (const auto& [number, version] : part_.versions())
    parents[number] = version.info.parent;
  places_ = lanes_of(parents);
  branches_ = std::ranges::any_of(places_, [](const auto& one) { return one.second.lane > 0; });
  setVerticalScrollBarPolicy(branches_ ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
  setIconSize(picture_size());
  for (const auto& [number, version] : part_.versions()) {
    auto* row = new QListWidgetItem(describe(version));
    row->setData(Qt::UserRole, number);
    row->setToolTip(details(version));
    if (version.info.cad)
      row->setData(cad_role, static_cast<int>(version.info.cad->status));
    row->setData(Qt::AccessibleDescriptionRole, cad_words(version.info));
    row->setSizeHint(cell() - (branches_ ? QSize(way, 6) : QSize(way / 2, 4)));
    row->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
    const QPixmap shown = picture_of(version);
    QIcon both(shown);
    both.addPixmap(shown, QIcon::Selected);  // Else it is tinted.
    row->setIcon(both);
    if (shown_head == number) {
      auto bold = font();
      bold.setBold(true);
      row->setFont(bold);
    }
    addItem(row);
    rows_[number] = row;
  }
  doItemsLayout();
  if (wanted && rows_.contains(*wanted)) {
    setCurrentItem(rows_[*wanted]);
    scrollToItem(rows_[*wanted]);
  }
}

/// Branches share the room: smaller pictures, with the words beside them.
QSize history_strip::picture_size() const {
  return branches_ ? small_thumbnail : thumbnail;
}

QSize history_strip::cell() const {
  return branches_ ? QSize(small_thumbnail.width() + words_beside + way, small_height + 6)
                   : thumbnail + QSize(way, words_height);
}

/// The list lays its rows out in lines; here each has its place in the tree.
void history_strip::doItemsLayout() {
  QListWidget::doItemsLayout();
  if (!placing_)
    put_in_places();
}

void history_strip::put_in_places() {
  placing_ = true;
  for (const auto& [number, row] : rows_)
    if (const auto at = places_.find(number); at != places_.end())
      setPositionForIndex(QPoint(border + at->second.column * cell().width(),
                                 border + at->second.lane * cell().height()),
                          indexFromItem(row));
  placing_ = false;
}

QRect history_strip::frame_of(std::uint32_t number) const {
  const auto row = rows_.find(number);
  return row == rows_.end() ? QRect() : visualItemRect(row->second);
}

/// Below the rows ways from each version to its children, above them a frame around the head.
void history_strip::paintEvent(QPaintEvent* event) {
  {
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    auto ink = palette().color(QPalette::WindowText);
    ink.setAlpha(110);
    if (branches_) {  // Words beside pictures: what belongs together has a frame.
      auto faint = ink;
      faint.setAlpha(45);
      painter.setPen(QPen(faint, 1));
      for (const auto& [number, row] : rows_)
        painter.drawRoundedRect(QRectF(visualItemRect(row)).adjusted(1.5, 1.5, -1.5, -1.5), 4, 4);
    }
    painter.setPen(QPen(ink, 1.6));
    for (const auto& [number, version] : part_.versions()) {
      if (!version.info.parent || !rows_.contains(*version.info.parent))
        continue;
      const QRect from = frame_of(*version.info.parent);
      const QRect to = frame_of(number);
      const double down = branches_ ? from.height() / 2.0 : picture_size().height() / 2.0;
      const QPointF a(from.right() - 2, from.top() + down);
      const QPointF b(to.left() + 3, to.top() + down);
      const double middle = (a.x() + b.x()) / 2;
      QPainterPath line(a);
      if (std::abs(a.y() - b.y()) < 1) {
        line.lineTo(b);
      } else {
        constexpr double bend = 8;
        line.lineTo(middle - bend, a.y());
        line.quadTo(middle, a.y(), middle, a.y() + bend);
        line.lineTo(middle, b.y() - bend);
        line.quadTo(middle, b.y(), middle + bend, b.y());
        line.lineTo(b);
      }
      painter.drawPath(line);
    }
  }
  QListWidget::paintEvent(event);
  if (!head_ || !rows_.contains(*head_))
    return;
  QPainter painter(viewport());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
  painter.drawRoundedRect(QRectF(frame_of(*head_)).adjusted(1, 1, -1, -1), 4, 4);
}

// -- names and notes -----------------------------------------------------------------

void history_strip::edit_words() {
  const auto* row = currentItem();
  const auto found =
    row ? part_.versions().find(row->data(Qt::UserRole).toUInt()) : part_.versions().end();
  if (found == part_.versions().end())
    return;
  auto* editor = new version_editor(found->second.info, this);
  connect(editor, &version_editor::accepted, &part_.edits(), &edit_requests::annotate);
  editor->open_beside(
    QRect(viewport()->mapToGlobal(visualItemRect(row).topLeft()), visualItemRect(row).size()));
}

void history_strip::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_F2)
    edit_words();
  else if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && currentItem())
    emit version_wanted(currentItem()->data(Qt::UserRole).toUInt());
  else
    QListWidget::keyPressEvent(event);
}

void history_strip::contextMenuEvent(QContextMenuEvent* event) {
  auto* row = itemAt(event->pos());
  if (!row)
    return;
  setCurrentItem(row);
  const auto number = row->data(Qt::UserRole).toUInt();
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Go to this version (Enter)"), this,
                  [this, number] { emit version_wanted(number); });
  if (head_ && number != *head_)
    menu->addAction(tr("Compare with version %1").arg(*head_), this,
                    [this, number] { emit comparison_wanted(number); });
  menu->addAction(tr("Name and note ... (F2)"), this, &history_strip::edit_words);
  menu->popup(event->globalPos());
}

void history_strip::wheelEvent(QWheelEvent* event) {
  auto* bar = horizontalScrollBar();
  if (branches_ || bar->maximum() == 0 || event->angleDelta().y() == 0)
    return QListWidget::wheelEvent(event);
  bar->setValue(bar->value() - event->angleDelta().y());
  event->accept();
}

}  // namespace tedit::desktop
