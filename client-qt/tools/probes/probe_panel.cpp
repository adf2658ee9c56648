// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/probes/probe_panel.hpp"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "client-qt/model/compare.hpp"
#include "client-qt/model/field_values.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/tools/results/field_panel.hpp"

namespace tedit::desktop {

// -- in the view ---------------------------------------------------------------------

probe_marks::probe_marks(viewport& view, document& part, probes& all)
    : QWidget(&view), view_(view), part_(part), all_(all) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setGeometry(view.rect());
  view.installEventFilter(this);
  connect(&view, &viewport::view_changed, this, qOverload<>(&QWidget::update));
  connect(&view, &viewport::shown, this, qOverload<>(&QWidget::update));
  connect(&all_, &probes::changed, this, qOverload<>(&QWidget::update));
}

bool probe_marks::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize)
    setGeometry(view_.rect());
  return QWidget::eventFilter(watched, event);
}

void probe_marks::set_accent(const QColor& accent) {
  accent_ = accent;
  update();
}

/// Where the place is in the deformed picture.
vec3 probe_marks::drawn_at(const probe_place& place) const {
  const auto& shown = view_.current();
  if (shown.deform == 0 || !shown.field || shown.field->values.of("displacement_m").empty() ||
      shown.field->version_id() != shown.surface->version_id())
    return place.at;
  const auto moved = [&](shown_field way) {
    return shown.deform * value_at(place, *shown.field, way).value_or(0);
  };
  return place.at + vec3{moved(shown_field::displacement_x), moved(shown_field::displacement_y),
                         moved(shown_field::displacement_z)};
}

void probe_marks::paintEvent(QPaintEvent*) {
  const auto* head = part_.head();
  if (!head || view_.current().surface != head->surface)
    return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = painter.font();
  font.setPixelSize(11);
  font.setBold(true);
  painter.setFont(font);
  for (const auto& one : all_.all()) {
    const auto place = all_.place(one, *head);
    if (!place)
      continue;
    const QPointF at = view_.to_frame(drawn_at(*place));
    const QPointF head_of_pin = at - QPointF(0, 20);
    painter.setPen(QPen(accent_, 2));
    painter.drawLine(at, head_of_pin);
    // An outline only: the place is the nearest one, not the very triangle.
    painter.setBrush(place->same ? accent_ : QColor(255, 255, 255, 230));
    painter.drawEllipse(head_of_pin, 10, 10);
    painter.setPen(place->same ? QColor(Qt::white) : accent_);
    painter.drawText(QRectF(head_of_pin - QPointF(10, 10), QSizeF(20, 20)), Qt::AlignCenter,
                     QString::number(one.number));
  }
}

// -- the list ------------------------------------------------------------------------

probe_panel::probe_panel(document& part, probes& all, field_panel& fields, QWidget* parent)
    : QWidget(parent), part_(part), all_(all), fields_(fields) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 4);
  list_ = new QTreeWidget;
  list_->setObjectName("probe_list");
  list_->setRootIsDecorated(false);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setAccessibleName(tr("Probes"));
  connect(list_, &QTreeWidget::itemSelectionChanged, this, [this] {
    show_distance();
    emit pair_changed();
    emit chosen_changed();
  });
  column->addWidget(list_, 1);
  auto* row = new QHBoxLayout;
  distance_ = new QLabel;
  distance_->setObjectName("probe_distance");
  distance_->setWordWrap(true);
  row->addWidget(distance_, 1);
  remove_ = new QPushButton(tr("Remove"));
  connect(remove_, &QPushButton::clicked, this, [this] {
    for (const int number : chosen())
      all_.remove(number);
  });
  clear_ = new QPushButton(tr("Remove all"));
  connect(clear_, &QPushButton::clicked, &all_, &probes::clear);
  row->addWidget(remove_);
  row->addWidget(clear_);
  column->addLayout(row);
  connect(&all_, &probes::changed, this, &probe_panel::refresh);
  connect(&fields_, &field_panel::changed, this, &probe_panel::refresh);
  refresh();
}

std::vector<int> probe_panel::chosen() const {
  std::vector<int> numbers;
  for (const auto* one : list_->selectedItems())
    numbers.push_back(one->data(0, Qt::UserRole).toInt());
  std::ranges::sort(numbers);
  return numbers;
}

void probe_panel::choose(const std::vector<int>& numbers) {
  {
    const QSignalBlocker quiet(list_);
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
      auto* row = list_->topLevelItem(i);
      row->setSelected(std::ranges::find(numbers, row->data(0, Qt::UserRole).toInt()) !=
                       numbers.end());
    }
  }
  show_distance();
  emit pair_changed();
  emit chosen_changed();
}

void probe_panel::refresh() {
  const auto before = chosen();
  const shown_field quantity_shown = fields_.wanted().field;
  const auto shown = fields_.field();
  const std::string load_case = shown && !shown->envelope ? shown->report.load_case : std::string();
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    QStringList titles{tr("Probe"), tr("Surface")};
    std::vector<std::pair<const version_record*, shared_field>> seen;
    for (const auto& [number, version] : part_.versions())
      if (auto field = field_of(version, load_case); field && version.surface) {
        seen.emplace_back(&version, field);
        titles << QString("v%1").arg(number);
      }
    list_->setColumnCount(static_cast<int>(titles.size()));
    list_->setHeaderLabels(titles);
    for (const auto& one : all_.all()) {
      auto* row =
        new QTreeWidgetItem(list_, {QString::number(one.number), part_.surface_name(one.surface)});
      row->setData(0, Qt::UserRole, one.number);
      int column = 2;
      for (const auto& [version, field] : seen) {
        const auto place = all_.place(one, *version);
        const auto value = place ? value_at(*place, *field, quantity_shown) : std::nullopt;
        QString text = value   ? quantity(*value, field_unit(quantity_shown))
                       : place ? tr("no value")
                               : tr("surface gone");
        if (place && !place->same) {
          text = QString::fromUtf8("≈ ") + text;
          row->setToolTip(column, tr("At the nearest point of the same surface: its triangle "
                                     "was changed"));
        }
        row->setText(column++, text);
      }
      row->setSelected(std::ranges::find(before, one.number) != before.end());
    }
    list_->header()->resizeSections(QHeaderView::ResizeToContents);
  }
  clear_->setEnabled(!all_.all().empty());
  show_distance();
  emit pair_changed();
}

std::vector<probe> probe_panel::pair() const {
  std::vector<probe> result;
  for (const auto* one : list_->selectedItems())
    for (const auto& known : all_.all())
      if (known.number == one->data(0, Qt::UserRole).toInt())
        result.push_back(known);
  if (result.size() != 2) {
    const auto& all = all_.all();
    result.assign(all.size() > 2 ? all.end() - 2 : all.begin(), all.end());
  }
  std::ranges::sort(result, {}, &probe::number);
  return result;
}

void probe_panel::show_distance() {
  remove_->setEnabled(!list_->selectedItems().empty());
  const auto both = pair();
  const auto* head = part_.head();
  if (both.size() < 2 || !head) {
    distance_->setText(all_.all().empty()
                         ? tr("P, then click places of the part. Two of them give a distance.")
                         : tr("A second probe gives the distance."));
    return;
  }
  const auto way = all_.distance(both[0], both[1], *head);
  distance_->setText(
    way ? tr("Distance %1 to %2: %3").arg(both[0].number).arg(both[1].number).arg(length(*way))
        : tr("The surface of one of them is gone."));
}

}  // namespace tedit::desktop
