// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/receipt.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace tedit::fem {

namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return text;
}

std::map<surface_id, double> areas_of(const mesh_version& mesh) {
  std::map<surface_id, double> areas;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      areas[mesh.facet(f).surface] += norm(area_vector(mesh, mesh.facet(f)));
  const auto& interfaces = mesh.data().interfaces;
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    const auto& v = interfaces[i].v;
    areas[interfaces[i].surface] +=
      norm(area_vector(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])));
  }
  return areas;
}

class carrier {
public:
  carrier(const load_case& before, const mesh_version& from, const mesh_version& to,
          const std::vector<surface_change>& map)
      : name_(before.name), from_(areas_of(from)), to_(areas_of(to)), map_(map) {}

  /// The surfaces of one item after the edit; writes its line.
  std::vector<surface_id> carry(const std::vector<surface_id>& surfaces, const std::string& item,
                                bool total_kept) {
    receipt_line line;
    line.load_case = name_;
    line.item = item;
    std::vector<surface_id> after;
    for (const auto id : surfaces) {
      line.area_before += area(from_, id);
      if (to_.contains(id)) {
        add(after, id);
        add_parts(id, after);
      } else if (const auto into = merged_into(id)) {
        add(after, *into);
      } else {
        line.surfaces_lost.push_back(id);
      }
    }
    for (const auto id : after)
      line.area_after += area(to_, id);
    describe(line, after, total_kept);
    lines_.push_back(std::move(line));
    return after;
  }

  std::vector<receipt_line> take_lines() { return std::move(lines_); }

private:
  static double area(const std::map<surface_id, double>& areas, surface_id id) {
    const auto found = areas.find(id);
    return found == areas.end() ? 0 : found->second;
  }

  static void add(std::vector<surface_id>& list, surface_id id) {
    if (std::ranges::find(list, id) == list.end())
      list.push_back(id);
  }

  void add_parts(surface_id id, std::vector<surface_id>& after) const {
    for (const auto& change : map_)
      if (change.fate == surface_fate::split_from && change.other == id)
        add(after, change.id);
  }

  [[nodiscard]] std::optional<surface_id> merged_into(surface_id id) const {
    for (const auto& change : map_)
      if (change.id == id && change.fate == surface_fate::merged_into)
        return change.other;
    return std::nullopt;
  }

  static std::string list(const std::vector<surface_id>& ids) {
    std::string text;
    for (const auto id : ids)
      text += (text.empty() ? "" : ", ") + std::to_string(id);
    return text;
  }

  static void describe(receipt_line& line, const std::vector<surface_id>& after, bool total_kept) {
    const double change = line.area_before > 0 ? 100 * (line.area_after / line.area_before - 1) : 0;
    const auto percent = (change > 0 ? "+" : "") + number(change) + " %";
    const std::string total = total_kept ? "; its total force is kept" : "";
    if (after.empty()) {
      line.fate = receipt_fate::dropped;
      line.text = line.item + " no longer acts: surface " + list(line.surfaces_lost) + " is gone";
    } else if (!line.surfaces_lost.empty()) {
      line.fate = receipt_fate::reduced;
      line.text = line.item + " lost surface " + list(line.surfaces_lost) + " and now acts on " +
                  list(after) + " (area " + percent + ")" + total;
    } else if (std::abs(change) > 1e-9) {
      line.fate = receipt_fate::area_changed;
      line.text = line.item + ": area of surface " + list(after) + " is now " +
                  number(1e6 * line.area_after) + " mm2 (" + percent + ")" + total;
    } else {
      line.text = line.item + " is as before";
    }
  }

  std::string name_;
  std::map<surface_id, double> from_;
  std::map<surface_id, double> to_;
  const std::vector<surface_change>& map_;
  std::vector<receipt_line> lines_;
};

std::string constraint_name(const constraint& item, std::size_t index) {
  constexpr std::array names{"fixed", "displacement", "roller"};
  return "constraint " + std::to_string(index) + " (" + names[item.kind.index()] + ")";
}

std::string load_name(const load& item, std::size_t index) {
  constexpr std::array names{"force", "traction", "pressure", "gravity"};
  return "load " + std::to_string(index) + " (" + names[item.kind.index()] + ")";
}

}  // namespace

std::string_view fate_name(receipt_fate fate) noexcept {
  switch (fate) {
    case receipt_fate::kept:
      return "kept";
    case receipt_fate::area_changed:
      return "area_changed";
    case receipt_fate::reduced:
      return "reduced";
    case receipt_fate::dropped:
      return "dropped";
  }
  return "kept";
}

carried_load_case carry_over(const load_case& before, const mesh_version& from,
                             const mesh_version& to, const std::vector<surface_change>& map) {
  carrier work(before, from, to, map);
  carried_load_case result;
  result.after = before;
  result.after.constraints.clear();
  result.after.loads.clear();
  for (std::size_t i = 0; i < before.constraints.size(); ++i) {
    auto item = before.constraints[i];
    item.surfaces = work.carry(item.surfaces, constraint_name(item, i), false);
    if (!item.surfaces.empty())
      result.after.constraints.push_back(std::move(item));
  }
  for (std::size_t i = 0; i < before.loads.size(); ++i) {
    auto item = before.loads[i];
    if (std::holds_alternative<gravity>(item.kind)) {
      result.after.loads.push_back(std::move(item));
      continue;
    }
    item.surfaces =
      work.carry(item.surfaces, load_name(item, i), std::holds_alternative<force>(item.kind));
    if (!item.surfaces.empty())
      result.after.loads.push_back(std::move(item));
  }
  result.lines = work.take_lines();
  return result;
}

}  // namespace tedit::fem
