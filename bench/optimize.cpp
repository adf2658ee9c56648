// SPDX-License-Identifier: AGPL-3.0-or-later
// optimize MESH... : for each mesh the quality as it is, after the local pass and after the
// thorough pass over all of it, with the boundary kept and with it allowed to move by 1e-3 of the
// local edge length; with --gmsh also what Gmsh's two optimizers make of it. Prints one table row
// each.
#include <dlfcn.h>
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>

#include "cli/command.hpp"
#include "mesh/checks.hpp"
#include "mesh/io/import.hpp"
#include "mesh/optimize/improve.hpp"

namespace {

using namespace tedit;

/// Of all threads: what a machine that others use, too, can still measure.
double cpu_seconds() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return static_cast<double>(use.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(use.ru_utime.tv_usec);
}

std::vector<tet_id> all_tets(const mesh_version& mesh) {
  std::vector<tet_id> result;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t))
      result.push_back(t);
  return result;
}

quality_figures measure(const mesh_version& mesh) {
  const auto tets = all_tets(mesh);
  return measure_quality(tets.size(), [&](std::size_t i) { return mesh.corners(tets[i]); });
}

void print(const std::string& what, const quality_figures& q, double seconds,
           const std::string& note) {
  std::cout << "| " << what << " | " << q.tets << " | " << cli::pretty(q.min_dihedral_deg, 3)
            << " | " << cli::pretty(q.dihedral_1pct_deg, 3) << " | "
            << cli::pretty(q.max_dihedral_deg, 4) << " | " << cli::pretty(q.min_ratio, 3) << " | "
            << cli::pretty(q.ratio_1pct, 3) << " | " << cli::pretty(q.mean_ratio, 3) << " | "
            << (seconds > 0 ? cli::pretty(seconds, 3) : std::string("-")) << " | " << note
            << " |\n";
}

std::string text_of(const improve_report& report) {
  const auto& m = report.moves;
  std::string text;
  const auto add = [&](const char* name, std::size_t n) {
    if (n > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + name;
  };
  add("flips", m.flips);
  add("relocations", m.relocations);
  add("collapses", m.collapses);
  add("insertions", m.insertions);
  add("harmonic flips", m.harmonic_flips);
  add("harmonic relocations", m.harmonic_relocations);
  add("boundary flips", m.boundary_flips);
  add("boundary relocations", m.boundary_relocations);
  add("boundary collapses", m.boundary_collapses);
  if (report.surface_deviation > 0)
    text += ", surface off by " + cli::pretty(1e6 * report.surface_deviation, 3) + " um";
  return text;
}

bool improve_and_print(const version_ptr& mesh, const char* what,
                       const improve_settings& settings) {
  mesh_builder builder(mesh);
  const double start = cpu_seconds();
  const auto report = improve(builder, all_tets(*mesh), settings, {});
  const double seconds = cpu_seconds() - start;
  if (!report) {
    std::cout << render(report.error()) << '\n';
    return false;
  }
  const auto after = builder.freeze();
  print(what, measure(*after), seconds, text_of(*report));
  const auto faults = check_version(*after).total;
  if (faults > check_version(*mesh).total)
    std::cout << "FAULT: " << to_error(check_version(*after)).message << '\n';
  return faults == 0 || faults <= check_version(*mesh).total;
}

/// Gmsh's C interface, from its library: its program optimizes no mesh that it has not made.
class gmsh_library {
public:
  explicit gmsh_library(const char* file) : handle_(dlopen(file, RTLD_NOW | RTLD_LOCAL)) {}

  [[nodiscard]] bool present() const { return handle_ != nullptr; }

  /// Debian builds it without Netgen; then that optimizer does nothing and says nothing.
  [[nodiscard]] bool has_netgen() const {
    int failed = 0;
    char* text = nullptr;
    find<void(int, char**, int, int*)>("gmshInitialize")(0, nullptr, 0, &failed);
    find<void(const char*, char**, int*)>("gmshOptionGetString")("General.BuildOptions", &text,
                                                                 &failed);
    const bool found = text && std::string(text).find("Netgen") != std::string::npos;
    find<void(void*)>("gmshFree")(text);
    find<void(int*)>("gmshFinalize")(&failed);
    return found;
  }

  void optimize(const std::string& file, const char* method, const std::string& out) const {
    int failed = 0;
    find<void(int, char**, int, int*)>("gmshInitialize")(0, nullptr, 0, &failed);
    find<void(const char*, double, int*)>("gmshOptionSetNumber")("General.Terminal", 0, &failed);
    find<void(const char*, double, int*)>("gmshOptionSetNumber")("Mesh.MshFileVersion", 4.1,
                                                                 &failed);
    find<void(const char*, int*)>("gmshOpen")(file.c_str(), &failed);
    const double start = cpu_seconds();
    constexpr int force = 1;  // Also meshes without a geometry.
    find<void(const char*, int, int, int*, std::size_t, int*)>("gmshModelMeshOptimize")(
      method, force, 1, nullptr, 0, &failed);
    seconds_ = cpu_seconds() - start;
    find<void(const char*, int*)>("gmshWrite")(out.c_str(), &failed);
    find<void(int*)>("gmshFinalize")(&failed);
  }

  [[nodiscard]] double seconds() const { return seconds_; }

private:
  template <class Function>
  [[nodiscard]] Function* find(const char* name) const {
    return reinterpret_cast<Function*>(dlsym(handle_, name));
  }

  void* handle_;
  mutable double seconds_ = 0;
};

void gmsh(const gmsh_library& library, const std::filesystem::path& file, const char* what,
          const char* method) {
  const auto out = std::filesystem::temp_directory_path() /
                   ("tedit-optimized-" + std::to_string(getpid()) + ".msh");
  library.optimize(file.string(), method, out.string());
  const auto mesh = import_mesh(out, "mm");
  if (mesh)
    print(what, measure(*mesh->version), library.seconds(), "");
  else
    std::cout << "| " << what << " | " << render(mesh.error()) << " |\n";
  std::filesystem::remove(out);
}

}  // namespace

int main(int argc, char** argv) {
  bool sound = true;
  bool with_gmsh = false;
  const gmsh_library library("libgmsh.so.4.8");
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--gmsh") {
      with_gmsh = library.present();
      if (!with_gmsh)
        std::cout << "libgmsh.so.4.8 is not there: Gmsh's rows are left out\n";
      else if (!library.has_netgen())
        std::cout << "this Gmsh was built without Netgen: OptimizeNetgen is left out\n";
      continue;
    }
    const std::filesystem::path file(argv[i]);
    const auto imported = import_mesh(file, "mm");
    if (!imported) {
      std::cerr << render(imported.error()) << '\n';
      return 65;
    }
    std::cout
      << "\n"
      << file.filename().string() << "\n\n"
      << "| state | tets | min angle deg | 1 % | max | min q | 1 % | mean | CPU s | moves |\n"
      << "|---|---|---|---|---|---|---|---|---|---|\n";
    print("as meshed", measure(*imported->version), 0, "");
    improve_settings settings;
    sound &= improve_and_print(imported->version, "local pass", settings);
    settings.thorough.emplace();
    sound &= improve_and_print(imported->version, "thorough", settings);
    settings.thorough->tolerance.relative = 1e-3;
    sound &= improve_and_print(imported->version, "thorough, 1e-3", settings);
    if (with_gmsh) {
      gmsh(library, file, "Gmsh Optimize", "");
      if (library.has_netgen())
        gmsh(library, file, "Gmsh OptimizeNetgen", "Netgen");
    }
  }
  return sound ? 0 : 1;
}
