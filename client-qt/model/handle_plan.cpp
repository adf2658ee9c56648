// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/handle_plan.hpp"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>

#include "base/metric_threads.hpp"

namespace tedit::desktop {

namespace {

using kind = handle::kind;

QStringList words_in(const std::string& text) {
  static const QRegularExpression between("[^a-z0-9]+");
  return QString::fromStdString(text).toLower().split(between, Qt::SkipEmptyParts);
}

bool any_of(const QStringList& words, std::initializer_list<const char*> wanted) {
  return std::ranges::any_of(wanted, [&](const char* w) { return words.contains(w); });
}

/// Names of threads, and maybe one for none.
bool is_thread(const ops::parameter_description& p) {
  const auto none = [](const std::string& name) { return !metric_thread_core(name); };
  return p.type == ops::parameter_type::choice && p.choices.size() > 1 &&
         std::ranges::count_if(p.choices, none) <= 1;
}

/// What people read goes before the id: a "Thickness" grows outward also where its id is "depth".
bool goes_inward(const ops::parameter_description& p) {
  for (const auto& words : {words_in(p.name), words_in(p.id)}) {
    if (any_of(words, {"depth", "offset"}))
      return true;
    if (any_of(words, {"height", "thickness", "distance"}))
      return false;
  }
  return false;
}

std::optional<handle> handle_of_length(const ops::parameter_description& p, bool has_profile) {
  handle h{kind::length, p.id, QString::fromStdString(p.name), "m", p.min, p.max};
  const auto words = words_in(p.id);
  if (any_of(words, {"diameter", "radius"})) {
    h.what = kind::ring;
    h.half = words.contains("radius") ? 1 : 0.5;
    return h;
  }
  if (has_profile && (p.id == "size" || p.id == "width")) {
    h.what = kind::span;
    h.half = 0.5;
    h.across = p.id == "width";
    return h;
  }
  if (!any_of(words, {"depth", "height", "distance", "offset"}))
    return std::nullopt;
  h.inward = goes_inward(p);
  return h;
}

std::optional<handle> handle_of(const ops::parameter_description& p, bool has_profile) {
  handle h{kind::place, p.id, QString::fromStdString(p.name), QString::fromStdString(p.unit)};
  switch (p.type) {
    case ops::parameter_type::point:
      return h;
    case ops::parameter_type::vector:
      h.what = kind::way;
      return h;
    case ops::parameter_type::direction:
      h.what = p.id == "along" || p.id == "up" ? kind::turn : kind::direction;
      h.either_way = words_in(p.name).contains("axis");
      return h;
    case ops::parameter_type::real:
      return p.unit == "m" ? handle_of_length(p, has_profile) : std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace

const handle* handle_plan::find(handle::kind what) const {
  const auto found = std::ranges::find(all, what, &handle::what);
  return found == all.end() ? nullptr : &*found;
}

const handle* handle_plan::find(const std::string& parameter) const {
  const auto found = std::ranges::find(all, parameter, &handle::parameter);
  return found == all.end() ? nullptr : &*found;
}

handle_plan plan_of(const ops::operation_description& about) {
  handle_plan plan;
  plan.takes_wall = about.selection.minimum == 0;
  const auto has = [&](const char* id, ops::parameter_type type) {
    return std::ranges::any_of(about.parameters,
                               [&](const auto& p) { return p.id == id && p.type == type; });
  };
  plan.has_profile = has("profile", ops::parameter_type::choice);
  plan.has_text = has("text", ops::parameter_type::text) && has("size", ops::parameter_type::real);
  for (const auto& p : about.parameters) {
    if (p.type == ops::parameter_type::real && p.unit == "rad")
      plan.angles.push_back(p.id);
    if (is_thread(p))
      plan.thread = p.id;
    auto h = handle_of(p, plan.has_profile);
    if (!h)
      continue;
    h->first = !plan.find(h->what);
    // A form has one place and one axis; a second of either would need a tool of its own.
    if (h->first || (h->what != kind::place && h->what != kind::direction && h->what != kind::turn))
      plan.all.push_back(std::move(*h));
  }
  const auto* normal = plan.find(kind::direction);
  plan.is_plane = plan.find(kind::place) && normal && normal->parameter == "normal";
  const auto plane = std::ranges::find(about.parameters, ops::parameter_type::plane,
                                       &ops::parameter_description::type);
  if (plan.is_plane && plane != about.parameters.end())
    plan.plane = plane->id;
  return plan;
}

}  // namespace tedit::desktop
