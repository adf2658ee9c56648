// SPDX-License-Identifier: AGPL-3.0-or-later
// Meshes the BREP that the reader wrote. Gmsh may end this program in any way: whoever starts it
// expects that.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <locale>
#include <map>
#include <new>
#include <sstream>
#include <utility>
#include <vector>

#include "cad/mesher/gmsh_part.hpp"

namespace {

using namespace tedit;
using namespace tedit::cad;

/// "3=0.5,4=0.5": the longest edges of surfaces, mm. Written by who starts this program.
std::map<int, double> local_sizes_of(const std::string& text) {
  std::map<int, double> result;
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  int surface = 0;
  double mm = 0;
  for (char equals = 0, comma = 0; in >> surface >> equals >> mm; in >> comma)
    if (const auto [row, fresh] = result.emplace(surface, mm); !fresh)
      row->second = std::min(row->second, mm);
  return result;
}

/// What mending moves is worth another mesh where that is more than this share of the longest edge,
/// and the other one is better where it is less by this factor.
constexpr double much_moved = 0.01;
constexpr double less_moved = 0.5;

/// Narrow strips that mending would close get short edges, where that keeps them: that comes first.
std::vector<surface_mesh> mesh_faces(gmsh_part& part, const fineness& size,
                                     const std::map<int, double>& local) {
  std::vector<surface_mesh> ways;
  ways.push_back(part.mesh_faces(size, local));  // Which finds the sizes.
  const double moved = moved_by_mending(ways.back(), part.least_length());
  if (moved <= much_moved * part.size())
    return ways;
  auto finer = part.mesh_faces_finer_where_narrow(local);
  if (finer && moved_by_mending(*finer, part.least_length()) <= less_moved * moved)
    ways.insert(ways.begin(), std::move(*finer));
  else
    part.forget_narrow_places();
  return ways;
}

void mesh(const program_call& call, const std::string& size, const std::string& local,
          const teller& tells) {
  tells.stage(0.02, "loading the shape into Gmsh");
  const auto facts = load_facts(call.folder);
  if (!facts)
    tells.refuse(facts.error());
  gmsh_part part(call, *facts, tells);
  const auto as_made = mesh_faces(part, fineness_of(size), local_sizes_of(local));
  const auto report = fill_mended(
    as_made, part.size(), part.least_length(), static_cast<int>(facts->faces.size()),
    [&](const surface_mesh& faces) { return part.fill(faces); }, tells);
  if (!save_report(report, call.folder))
    tells.refuse({ec::io_error,
                  "the mesh cannot be written",
                  "Make room on the disk of the temporary folder ($TMPDIR)",
                  {}});
}

}  // namespace

int main(int argc, char** argv) {
  const auto call = parse_call(argc, argv, 6);
  if (!call)
    return 2;
  lie_still(argv);
  const teller tells(*call);
  confine(*call, {}, tells);
  try {
    mesh(*call, argv[4], argv[5], tells);
  } catch (const std::bad_alloc&) {
    tells.refuse({ec::out_of_memory,
                  "the mesher needs more memory than it may take",
                  "Give it more memory, or mesh it coarser",
                  {}});
  } catch (...) {
    tells.refuse({ec::mesher_failed,
                  "Gmsh could not mesh the part: " + last_word_of_gmsh(),
                  "Mesh it coarser or finer; if neither works, mend the part in the CAD program",
                  {}});
  }
  std::fflush(stdout);
  _exit(0);
}
