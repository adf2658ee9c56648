// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/receipt.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "fem/receipt_successors.hpp"
#include "mesh/facet_pages.hpp"

namespace tedit::fem {

namespace {

std::string readable(double value) {
  char text[32];
  // People read 20000 N, not 2e+04 N.
  const bool large = std::abs(value) >= 1e4 && std::abs(value) < 1e7;
  std::snprintf(text, sizeof(text), large ? "%.0f" : "%.4g", value);
  return text;
}

/// What became of the surfaces of one item.
struct carried {
  std::vector<surface_id> left;        ///< Still there, changed or merged; areas below are m^2.
  std::map<surface_id, double> moved;  ///< Successor -> lost area that it stands for.
  double area_left_before = 0;         ///< Of the surfaces that are not lost.
  double area_moved = 0;               ///< Sum of `moved`.
};

class carrier {
public:
  carrier(const load_case& before, const mesh_version& from, const mesh_version& to,
          const std::vector<surface_change>& map, const carry_settings& settings)
      : name_(before.name),
        from_version_(from),
        to_version_(to),
        from_(surface_areas(from)),
        to_(surface_areas(to)),
        map_(map),
        settings_(settings) {}

  /// Appends what is left of a constraint.
  void carry(const constraint& before, const std::string& item, std::vector<constraint>& after) {
    auto line = begin_line(item);
    const auto now = follow(before.surfaces, line);
    auto surfaces = now.left;
    for (const auto& [id, area] : now.moved)
      add(surfaces, id);
    const auto& warning = finish_line(std::move(line), surfaces, "").warning;
    if (!surfaces.empty())
      after.push_back(
        {std::move(surfaces), before.kind, warning.empty() ? before.warning : warning});
  }

  /// Appends what is left of a load: one on the surfaces that are left, one for each successor.
  void carry(const load& before, const std::string& item, std::vector<load>& after) {
    auto line = begin_line(item);
    const auto now = follow(before.surfaces, line);
    const auto first = after.size();
    share(before, now, after);
    line.total_before = newtons(before, from_);
    std::vector<surface_id> surfaces;
    for (auto i = first; i < after.size(); ++i) {
      line.total_after += newtons(after[i], to_);
      for (const auto id : after[i].surfaces)
        add(surfaces, id);
    }
    const auto total = total_of(line, before);
    const auto& warning = finish_line(std::move(line), surfaces, total).warning;
    for (auto i = first; i < after.size(); ++i)
      after[i].warning = warning.empty() ? before.warning : warning;
  }

  std::vector<receipt_line> take_lines() { return std::move(lines_); }

private:
  static double area(const std::map<surface_id, double>& areas, surface_id id) {
    const auto found = areas.find(id);
    return found == areas.end() ? 0 : found->second;
  }

  static double area(const std::map<surface_id, double>& areas,
                     const std::vector<surface_id>& ids) {
    return std::accumulate(ids.begin(), ids.end(), 0.0,
                           [&](double sum, surface_id id) { return sum + area(areas, id); });
  }

  /// N: see `receipt_line::total_before`.
  static double newtons(const load& l, const std::map<surface_id, double>& areas) {
    if (const auto* p = std::get_if<pressure>(&l.kind))
      return changes_by_place(*p) ? 0 : p->pa * area(areas, l.surfaces);
    if (const auto* t = std::get_if<traction>(&l.kind))
      return norm(t->pa) * area(areas, l.surfaces);
    if (const auto* total = std::get_if<normal_force>(&l.kind))
      return total->total_n;
    return norm(force_of(l));
  }

  /// Of those kinds that have one; zero of a moment.
  static vec3 force_of(const load& l) {
    if (const auto* f = std::get_if<force>(&l.kind))
      return f->total_n;
    if (const auto* f = std::get_if<remote_force>(&l.kind))
      return f->total_n;
    if (const auto* f = std::get_if<bearing_force>(&l.kind))
      return f->total_n;
    return {};
  }

  static bool changes_by_place(const pressure& p) { return p.gradient_pa_m != vec3{}; }

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

  [[nodiscard]] receipt_line begin_line(const std::string& item) const {
    receipt_line line;
    line.load_case = name_;
    line.item = item;
    return line;
  }

  carried follow(const std::vector<surface_id>& surfaces, receipt_line& line) {
    carried now;
    for (const auto id : surfaces) {
      const double before = area(from_, id);
      line.area_before += before;
      const auto into = to_.contains(id) ? id : merged_into(id).value_or(id);
      if (to_.contains(into)) {
        now.area_left_before += before;
        add(now.left, into);
        if (into == id)
          add_parts(id, now.left);
      } else {
        line.surfaces_lost.push_back(id);
        if (settings_.policy == load_policy::move)
          hand_on(id, before, now);
      }
    }
    for (const auto& [id, share] : now.moved)
      line.moved_to.push_back(id);
    return now;
  }

