// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/checks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <unordered_set>

#include "base/sparse_numbers.hpp"
#include "base/text.hpp"
#include "mesh/face_key.hpp"
#include "mesh/facet_pages.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"
#include "mesh/slot_checks.hpp"

namespace tedit {

namespace {

/// One byte a vertex slot, 1 for those of the set: for questions about every tet or facet.
std::vector<std::uint8_t> marks_of(const std::unordered_set<vertex_id>& set, std::size_t slots) {
  std::vector<std::uint8_t> marks(slots, 0);
  for (const auto v : set)
    if (v < slots)
      marks[v] = 1;
  return marks;
}

/// The boundary facets around each vertex of a set. Cost: O(facets) of the pages nearby.
using vertex_facets = std::unordered_map<vertex_id, std::vector<facet_id>>;

vertex_facets facets_around(const mesh_version& mesh, const std::unordered_set<vertex_id>& set) {
  vertex_facets result;
  box around;
  for (const auto v : set)
    if (v < mesh.vertex_slots() && mesh.is_live_vertex(v))
      around.add(mesh.position(v));
  const auto marks = marks_of(set, mesh.vertex_slots());
  for_each_facet_near(mesh, around, [&](facet_id f) {
    for (const auto v : mesh.facet(f).v)
      if (marks[v])
        result[v].push_back(f);
  });
  return result;
}

/// The live tets that hold one of the vertices, ascending, also where their stars hang together at
/// the vertex alone: every part of a star that fills no whole ball has facets of the boundary
/// there. Cost: O(stars + facets of the pages nearby).
std::vector<tet_id> all_tets_around(const mesh_version& mesh,
                                    const std::unordered_set<vertex_id>& set) {
  const auto facets = facets_around(mesh, set);
  std::unordered_set<tet_id> found;
  std::vector<tet_id> star;
  for (const auto v : set) {
    star.clear();
    grow_star(mesh, v, mesh.incident_tet(v), star);
    if (const auto around = facets.find(v); around != facets.end())
      for (const auto f : around->second)
        grow_star(mesh, v, mesh.facet(f).tet, star);
    found.insert(star.begin(), star.end());
  }
  std::vector<tet_id> result(found.begin(), found.end());
  std::ranges::sort(result);
  return result;
}

/// Empty when the facets around v form one closed fan, else what is wrong.
std::string fan_fault(const mesh_version& mesh, vertex_id v, const std::vector<facet_id>& around) {
  // Each facet a -> v -> b: a fan is one cycle of the map a -> b.
  std::map<vertex_id, vertex_id> next;
  for (const auto f : around) {
    const auto& c = mesh.facet(f).v;
    const auto at = std::ranges::find(c, v) - c.begin();
    if (!next.emplace(c[(at + 2) % 3], c[(at + 1) % 3]).second)
      return "edge " + std::to_string(v) + "-" + std::to_string(c[(at + 2) % 3]) +
             " has more than two facets";
  }
  std::size_t steps = 0;
  for (auto at = next.begin()->first; steps < next.size();) {
    const auto row = next.find(at);
    if (row == next.end())
      return "edge " + std::to_string(v) + "-" + std::to_string(at) + " has one facet";
    at = row->second;
    ++steps;
    if (at == next.begin()->first)
      break;
  }
  return steps == next.size() ? "" : "more than one fan of facets meets there";
}

void check_counts(const mesh_version& mesh, slot_checks& checks) {
  const auto compare = [&](const char* what, std::size_t counted, std::size_t stated) {
    if (counted != stated)
      checks.add(ec::invalid_mesh, "counts are right", what,
                 std::to_string(counted) + " live, " + std::to_string(stated) + " stated");
  };
  std::size_t tets = 0;
  std::size_t facets = 0;
  std::size_t vertices = 0;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    tets += mesh.is_live_tet(t);
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    facets += mesh.is_live_facet(f);
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v)
    vertices += mesh.is_live_vertex(v);
  compare("tets", tets, mesh.tet_count());
  compare("facets", facets, mesh.facet_count());
  compare("vertices", vertices, mesh.vertex_count());
}

template <class Row, class Visit>
void for_each_changed(const paged_array<Row>& before, const paged_array<Row>& after,
                      Visit&& visit) {
  const auto& old_pages = before.pages();
  const auto& new_pages = after.pages();
  for (std::size_t p = 0; p < new_pages.size(); ++p) {
    if (p < old_pages.size() && old_pages[p]->id() == new_pages[p]->id())
      continue;
    const std::size_t first = p * paged_array<Row>::items_per_page;
    const auto items = after.page_items(p);
    for (std::size_t i = 0; i < items.size(); ++i)
      if (first + i >= before.size() || !(before[first + i] == items[i]))
        visit(static_cast<std::uint32_t>(first + i));
  }
}

/// One run of `check_edit`.
class edit_checks {
public:
  edit_checks(const mesh_version& base, const mesh_version& candidate, const edit_claim& claim)
      : base_(base),
        mesh_(candidate),
        claim_(claim),
        touched_(claim.touched.begin(), claim.touched.end()),
        slots_(candidate, report_) {}

