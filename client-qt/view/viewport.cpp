// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/viewport.hpp"

#include <vtkCamera.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "client-qt/view/box_pick.hpp"
#include "client-qt/view/isolines.hpp"
#include "client-qt/view/shown_values.hpp"

namespace tedit::desktop {

/// The mark of each cell. Cost: O(cells log marks).
static std::vector<print_mark> marks_of_cells(const part_geometry& part,
                                              const client::print_check& made) {
  std::vector<print_mark> marks;
  marks.reserve(part.cell_facet.size());
  for (const auto slot : part.cell_facet) {
    const auto found = std::ranges::lower_bound(made.facets, slot);
    const bool marked = found != made.facets.end() && *found == slot;
    marks.push_back(marked ? made.marks[static_cast<std::size_t>(found - made.facets.begin())]
                           : print_mark::sound);
  }
  return marks;
}

viewport::viewport(QWidget* parent) : vtk_view(parent) {
  change([this](vtkRenderer& renderer) { stage_ = std::make_unique<stage>(renderer); });
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 240);
  setAccessibleName(tr("The part"));
  builders_.setMaxThreadCount(1);
  connect(&framing_, &part_framing::moved, this, [this] {
    redraw();
    emit view_changed();
  });
}

viewport::~viewport() {
  end_drawing();
  builders_.clear();
  builders_.waitForDone();
}

void viewport::change_stage(std::function<void(stage&)> what) {
  change([this, what = std::move(what)](vtkRenderer&) { what(*stage_); });
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
  } else if (!building_ && part_ && same_field) {
    emit legend_changed();
    emit shown();
  } else if (!building_ && part_) {
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
    auto part =
      build_part(*shown.surface, moves ? shown.field->vertices : no_slots,
                 moves ? shown.field->values.of("displacement_m") : no_values, shown.deform);
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
  part_ = std::move(part);
  if (!shown_.before && shown_.deform == 0)
    at_rest_ = part_;
  change_stage([part = part_, preview](stage& on) {
    on.part.set_part(part);
    on.preview.show(preview);
  });
  framing_.set_part(part_);
  paint_values();
  shaped_ = asked();
  highlight();
  hovered_.reset();
}

/// Most of what changes in the window changes no colour; painting takes 10 ms for 50 000 points.
void viewport::set_legend(const legend& by) {
  if (painted_values_.by.draws_like(by))
    return;
  painted_values_.by = by;
  if (part_)
    paint_values();
}

void viewport::paint_values() {
  painted_values_.values.clear();
  painted_values_.extremes.reset();
  const auto& part = part_;
  const bool fits = shown_.field && shown_.field->version_id() == part->version_id;
  if (shows_print_marks()) {
    change_stage([marks = marks_of_cells(*part, *print_marks_)](stage& on) {
      on.part.show_print_marks(marks);
    });
  } else if (painted_values_.by.field == shown_field::surfaces) {
    change_stage([](stage& on) { on.part.show_surfaces(); });
  } else if (painted_values_.by.field == shown_field::none || !fits) {
    change_stage([](stage& on) { on.part.show_plain(); });
  } else {
    painted_values_.values = values_of(*part, *shown_.field, painted_values_.by.field);
    painted_values_.by.fit(painted_values_.values, part->areas);
    change_stage([values = painted_values_.values, by = painted_values_.by](stage& on) {
      on.part.show_values(values, by);
    });
    painted_values_.find_extremes(*part);
  }
  paint_cap();
  contour();
  redraw();
  painted_ = asked();
  emit legend_changed();
  emit shown();
}

void viewport::show_print_marks(shared_print_check marks) {
  if (print_marks_ == marks)
    return;
  print_marks_ = std::move(marks);
  if (part_)
    paint_values();
}

bool viewport::shows_print_marks() const {
  return print_marks_ && part_ && !shown_.before && print_marks_->version_id == part_->version_id;
}

/// On another thread; the newest wins.
void viewport::contour() {
  const int mine = ++contours_;
  contouring_ = isolines_ && !painted_values_.values.empty();
  if (!contouring_) {
    change_stage([](stage& on) { on.part.set_isolines(nullptr); });
    return;
  }
  builders_.start([this, mine, part = part_, values = painted_values_.values,
                   levels = painted_values_.by.levels(), hidden = hidden_] {
    auto lines = make_isolines(*part, values, levels, hidden);
    QMetaObject::invokeMethod(
      this,
      [this, lines, mine] {
        if (mine != contours_)
          return;
        contouring_ = false;
        change_stage([lines](stage& on) { on.part.set_isolines(lines); });
        redraw();
      },
      Qt::QueuedConnection);
  });
}

void viewport::show_isolines(bool on) {
  if (std::exchange(isolines_, on) == on || !part_ || building_)
    return;
  paint_cap();
  contour();
}

/// A cap of another version than the one that is drawn would lie: it is left out until its own
/// comes.
void viewport::paint_cap() {
  const auto& part = part_;
  if (!section_ || !cap_ || !part || cap_->version_id != part->version_id) {
    change_stage([](stage& on) {
      on.part.set_cap(nullptr, {}, {});
      on.part.set_cap_isolines(nullptr);
    });
    return;
  }
  const auto cap = make_cap(*cap_, shown_.deform);
  const bool lines = isolines_ && !painted_values_.values.empty();
  // Beside marks the field would be colours without a legend.
  auto values =
    shows_print_marks() ? std::vector<float>() : values_of(*cap_, painted_values_.by.field);
  change_stage([cap, values = std::move(values), by = painted_values_.by, lines](stage& on) {
    on.part.set_cap(cap, values, by);
    on.part.set_cap_isolines(
      lines && !values.empty() ? make_isolines(*cap, values, by.levels()).Get() : nullptr);
  });
}

