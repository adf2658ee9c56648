// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/probes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "client-qt/model/field_values.hpp"

namespace tedit::desktop {

namespace {

double squared(const vec3& v) {
  return dot(v, v);
}

/// Barycentric weights of the point on segment a-b that is nearest to p.
std::pair<double, double> on_segment(const vec3& p, const vec3& a, const vec3& b) {
  const double length = squared(b - a);
  const double t = length > 0 ? std::clamp(dot(p - a, b - a) / length, 0.0, 1.0) : 0;
  return {1 - t, t};
}

vec3 mixed(const std::array<vec3, 3>& corners, const std::array<double, 3>& weights) {
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

/// Weights of the point of a triangle that is nearest to p: inside, or the best of its edges.
std::array<double, 3> nearest(const vec3& p, const std::array<vec3, 3>& c) {
  const vec3 n = cross(c[1] - c[0], c[2] - c[0]);
  const double area = squared(n);
  if (area > 0) {
    const double u = dot(cross(c[2] - c[1], p - c[1]), n) / area;
    const double v = dot(cross(c[0] - c[2], p - c[2]), n) / area;
    if (u >= 0 && v >= 0 && u + v <= 1)
      return {u, v, 1 - u - v};
  }
  std::array<double, 3> best{};
  double least = INFINITY;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    std::array<double, 3> weights{};
    std::tie(weights[i], weights[j]) = on_segment(p, c[i], c[j]);
    if (const double far = squared(mixed(c, weights) - p); far < least) {
      least = far;
      best = weights;
    }
  }
  return best;
}

}  // namespace

vec3 nearest_on(const std::array<vec3, 3>& corners, const vec3& to) {
  return mixed(corners, nearest(to, corners));
}

probe make_probe(int number, surface_id surface, const std::array<std::uint32_t, 3>& vertices,
                 const std::array<double, 3>& weights, const client::surface_model& on) {
  probe result;
  result.number = number;
  result.surface = surface;
  result.place.vertices = vertices;
  result.place.weights = weights;
  for (std::size_t i = 0; i < 3; ++i)
    if (const auto* at = on.positions().find(vertices[i]))
      result.corners[i] = *at;
  result.place.at = mixed(result.corners, weights);
  return result;
}

std::optional<probe_place> locate(const probe& what, const client::surface_model& on) {
  auto wanted = what.place.vertices;
  std::ranges::sort(wanted);
  bool unchanged = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto* at = on.positions().find(what.place.vertices[i]);
    unchanged = unchanged && at && *at == what.corners[i];
  }
  std::optional<probe_place> best;
  double least = INFINITY;
  bool same = false;
  on.facets().for_each([&](std::uint32_t, const client::surface_facet& f) {
    if (same || f.surface != what.surface)
      return;
    std::array<std::uint32_t, 3> slots_here{f.v[0], f.v[1], f.v[2]};
    auto ascending = slots_here;
    std::ranges::sort(ascending);
    if (unchanged && ascending == wanted) {
      same = true;
      return;
    }
    std::array<vec3, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = *on.positions().find(f.v[i]);
    const auto weights = nearest(what.place.at, corners);
    const vec3 at = mixed(corners, weights);
    if (const double far = squared(at - what.place.at); far < least) {
      least = far;
      best = probe_place{slots_here, weights, at, false};
    }
  });
  return same ? std::optional(what.place) : best;
}

std::optional<double> value_at(const probe_place& place, const client::field_event& field,
                               shown_field wanted) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (place.weights[i] != 0)
      sum += place.weights[i] * value_at(field, place.vertices[i], wanted);
  return std::isfinite(sum) ? std::optional(sum) : std::nullopt;
}

// -- of a document -------------------------------------------------------------------

probes::probes(document& part, QObject* parent) : QObject(parent), part_(part) {
  connect(&part_, &document::begun, this, &probes::clear);
  for (auto signal : {&document::field_changed, &document::head_changed, &document::history_changed,
                      &document::surface_changed})
    connect(&part_, signal, this, [this] {
      if (!all_.empty())
        emit changed();
    });
}

void probes::add(surface_id surface, const std::array<std::uint32_t, 3>& vertices,
                 const std::array<double, 3>& weights) {
  const auto* head = part_.head();
  if (!head || !head->surface)
    return;
  all_.push_back(make_probe(++last_, surface, vertices, weights, *head->surface));
  emit changed();
  emit added(all_.back());
}

bool probes::put(int number, surface_id surface, const vec3& at) {
  const auto* head = part_.head();
  probe wanted;
  wanted.surface = surface;
  wanted.place.at = at;
  const auto place = head && head->surface ? locate(wanted, *head->surface) : std::nullopt;
  if (!place)
    return false;
  remove(number);
  last_ = number - 1;
  add(surface, place->vertices, place->weights);
  last_ = std::ranges::max(all_, {}, &probe::number).number;
  return true;
}

void probes::remove(int number) {
  std::erase_if(found_, [number](const auto& one) { return one.first.first == number; });
  if (std::erase_if(all_, [number](const probe& one) { return one.number == number; }) == 0)
    return;
  emit changed();
  emit removed(number);
}

void probes::clear() {
  const auto gone = std::exchange(all_, {});
  found_.clear();
  last_ = 0;
  emit changed();
  for (const auto& one : gone)
    emit removed(one.number);
}

std::optional<probe_place> probes::place(const probe& what, const version_record& in) const {
  if (!in.surface)
    return std::nullopt;
  auto [at, fresh] = found_.try_emplace({what.number, in.surface->version_id()});
  if (fresh)
    at->second = locate(what, *in.surface);
  return at->second;
}

std::optional<double> probes::distance(const probe& a, const probe& b,
                                       const version_record& in) const {
  const auto from = place(a, in);
  const auto to = place(b, in);
  return from && to ? std::optional(std::sqrt(squared(to->at - from->at))) : std::nullopt;
}

// -- by area -------------------------------------------------------------------------

histogram histogram_of(const client::surface_model& surface, const client::field_event& field,
                       shown_field wanted, std::size_t steps) {
  struct piece {
    double value;
    double area;
  };
  std::vector<piece> pieces;
  histogram result;
  result.low = INFINITY;
  result.high = -INFINITY;
  double total = 0;
  std::vector<float> by_slot(field.vertices.empty() ? 0 : field.vertices.back() + 1, NAN);
  const value_reader read(field.values, wanted);
  for (std::size_t i = 0; i < field.vertices.size(); ++i)
    by_slot[field.vertices[i]] = read(i);
  surface.facets().for_each([&](std::uint32_t, const client::surface_facet& f) {
    std::array<vec3, 3> corners{};
    double value = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = *surface.positions().find(f.v[i]);
      value += (f.v[i] < by_slot.size() ? by_slot[f.v[i]] : NAN) / 3.0;
    }
    if (!std::isfinite(value))
      return;
    const double area =
      0.5 * std::sqrt(squared(cross(corners[1] - corners[0], corners[2] - corners[0])));
    pieces.push_back({value, area});
    total += area;
    result.low = std::min(result.low, value);
    result.high = std::max(result.high, value);
  });
  if (pieces.empty() || total <= 0)
    return {};
  result.share.assign(steps, 0);
  const double width = (result.high - result.low) / static_cast<double>(steps);
  for (const auto& one : pieces) {
    const auto step = width > 0 ? static_cast<std::size_t>((one.value - result.low) / width) : 0;
    result.share[std::min(step, steps - 1)] += one.area / total;
  }
  return result;
}

}  // namespace tedit::desktop