  /// Shares a lost surface's area among its successors.
  void hand_on(surface_id lost, double area, carried& now) {
    if (!successors_)
      successors_.emplace(from_version_, to_version_);
    const auto weights = successors_->of(lost);
    double sum = 0;
    for (const auto& [id, weight] : weights)
      sum += weight;
    if (!(sum > 0))
      return;
    for (const auto& [id, weight] : weights)
      now.moved[id] += area * weight / sum;
    now.area_moved += area;
  }

  void share(const load& before, const carried& now, std::vector<load>& after) const {
    if (const auto* total = std::get_if<force>(&before.kind))
      share_total(*total, now, after);
    else if (const auto* along_normal = std::get_if<normal_force>(&before.kind))
      share_total(*along_normal, now, after);
    else if (const auto* pin = std::get_if<bearing_force>(&before.kind))
      share_total(*pin, now, after);
    else if (std::holds_alternative<moment>(before.kind) ||
             std::holds_alternative<remote_force>(before.kind))
      spread_anew(before, now, after);
    else
      share_pressure(before, now, after);
  }

  /// The total goes to what is left and to successors, by the area that they stand for.
  template <class Total>
  static void share_total(const Total& total, const carried& now, std::vector<load>& after) {
    const double all = now.area_left_before + now.area_moved;
    const auto part = [&](double area) {
      return area == all ? total : Total{(area / all) * total.total_n};
    };
    if (!now.left.empty())
      after.push_back({now.left, now.moved.empty() ? total : part(now.area_left_before)});
    for (const auto& [id, area] : now.moved)
      after.push_back({{id}, on_successor(part(area))});
  }

  template <class Total>
  static Total on_successor(const Total& total) {
    return total;
  }

  /// Where its bore is gone a pin finds no wall to press on; its force acts all the same.
  static force on_successor(const bearing_force& pin) { return {pin.total_n}; }

  /// A couple has no parts by area: it acts on all surfaces together.
  static void spread_anew(const load& before, const carried& now, std::vector<load>& after) {
    auto surfaces = now.left;
    for (const auto& [id, area] : now.moved)
      add(surfaces, id);
    if (!surfaces.empty())
      after.push_back({std::move(surfaces), before.kind});
  }

  /// What is left keeps its Pa; a successor gets the lost newtons on its own area. One that changes
  /// by place, as a liquid's, is the same wherever its wall is.
  void share_pressure(const load& before, const carried& now, std::vector<load>& after) const {
    if (!now.left.empty())
      after.push_back({now.left, before.kind});
    const auto* p = std::get_if<pressure>(&before.kind);
    const bool keep = settings_.keep_traction || (p && changes_by_place(*p));
    for (const auto& [id, lost] : now.moved) {
      const double factor = keep ? 1 : lost / area(to_, id);
      // With its Pa kept, a surface that has the load already needs no second one.
      if (keep && std::ranges::find(now.left, id) != now.left.end())
        continue;
      auto moved = before;
      moved.surfaces = {id};
      if (auto* t = std::get_if<traction>(&moved.kind))
        t->pa = factor * t->pa;
      else
        std::get<pressure>(moved.kind).pa *= factor;
      after.push_back(std::move(moved));
    }
  }

  static std::string total_of(const receipt_line& line, const load& before) {
    if (const auto* p = std::get_if<pressure>(&before.kind); p && changes_by_place(*p))
      return "its pressure by place kept";
    if (const auto* m = std::get_if<moment>(&before.kind))
      return "moment " + readable(norm(m->total_nm)) + " N m kept";
    const bool is_force = !std::holds_alternative<traction>(before.kind) &&
                          !std::holds_alternative<pressure>(before.kind);
    const double change = std::abs(line.total_after - line.total_before);
    if (change > 1e-9 * std::abs(line.total_before))
      return "total changed from " + readable(line.total_before) + " to " +
             readable(line.total_after) + " N";
    return (is_force ? "total force " : "total ") + readable(line.total_after) + " N kept";
  }

  static std::string list(const std::vector<surface_id>& ids) {
    std::string text;
    for (const auto id : ids)
      text += (text.empty() ? "" : ", ") + std::to_string(id);
    return text;
  }

  /// The surfaces with their names, where they have one.
  [[nodiscard]] std::string named_list(const std::vector<surface_id>& ids) const {
    std::string text;
    for (const auto id : ids) {
      const auto* row = to_version_.find_surface(id);
      text += (text.empty() ? "" : ", ") + std::to_string(id);
      if (row && !row->name.empty())
        text += " (" + row->name + ")";
    }
    return text;
  }

  /// A sentence that can stand by itself beside a result.
  [[nodiscard]] std::string area_warning(const receipt_line& line,
                                         const std::vector<surface_id>& after) const {
    if (line.moved_to.empty() || !(line.area_after > much_larger * line.area_before))
      return {};
    return "an edit moved " + line.item + " from " + readable(1e6 * line.area_before) + " mm2 to " +
           readable(1e6 * line.area_after) + " mm2 (surface " + named_list(after) +
           "): check that it may act on all of that";
  }

