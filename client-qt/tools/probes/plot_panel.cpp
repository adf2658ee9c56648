// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/probes/plot_panel.hpp"

#include <QComboBox>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>

#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>

#include "client-qt/model/quantities.hpp"
#include "client-qt/tools/probes/probe_panel.hpp"
#include "client-qt/tools/results/field_panel.hpp"

namespace tedit::desktop {

namespace {

constexpr std::size_t bar_count = 40;
constexpr std::size_t line_steps = 240;

/// Round places on an axis, as the legend has them.
std::vector<double> ticks(double low, double high, int most) {
  legend by;
  by.field = shown_field::none;
  by.low = low;
  by.high = high;
  return by.ticks(most);
}

}  // namespace

std::vector<double> along(const part_geometry& part, const std::vector<float>& values,
                          const vec3& from, const vec3& to, std::size_t steps) {
  std::vector<double> result;
  const double length = std::sqrt(dot(to - from, to - from));
  vtkNew<vtkGenericCell> scratch;
  for (std::size_t i = 0; i < steps; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(steps - 1);
    const vec3 wanted = from + t * (to - from);
    std::array<double, 3> point{wanted.x, wanted.y, wanted.z};
    std::array<double, 3> nearest{};
    std::array<double, 3> local{};
    std::array<double, 3> weights{};
    vtkIdType cell = -1;
    int sub = 0;
    double far = 0;
    part.locator->FindClosestPoint(point.data(), nearest.data(), scratch, cell, sub, far);
    double value = NAN;
    if (cell >= 0 && std::sqrt(far) <= 0.02 * length &&
        scratch->EvaluatePosition(nearest.data(), nullptr, sub, local.data(), far,
                                  weights.data()) >= 0) {
      value = 0;
      for (int k = 0; k < 3; ++k)
        value += weights[k] * values[static_cast<std::size_t>(scratch->GetPointId(k))];
    }
    result.push_back(value);
  }
  return result;
}

// -- drawing -------------------------------------------------------------------------

plot_area::plot_area(QWidget* parent) : QWidget(parent) {
  setMinimumSize(200, 90);
}

void plot_area::set(plot what) {
  what_ = std::move(what);
  setAccessibleName(what_.title);
  update();
}

/// Where the plot is in the widget, and its scales.
struct plot_area::axes {
  QRectF box;
  double x_low, x_high, y_low, y_high;

  [[nodiscard]] QPointF at(double x, double y) const {
    return {box.left() + box.width() * (x - x_low) / (x_high - x_low),
            box.bottom() - box.height() * (y - y_low) / (y_high - y_low)};
  }
};

plot_area::axes plot_area::make_axes(double line) const {
  axes result{{64, line + 8, width() - 80.0, height() - 3 * line - 14},
              what_.x_low,
              what_.x_high,
              what_.bars ? 0 : INFINITY,
              what_.bars ? 0 : -INFINITY};
  for (const auto* list : {&what_.y, &what_.y_before})
    for (const double y : *list)
      if (std::isfinite(y)) {
        result.y_low = std::min(result.y_low, y);
        result.y_high = std::max(result.y_high, y);
      }
  if (!std::isfinite(result.y_low))
    result.y_low = result.y_high = 0;
  if (result.y_high <= result.y_low) {
    result.y_low -= what_.bars ? 0 : 1;
    result.y_high += 1;
  } else if (!what_.bars) {
    const double room = 0.06 * (result.y_high - result.y_low);
    result.y_low -= room;
    result.y_high += room;
  }
  return result;
}

void plot_area::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(palette().color(QPalette::WindowText));
  if (what_.y.empty()) {
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, what_.note);
    return;
  }
  const axes frame = make_axes(QFontMetricsF(painter.font()).height());
  paint_axes(painter, frame);
  if (what_.bars)
    paint_bars(painter, frame);
  else
    paint_line(painter, frame);
}

