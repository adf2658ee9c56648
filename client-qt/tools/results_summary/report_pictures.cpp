// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/results_summary/report_pictures.hpp"

#include <QBuffer>
#include <QCoreApplication>
#include <QResizeEvent>

#include <vtkPolyData.h>

#include <algorithm>

#include "client-qt/model/field_values.hpp"
#include "client-qt/tools/loads/load_glyphs.hpp"
#include "client-qt/widgets/theme.hpp"

namespace tedit::desktop {

namespace {

constexpr int poll_ms = 15;

/// A hidden widget is not told of its size by itself.
void give_size(QWidget& widget, const QSize& size) {
  QResizeEvent resized(size, widget.size());
  widget.resize(size);
  QCoreApplication::sendEvent(&widget, &resized);
}

report_picture encoded(const QString& caption, const QImage& image) {
  report_picture result{caption, {}, image.width(), image.height()};
  QBuffer buffer(&result.png);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return result;
}

/// What has no values, or none of its own, is shown by the stress.
legend legend_for(legend by, const client::field_event& field) {
  if (!is_of_result(by.field) || !has(field, by.field)) {
    by = legend();
    by.field = shown_field::von_mises;
  }
  return by;
}

}  // namespace

report_pictures::report_pictures(pictured_part what, QObject* parent)
    : QObject(parent), what_(std::move(what)), view_(std::make_unique<viewport>()) {
  const auto look = make_theme(false);
  over_ = new overlay(*view_);
  give_size(*view_, what_.size);
  over_->setGeometry(view_->rect());
  over_->set_note(what_.note);
  over_->set_ink(look.ink);
  view_->set_colours(look.scene);
  view_->hide(what_.hidden);
  poll_.setInterval(poll_ms);
  connect(&poll_, &QTimer::timeout, this, &report_pictures::take);
  list_steps();
}

report_pictures::~report_pictures() = default;

void report_pictures::list_steps() {
  const auto title = [this](const client::field_event& field) {
    return field_title(legend_for(what_.by, field).field);
  };
  for (const auto& field : what_.fields)
    if (field->envelope)
      steps_.push_back({tr("%1, worst of all load cases").arg(title(*field)), field, {}});
  for (const auto& field : what_.fields)
    if (!field->envelope)
      steps_.push_back(
        {tr("%1, load case %2").arg(title(*field), QString::fromStdString(field->report.load_case)),
         field,
         {}});
  for (const auto& loads : what_.load_cases)
    steps_.push_back(
      {tr("Supports and loads, load case %1").arg(QString::fromStdString(loads.name)),
       nullptr,
       {loads}});
  if (steps_.empty())
    steps_.push_back({tr("The part"), nullptr, {}});
}

void report_pictures::start() {
  if (what_.surface)
    show_step();
  else
    emit finished({});
}

void report_pictures::show_step() {
  const auto& now = steps_[at_];
  const shown_part part{what_.surface, now.field, now.field ? what_.deform : 0};
  if (now.field) {
    view_->set_glyphs(nullptr, nullptr);
    view_->set_legend(legend_for(what_.by, *now.field));
  } else {
    const auto marks = make_glyphs(part, now.loads);
    view_->set_glyphs(marks.loads, marks.supports);
    legend bare;
    bare.field = shown_field::none;
    view_->set_legend(bare);
  }
  view_->show_part(part);
  poll_.start();
}

void report_pictures::take() {
  if (!view_->is_settled())
    return;
  poll_.stop();
  view_->view().set_parallel(what_.parallel);
  view_->view().set(what_.from);
  view_->redraw();
  const auto& now = steps_[at_];
  // An envelope has no displacement: a picture without values would say nothing.
  if (!now.field || view_->painted().extremes)
    made_.push_back(encoded(now.caption, over_->picture()));
  emit progressed(static_cast<int>(++at_), static_cast<int>(steps_.size()));
  if (at_ < steps_.size())
    show_step();
  else
    emit finished(made_);
}

}  // namespace tedit::desktop
