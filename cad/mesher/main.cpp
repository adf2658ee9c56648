// SPDX-License-Identifier: AGPL-3.0-or-later
// Meshes the BREP that the reader wrote. Gmsh may end this program in any way: whoever starts it
// expects that.
#include <sys/personality.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <new>
#include <set>

#include <gmsh.h>

#include "cad/mesher/gmsh_part.hpp"

namespace {

using namespace tedit;
using namespace tedit::cad;

/// What may be moved for what, in terms of the thinnest wall.
struct cleaning_step {
  double most;
  double flat;
};
constexpr std::array cleaning_steps{cleaning_step{0.01, 0.15}, cleaning_step{0.05, 0.07}};

void tell_what_is_gone(const surface_mesh& faces, const part_facts& facts, mesh_report& report) {
  std::set<int> there;
  for (const auto& one : faces.triangles)
    there.insert(one.surface);
  for (int face = 1; face <= static_cast<int>(facts.faces.size()); ++face)
    if (!there.contains(face))
      report.gone.push_back(face);
}

mesh_report clean(surface_mesh& faces, const gmsh_part& part) {
  mesh_report report{part.size(), 0, 0, 0, {}};
  for (const auto& step : cleaning_steps) {
    const auto done = clean_surface(faces, step.most * part.thinnest_wall(), step.flat);
    report.collapsed += done.collapsed;
    report.flipped += done.flipped;
    report.moved_mm = std::max(report.moved_mm, done.moved);
  }
  return report;
}

void mesh(const program_call& call, const std::string& size, const teller& tells) {
  tells.stage(0.02, "loading the shape into Gmsh");
  const auto facts = load_facts(call.folder);
  if (!facts)
    tells.refuse(facts.error());
  gmsh_part part(call, *facts, tells);
  const auto as_made = part.mesh_faces(fineness_of(size));
  auto faces = as_made;
  tells.stage(0.4, "collapsing short edges");
  auto report = clean(faces, part);
  tells.stage(0.45, "filling the solids with tets");
  if (!part.fill(faces)) {
    tells.stage(0.6, "filling the solids with tets once more, as the surface was");
    report = {part.size(), 0, 0, 0, {}};
    faces = as_made;
    if (!part.fill(faces))
      tells.refuse({ec::mesher_failed,
                    "Gmsh could not fill the part with tets",
                    "Try another --size; if none works, check in the CAD program that no faces cut "
                    "each other",
                    {}});
  }
  tell_what_is_gone(faces, *facts, report);
  if (!save_report(report, call.folder))
    tells.refuse({ec::io_error,
                  "the mesh cannot be written",
                  "Make room on the disk of the temporary folder ($TMPDIR)",
                  {}});
}

std::string last_word_of_gmsh() {
  std::string words;
  try {
    gmsh::logger::getLastError(words);
  } catch (...) {
  }
  return words.empty() ? "it did not say why" : words;
}

/// Gmsh's meshes depend on where things lie in memory: the same place each time gives the same
/// mesh.
void lie_still(char** argv) {
  constexpr unsigned long ask = 0xFFFFFFFF;
  const int now = personality(ask);
  if (now >= 0 && (now & ADDR_NO_RANDOMIZE) == 0 &&
      personality(static_cast<unsigned long>(now) | ADDR_NO_RANDOMIZE) >= 0)
    execv(argv[0], argv);
}

}  // namespace

int main(int argc, char** argv) {
  const auto call = parse_call(argc, argv, 5);
  if (!call)
    return 2;
  lie_still(argv);
  const teller tells(*call);
  confine(*call, {}, tells);
  try {
    mesh(*call, argv[4], tells);
  } catch (const std::bad_alloc&) {
    tells.refuse({ec::out_of_memory,
                  "the mesher needs more memory than it may take",
                  "Give it more with --memory-mb, or take a coarser --size",
                  {}});
  } catch (...) {
    tells.refuse({ec::mesher_failed,
                  "Gmsh could not mesh the part: " + last_word_of_gmsh(),
                  "Try another --size; if none works, mend the part in the CAD program",
                  {}});
  }
  std::fflush(stdout);
  _exit(0);
}
