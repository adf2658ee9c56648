// SPDX-License-Identifier: AGPL-3.0-or-later
#include "compare/load_differences.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "base/text.hpp"

namespace tedit {

namespace {

/// Every digit that the number has, and no more.
std::string number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

/// What a load case says, by the names of its file: one row for each number and name.
class load_case_rows {
public:
  explicit load_case_rows(const fem::load_case& from) {
    for (const auto& m : from.materials)
      add_material(m);
    for (std::size_t i = 0; i < from.constraints.size(); ++i)
      add_item("constraints", i, from.constraints[i]);
    for (std::size_t i = 0; i < from.loads.size(); ++i)
      add_item("loads", i, from.loads[i]);
  }

  [[nodiscard]] const std::map<std::string, std::string>& rows() const { return rows_; }

private:
  void add_material(const fem::material& m) {
    at_ = "materials[" + m.name + "]";
    add("young_modulus_pa", m.young_modulus_pa);
    add("poisson_ratio", m.poisson_ratio);
    add("density_kg_m3", m.density_kg_m3);
    add("yield_strength_pa", m.yield_strength_pa);
    rows_[at_ + ".regions"] = m.regions.empty() ? "all others" : list_of(m.regions);
  }

  template <class Item>
  void add_item(const char* list, std::size_t i, const Item& item) {
    at_ = std::string(list) + "[" + std::to_string(i) + "]";
    if (!item.surfaces.empty())
      rows_[at_ + ".surfaces"] = list_of(item.surfaces);
    std::visit([&](const auto& kind) { add_kind(kind); }, item.kind);
  }

  void add(const std::string& name, double value) { rows_[at_ + "." + name] = number(value); }
  void add(const std::string& name, const std::optional<double>& value) {
    rows_[at_ + "." + name] = value ? number(*value) : "free";
  }
  void add(const std::string& name, const vec3& v) {
    add(name + ".x", v.x);
    add(name + ".y", v.y);
    add(name + ".z", v.z);
  }

  void add_kind(const fem::fixed&) { rows_[at_ + ".fixed"] = "yes"; }
  void add_kind(const fem::roller&) { rows_[at_ + ".roller"] = "yes"; }
  void add_kind(const fem::prescribed_displacement& d) {
    add("displacement.x_m", d.x_m);
    add("displacement.y_m", d.y_m);
    add("displacement.z_m", d.z_m);
  }
  void add_kind(const fem::force& f) { add("force.total_n", f.total_n); }
  void add_kind(const fem::traction& t) { add("traction.pa", t.pa); }
  void add_kind(const fem::gravity& g) { add("gravity.m_s2", g.m_s2); }
  void add_kind(const fem::normal_force& f) { add("normal_force.total_n", f.total_n); }
  void add_kind(const fem::moment& m) { add("moment.total_nm", m.total_nm); }
  void add_kind(const fem::bearing_force& f) { add("bearing_force.total_n", f.total_n); }
  void add_kind(const fem::pressure& p) {
    add("pressure.pa", p.pa);
    if (p.gradient_pa_m == vec3{})
      return;
    add("pressure.gradient_pa_m", p.gradient_pa_m);
    add("pressure.at_m", p.at_m);
  }
  void add_kind(const fem::remote_force& f) {
    add("remote_force.total_n", f.total_n);
    add("remote_force.at_m", f.at_m);
    add("remote_force.moment_nm", f.moment_nm);
  }

  std::string at_;
  std::map<std::string, std::string> rows_;
};

}  // namespace

std::vector<std::string> differences_of(const fem::load_case& before, const fem::load_case& after) {
  const load_case_rows was(before);
  const load_case_rows is(after);
  std::vector<std::string> result;
  for (const auto& [name, value] : was.rows()) {
    const auto other = is.rows().find(name);
    if (other == is.rows().end())
      result.push_back(name + ": " + value + " -> none");
    else if (other->second != value)
      result.push_back(name + ": " + value + " -> " + other->second);
  }
  for (const auto& [name, value] : is.rows())
    if (!was.rows().contains(name))
      result.push_back(name + ": none -> " + value);
  return result;
}

std::vector<region_volume> region_volumes(const mesh_version& mesh) {
  std::map<region_id, double> sums;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t))
      continue;
    const auto c = mesh.corners(t);
    sums[mesh.region_of(t)] += dot(c[1] - c[0], cross(c[2] - c[0], c[3] - c[0])) / 6;
  }
  std::vector<region_volume> result;
  for (const auto& [region, volume] : sums)
    result.push_back({region, volume});
  return result;
}

std::optional<double> mass_of(std::span<const region_volume> volumes, const fem::load_case& loads) {
  double sum = 0;
  for (const auto& [region, volume] : volumes) {
    const fem::material* of = nullptr;
    for (const auto& m : loads.materials)  // One that names the region goes before one for all.
      if (std::ranges::count(m.regions, region) > 0 || (m.regions.empty() && !of))
        of = &m;
    if (!of || !(of->density_kg_m3 > 0))
      return std::nullopt;
    sum += of->density_kg_m3 * volume;
  }
  return sum;
}

}  // namespace tedit
