// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/editor/measure_solids.hpp"

#include <algorithm>
#include <set>

#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace tedit::cad {

namespace {

/// The surfaces of each solid.
std::vector<std::set<int>> surfaces_of_solids(const part_model& part) {
  std::vector<std::set<int>> result;
  for (const auto& solid : solids_of(part.shape)) {
    auto& ids = result.emplace_back();
    for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next())
      if (const auto i = part.faces.FindIndex(faces.Current()); i > 0)
        for (const int id : part.facts.faces[static_cast<std::size_t>(i - 1)].ids)
          ids.insert(id);
  }
  return result;
}

/// A piece is called as the solid that it has most of its surfaces of.
void name_pieces(const part_model& before, part_model& part) {
  const auto old = surfaces_of_solids(before);
  part.facts.solids.clear();
  for (const auto& ids : surfaces_of_solids(part)) {
    std::size_t best = 0;
    std::ptrdiff_t most = -1;
    for (std::size_t i = 0; i < old.size(); ++i)
      if (const auto shared =
            std::ranges::count_if(ids, [&](int id) { return old[i].contains(id); });
          shared > most) {
        most = shared;
        best = i;
      }
    part.facts.solids.push_back(before.facts.solids.at(best));
  }
}

}  // namespace

void measure_solids(const part_model& before, part_model& part) {
  const auto solids = solids_of(part.shape);
  if (solids.size() != before.facts.solids.size())
    name_pieces(before, part);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    auto& row = part.facts.solids[i];
    row.area_mm2 = area_of(solids[i]);
    row.volume_mm3 = 0;
    for (TopExp_Explorer faces(solids[i], TopAbs_FACE); faces.More(); faces.Next())
      row.volume_mm3 += volume_below(TopoDS::Face(faces.Current()));
  }
}

}  // namespace tedit::cad
