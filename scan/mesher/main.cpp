// SPDX-License-Identifier: AGPL-3.0-or-later
// Meshes the surface that the reader wrote. Gmsh may end this program in any way: whoever starts it
// expects that.
#include <unistd.h>

#include <cstdio>
#include <new>

#include "cad/mesher/gmsh_fill.hpp"
#include "scan/mesher/remesh.hpp"

#include <gmsh.h>

namespace {

using namespace tedit;
using namespace tedit::scan;

std::map<int, std::vector<int>> faces_of_solids(const surface_part& part) {
  std::map<int, std::vector<int>> faces;
  for (std::size_t i = 0; i < part.solid_of.size(); ++i)
    faces[static_cast<int>(part.solid_of[i]) + 1].push_back(static_cast<int>(i) + 1);
  return faces;
}

void mesh(const cad::program_call& call, const std::string& size, const cad::teller& tells) {
  tells.stage(0.02, "loading the surface");
  const auto facts = cad::load_facts(call.folder);
  const auto part = load_surface(call.folder);
  if (!facts || !part)
    tells.refuse(facts ? part.error() : facts.error());
  cad::begin_gmsh();
  const auto lengths = lengths_for(*facts, cad::fineness_of(size));
  gmsh::option::setNumber("Mesh.MeshSizeMax", lengths.longest);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 1);
  const auto made = remesh(
    *part, lengths, [&](double share) { tells.stage(0.05 + 0.35 * share, "meshing the surface"); });
  const auto around = faces_of_solids(*part);
  const auto report = cad::fill_mended(
    {&made, 1}, lengths.longest, lengths.thinnest_wall, static_cast<int>(facts->faces.size()),
    [&](const cad::surface_mesh& faces) { return cad::fill_solids(faces, around, call.folder); },
    tells);
  if (!cad::save_report(report, call.folder))
    tells.refuse({ec::io_error,
                  "the mesh cannot be written",
                  "Make room on the disk of the temporary folder ($TMPDIR)",
                  {}});
}

}  // namespace

int main(int argc, char** argv) {
  const auto call = cad::parse_call(argc, argv, 5);
  if (!call)
    return 2;
  cad::lie_still(argv);
  const cad::teller tells(*call);
  cad::confine(*call, {}, tells);
  try {
    mesh(*call, argv[4], tells);
  } catch (const std::bad_alloc&) {
    tells.refuse({ec::out_of_memory,
                  "the mesher needs more memory than it may take",
                  "Give it more memory, or mesh it coarser",
                  {}});
  } catch (...) {
    tells.refuse(
      {ec::mesher_failed,
       "Gmsh could not mesh the part: " + cad::last_word_of_gmsh(),
       "Mesh it coarser or finer; if neither works, repair the surface in the program that it "
       "comes from",
       {}});
  }
  std::fflush(stdout);
  _exit(0);
}