void plot_area::paint_axes(QPainter& painter, const axes& frame) const {
  const QColor ink = palette().color(QPalette::WindowText);
  QColor grid = ink;
  grid.setAlphaF(0.15F);
  const QFontMetricsF font(painter.font());
  const double line = font.height();
  const QRectF& box = frame.box;
  const QRectF head(4, line - font.ascent(), width() - 8.0, line);
  painter.drawText(head, Qt::AlignLeft, what_.y_title);
  const double left =
    std::max(box.left(), head.left() + font.horizontalAdvance(what_.y_title) + 12);
  painter.drawText(QRectF(left, head.top(), head.right() - left, line), Qt::AlignLeft,
                   font.elidedText(what_.title, Qt::ElideRight, head.right() - left));
  painter.drawText(QRectF(box.left(), height() - line - 2, box.width(), line), Qt::AlignHCenter,
                   what_.x_title);
  for (const double x :
       ticks(frame.x_low, frame.x_high, std::max(5, static_cast<int>(box.width() / 60)))) {
    const double at = frame.at(x, 0).x();
    painter.setPen(grid);
    painter.drawLine(QPointF(at, box.top()), QPointF(at, box.bottom()));
    painter.setPen(ink);
    painter.drawText(QRectF(at - 40, box.bottom() + 2, 80, line), Qt::AlignHCenter, number(x));
  }
  for (const double y :
       ticks(frame.y_low, frame.y_high, std::max(4, static_cast<int>(box.height() / 22)))) {
    const double at = frame.at(0, y).y();
    painter.setPen(grid);
    painter.drawLine(QPointF(box.left(), at), QPointF(box.right(), at));
    painter.setPen(ink);
    painter.drawText(QRectF(0, at - line / 2, 58, line), Qt::AlignRight | Qt::AlignVCenter,
                     number(y));
  }
}

void plot_area::paint_bars(QPainter& painter, const axes& frame) const {
  const double step = (what_.x_high - what_.x_low) / static_cast<double>(what_.y.size());
  painter.setPen(palette().color(QPalette::WindowText));
  painter.setBrush(Qt::NoBrush);
  for (std::size_t i = 0; i < what_.y.size(); ++i) {
    const double left = what_.x_low + step * static_cast<double>(i);
    const auto bar = [&](double y) {
      return QRectF(frame.at(left, y) + QPointF(1, 0), frame.at(left + step, 0) - QPointF(1, 0));
    };
    painter.fillRect(bar(what_.y[i]), palette().color(QPalette::Highlight));
    if (i < what_.y_before.size())
      painter.drawRect(bar(what_.y_before[i]));
  }
}

void plot_area::paint_line(QPainter& painter, const axes& frame) const {
  const double step = (what_.x_high - what_.x_low) /
                      static_cast<double>(std::max<std::size_t>(2, what_.y.size()) - 1);
  QPainterPath path;
  bool gap = true;
  for (std::size_t i = 0; i < what_.y.size(); ++i) {
    if (!std::isfinite(what_.y[i])) {
      gap = true;
      continue;
    }
    const QPointF at = frame.at(what_.x_low + step * static_cast<double>(i), what_.y[i]);
    gap ? path.moveTo(at) : path.lineTo(at);
    gap = false;
  }
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
}

// -- the panel -----------------------------------------------------------------------

plot_panel::plot_panel(document& part, probes& all, probe_panel& list, field_panel& fields,
                       viewport& view, QWidget* parent)
    : QWidget(parent), part_(part), all_(all), list_(list), fields_(fields), view_(view) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 4);
  kind_ = new QComboBox;
  kind_->setObjectName("plot_kind");
  kind_->addItems({tr("Shown field by area"), tr("Shown field between two probes"),
                   tr("Tets that the edit touched, by quality")});
  column->addWidget(kind_, 0, Qt::AlignLeft);
  area_ = new plot_area;
  area_->setObjectName("plot");
  column->addWidget(area_, 1);
  connect(kind_, &QComboBox::currentIndexChanged, this, &plot_panel::refresh);
  connect(&list_, &probe_panel::pair_changed, this, &plot_panel::refresh);
  connect(&view_, &viewport::shown, this, &plot_panel::refresh);
  connect(&part_, &document::closed, this, &plot_panel::refresh);
}

