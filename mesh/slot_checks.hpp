// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "mesh/checks.hpp"
#include "mesh/face_key.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

/// For checks.cpp: what is looked at slot by slot.
namespace tedit {

inline std::string slot_name(const char* what, std::uint64_t id) {
  return std::string(what) + " " + std::to_string(id);
}

/// Looks at single slots of one version and collects findings.
class slot_checks {
public:
  slot_checks(const mesh_version& mesh, check_report& report) : mesh_(mesh), report_(report) {}

  void add(ec code, std::string rule, std::string element, std::string numbers) {
    if (++report_.total <= max_findings)
      report_.findings.push_back({code, std::move(rule), std::move(element), std::move(numbers)});
  }

  void check_tet(tet_id t) {
    const auto& v = mesh_.tet_at(t).v;
    for (const auto i : v) {
      if (i >= mesh_.vertex_slots() || !mesh_.is_live_vertex(i)) {
        add(ec::invalid_mesh, "corners exist", slot_name("tet", t), slot_name("vertex", i));
        within_range_ = within_range_ && i < mesh_.vertex_slots();
        return;
      }
    }
    const auto c = mesh_.corners(t);
    if (const int sign = orient3d(c[0], c[1], c[2], c[3]); sign <= 0)
      add(sign < 0 ? ec::inverted_tet : ec::degenerate_tet, "positive orientation",
          slot_name("tet", t), "volume " + format_number("%.4g", signed_volume(c)) + " m3");
    for (int face = 0; face < 4; ++face)
      check_face(t, face);
  }

  void check_facet(facet_id f) {
    const auto& facet = mesh_.facet(f);
    const bool known = facet.tet < mesh_.tet_slots() && mesh_.is_live_tet(facet.tet) &&
                       std::ranges::count(mesh_.neighbours(facet.tet), facet_flag | f) == 1;
    if (!known)
      add(ec::invalid_mesh, "facet lies on its tet", slot_name("facet", f),
          slot_name("tet", facet.tet));
    check_corners(f);
    if (!mesh_.find_surface(facet.surface))
      add(ec::surface_not_found, "facet has a surface of the table", slot_name("facet", f),
          "surface " + std::to_string(facet.surface));
  }

  /// Whether a facet's corners and tet are slots that there are.
  void check_corners(facet_id f) {
    const auto& facet = mesh_.facet(f);
    within_range_ = within_range_ && facet.tet < mesh_.tet_slots();
    for (const auto i : facet.v)
      if (i >= mesh_.vertex_slots()) {
        add(ec::invalid_mesh, "corners exist", slot_name("facet", f), slot_name("vertex", i));
        within_range_ = false;
        return;
      }
  }

  /// Arrays of one kind of slot have one length: without that nothing else can be looked at.
  [[nodiscard]] bool check_sizes() {
    const auto& data = mesh_.data();
    const auto fits = [&](const char* what, std::size_t one, std::size_t other) {
      if (one != other)
        add(ec::invalid_mesh, "arrays of one kind have one length", what,
            std::to_string(one) + " and " + std::to_string(other) + " slots");
      return one == other;
    };
    return fits("tets and neighbours", data.tets.size(), data.neighbours.size()) &&
           fits("tets and regions", data.tets.size(), data.tet_regions.size()) &&
           fits("vertices and their tets", data.positions.size(), data.vertex_tet.size());
  }

  /// False once a number of a slot was beyond those that there are: who walks from slot to slot
  /// would leave the arrays.
  [[nodiscard]] bool within_range() const { return within_range_; }

  void check_vertex(vertex_id v) {
    const auto t = mesh_.incident_tet(v);
    within_range_ = within_range_ && t < mesh_.tet_slots();
    if (t >= mesh_.tet_slots() || !mesh_.is_live_tet(t) ||
        !std::ranges::count(mesh_.tet_at(t).v, v))
      add(ec::invalid_mesh, "incident tet holds the vertex", slot_name("vertex", v),
          slot_name("tet", t));
  }

private:
  void check_face(tet_id t, int face) {
    const auto behind = mesh_.neighbours(t)[face];
    const auto key = make_face_key(mesh_.tet_at(t), face);
    if (is_facet(behind)) {
      const auto f = behind & ~facet_flag;
      within_range_ = within_range_ && f < mesh_.facet_slots();
      const bool fits = f < mesh_.facet_slots() && mesh_.facet(f).tet == t &&
                        make_face_key(mesh_.facet(f).v).v == key.v &&
                        make_face_key(mesh_.facet(f).v).odd == key.odd;
      if (!fits)
        add(ec::invalid_mesh, "boundary face has its facet", slot_name("tet", t),
            slot_name("facet", f));
      return;
    }
    bool fits = false;
    within_range_ = within_range_ && behind < mesh_.tet_slots();
    if (behind < mesh_.tet_slots() && mesh_.is_live_tet(behind)) {
      for (int back = 0; back < 4; ++back) {
        const auto other = make_face_key(mesh_.tet_at(behind), back);
        fits =
          fits || (mesh_.neighbours(behind)[back] == t && other.v == key.v && other.odd != key.odd);
      }
    }
    if (!fits)
      add(ec::invalid_mesh, "neighbours share a face", slot_name("tet", t),
          slot_name("neighbour", behind));
  }

  const mesh_version& mesh_;
  check_report& report_;
  bool within_range_ = true;
};

}  // namespace tedit
