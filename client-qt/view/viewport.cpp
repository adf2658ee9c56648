// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/viewport.hpp"

#include <QMouseEvent>
#include <QRubberBand>
#include <QWheelEvent>

#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

#include "client-qt/view/box_pick.hpp"
#include "client-qt/view/isolines.hpp"
#include "client-qt/view/shown_values.hpp"

namespace tedit::desktop {

namespace {

constexpr double drag_threshold = 4;  // Pixels: less is a click.
constexpr double zoom_step = 1.12;    // For a notch of the wheel.

}  // namespace

viewport::viewport(QWidget* parent)
    : vtk_view(parent), camera_(renderer()), scene_(renderer()), preview_(renderer()) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 240);
  setAccessibleName(tr("The part"));
  builders_.setMaxThreadCount(1);
}

viewport::~viewport() {
  builders_.clear();
  builders_.waitForDone();
}

// -- what is shown -------------------------------------------------------------------

void viewport::show_part(const shown_part& what) {
  const bool same_shape = shown_.surface == what.surface && shown_.before == what.before &&
                          shown_.deform == what.deform &&
                          (what.deform == 0 || shown_.field == what.field);
  const bool same_field = shown_.field == what.field;
  shown_ = what;
  if (!shown_.surface)
    return;
  if (!same_shape) {
    build();
  } else if (!building_ && scene_.part() && same_field) {
    emit legend_changed();
    emit shown();
  } else if (!building_ && scene_.part()) {
    paint_values();
  }
}

void viewport::build() {
  const int mine = ++generation_;
  builders_.clear();  // What has not begun is out of date; it never reports.
  contouring_ = false;
  building_ = true;
  builders_.start([this, mine, shown = shown_] {
    static const std::vector<std::uint32_t> no_slots;
    static const std::vector<float> no_values;
    const bool moves =
      shown.deform != 0 && shown.field && shown.field->version_id() == shown.surface->version_id();
    auto part = build_part(*shown.surface, moves ? shown.field->vertices : no_slots,
                           moves ? shown.field->displacement : no_values, shown.deform);
    auto preview = shown.before ? differences_of(*shown.before, *shown.surface) : nullptr;
    QMetaObject::invokeMethod(
      this, [this, part, preview, mine] { take_geometry(part, preview, mine); },
      Qt::QueuedConnection);
  });
}

void viewport::take_geometry(std::shared_ptr<const part_geometry> part,
                             const std::shared_ptr<const preview_geometry>& preview,
                             int generation) {
  if (generation != generation_)
    return;
  building_ = false;
  const bool first = !scene_.part();
  scene_.set_part(std::move(part));
  preview_.show(preview);
  if (first || !fitted_)
    fit();
  paint_values();
  highlight();
  hovered_.reset();
  camera_.adjust_depth();
}

/// Most of what changes in the window changes no colour; painting takes 10 ms for 50 000 points.
void viewport::set_legend(const legend& by) {
  if (legend_.draws_like(by))
    return;
  legend_ = by;
  if (scene_.part())
    paint_values();
}

void viewport::paint_values() {
  values_.clear();
  extremes_.reset();
  const auto& part = scene_.part();
  const bool fits = shown_.field && shown_.field->version_id() == part->version_id;
  if (legend_.field == shown_field::surfaces) {
    scene_.show_surfaces();
  } else if (legend_.field == shown_field::none || !fits) {
    scene_.show_plain();
  } else {
    values_ = values_of(*part, *shown_.field, legend_.field);
    legend_.fit(values_);
    scene_.show_values(values_, legend_);
    std::size_t low = values_.size();
    std::size_t high = values_.size();
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (!std::isfinite(values_[i]))
        continue;
      if (low == values_.size() || values_[i] < values_[low])
        low = i;
      if (high == values_.size() || values_[i] > values_[high])
        high = i;
    }
    if (low < values_.size()) {
      const auto at = [&](std::size_t i) {
        std::array<double, 3> p{};
        part->faces->GetPoints()->GetPoint(static_cast<vtkIdType>(i), p.data());
        return vec3{p[0], p[1], p[2]};
      };
      extremes_ = extremes{values_[low], values_[high], at(low), at(high)};
    }
  }
  paint_cap();
  contour();
  redraw();
  emit legend_changed();
  emit shown();
}

/// On another thread; the newest wins.
void viewport::contour() {
  const int mine = ++contours_;
  contouring_ = isolines_ && !values_.empty();
  if (!contouring_) {
    scene_.set_isolines(nullptr);
    return;
  }
  builders_.start([this, mine, part = scene_.part(), values = values_, levels = legend_.levels(),
                   hidden = scene_.hidden()] {
    auto lines = make_isolines(*part, values, levels, hidden);
    QMetaObject::invokeMethod(
      this,
      [this, lines, mine] {
        if (mine != contours_)
          return;
        contouring_ = false;
        scene_.set_isolines(lines);
        redraw();
      },
      Qt::QueuedConnection);
  });
}

