// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/deform/drag.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "mesh/pieces.hpp"
#include "mesh/place_text.hpp"
#include "mesh/quality.hpp"
#include "ops/shapes/deform/smooth_field.hpp"

namespace tedit::ops {

namespace {

/// No tet may come out worse, unless one was before: nothing is meshed anew here that could mend
/// it.
constexpr double least_quality = lowest_boolean_quality;

/// Of the part's volume: what is left of a change where it is to be kept.
constexpr double volume_rest = 1e-13;
constexpr int volume_steps = 30;

std::vector<vertex_id> united(const std::vector<vertex_id>& a, const std::vector<vertex_id>& b) {
  std::vector<vertex_id> result;
  std::ranges::set_union(a, b, std::back_inserter(result));
  return result;
}

/// The tets around free vertices, and which of the mesh's vertices theirs are.
struct numbered_piece {
  field_piece piece;
  std::vector<vertex_id> vertices;
};

numbered_piece piece_of(const mesh_version& mesh, const deform_zone& zone) {
  numbered_piece result;
  std::vector<std::uint32_t> number(mesh.vertex_slots(), no_id);
  const auto is_free = [&](vertex_id v) { return std::ranges::binary_search(zone.free, v); };
  for (const auto t : zone.tets) {
    const auto& corner = mesh.tet_at(t).v;
    if (std::ranges::none_of(corner, is_free))
      continue;
    auto& row = result.piece.tets.emplace_back();
    for (int i = 0; i < 4; ++i) {
      auto& n = number[corner[i]];
      if (n == no_id) {
        n = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(corner[i]);
        result.piece.at.push_back(mesh.position(corner[i]));
        result.piece.is_free.push_back(is_free(corner[i]));
      }
      row[i] = n;
    }
  }
  return result;
}

/// By how much the volume grows as each vertex of the piece moves, m^2; 0 inside the part.
std::vector<vec3> volume_slopes(const mesh_version& mesh, const std::vector<facet_id>& facets,
                                const std::vector<vertex_id>& vertices) {
  std::vector<vec3> by_slot(mesh.vertex_slots());
  for (const auto f : facets)
    for (const auto v : mesh.facet(f).v)
      by_slot[v] += area_vector(mesh, mesh.facet(f)) / 3;
  std::vector<vec3> result;
  for (const auto v : vertices)
    result.push_back(by_slot[v]);
  return result;
}

}  // namespace

expected<drag> drag::prepare(const version_ptr& mesh, const drag_handle& handle, deform_zone zone,
                             vec3 direction, bool keep_volume, const execution& run) {
  drag result(mesh, united(handle.vertices, zone.free));
  result.direction_ = direction;
  result.number_.assign(mesh->vertex_slots(), no_id);
  for (std::uint32_t i = 0; i < result.moved_.size(); ++i)
    result.number_[result.moved_[i]] = i;
  for (facet_id f = 0; f < mesh->facet_slots(); ++f)
    if (mesh->is_live_facet(f) && std::ranges::any_of(mesh->facet(f).v, [&](vertex_id v) {
          return result.number_[v] != no_id;
        }))
      result.facets_.push_back(f);
  for (const auto t : zone.tets)
    result.worst_before_ = std::min(result.worst_before_, radius_ratio(mesh->corners(t)));
  result.share_.assign(result.moved_.size(), 1);
  result.moves_all_ = std::ranges::all_of(zone.tets, [&](tet_id t) {
    return std::ranges::all_of(mesh->tet_at(t).v,
                               [&](vertex_id v) { return result.number_[v] != no_id; });
  });
  const auto piece = piece_of(*mesh, zone);
  result.tets_ = std::move(zone.tets);
  const bool nothing_bends = result.moves_all_ || zone.free.empty();
  if (keep_volume && nothing_bends)
    return fail(ec::invalid_parameter, "nothing within reach can give way to keep the volume",
                "Take a larger reach, or let the volume change");
  if (nothing_bends)
    return result;
  const auto field = smooth_field::create(piece.piece);
  if (!field)
    return fail(field.error());
  if (auto done = result.find_shares(*field, piece.vertices, run); !done)
    return fail(done.error());
  if (keep_volume)
    if (auto done = result.find_give_way(*field, piece.vertices, run); !done)
      return fail(done.error());
  return result;
}

expected<void> drag::find_shares(const smooth_field& field, const std::vector<vertex_id>& vertices,
                                 const execution& run) {
  std::vector<double> given;
  for (const auto v : vertices)
    given.push_back(number_[v] == no_id ? 0 : 1);
  const auto shares = field.through(given, run.cancel);
  if (!shares)
    return fail(shares.error());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (const auto n = number_[vertices[i]]; n != no_id)
      share_[n] = (*shares)[i];
  return {};
}

expected<void> drag::find_give_way(const smooth_field& field,
                                   const std::vector<vertex_id>& vertices, const execution& run) {
  const auto slopes = volume_slopes(*mesh_, facets_, vertices);
  give_way_.assign(moved_.size(), {});
  for (const auto axis : {&vec3::x, &vec3::y, &vec3::z}) {
    std::vector<double> load;
    for (const auto& s : slopes)
      load.push_back(s.*axis);
    const auto bent = field.bent_by(load, run.cancel);
    if (!bent)
      return fail(bent.error());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (const auto n = number_[vertices[i]]; n != no_id)
        give_way_[n].*axis = (*bent)[i];
  }
  double largest = 0;
  for (const auto& g : give_way_)
    largest = std::max(largest, norm(g));
  if (!(largest > 0))
    return fail(ec::invalid_parameter, "nothing within reach can give way to keep the volume",
                "Take a larger reach, or let the volume change");
  for (auto& g : give_way_)
    g = g / largest;
  return {};
}

vec3 drag::place_of(vertex_id v, const std::vector<vec3>& places) const {
  const auto n = number_[v];
  return n == no_id ? mesh_->position(v) : places[n];
}

/// By the boundary around what moved, m^3: its rim stays.
double drag::boundary_change(const std::vector<vec3>& places) const {
  if (facets_.empty())
    return 0;
  const vec3 apex = mesh_->position(mesh_->facet(facets_.front()).v[0]);
  const auto cone = [&](vec3 a, vec3 b, vec3 c) {
    return dot(a - apex, cross(b - apex, c - apex)) / 6;
  };
  double change = 0;
  for (const auto f : facets_) {
    const auto& v = mesh_->facet(f).v;
    change += cone(place_of(v[0], places), place_of(v[1], places), place_of(v[2], places)) -
              cone(mesh_->position(v[0]), mesh_->position(v[1]), mesh_->position(v[2]));
  }
  return change;
}

/// Where the moved vertices are. The volume is a cubic of how far they give way: secants find its
/// root. Errors: `inverted_tet` where there is none.
expected<std::vector<vec3>> drag::places_at(double distance) const {
  std::vector<vec3> dragged;
  for (std::size_t i = 0; i < moved_.size(); ++i)
    dragged.push_back(mesh_->position(moved_[i]) + distance * share_[i] * direction_);
  if (give_way_.empty())
    return dragged;
  const auto with = [&](double way) {
    auto result = dragged;
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] += way * give_way_[i];
    return result;
  };
  const double enough = volume_rest * total_volume(*mesh_);
  double before = 0;
  double off_before = boundary_change(dragged);
  double way = -1e-3 * distance;
  for (int step = 0; step < volume_steps; ++step) {
    auto places = with(way);
    const double off = boundary_change(places);
    if (std::abs(off) <= enough)
      return places;
    const double next = way - off * (way - before) / (off - off_before);
    before = std::exchange(way, next);
    off_before = off;
    if (!std::isfinite(way))
      break;
  }
  return fail(ec::inverted_tet,
              "what is within reach cannot give way so far as to keep the volume");
}