void viewport::set_section(const std::optional<section_plane>& plane) {
  section_ = plane;
  if (!plane)
    cap_.reset();
  change_stage([plane](stage& on) {
    on.part.clip(plane);
    on.preview.clip(plane);
  });
  paint_cap();
  redraw();
}

void viewport::show_cap(std::shared_ptr<const client::section> cap) {
  cap_ = std::move(cap);
  paint_cap();
  redraw();
}

void viewport::set_colours(const scene_colours& colours) {
  change_stage([colours](stage& on) {
    on.part.set_colours(colours);
    on.preview.set_colours(colours);
  });
  if (part_)
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
  if (!part_)
    return;
  const bool preview = shown_.before != nullptr;
  change_stage([part = part_,
                picked = preview || !faulty_.empty() ? std::vector<surface_id>{} : selected_,
                faulty = preview ? std::vector<surface_id>{} : faulty_](stage& on) {
    on.part.select(picked);
    on.preview.mark(*part, faulty);
  });
}

/// Of a preview nothing is selected, but what is new has a colour of its own: it is no picture of
/// the head at all.
void viewport::plain_picture(const std::function<void(const QImage&)>& then) {
  if (selected_.empty() && faulty_.empty() && !hovered_)
    return then(last_picture());
  draw_aside(
    [this](vtkRenderer&) {
      stage_->part.show_highlights(false);
      stage_->preview.show_marks(false);
    },
    [this](vtkRenderer&) {
      stage_->part.show_highlights(true);
      stage_->preview.show_marks(true);
    },
    then);
}

void viewport::hide(const std::set<surface_id>& hidden) {
  hidden_ = hidden;
  change_stage([hidden](stage& on) { on.part.hide(hidden); });
  if (part_)
    paint_values();
}

void viewport::show_mesh(bool on) {
  change_stage([on](stage& there) { there.part.show_mesh(on); });
  redraw();
}

void viewport::show_edges(bool on) {
  change_stage([on](stage& there) { there.part.show_edges(on); });
  redraw();
}

void viewport::set_glyphs(vtkPolyData* loads, vtkPolyData* supports) {
  change_stage([loads = vtkSmartPointer(loads), supports = vtkSmartPointer(supports)](stage& on) {
    on.part.set_glyphs(loads, supports);
  });
  redraw();
}

/// Only a closed part hides the backs of its faces: not one that is cut open, nor one with faces
/// left out, nor from within.
void viewport::about_to_draw() {
  drawn_by_ = camera_.to_pixels();
  change([this, from = camera_.copy(),
          closed = part_ && !section_ && hidden_.empty() &&
                   !camera_.is_within(part_->bounds)](vtkRenderer& renderer) {
    renderer.GetActiveCamera()->DeepCopy(from);
    stage_->part.cull_backs(closed);
  });
}

void viewport::frame_came() {
  seen_by_ = drawn_by_;
}

// -- places --------------------------------------------------------------------------

void viewport::resizeEvent(QResizeEvent* event) {
  camera_.set_size(width(), height());
  vtk_view::resizeEvent(event);
  framing_.set_size(size());
}

std::optional<picked_point> viewport::pick_at(QPointF position) const {
  if (!part_)
    return std::nullopt;
  const auto [from, to] = camera_.ray(position.x(), height() - position.y());
  return pick_visible(*part_, hidden_, section_, from, to);
}

std::optional<picked_point> viewport::pick_at(QPointF position, const std::string& version) const {
  if (!at_rest_ || at_rest_->version_id != version)
    return pick_at(position);
  const auto [from, to] = camera_.ray(position.x(), height() - position.y());
  return pick_visible(*at_rest_, hidden_, section_, from, to);
}

QPointF viewport::to_widget(const vec3& at) const {
  const auto [x, y] = camera_.to_pixel(at);
  return {x, height() - y};
}

QPointF viewport::to_frame(const vec3& at) const {
  if (seen() == 0)
    return to_widget(at);
  const auto [x, y] = seen_by_.apply(at);
  return {x, height() - y};
}

std::optional<vec3> viewport::visible_point(surface_id surface) const {
  const auto& part = part_;
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

void viewport::show_place(const vec3& drawn, const vec3& outward) {
  framing_.fly_to(drawn);
  auto pose = camera_.get();
  const double distance = norm(pose.position - drawn);
  const auto found = pick_at(to_widget(drawn));
  if (outward == vec3{} || !found || norm(found->at - drawn) < 0.02 * distance)
    return;
  pose.position = drawn + distance * outward;
  if (std::abs(dot(pose.up, outward)) > 0.99 * norm(pose.up))  // Looking along it.
    pose.up = std::abs(outward.y) < 0.9 ? vec3{0, 1, 0} : vec3{1, 0, 0};
  camera_.set(pose);
  redraw();
  emit view_changed();
}

std::optional<double> viewport::value_at(const picked_point& at) const {
  const auto& values = painted_values_.values;
  if (!part_ || values.empty())
    return std::nullopt;
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  part_->faces->GetCellPoints(at.cell, count, points);
  double sum = 0;
  for (int k = 0; k < 3; ++k)
    sum += at.weights[k] * values[static_cast<std::size_t>(points[k])];
  return std::isfinite(sum) ? std::optional(sum) : std::nullopt;
}

}  // namespace tedit::desktop
