// SPDX-License-Identifier: AGPL-3.0-or-later
// random_edits MESH EDITS SEED [RECIPE]: applies random operations with random selections and
// parameters, one on the result of the other (a part that has lost half of its volume starts
// again), and checks the whole version after each: every invariant, every surface id, the volume as
// claimed, and the version before unchanged. A broken one is shrunk to the fewest edits that break
// it and written as a recipe. Prints a summary; ends with status 1 when something broke.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <random>

#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "cli/command.hpp"
#include "cli/local_edit.hpp"
#include "mesh/io/import.hpp"

namespace {

using namespace tedit;
using random_source = std::mt19937_64;

double uniform(random_source& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

std::size_t below(random_source& random, std::size_t n) {
  return static_cast<std::size_t>(random() % n);
}

/// A value inside the range, now and then at its ends or left at the default.
void set_random(const ops::parameter_description& p, random_source& random, double size,
                ops::parameters& values) {
  if (below(random, 3) == 0)
    return;
  const double low = p.min.value_or(0);
  // Lengths are drawn from what makes sense on the part.
  const double high = std::min(p.max.value_or(1), p.unit == "m" ? 0.05 * size : 1e3);
  switch (p.type) {
    case ops::parameter_type::boolean:
      values[p.id] = below(random, 2) == 1;
      break;
    case ops::parameter_type::integer:
      values[p.id] =
        static_cast<std::int64_t>(std::lround(uniform(random, low, std::min(high, low + 3))));
      break;
    case ops::parameter_type::real:
      values[p.id] = below(random, 20) == 0 ? low : uniform(random, low, std::max(low, high));
      break;
    case ops::parameter_type::choice:
      values[p.id] = p.choices[below(random, p.choices.size())];
      break;
    case ops::parameter_type::text:
      break;
  }
}

cli::edit_request random_request(const ops::catalogue& plugins, const mesh_version& mesh,
                                 double size, random_source& random) {
  const auto& entry = plugins.entries()[below(random, plugins.entries().size())];
  cli::edit_request request;
  request.operation = entry.description.id;
  const auto& surfaces = mesh.surfaces();
  const std::size_t count = 1 + (below(random, 3) == 0 ? below(random, 3) : 0);
  for (std::size_t i = 0; i < count; ++i)
    request.surfaces.push_back(surfaces[below(random, surfaces.size())].id);
  for (const auto& p : entry.description.parameters)
    set_random(p, random, size, request.parameters);
  return request;
}

/// What an edit broke; empty when it is right or was refused.
std::string fault_of(const version_ptr& before, const std::vector<std::byte>& manifest,
                     const expected<cli::edit_outcome>& outcome) {
  if (before->pages().to_bytes() != manifest)
    return "the version before changed";
  if (!outcome)
    return outcome.error().message.empty() ? "a refusal without a reason" : "";
  const auto& after = *outcome->version;
  if (const auto report = check_version(after);
      !report.ok() && check_version(*before).total < report.total)
    return to_error(report).message;
  const double claimed = outcome->report.volume_change;
  const double error = std::abs(total_volume(after) - total_volume(*before) - claimed);
  if (error > 1e-9 * total_volume(*before))
    return "the volume changed by other than was claimed";
  for (const auto& row : after.surfaces()) {
    const std::array list{row.id};
    if (facets_of(after, list).empty() && after.data().interfaces.size() == 0)
      return "surface " + std::to_string(row.id) + " has no facets";
  }
  return "";
}

/// The fault of a sequence applied from the start; refused edits are left out.
std::string replay(const ops::catalogue& plugins, const version_ptr& start,
                   const std::vector<cli::edit_request>& requests) {
  auto mesh = start;
  for (const auto& request : requests) {
    const auto manifest = mesh->pages().to_bytes();
    const auto outcome = cli::apply_edit(plugins, mesh, request, {}, {});
    if (const auto fault = fault_of(mesh, manifest, outcome); !fault.empty())
      return fault;
    if (outcome)
      mesh = outcome->version;
  }
  return "";
}

std::vector<cli::edit_request> shrink(const ops::catalogue& plugins, const version_ptr& start,
                                      std::vector<cli::edit_request> requests) {
  for (std::size_t i = requests.size(); i-- > 0;) {
    auto fewer = requests;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (!replay(plugins, start, fewer).empty())
      requests = std::move(fewer);
  }
  return requests;
}

void write_recipe(const std::string& path, const std::string& mesh, const std::string& fault,
                  const std::vector<cli::edit_request>& requests) {
  nlohmann::ordered_json recipe;
  recipe["name"] = fault;
  recipe["steps"].push_back({{"import", {{"mesh", mesh}, {"length_unit", "mm"}}}});
  for (const auto& request : requests) {
    nlohmann::ordered_json edit{{"operation", request.operation}, {"surfaces", request.surfaces}};
    for (const auto& [name, value] : request.parameters)
      std::visit([&](const auto& v) { edit["parameters"][name] = v; }, value);
    recipe["steps"].push_back({{"edit", edit}});
  }
  std::ofstream(path) << recipe.dump(2) << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "usage: random_edits MESH EDITS SEED [RECIPE]\n";
    return 2;
  }
  const auto imported = import_mesh(std::filesystem::path(argv[1]), "mm");
  if (!imported) {
    std::cerr << render(imported.error()) << '\n';
    return 65;
  }
  const auto plugins = ops::load_default_catalogue();
  const auto start = imported->version;
  const double volume = total_volume(*start);
  const double size = std::cbrt(volume);
  random_source random(std::stoull(argv[3]));
  auto mesh = start;
  std::vector<cli::edit_request> made;
  std::map<std::string, std::pair<int, int>> counts;  // operation -> made, refused
  std::map<std::string, int> reasons;
  double slowest = 0;
  for (int i = 0; i < std::stoi(argv[2]); ++i) {
    if (made.size() >= 100 || total_volume(*mesh) < 0.5 * volume || mesh->tet_count() > 200'000) {
      mesh = start;
      made.clear();
    }
    const auto request = random_request(plugins, *mesh, size, random);
    const auto manifest = mesh->pages().to_bytes();
    const stopwatch clock;
    const auto outcome = cli::apply_edit(plugins, mesh, request, {}, {});
    slowest = std::max(slowest, clock.milliseconds());
    if (const auto fault = fault_of(mesh, manifest, outcome); !fault.empty()) {
      made.push_back(request);
      made = shrink(plugins, start, std::move(made));
      const std::string path = argc > 4 ? argv[4] : "broken.json";
      write_recipe(path, std::filesystem::absolute(argv[1]).string(), fault, made);
      std::cout << "BROKEN by edit " << i << " (" << request.operation << "): " << fault
                << "; shrunk to " << made.size() << " edits in " << path << '\n';
      return 1;
    }
    auto& [done, refused] = counts[request.operation];
    if (!outcome) {
      ++refused;
      ++reasons[std::string(code_name(outcome.error().code))];
      continue;
    }
    ++done;
    mesh = outcome->version;
    made.push_back(request);
  }
  std::cout << std::filesystem::path(argv[1]).filename().string() << ": nothing broke";
  for (const auto& [operation, count] : counts)
    std::cout << "; " << operation << " " << count.first << " made, " << count.second << " refused";
  std::cout << "; slowest answer " << cli::pretty(slowest, 3) << " ms";
  for (const auto& [reason, count] : reasons)
    std::cout << "; " << reason << " " << count;
  std::cout << '\n';
  return 0;
}