  check_report run() {
    if (!slots_.check_sizes())
      return std::move(report_);
    // What did not change may point at slots that are no longer there.
    if (mesh_.tet_slots() < base_.tet_slots() || mesh_.vertex_slots() < base_.vertex_slots() ||
        mesh_.facet_slots() < base_.facet_slots())
      if (auto whole = check_version(mesh_); !whole.ok())
        return whole;
    check_tets();
    for_each_changed(base_.data().facets, mesh_.data().facets, [&](facet_id f) {
      if (mesh_.is_live_facet(f))
        slots_.check_corners(f);
    });
    if (!slots_.within_range())
      return std::move(report_);
    check_moved_vertices();
    check_facets();
    check_components();
    check_volume();
    check_quality();
    return std::move(report_);
  }

private:
  /// A part has one boundary at least: mostly there is nothing to compare.
  void check_components() {
    const auto after = boundary_components(mesh_);
    if (after <= 1 + claim_.bodies_added)
      return;
    const auto before = boundary_components(base_);
    if (after > before + claim_.bodies_added)
      slots_.add(ec::postcondition_failed, "no new closed void or separate boundary", "",
                 std::to_string(before) + " boundary components before, " + std::to_string(after) +
                   " after");
  }

  void check_tets() {
    const auto& before = base_.data();
    const auto& after = mesh_.data();
    std::unordered_set<tet_id> suspects;
    for_each_changed(before.tets, after.tets, [&](tet_id t) {
      changed_.insert(t);
      if (mesh_.is_live_tet(t)) {
        suspects.insert(t);
        if (!touched_.contains(t))
          slots_.add(ec::postcondition_failed, "untouched tets are identical", slot_name("tet", t),
                     "it changed but was not reported");
      }
    });
    const auto also = [&](tet_id t) {
      if (mesh_.is_live_tet(t))
        suspects.insert(t);
    };
    for_each_changed(before.neighbours, after.neighbours, also);
    for_each_changed(before.tet_regions, after.tet_regions, [&](tet_id t) {
      also(t);
      if (mesh_.is_live_tet(t) && !touched_.contains(t))
        slots_.add(ec::postcondition_failed, "untouched tets keep their region",
                   slot_name("tet", t), "");
    });
    for_each_changed(before.vertex_tet, after.vertex_tet, [&](vertex_id v) {
      if (mesh_.is_live_vertex(v))
        slots_.check_vertex(v);
    });
    for (const auto t : suspects)
      slots_.check_tet(t);
  }

  void check_moved_vertices() {
    std::unordered_set<vertex_id> moved;
    for_each_changed(base_.data().positions, mesh_.data().positions, [&](vertex_id v) {
      if (v < base_.vertex_slots() && base_.is_live_vertex(v) && mesh_.is_live_vertex(v))
        moved.insert(v);
    });
    if (moved.empty())
      return;
    for (const auto t : all_tets_around(mesh_, moved)) {
      changed_.insert(t);
      slots_.check_tet(t);
      if (!touched_.contains(t))
        slots_.add(ec::postcondition_failed, "untouched tets are identical", slot_name("tet", t),
                   "a corner moved");
    }
  }

  void check_facets() {
    std::unordered_set<vertex_id> rim;
    for_each_changed(base_.data().facets, mesh_.data().facets, [&](facet_id f) {
      if (mesh_.is_live_facet(f)) {
        slots_.check_facet(f);
        rim.insert(mesh_.facet(f).v.begin(), mesh_.facet(f).v.end());
      }
      if (f < base_.facet_slots() && base_.is_live_facet(f))
        rim.insert(base_.facet(f).v.begin(), base_.facet(f).v.end());
    });
    if (rim.empty())
      return;
    const auto before = facets_around(base_, rim);
    for (const auto& [v, around] : facets_around(mesh_, rim)) {
      const auto fault = fan_fault(mesh_, v, around);
      const auto old = before.find(v);
      // What was not manifold before the edit is not the edit's fault.
      if (!fault.empty() && (old == before.end() || fan_fault(base_, v, old->second).empty()))
        slots_.add(ec::non_manifold, "boundary is a 2-manifold", slot_name("vertex", v), fault);
    }
  }

