// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/mesher/filling.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gmsh.h>

namespace tedit::cad {

namespace {

/// What may be moved for what, in terms of the thinnest wall.
struct cleaning_step {
  double most;
  double flat;
};
constexpr std::array cleaning_steps{cleaning_step{0.01, 0.15}, cleaning_step{0.05, 0.07}};
constexpr double hxt_3d = 10;

void tell_what_is_gone(const surface_mesh& surface, int faces, mesh_report& report) {
  std::set<int> there;
  for (const auto& one : surface.triangles)
    there.insert(one.surface);
  for (int face = 1; face <= faces; ++face)
    if (!there.contains(face))
      report.gone.push_back(face);
}

mesh_report clean(surface_mesh& surface, double size_mm, double wall_mm) {
  mesh_report report{size_mm, 0, 0, 0, {}};
  for (const auto& step : cleaning_steps) {
    const auto done = clean_surface(surface, step.most * wall_mm, step.flat);
    report.collapsed += done.collapsed;
    report.flipped += done.flipped;
    report.moved_mm = std::max(report.moved_mm, done.moved);
  }
  return report;
}

/// What the program is called when its addresses lie still; 15 letters at most.
constexpr const char* still_name = "tedit-gmsh";

/// In memory: libraries of Gmsh's look for the path that their program was started by. Below zero
/// where the system has no such files.
int copy_of_this_program() {
  const int from = open("/proc/self/exe", O_RDONLY | O_CLOEXEC);
  const int to = memfd_create(still_name, MFD_CLOEXEC);
  struct stat about {};
  bool done = from >= 0 && to >= 0 && fstat(from, &about) == 0;
  for (off_t left = done ? about.st_size : 0; done && left > 0;) {
    const auto sent = sendfile(to, from, nullptr, static_cast<std::size_t>(left));
    done = sent > 0;
    left -= sent;
  }
  if (from >= 0)
    close(from);
  if (!done && to >= 0)
    close(to);
  return done ? to : -1;
}

/// Variables for the loader, for sanitizers and for the sandbox.
bool is_needed(std::string_view variable) {
  const auto name = variable.substr(0, variable.find('='));
  return name.starts_with("LD_") || name.ends_with("SAN_OPTIONS") || name == "TEDIT_SANDBOX";
}

}  // namespace

fineness fineness_of(const std::string& name) {
  return name == "fine" ? fineness{1.0 / 3, 12} : name == "medium" ? fineness{0.5, 8} : fineness{};
}

void lie_still(char** argv) {
  constexpr unsigned long ask = 0xFFFFFFFF;
  constexpr const char* mark = "TEDIT_LIES_STILL";
  if (std::getenv(mark)) {
    prctl(PR_SET_NAME, still_name);
    return;
  }
  const int now = personality(ask);
  if (now < 0 || personality(static_cast<unsigned long>(now) | ADDR_NO_RANDOMIZE) < 0 ||
      chdir(argv[1]) != 0)
    return;
  // What a program is given lies in its memory, before all else.
  std::string marked = std::string(mark) + "=1";
  std::vector<char*> variables{marked.data()};
  for (char** one = environ; *one; ++one)
    if (is_needed(*one))
      variables.push_back(*one);
  variables.push_back(nullptr);
  static std::string name = still_name;
  static std::string here = ".";
  argv[0] = name.data();
  argv[1] = here.data();
  if (const int copy = copy_of_this_program(); copy >= 0)
    fexecve(copy, argv, variables.data());
  execve("/proc/self/exe", argv, variables.data());
}

void begin_gmsh() {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 1);    // Into the folder's file.
  gmsh::option::setNumber("General.NumThreads", 1);  // The same mesh each time.
  gmsh::option::setNumber("Mesh.Algorithm3D", hxt_3d);
}

std::string last_word_of_gmsh() {
  std::string words;
  try {
    gmsh::logger::getLastError(words);
  } catch (...) {
  }
  return words.empty() ? "it did not say why" : words;
}

double moved_by_mending(surface_mesh surface, double wall_mm) {
  return clean(surface, 0, wall_mm).moved_mm;
}

mesh_report fill_mended(std::span<const surface_mesh> ways, double size_mm, double wall_mm,
                        int faces, const filler& fill, const teller& tells) {
  const auto told = [&](const surface_mesh& surface, mesh_report report) {
    tell_what_is_gone(surface, faces, report);
    return report;
  };
  for (const auto& as_made : ways) {
    tells.stage(0.4, "collapsing short edges");
    auto surface = as_made;
    const auto report = clean(surface, size_mm, wall_mm);
    tells.stage(0.45, "filling the solids with tets");
    if (fill(surface))
      return told(surface, report);
  }
  tells.stage(0.6, "filling the solids with tets once more, as the surface was");
  if (!fill(ways.back()))
    tells.refuse({ec::mesher_failed,
                  "Gmsh could not fill the part with tets",
                  "Mesh it coarser or finer; if neither works, check in the CAD program that no "
                  "faces cut each other",
                  {}});
  return told(ways.back(), {size_mm, 0, 0, 0, {}});
}

}  // namespace tedit::cad
