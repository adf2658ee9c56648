// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/section/section_bar.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>

#include <algorithm>
#include <cmath>

#include "client-qt/model/quantities.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/view/viewport.hpp"

namespace tedit::desktop {

namespace {

constexpr int steps = 1000;
enum axis_choice { along_x, along_y, along_z, own };

}  // namespace

section_bar::section_bar(document& part, viewport& view, const field_panel& fields)
    : QFrame(&view), part_(part), view_(view), fields_(fields) {
  setObjectName("section_bar");
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 4, 10, 4);
  axis_ = new QComboBox;
  axis_->addItems({tr("Section across x"), tr("Section across y"), tr("Section across z"),
                   tr("Parallel to the picked surface")});
  place_ = new QSlider(Qt::Horizontal);
  place_->setRange(0, steps);
  place_->setValue(steps / 2);
  place_->setMinimumWidth(220);
  place_->setAccessibleName(tr("Place of the section"));
  shown_ = new QLabel;
  shown_->setMinimumWidth(80);
  auto* flip = new QPushButton(tr("Other side"));
  auto* close = new QPushButton(tr("Close"));
  for (QWidget* one :
       {static_cast<QWidget*>(axis_), static_cast<QWidget*>(place_), static_cast<QWidget*>(shown_),
        static_cast<QWidget*>(flip), static_cast<QWidget*>(close)})
    row->addWidget(one);
  connect(axis_, &QComboBox::currentIndexChanged, this, [this] {
    flipped_ = false;
    face_viewer();
    read_form();
  });
  connect(place_, &QSlider::valueChanged, this, &section_bar::read_form);
  connect(flip, &QPushButton::clicked, this, [this] {
    flipped_ = !flipped_;
    read_form();
  });
  connect(close, &QPushButton::clicked, this, [this] { set_on(false); });
  // A new version or field needs a new cap.
  connect(&part_, &document::surface_changed, this, &section_bar::read_form);
  connect(&fields_, &field_panel::changed, this, [this] {
    if (on_)
      ask();
  });
  connect(&part_, &document::begun, this, [this] { set_on(false); });
  hide();
}

void section_bar::set_on(bool on) {
  if (on && !on_)
    face_viewer();
  on_ = on;
  setVisible(on);
  if (on)
    read_form();
  else
    view_.set_section(std::nullopt);
  emit moved();
}

void section_bar::set_plane(const vec3& at, const vec3& normal) {
  own_normal_ = normal / std::sqrt(dot(normal, normal));
  const std::array<double, 3> parts{own_normal_.x, own_normal_.y, own_normal_.z};
  const auto along = std::ranges::find_if(parts, [](double c) { return std::abs(c) == 1; });
  // Across an axis it is called so.
  axis_->setCurrentIndex(along == parts.end() ? own : static_cast<int>(along - parts.begin()));
  flipped_ = along != parts.end() && *along < 0;
  const vec3 direction = flipped_ ? -own_normal_ : own_normal_;
  const auto ends = reach(direction);
  set_place((dot(at, direction) - ends[0]) / std::max(1e-300, ends[1] - ends[0]));
  on_ = true;  // The side is given, not the viewer's.
  set_on(true);
}

void section_bar::set_place(double place) {
  place_->setValue(qRound(steps * place));
}

/// How far the part's box goes along a direction, m.
std::array<double, 2> section_bar::reach(const vec3& normal) const {
  if (!view_.geometry())
    return {0, 1};
  const auto& box = view_.geometry()->bounds;
  std::array<double, 2> ends{INFINITY, -INFINITY};
  for (int corner = 0; corner < 8; ++corner) {
    const vec3 p{box[corner & 1], box[2 + (corner >> 1 & 1)], box[4 + (corner >> 2 & 1)]};
    ends[0] = std::min(ends[0], dot(p, normal));
    ends[1] = std::max(ends[1], dot(p, normal));
  }
  return ends;
}

std::optional<section_plane> section_bar::plane() const {
  if (!view_.geometry())
    return std::nullopt;
  const std::array<vec3, 4> normals{vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}, own_normal_};
  const vec3 normal = normals[static_cast<std::size_t>(axis_->currentIndex())];
  const auto ends = reach(normal);
  const double along = ends[0] + (ends[1] - ends[0]) * place_->value() / steps;
  return section_plane{along * normal, flipped_ ? -normal : normal};
}

/// What stays is the half that shows the cut. A plane of one's own has its side.
void section_bar::face_viewer() {
  const auto from = view_.view().get();
  const auto wanted = plane();
  if (wanted && axis_->currentIndex() != own && dot(wanted->normal, from.position - from.focus) < 0)
    flipped_ = !flipped_;
}

void section_bar::read_form() {
  const auto wanted = plane();
  if (!on_ || !wanted)
    return;
  const vec3 along = flipped_ ? -wanted->normal : wanted->normal;
  const auto ends = reach(along);
  const auto unit = shown_as("m");  // Of one size everywhere: a slider's number must not jump.
  shown_->setText(number_in(unit.scale * dot(wanted->at, along), unit.scale * (ends[1] - ends[0])) +
                  " " + unit.name);
  view_.set_section(wanted);
  emit moved();
  ask();
}

/// One question at a time; what moved meanwhile is asked for when its answer is there.
void section_bar::ask() {
  const auto wanted = plane();
  if (!wanted || asking_) {
    again_ = asking_;
    return;
  }
  asking_ = true;
  const auto field = fields_.field();
  const std::string load_case = field && !field->envelope ? field->report.load_case : std::string();
  part_.questions().cut(
    wanted->at, wanted->normal, load_case, [this](expected<client::section> got) {
      asking_ = false;
      if (got && on_)
        view_.show_cap(std::make_shared<const client::section>(std::move(*got)));
      else if (!got && got.error().code == ec::cancelled)
        again_ = false;  // Until the plane is moved.
      else if (!got && got.error().code != ec::superseded &&
               got.error().code != ec::service_unavailable)
        emit part_.failed(tr("Section"), got.error());
      if (std::exchange(again_, false))
        ask();
    });
}

}  // namespace tedit::desktop