  /// `total` is a clause about newtons; empty for constraints.
  const receipt_line& finish_line(receipt_line line, const std::vector<surface_id>& after,
                                  std::string total) {
    line.area_after = area(to_, after);
    const double change = line.area_before > 0 ? 100 * (line.area_after / line.area_before - 1) : 0;
    const auto percent = (change > 0 ? "+" : "") + readable(change) + " %";
    if (!total.empty())
      total.insert(0, "; ");
    const auto lost = list(line.surfaces_lost);
    if (after.empty()) {
      line.fate = receipt_fate::dropped;
      line.text = line.item + " no longer acts: surface " + lost + " is gone" +
                  (settings_.policy == load_policy::move ? " and none took its place" : "");
    } else if (!line.moved_to.empty()) {
      line.fate = receipt_fate::moved;
      line.text = line.item + ": surface " + lost + " is gone, its share moved to surface " +
                  named_list(line.moved_to) + total;
    } else if (!line.surfaces_lost.empty()) {
      line.fate = receipt_fate::reduced;
      line.text = line.item + " lost surface " + lost + " and now acts on " + list(after) +
                  " (area " + percent + ")" + total;
    } else if (std::abs(change) > 1e-9) {
      line.fate = receipt_fate::area_changed;
      line.text = line.item + ": area of surface " + list(after) + " is now " +
                  readable(1e6 * line.area_after) + " mm2 (" + percent + ")" + total;
    } else {
      line.text = line.item + " is as before";
    }
    line.warning = area_warning(line, after);
    return lines_.emplace_back(std::move(line));
  }

  std::string name_;
  const mesh_version& from_version_;
  const mesh_version& to_version_;
  std::map<surface_id, double> from_;
  std::map<surface_id, double> to_;
  const std::vector<surface_change>& map_;
  const carry_settings& settings_;
  std::optional<successors> successors_;  ///< Made when the first surface is lost.
  std::vector<receipt_line> lines_;
};

std::string constraint_name(const constraint& item, std::size_t index) {
  constexpr std::array names{"fixed", "displacement", "roller"};
  return "constraint " + std::to_string(index) + " (" + names[item.kind.index()] + ")";
}

std::string load_name(const load& item, std::size_t index) {
  constexpr std::array names{"force",        "traction", "pressure",     "gravity",
                             "normal force", "moment",   "remote force", "bearing force"};
  static_assert(names.size() == std::variant_size_v<decltype(item.kind)>);
  return "load " + std::to_string(index) + " (" + names[item.kind.index()] + ")";
}

}  // namespace

std::string_view policy_name(load_policy policy) noexcept {
  constexpr std::array names{"drop", "move", "refuse"};
  return names[static_cast<std::size_t>(policy)];
}

expected<load_policy> policy_from_name(std::string_view name) {
  for (const auto policy : {load_policy::drop, load_policy::move, load_policy::refuse})
    if (policy_name(policy) == name)
      return policy;
  return fail(ec::invalid_argument, "there is no policy \"" + std::string(name) + "\" for loads",
              "Take drop, move or refuse");
}

std::string_view fate_name(receipt_fate fate) noexcept {
  constexpr std::array names{"kept", "area_changed", "reduced", "dropped", "moved"};
  return names[static_cast<std::size_t>(fate)];
}

carried_load_case carry_over(const load_case& before, const mesh_version& from,
                             const mesh_version& to, const std::vector<surface_change>& map,
                             const carry_settings& settings) {
  carrier work(before, from, to, map, settings);
  carried_load_case result;
  result.after.name = before.name;
  result.after.materials = before.materials;
  for (std::size_t i = 0; i < before.constraints.size(); ++i)
    work.carry(before.constraints[i], constraint_name(before.constraints[i], i),
               result.after.constraints);
  for (std::size_t i = 0; i < before.loads.size(); ++i) {
    const auto& item = before.loads[i];
    if (std::holds_alternative<gravity>(item.kind))
      result.after.loads.push_back(item);
    else
      work.carry(item, load_name(item, i), result.after.loads);
  }
  result.lines = work.take_lines();
  return result;
}

expected<void> refuse_losses(const std::vector<receipt_line>& lines) {
  std::string losses;
  for (const auto& line : lines) {
    if (line.surfaces_lost.empty())
      continue;
    losses += losses.empty() ? "" : "; ";
    losses += (line.load_case.empty() ? "" : "load case " + line.load_case + ": ") + line.item +
              (line.surfaces_lost.size() == 1 ? " acts on surface" : " acts on surfaces");
    for (const auto id : line.surfaces_lost)
      losses += (id == line.surfaces_lost.front() ? " " : ", ") + std::to_string(id);
  }
  if (losses.empty())
    return {};
  return fail(ec::postcondition_failed,
              "the edit takes away surfaces that loads or supports need: " + losses,
              "Put them elsewhere first, or let the edit move or drop them");
}

}  // namespace tedit::fem
