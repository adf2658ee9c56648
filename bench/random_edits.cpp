// SPDX-License-Identifier: AGPL-3.0-or-later
// random_edits MESH EDITS SEED [RECIPE]: applies random operations with random selections and
// parameters, one on the result of the other (a part that has lost half of its volume starts
// again), and checks the whole version after each (tests/support/random_edits.hpp). A sequence
// that breaks something is shrunk to the fewest edits that break it and written as a recipe; while
// an edit runs, the recipe holds all up to it, so that a crash leaves it behind. Prints a summary;
// ends with status 1 when something broke.
#include <iostream>
#include <random>

#include "base/stopwatch.hpp"
#include "mesh/io/import.hpp"
#include "tests/support/random_edits.hpp"

namespace {

using namespace tedit;
using namespace tedit::test;

struct campaign {
  std::filesystem::path mesh;
  std::filesystem::path recipe;
  int edits = 0;
  std::mt19937_64 random;
  std::map<std::string, std::pair<int, int>> counts;  ///< Operation -> made, refused.
  std::map<std::string, int> reasons;
  double slowest_ms = 0;
};

/// False when an edit broke something.
bool run(campaign& all, const ops::catalogue& plugins, const version_ptr& start) {
  const double volume = total_volume(*start);
  auto mesh = start;
  std::vector<planned_edit> made;
  for (int i = 0; i < all.edits; ++i) {
    if (made.size() >= 100 || total_volume(*mesh) < 0.5 * volume || mesh->tet_count() > 200'000) {
      mesh = start;
      made.clear();
    }
    made.push_back(choose_edit(plugins, *mesh, std::cbrt(volume), [&] { return all.random(); }));
    write_recipe(all.recipe, all.mesh, "an edit that ended the program", made);
    const stopwatch clock;
    const auto tried = try_edit(plugins, mesh, made.back());
    all.slowest_ms = std::max(all.slowest_ms, clock.milliseconds());
    const auto operation = made.back().operation;
    if (!tried.fault.empty()) {
      made = shrink(plugins, start, std::move(made));
      write_recipe(all.recipe, all.mesh, tried.fault, made);
      std::cout << "BROKEN by edit " << i << " (" << operation << "): " << tried.fault
                << "; shrunk to " << made.size() << " edits in " << all.recipe.string() << '\n';
      return false;
    }
    auto& [done, refused] = all.counts[operation];
    if (tried.after) {
      ++done;
      mesh = tried.after;
    } else {
      ++refused;
      ++all.reasons[std::string(code_name(tried.refusal.code))];
      made.pop_back();
    }
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "usage: random_edits MESH EDITS SEED [RECIPE]\n";
    return 2;
  }
  campaign all;
  all.mesh = std::filesystem::absolute(argv[1]);
  all.recipe = argc > 4 ? argv[4] : "broken.json";
  all.edits = std::stoi(argv[2]);
  all.random.seed(std::stoull(argv[3]));
  const auto imported = import_mesh(all.mesh, "mm");
  if (!imported) {
    std::cerr << render(imported.error()) << '\n';
    return 65;
  }
  if (!run(all, ops::load_default_catalogue(), imported->version))
    return 1;
  std::filesystem::remove(all.recipe);
  std::cout << all.mesh.filename().string() << ": nothing broke";
  for (const auto& [operation, count] : all.counts)
    std::cout << "; " << operation << " " << count.first << " made, " << count.second << " refused";
  std::cout << "; slowest answer " << std::lround(all.slowest_ms) << " ms";
  for (const auto& [reason, count] : all.reasons)
    std::cout << "; " << reason << " " << count;
  std::cout << '\n';
  return 0;
}
