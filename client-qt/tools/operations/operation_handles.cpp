// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/operations/operation_handles.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "client-qt/model/part_size.hpp"
#include "client-qt/model/pick_words.hpp"
#include "client-qt/model/probes.hpp"
#include "client-qt/tools/operations/context_panel.hpp"

namespace tedit::desktop {

namespace {

using kind = handle::kind;

bool is_free(Qt::KeyboardModifiers modifiers) {
  return modifiers.testFlag(Qt::ControlModifier) || modifiers.testFlag(Qt::AltModifier);
}

}  // namespace

operation_handles::operation_handles(window_context& in, context_panel& panel)
    : in_(in), panel_(panel), layer_(new handle_layer(in.view)) {
  finders_.setMaxThreadCount(1);
  layer_->setObjectName("handles");
  layer_->stackUnder(&in_.over);
  in_.over.stackUnder(layer_);  // Directly over it: what is dragged is not covered by marks.
  layer_->set_source([this](const lens& by) { return drawn(by); });
  in_.view.set_grips(this);
  connect(&panel_, &context_panel::followed, this, &operation_handles::follow);
  connect(&panel_.preview(), &live_preview::changed, layer_, qOverload<>(&QWidget::update));
  connect(&in_.part, &document::surface_changed, this, &operation_handles::follow);
  connect(&in_.look, &appearance::changed, this, [this](const theme& look) {
    const auto& c = look.scene.accent;
    layer_->set_accent(QColor::fromRgbF(c[0], c[1], c[2]));
  });
}

operation_handles::~operation_handles() {
  finders_.clear();
  finders_.waitForDone();
}

// -- what there is -------------------------------------------------------------------

void operation_handles::follow() {
  const auto* head = in_.part.head();
  const auto* form = panel_.chosen().isEmpty() ? nullptr : panel_.form();
  const auto& plans = in_.part.operations().handles;
  const auto found = plans.find(panel_.chosen().toStdString());
  layer_->update();
  if (!form || !head || !head->surface || found == plans.end()) {
    end_drag();
    mark(nullptr);
    pose_.reset();
    operation_.clear();
    return;
  }
  if (operation_ != panel_.chosen()) {
    end_drag();
    mark(nullptr);
    operation_ = panel_.chosen();
    plan_ = found->second;
  }
  values_ = form->values();
  const auto& geometry = in_.view.geometry();
  pose_ = pose_of(plan_, values_, in_.picked.surfaces(), *head->surface,
                  geometry ? geometry->bounds : std::array<double, 6>{});
  if (!drag_) {
    snapped_.reset();
    snapped_to_.clear();
  }
  if (plan_.find(kind::place))
    find_snap_places();
}

/// Aside: 100 ms for a part of a million tets.
void operation_handles::find_snap_places() {
  const auto& surface = in_.part.head()->surface;
  if (places_of_ == surface->version_id())
    return;
  places_of_ = surface->version_id();
  places_ = nullptr;
  finders_.clear();
  finders_.start([this, surface] {
    auto found = std::make_shared<const std::vector<snap_place>>(snap_places(*surface));
    QMetaObject::invokeMethod(
      this,
      [this, found, of = surface->version_id()] {
        if (of == places_of_)
          places_ = found;
      },
      Qt::QueuedConnection);
  });
}

std::vector<laid_handle> operation_handles::laid() const {
  return pose_ ? lay_out(plan_, values_, *pose_, lens_of(in_.view)) : std::vector<laid_handle>();
}

bool operation_handles::shows_ghost() const {
  const auto& preview = panel_.preview();
  return pose_ && preview.has_wish() && (!preview.shown() || preview.is_busy());
}

QString operation_handles::words(const laid_handle& one) const {
  const QString what = words_of(one, values_);
  return snapped_to_.isEmpty() || !drag_ ? what : what + "\n" + snapped_to_;
}

drawn_handles operation_handles::drawn(const lens& by) const {
  drawn_handles result;
  if (!pose_)
    return result;
  result.handles = lay_out(plan_, values_, *pose_, by);
  if (shows_ghost())
    result.ghost = ghost_of(plan_, values_, *pose_);
  result.marked = marked_;
  for (const auto& one : result.handles)
    if (one.of == marked_)
      result.words = words(one);
  result.snapped = snapped_;
  result.snapped_to = snapped_to_;
  return result;
}

// -- the mouse -----------------------------------------------------------------------

void operation_handles::mark(const handle* what) {
  if (marked_ == what)
    return;
  if (what && !marked_) {
    cursor_ = in_.view.cursor().shape();
    in_.view.setCursor(Qt::PointingHandCursor);
  } else if (!what) {
    in_.view.setCursor(cursor_);
  }
  marked_ = what;
  layer_->update();
}

bool operation_handles::hover(QPointF at) {
  if (!pose_)
    return false;
  const auto all = laid();
  const auto* one = handle_at(all, at);
  mark(one ? one->of : nullptr);
  return one != nullptr;
}

void operation_handles::leave() {
  if (!drag_)
    mark(nullptr);
}

bool operation_handles::take(QPointF at) {
  if (!pose_ || !panel_.form())
    return false;
  const auto all = laid();
  const auto* one = handle_at(all, at);
  if (!one)
    return false;
  mark(one->of);
  drag_ = handle_drag{*one, *pose_, at, lens_of(in_.view)};
  before_ = {values_.at(one->of->parameter), in_.picked.surfaces()};
  panel_.preview().set_dragged(true);
  return true;
}

void operation_handles::drag(QPointF to, Qt::KeyboardModifiers modifiers) {
  if (!drag_ || !panel_.form())
    return;
  const bool free = is_free(modifiers);
  const auto* what = drag_->from.of;
  if (what->what == kind::place) {
    move_place(to + (drag_->from.knob - drag_->pressed), free);
  } else {
    const auto found = drag_to(*drag_, to, free);
    snapped_to_ = found.snapped;
    panel_.form()->set_values({{what->parameter, found.value}});
  }
  layer_->update();
  emit dragged();
}

void operation_handles::end_drag() {
  if (!drag_)
    return;
  drag_.reset();
  snapped_.reset();
  panel_.preview().set_dragged(false);
  emit dropped();
}

/// Its field has the keys then, and what is typed replaces what it has.
void operation_handles::drop() {
  if (!drag_)
    return;
  const auto field = QString::fromStdString(drag_->from.of->parameter);
  end_drag();
  if (auto* widget = panel_.form() ? panel_.form()->findChild<QWidget*>(field) : nullptr)
    widget->setFocus(Qt::TabFocusReason);
  layer_->update();
}

bool operation_handles::cancel() {
  if (!drag_)
    return false;
  const auto parameter = drag_->from.of->parameter;
  end_drag();
  if (in_.picked.surfaces() != before_.picked)
    in_.picked.set(before_.picked);
  if (panel_.form())
    panel_.form()->set_values({{parameter, before_.value}});
  return true;
}

// -- the place -----------------------------------------------------------------------

void operation_handles::move_place(QPointF to, bool free) {
  const auto* head = in_.part.head();
  if (head && head->surface)
    put_place(in_.view.pick_at(to, head->surface->version_id()), to, free);
}

bool operation_handles::take_place(const picked_point& at, bool free) {
  const auto* head = in_.part.head();
  auto* form = panel_.form();
  if (panel_.chosen().isEmpty() || !form || !head || !head->surface)
    return false;
  if (form->picks()) {
    const double reach = snap_reach * lens_of(in_.view).metres_per_pixel(at.at);
    if (head->surface->surfaces().contains(at.surface))  // Else of a preview only.
      form->take_pick(pick_words(*head->surface, at.surface, on_head(at), reach));
    return true;
  }
  if (!form->has_place())
    return false;
  put_place(at, in_.view.to_widget(at.at), free);
  return true;
}

/// Of what is drawn, which may be a preview with other triangles, and is not deformed then.
vec3 operation_handles::on_head(const picked_point& hit) const {
  const auto& surface = *in_.part.head()->surface;
  auto wanted = make_probe(0, hit.surface, hit.vertices, hit.weights, surface);
  if (panel_.preview().shown()) {
    wanted.place.at = hit.at;
    if (const auto place = locate(wanted, surface))
      wanted.place.at = place->at;
  }
  return wanted.place.at;
}

/// In sight: its wall looks at the viewer, and nothing else of the part is before it.
bool operation_handles::sees(const snap_place& place) const {
  const QPointF pointer = in_.view.to_widget(place.at);
  const auto [from, to] = lens_of(in_.view).ray(pointer);
  const vec3 ahead = normalized(to - from);
  if (place.wall && dot(place.normal, ahead) > 0)
    return false;
  const auto hit = in_.view.pick_at(pointer, in_.part.head()->surface->version_id());
  if (!hit || std::ranges::find(place.surfaces, hit->surface) != place.surfaces.end())
    return true;
  const double tolerance = 1e-3 * norm(to - from);
  return dot(hit->at - place.at, ahead) > -tolerance;
}

void operation_handles::put_place(const std::optional<picked_point>& hit, QPointF pointer,
                                  bool free) {
  const auto& known = in_.part.head()->surface->surfaces();
  if (hit && !known.contains(hit->surface))
    return;  // Of a preview only.
  std::optional<vec3> at = hit ? std::optional(on_head(*hit)) : std::nullopt;
  auto wall = hit ? std::optional(hit->surface) : std::nullopt;
  std::optional<snapped_place> held;
  if (!free && places_)
    held = snap(*places_, pointer, lens_of(in_.view), at.value_or(vec3{}),
                wall.value_or(std::numeric_limits<surface_id>::min()),
                [this](const snap_place& one) { return sees(one); });
  if (held) {
    at = held->at;
    wall = held->wall ? held->wall : wall;
  }
  snapped_ = held ? std::optional(held->at) : std::nullopt;
  snapped_to_ = held ? held->words : QString();
  if (!at)
    return;
  const std::vector<surface_id> picks = wall ? std::vector{*wall} : std::vector<surface_id>{};
  if (plan_.takes_wall && wall && in_.picked.surfaces() != picks)
    in_.picked.set(picks);
  panel_.form()->set_place(*at);
}

}  // namespace tedit::desktop