void viewport::show_isolines(bool on) {
  if (std::exchange(isolines_, on) == on || !scene_.part() || building_)
    return;
  paint_cap();
  contour();
}

/// A cap of another version than the one that is drawn would lie: it is left out until its own
/// comes.
void viewport::paint_cap() {
  const auto& part = scene_.part();
  if (!section_ || !cap_ || !part || cap_->version_id != part->version_id) {
    scene_.set_cap(nullptr, {}, legend_);
    scene_.set_cap_isolines(nullptr);
    return;
  }
  const auto cap = make_cap(*cap_, shown_.deform);
  const auto values = values_of(*cap_, legend_.field);
  scene_.set_cap(cap, values, legend_);
  // Some ten thousand triangles at most: no work for another thread.
  const bool lines = isolines_ && !values.empty() && !values_.empty();
  scene_.set_cap_isolines(lines ? make_isolines(*cap, values, legend_.levels()).Get() : nullptr);
}

void viewport::set_section(const std::optional<section_plane>& plane) {
  section_ = plane;
  if (!plane)
    cap_.reset();
  scene_.clip(plane);
  preview_.clip(plane);
  paint_cap();
  redraw();
}

void viewport::show_cap(std::shared_ptr<const client::section> cap) {
  cap_ = std::move(cap);
  paint_cap();
  redraw();
}

std::optional<std::array<double, 6>> viewport::bounds() const {
  return scene_.part() ? std::optional(scene_.part()->bounds) : std::nullopt;
}

void viewport::set_colours(const scene_colours& colours) {
  scene_.set_colours(colours);
  preview_.set_colours(colours);
  if (scene_.part())
    paint_values();
  redraw();
}

void viewport::select(const std::vector<surface_id>& picked) {
  selected_ = picked;
  highlight();
  redraw();
}

void viewport::mark(const std::vector<surface_id>& faulty) {
  faulty_ = faulty;
  highlight();
  redraw();
}

/// In a preview the accent's colour is that of what would be new; a fault is shown on the head.
void viewport::highlight() {
  const auto& part = scene_.part();
  if (!part)
    return;
  const bool preview = shown_.before != nullptr;
  scene_.select(preview || !faulty_.empty() ? std::vector<surface_id>{} : selected_);
  preview_.mark(*part, preview ? std::vector<surface_id>{} : faulty_);
}

void viewport::hide(const std::set<surface_id>& hidden) {
  scene_.hide(hidden);
  if (scene_.part())
    paint_values();
}

void viewport::show_mesh(bool on) {
  scene_.show_mesh(on);
  redraw();
}

void viewport::show_edges(bool on) {
  scene_.show_edges(on);
  redraw();
}

void viewport::set_glyphs(vtkPolyData* loads, vtkPolyData* supports) {
  scene_.set_glyphs(loads, supports);
  camera_.adjust_depth();
  redraw();
}

/// Only a closed part hides the backs of its faces: not one that is cut open, nor one with faces
/// left out, nor from within.
void viewport::about_to_draw() {
  const auto& part = scene_.part();
  scene_.cull_backs(part && !section_ && scene_.hidden().empty() &&
                    !camera_.is_within(part->bounds));
}

// -- the camera ----------------------------------------------------------------------

void viewport::fit(const std::vector<surface_id>& around) {
  const auto& part = scene_.part();
  if (!part)
    return;
  auto bounds = part->bounds;
  if (!around.empty()) {
    auto some = extract(*part, around);
    if (some->GetNumberOfCells() > 0) {
      some->GetCellsBounds(bounds.data());
    }
  }
  fitted_ = true;
  camera_.fit(bounds);
  whole_ = around.empty() ? std::optional(camera_.get()) : std::nullopt;
  redraw();
  emit view_changed();
}

void viewport::set_left_margin(int pixels) {
  left_margin_ = pixels;
  camera_.set_left_margin(static_cast<double>(pixels) / std::max(1, width()));
}

double viewport::free_aspect(const QSize& size) const {
  const double width =
    std::max(0.6 * size.width(), static_cast<double>(size.width() - left_margin_));
  return width / std::max(1, size.height());
}

void viewport::resizeEvent(QResizeEvent* event) {
  vtk_view::resizeEvent(event);
  set_left_margin(left_margin_);
  if (keeps_fitted_ && whole_ == camera_.get())
    fit();
}

void viewport::look_from(camera::direction from) {
  camera_.look_from(from);
  fit();
}

void viewport::fly_to(const vec3& place) {
  camera_.focus_on(place);
  redraw();
  emit view_changed();
}