  void check_volume() {
    double change = 0;
    double largest = 0;
    for (const auto t : changed_) {
      if (t < base_.tet_slots() && base_.is_live_tet(t)) {
        const double v = signed_volume(base_.corners(t));
        change -= v;
        largest += std::abs(v);
      }
      if (mesh_.is_live_tet(t)) {
        const double v = signed_volume(mesh_.corners(t));
        change += v;
        largest += std::abs(v);
      }
    }
    const double allowed =
      claim_.volume_tolerance * std::max(std::abs(claim_.volume_change), largest);
    if (!(std::abs(change - claim_.volume_change) <= allowed))
      slots_.add(ec::postcondition_failed, "volume changes as the operation says", "",
                 "it says " + format_number("%.4g", claim_.volume_change) + " m3, the tets say " +
                   format_number("%.4g", change) + " m3");
  }

  void check_quality() {
    double after = 1;
    tet_id worst = no_id;
    for (const auto t : touched_) {
      if (t >= mesh_.tet_slots() || !mesh_.is_live_tet(t))
        continue;
      const double q = radius_ratio(mesh_.corners(t));
      if (q < after)
        std::tie(after, worst) = std::tuple(q, t);
    }
    if (worst == no_id || after >= claim_.quality_floor)
      return;
    const double before = worst_quality_before(base_, mesh_, claim_.touched);
    // A floor that is no number allows nothing.
    if (!(after >= std::min(claim_.quality_floor, before) * (1 - 1e-9)))
      slots_.add(
        ec::postcondition_failed, "worst quality of the touched region", slot_name("tet", worst),
        "q = " + format_number("%.4g", after) + ", before " + format_number("%.4g", before) +
          ", floor " + format_number("%.4g", claim_.quality_floor));
  }

private:
  const mesh_version& base_;
  const mesh_version& mesh_;
  const edit_claim& claim_;
  std::unordered_set<tet_id> touched_;
  std::unordered_set<tet_id> changed_;
  check_report report_;
  slot_checks slots_;
};

}  // namespace

std::size_t boundary_components(const mesh_version& mesh) {
  sparse_numbers parent(mesh.vertex_slots());
  const auto root = [&](vertex_id v) {
    while (parent[v] != v) {
      parent.set(v, parent[parent[v]]);
      v = parent[v];
    }
    return v;
  };
  std::size_t count = 0;
  const auto& facets = mesh.data().facets;
  for (std::size_t p = 0; p < facets.pages().size(); ++p)
    for (const auto& f : facets.page_items(p)) {
      if (f.tet == no_id)
        continue;
      for (const auto v : f.v)
        if (parent[v] == sparse_numbers::none) {
          parent.set(v, v);
          ++count;
        }
      auto a = root(f.v[0]);
      for (const auto v : {f.v[1], f.v[2]}) {
        const auto b = root(v);
        count -= a != b;
        parent.set(std::max(a, b), std::min(a, b));
        a = std::min(a, b);
      }
    }
  return count;
}

check_report check_version(const mesh_version& mesh) {
  check_report report;
  slot_checks checks(mesh, report);
  if (!checks.check_sizes())
    return report;
  std::unordered_set<vertex_id> boundary;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t))
      checks.check_tet(t);
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.is_live_vertex(v))
      checks.check_vertex(v);
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    checks.check_facet(f);
    boundary.insert(mesh.facet(f).v.begin(), mesh.facet(f).v.end());
  }
  if (checks.within_range())
    for (const auto& [v, around] : facets_around(mesh, boundary))
      if (const auto fault = fan_fault(mesh, v, around); !fault.empty())
        checks.add(ec::non_manifold, "boundary is a 2-manifold", slot_name("vertex", v), fault);
  check_counts(mesh, checks);
  return report;
}

check_report check_edit(const mesh_version& base, const mesh_version& candidate,
                        const edit_claim& claim) {
  return edit_checks(base, candidate, claim).run();
}

double worst_quality_before(const mesh_version& base, const mesh_version& candidate,
                            const std::vector<tet_id>& touched) {
  std::unordered_set<vertex_id> corners;
  for (const auto t : touched)
    if (t < candidate.tet_slots() && candidate.is_live_tet(t))
      corners.insert(candidate.tet_at(t).v.begin(), candidate.tet_at(t).v.end());
  const std::vector<vertex_id> list(corners.begin(), corners.end());
  double worst = 1;
  for (const auto t : tets_around(base, list))
    worst = std::min(worst, radius_ratio(base.corners(t)));
  return worst;
}

error to_error(const check_report& report) {
  error result{ec::postcondition_failed, {}, {}, {}};
  if (report.ok())
    return result;
  const auto& first = report.findings.front();
  result.message =
    "the edit was rolled back: " + first.rule + " does not hold" +
    (first.element.empty() ? "" : " at " + first.element) +
    (first.numbers.empty() ? "" : " (" + first.numbers + ")") +
    (report.total > 1 ? " and " + std::to_string(report.total - 1) + " more findings" : "");
  result.where = first.element;
  result.remedy = "The version is unchanged; try other surfaces or parameters";
  return result;
}

}  // namespace tedit
