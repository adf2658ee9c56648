// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/support/random_edits.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "fem/receipt.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/quality.hpp"
#include "ops/services/host_services.hpp"

namespace tedit::test {

namespace {

double uniform(const number_source& numbers, double low, double high) {
  return low + (high - low) * (static_cast<double>(numbers() >> 11) * 0x1p-53);
}

std::size_t below(const number_source& numbers, std::size_t n) {
  return static_cast<std::size_t>(numbers() % n);
}

/// A list of one, or points within the part's size.
std::string some_numbers(const ops::parameter_description& p, const number_source& numbers,
                         double size) {
  if (p.type == ops::parameter_type::list)
    return std::to_string(uniform(numbers, p.min.value_or(0), p.max.value_or(1)));
  std::size_t count = 2;
  if (p.type == ops::parameter_type::polyline)
    count = static_cast<std::size_t>(std::max(p.min.value_or(2), 2.0)) + below(numbers, 4);
  std::string text;
  for (std::size_t i = 0; i < 3 * count; ++i)
    text += (i == 0       ? ""
             : i % 3 == 0 ? "; "
                          : ", ") +
            std::to_string(uniform(numbers, -0.5 * size, 0.5 * size));
  return text;
}

/// A value inside the range, now and then at its ends or left at the default.
void choose_value(const ops::parameter_description& p, const number_source& numbers, double size,
                  ops::parameters& values) {
  if (below(numbers, 3) == 0)
    return;
  const double low = p.min.value_or(0);
  // Lengths are drawn from what makes sense on the part.
  const double high = std::min(p.max.value_or(1), p.unit == "m" ? 0.05 * size : 1e3);
  switch (p.type) {
    case ops::parameter_type::boolean:
      values[p.id] = below(numbers, 2) == 1;
      break;
    case ops::parameter_type::integer:
      values[p.id] =
        static_cast<std::int64_t>(std::lround(uniform(numbers, low, std::min(high, low + 3))));
      break;
    case ops::parameter_type::real:
      values[p.id] = below(numbers, 20) == 0 ? low : uniform(numbers, low, std::max(low, high));
      break;
    case ops::parameter_type::choice:
      values[p.id] = p.choices[below(numbers, p.choices.size())];
      break;
    case ops::parameter_type::text:
    case ops::parameter_type::file:
      break;
    case ops::parameter_type::point:
    case ops::parameter_type::direction:
    case ops::parameter_type::vector: {
      // Most points are left to the wall: few of those in the air meet the part.
      if (p.type == ops::parameter_type::point && below(numbers, 4) != 0)
        break;
      const double reach = p.type == ops::parameter_type::point ? 0.5 * size : 1;
      std::string text;
      for (int axis = 0; axis < 3; ++axis)
        text += (axis > 0 ? "," : "") + std::to_string(uniform(numbers, -reach, reach));
      values[p.id] = text;
      break;
    }
    case ops::parameter_type::axis:
    case ops::parameter_type::plane:
    case ops::parameter_type::polyline:
    case ops::parameter_type::list:
      // Most are left out: they stand instead of others, or mean something for one choice only.
      if (below(numbers, 4) == 0)
        values[p.id] = some_numbers(p, numbers, size);
      break;
  }
}

/// Whether every page still has the bytes that it is known by.
bool is_intact(const mesh_version& mesh) {
  bool intact = true;
  mesh.for_each_page(
    [&](const page_ptr& p) { intact = intact && hash_bytes(p->bytes()) == p->id(); });
  return intact;
}

/// Facets and interface triangles of each surface.
std::map<surface_id, std::size_t> triangles_by_surface(const mesh_version& mesh) {
  std::map<surface_id, std::size_t> result;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      ++result[mesh.facet(f).surface];
  for (std::size_t i = 0; i < mesh.data().interfaces.size(); ++i)
    ++result[mesh.data().interfaces[i].surface];
  return result;
}

/// Every id of both tables is accounted for.
std::string surface_fault(const mesh_version& before, const mesh_version& after,
                          const std::vector<surface_change>& map) {
  const auto says = [&](surface_id id, surface_fate one, surface_fate other) {
    return std::ranges::any_of(map, [&](const surface_change& change) {
      return change.id == id && (change.fate == one || change.fate == other);
    });
  };
  using enum surface_fate;
  const auto triangles = triangles_by_surface(after);
  for (const auto& row : after.surfaces()) {
    if (!triangles.contains(row.id))
      return "surface " + std::to_string(row.id) + " has no facets";
    if (!before.find_surface(row.id) && !says(row.id, added, split_from))
      return "the surface map does not tell where surface " + std::to_string(row.id) + " is from";
  }
  for (const auto& row : before.surfaces())
    if (!after.find_surface(row.id) && !says(row.id, removed, merged_into))
      return "the surface map does not tell where surface " + std::to_string(row.id) + " went";
  return "";
}

/// One newton on each of the first surfaces, moved with the edit: none gets lost unsaid.
std::string load_fault(const mesh_version& before, const mesh_version& after,
                       const std::vector<surface_change>& map) {
  fem::load_case loads;
  for (const auto& change : map)
    if (before.find_surface(change.id) && loads.loads.size() < 8)
      loads.loads.push_back({{change.id}, fem::force{{0, 0, 1}}});
  const auto carried = fem::carry_over(loads, before, after, map, {fem::load_policy::move, false});
  double newtons = 0;
  for (const auto& load : carried.after.loads) {
    newtons += std::get<fem::force>(load.kind).total_n.z;
    for (const auto id : load.surfaces)
      if (!after.find_surface(id))
        return "a load was moved to surface " + std::to_string(id) + ", which is not there";
  }
  for (const auto& line : carried.lines)
    newtons += line.fate == fem::receipt_fate::dropped ? 1 : 0;
  return std::abs(newtons - static_cast<double>(loads.loads.size())) > 1e-9
           ? "loads that moved did not keep their total"
           : "";
}

/// The promises about a new version.
std::string result_fault(const mesh_version& before, const finished_edit& done, double floor) {
  const auto& after = *done.version;
  if (const auto report = check_version(after);
      !report.ok() && check_version(before).total < report.total)
    return to_error(report).message;
  const double volume = total_volume(before);
  if (std::abs(total_volume(after) - volume - done.volume_change) > 1e-9 * volume)
    return "the volume changed by other than was claimed";
  if (done.ratios.has_value() == done.touched.empty())
    return "radius ratios are told where no tet was touched, or are not told";
  if (done.ratios && done.ratios->min_after < std::min(floor, done.ratios->min_before) * (1 - 1e-9))
    return "the worst of " + std::to_string(done.touched.size()) + " touched tets has q " +
           std::to_string(done.ratios->min_after) + ", before " +
           std::to_string(done.ratios->min_before);
  const auto map = compare_surfaces(before, after);
  const auto fault = surface_fault(before, after, map);
  return fault.empty() ? load_fault(before, after, map) : fault;
}

}  // namespace

planned_edit choose_edit(const ops::catalogue& plugins, const mesh_version& mesh, double size,
                         const number_source& numbers) {
  const auto& entry = plugins.entries()[below(numbers, plugins.entries().size())];
  planned_edit edit;
  edit.operation = entry.description.id;
  const auto& surfaces = mesh.surfaces();
  const std::size_t count = 1 + (below(numbers, 3) == 0 ? below(numbers, 3) : 0);
  for (std::size_t i = 0; i < count; ++i)
    edit.surfaces.push_back(surfaces[below(numbers, surfaces.size())].id);
  for (const auto& p : entry.description.parameters)
    choose_value(p, numbers, size, edit.parameters);
  return edit;
}

tried_edit try_edit(const ops::catalogue& plugins, const version_ptr& before,
                    const planned_edit& edit) {
  tried_edit tried;
  const auto refuse = [&](const error& e) {
    tried.refusal = e;
    if (e.message.empty())
      tried.fault = "a refusal without a reason";
  };
  const auto host = ops::make_host_services();
  ops::context ctx;
  ctx.host = host.get();
  const auto result =
    ops::run_operation(plugins, edit.operation, before, {edit.surfaces}, edit.parameters, ctx);
  if (result) {
    edit_claim claim;
    claim.touched = result->touched;
    claim.volume_change = result->volume_change;
    claim.quality_floor = result->quality_floor;
    claim.bodies_added = result->bodies_added;
    const auto done =
      finish_edit(before, result->candidate, claim, {result->improve, result->thorough}, {}, {});
    if (done) {
      tried.after = done->version;
      tried.fault = result_fault(*before, *done, lowest_quality_floor);
    } else {
      refuse(done.error());
    }
  } else {
    refuse(result.error());
  }
  if (!is_intact(*before))
    tried.fault = "the version before changed";
  return tried;
}

std::string first_fault(const ops::catalogue& plugins, const version_ptr& start,
                        const std::vector<planned_edit>& edits) {
  auto mesh = start;
  for (const auto& edit : edits) {
    const auto tried = try_edit(plugins, mesh, edit);
    if (!tried.fault.empty())
      return tried.fault;
    if (tried.after)
      mesh = tried.after;
  }
  return "";
}

std::vector<planned_edit> shrink(const ops::catalogue& plugins, const version_ptr& start,
                                 std::vector<planned_edit> edits) {
  for (std::size_t i = edits.size(); i-- > 0;) {
    auto fewer = edits;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (!first_fault(plugins, start, fewer).empty())
      edits = std::move(fewer);
  }
  return edits;
}

void write_recipe(const std::filesystem::path& file, const std::filesystem::path& mesh,
                  const std::string& name, const std::vector<planned_edit>& edits) {
  nlohmann::ordered_json recipe;
  recipe["name"] = name;
  recipe["steps"].push_back({{"import", {{"mesh", mesh.string()}, {"length_unit", "mm"}}}});
  for (const auto& edit : edits) {
    nlohmann::ordered_json step{{"operation", edit.operation}, {"surfaces", edit.surfaces}};
    for (const auto& [id, value] : edit.parameters)
      std::visit([&](const auto& v) { step["parameters"][id] = v; }, value);
    recipe["steps"].push_back({{"edit", step}});
  }
  std::ofstream(file) << recipe.dump(2) << '\n';
}

}  // namespace tedit::test