std::optional<picked_point> viewport::pick_at(QPointF position) const {
  if (!scene_.part())
    return std::nullopt;
  const double ratio = pixel_ratio();
  const auto [from, to] = camera_.ray(position.x() * ratio, (height() - position.y()) * ratio);
  return pick_visible(*scene_.part(), scene_.hidden(), section_, from, to);
}

QPointF viewport::to_widget(const vec3& at) const {
  const double ratio = pixel_ratio();
  const vec3 pixel = camera_.to_pixel(at);
  return {pixel.x / ratio, height() - pixel.y / ratio};
}

std::optional<vec3> viewport::visible_point(surface_id surface) const {
  const auto& part = scene_.part();
  if (!part || !part->cells.contains(surface))
    return std::nullopt;
  const auto [first, last] = part->cells.at(surface);
  for (auto cell = first; cell < last; ++cell) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    part->faces->GetCellPoints(cell, count, points);
    vec3 middle;
    for (int k = 0; k < 3; ++k) {
      std::array<double, 3> p{};
      part->faces->GetPoints()->GetPoint(points[k], p.data());
      middle += vec3{p[0], p[1], p[2]} / 3;
    }
    const auto seen = pick_at(to_widget(middle));
    if (seen && seen->surface == surface)
      return middle;
  }
  return std::nullopt;
}

std::optional<double> viewport::value_at(const picked_point& at) const {
  const auto& part = scene_.part();
  if (!part || values_.empty())
    return std::nullopt;
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  part->faces->GetCellPoints(at.cell, count, points);
  double sum = 0;
  for (int k = 0; k < 3; ++k)
    sum += at.weights[k] * values_[static_cast<std::size_t>(points[k])];
  return std::isfinite(sum) ? std::optional(sum) : std::nullopt;
}

// -- the mouse -----------------------------------------------------------------------

void viewport::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->position();
  dragging_ = false;
  draws_box_ = event->button() == Qt::LeftButton &&
               (boxing_ || event->modifiers().testFlag(Qt::ControlModifier));
}

void viewport::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) {
    hover_at(event->position(), event->globalPosition().toPoint());
    return;
  }
  const QPointF moved = event->position() - *pressed_;
  if (!dragging_ && std::hypot(moved.x(), moved.y()) < drag_threshold)
    return;
  if (!dragging_) {
    scene_.hover(std::nullopt);
    hovered_.reset();
    emit hovered(std::nullopt, {});
  }
  dragging_ = true;
  if (draws_box_) {
    if (!band_)
      band_ = new QRubberBand(QRubberBand::Rectangle, this);
    band_->setGeometry(QRectF(*pressed_, event->position()).normalized().toRect());
    band_->show();
    return;
  }
  drag(event->position(), event->buttons(), event->modifiers());
}

void viewport::drag(QPointF to, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
  const QPointF moved = to - std::exchange(last_, to);
  const double ratio = pixel_ratio();
  draw_quickly();
  const bool pans = (buttons & Qt::MiddleButton) || (modifiers & Qt::ShiftModifier);
  if (pans)
    camera_.pan(moved.x() * ratio, -moved.y() * ratio);
  else if (buttons & Qt::LeftButton)
    camera_.rotate(moved.x() / height(), moved.y() / height());
  else if (buttons & Qt::RightButton)
    camera_.zoom(std::pow(zoom_step, -moved.y() / 12), width() * ratio / 2, height() * ratio / 2);
  redraw();
  emit view_changed();
}

void viewport::mouseReleaseEvent(QMouseEvent* event) {
  const bool click = pressed_ && !dragging_;
  if (pressed_ && dragging_ && draws_box_)
    finish_box(event->position(), event->modifiers());
  pressed_.reset();
  dragging_ = false;
  if (!click)
    return;
  const auto hit = pick_at(event->position());
  if (event->button() == Qt::LeftButton)
    emit clicked(hit, event->modifiers());
  else if (event->button() == Qt::RightButton)
    emit menu_wanted(hit, event->globalPosition().toPoint());
}

void viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  if (const auto hit = pick_at(event->position()))
    fly_to(hit->at);
}

void viewport::wheelEvent(QWheelEvent* event) {
  draw_quickly();
  const double notches = event->angleDelta().y() / 120.0;
  const double ratio = pixel_ratio();
  camera_.zoom(std::pow(zoom_step, notches), event->position().x() * ratio,
               (height() - event->position().y()) * ratio);
  redraw();
  emit view_changed();
}

void viewport::leaveEvent(QEvent*) {
  scene_.hover(std::nullopt);
  hovered_.reset();
  redraw();
  emit hovered(std::nullopt, {});
}

void viewport::hover_at(QPointF position, QPoint global) {
  const auto hit = pick_at(position);
  const auto under = hit ? std::optional(hit->surface) : std::nullopt;
  if (under != hovered_) {
    hovered_ = under;
    scene_.hover(under);
    redraw();
  }
  emit hovered(hit, global);
}

}  // namespace tedit::desktop