expected<void> drag::check_tets(const std::vector<vec3>& places) const {
  const double floor = std::min(least_quality, worst_before_);
  double worst = 1;
  tet_id where = no_id;
  for (const auto t : tets_) {
    const auto& v = mesh_->tet_at(t).v;
    const double q = radius_ratio(place_of(v[0], places), place_of(v[1], places),
                                  place_of(v[2], places), place_of(v[3], places));
    if (q < worst)
      std::tie(worst, where) = std::pair(q, t);
  }
  if (where == no_id || worst >= floor * (1 - 1e-9))
    return {};
  const auto c = mesh_->corners(where);
  const auto place = place_text((c[0] + c[1] + c[2] + c[3]) / 4);
  const auto number = [](double q) { return format_number("%.3g", q); };
  if (const double before = radius_ratio(c); before < least_quality)
    return fail(ec::inverted_tet,
                "the tet near " + place + " is too flat already, q = " + number(before) +
                  ", and would become " + number(worst),
                "Give the part better tets there: improve_mesh");
  return fail(ec::inverted_tet, "the tet near " + place + " would become too flat: q = " +
                                  number(worst) + ", at least " + number(floor));
}

expected<edit_result> drag::by(double distance, const execution& run) const {
  if (run.cancel.cancelled())
    return fail(ec::cancelled, "the edit was cancelled");
  const auto places = places_at(distance);
  if (!places)
    return fail(places.error());
  if (auto good = check_tets(*places); !good)
    return fail(good.error());
  const auto met = boundary_.meets_itself(*places, run.cancel);
  if (!met)
    return fail(met.error());
  if (*met)
    return fail(ec::invalid_argument,
                "surface " + std::to_string((*met)->first) + " would run into surface " +
                  std::to_string((*met)->second) + " near " + place_text((*met)->at));
  mesh_builder builder(mesh_);
  for (std::size_t i = 0; i < moved_.size(); ++i)
    if (!((*places)[i] == mesh_->position(moved_[i])))
      builder.set_position(moved_[i], (*places)[i]);
  edit_result result;
  result.touched = builder.touched();
  result.candidate = builder.freeze();
  result.volume_change = boundary_volume_change(*mesh_, *result.candidate);
  result.improve = improvement::none;
  result.quality_floor = least_quality;
  return result;
}

}  // namespace tedit::ops
