// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/history_strip.hpp"

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

constexpr QSize thumbnail(132, 84);

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
  setFlow(QListView::LeftToRight);
  setWrapping(false);
  setMovement(QListView::Static);
  setIconSize(thumbnail);
  setGridSize(thumbnail + QSize(28, 62));
  setWordWrap(true);
  setUniformItemSizes(true);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setAccessibleName(tr("Versions"));
  setMinimumHeight(gridSize().height() + 22);
  connect(&part_, &document::history_changed, this, &history_strip::refresh);
  connect(&part_, &document::head_changed, this, &history_strip::refresh);
  connect(&part_, &document::closed, this, &history_strip::refresh);
  connect(this, &QListWidget::itemActivated, this, [this](const QListWidgetItem* row) {
    emit version_wanted(row->data(Qt::UserRole).toUInt());
  });
}

void history_strip::set_thumbnail(const std::string& version_id, const QImage& picture) {
  const QImage fitted =
    picture.scaled(2 * thumbnail, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  const QRect middle(QPoint((fitted.width() - 2 * thumbnail.width()) / 2,
                            (fitted.height() - 2 * thumbnail.height()) / 2),
                     2 * thumbnail);
  pictures_[version_id] = QPixmap::fromImage(
    fitted.copy(middle).scaled(thumbnail, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  refresh();
}

QString history_strip::describe(const version_record& version) const {
  const auto* offered = part_.operations().find(QString::fromStdString(version.info.operation));
  const QString what = version.info.operation == "import" ? tr("Import")
                       : offered ? QString::fromStdString(offered->about.name)
                                 : QString::fromStdString(version.info.operation);
  QString text = QString("v%1  %2").arg(version.info.number).arg(what);
  const double stress = largest_stress(version);
  if (stress > 0) {
    text += "\n" + quantity(stress, "Pa");
    const auto& all = part_.versions();
    const auto parent = version.info.parent ? all.find(*version.info.parent) : all.end();
    if (parent != all.end() && largest_stress(parent->second) > 0)
      text += "  " + change(largest_stress(parent->second), stress);
  }
  return text;
}

QString history_strip::details(const version_record& version) const {
  QStringList lines{describe(version)};
  lines << tr("%1 tets").arg(desktop::count(static_cast<double>(version.info.tets)));
  if (const auto m = mass(version))
    lines << tr("mass %1").arg(desktop::mass(*m));
  if (version.report) {
    lines << tr("volume %1").arg(quantity(version.report->volume_change, "m3"));
    lines << tr("worst tet where it changed: %1 before, %2 now")
               .arg(number(version.report->touched_min_before),
                    number(version.report->touched_min_after));
  }
  return lines.join("\n");
}

void history_strip::refresh() {
  clear();
  const auto* head = part_.head();
  for (const auto& [number, version] : part_.versions()) {
    auto* row = new QListWidgetItem(describe(version));
    row->setData(Qt::UserRole, number);
    row->setToolTip(details(version));
    row->setSizeHint(gridSize() -
                     QSize(12, 20));  // Else all get the first one's, which may have fewer lines.
    row->setTextAlignment(Qt::AlignHCenter);
    const auto picture = pictures_.find(version.info.version_id);
    QPixmap empty(thumbnail);
    empty.fill(palette().color(QPalette::AlternateBase));
    const QPixmap& shown = picture == pictures_.end() ? empty : picture->second;
    QIcon both(shown);
    both.addPixmap(shown, QIcon::Selected);  // Else it is tinted.
    row->setIcon(both);
    addItem(row);
    if (head && head->info.number == number)
      setCurrentItem(row);
  }
}

}  // namespace tedit::desktop