void plot_panel::refresh() {
  if (!isVisible())
    return;  // Counted when it is looked at.
  const int kind = kind_->currentIndex();
  area_->set(kind == 0 ? by_area() : kind == 1 ? on_line() : quality());
}

void plot_panel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

plot plot_panel::by_area() const {
  const auto* head = part_.head();
  const auto field = fields_.field();
  const auto wanted = fields_.wanted().field;
  plot result;
  result.note = tr("No field is shown.");
  if (!head || !head->surface || !field || field->version_id() != head->info.version_id)
    return result;
  const auto counted = histogram_of(*head->surface, *field, wanted, bar_count);
  const auto unit = shown_as(field_unit(wanted));
  result.title = tr("%1, v%2").arg(field_title(wanted)).arg(head->info.number);
  result.x_title = unit.name;
  result.y_title = tr("% of area");
  result.x_low = counted.low * unit.scale;
  result.x_high = counted.high * unit.scale;
  for (const double share : counted.share)
    result.y.push_back(100 * share);
  if (!(result.x_high > result.x_low))
    result.y.clear();
  return result;
}

plot plot_panel::on_line() const {
  plot result;
  result.note = tr("Set two probes (P, then click the part).");
  const auto both = list_.pair();
  const auto* head = part_.head();
  const auto wanted = fields_.wanted().field;
  if (both.size() < 2 || !head)
    return result;
  const auto from = all_.place(both[0], *head);
  const auto to = all_.place(both[1], *head);
  result.note = tr("There is no field on this line.");
  const auto& drawn = view_.geometry();
  if (!from || !to || !drawn || view_.painted().values.size() != drawn->vertices.size() ||
      drawn->version_id != head->info.version_id)
    return result;
  if (view_.current().deform != 0) {
    result.note = tr("Set the deformation to 0: the line runs through the part as it is.");
    return result;
  }
  const auto unit = shown_as(field_unit(wanted));
  const vec3 way = to->at - from->at;
  const double length_mm = 1e3 * std::sqrt(dot(way, way));
  if (!(length_mm > 0))
    return result;
  result.bars = false;
  result.title =
    tr("%1 from probe %2 to %3").arg(field_title(wanted)).arg(both[0].number).arg(both[1].number);
  result.x_title = "mm";
  result.y_title = unit.name;
  result.x_high = length_mm;
  for (const double value : along(*drawn, view_.painted().values, from->at, to->at, line_steps))
    result.y.push_back(value * unit.scale);
  if (std::ranges::none_of(result.y, [](double y) { return std::isfinite(y); }))
    result.y.clear();
  return result;
}

plot plot_panel::quality() const {
  plot result;
  const auto* head = part_.head();
  if (!head || !head->report) {
    result.note = tr("No edit has been made yet.");
    return result;
  }
  const auto& report = *head->report;
  const auto& ratios = report.ratios;
  if (!report.optimisation || !report.optimisation->before || !report.optimisation->after) {
    result.note = ratios
                    ? tr(
                        "Worst tet: %1 before, %2 now; median now %3.\nHow many have which "
                        "quality is counted by a thorough improvement only (\"Improve mesh\").")
                        .arg(number(ratios->min_before), number(ratios->min_after),
                             number(ratios->median_after))
                    : tr("This edit made and changed no tet.");
    return result;
  }
  const auto& before = *report.optimisation->before;
  const auto& after = *report.optimisation->after;
  result.title = tr("Radius ratio of the tets, v%1; the outline: before").arg(head->info.number);
  result.x_title = tr("radius ratio, 1 is best");
  result.y_title = tr("% of tets");
  result.x_high = 1;
  const auto percent = [](std::uint64_t part, std::uint64_t all) {
    return all > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(all) : 0;
  };
  for (std::size_t i = 0; i < after.ratio.size(); ++i) {
    result.y.push_back(percent(after.ratio[i], after.tets));
    result.y_before.push_back(percent(before.ratio[i], before.tets));
  }
  return result;
}

}  // namespace tedit::desktop
