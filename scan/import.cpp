// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scan/import.hpp"

#include "base/stopwatch.hpp"
#include "cad/mesh_file.hpp"
#include "cad/private_folder.hpp"

namespace tedit::scan {

namespace {

namespace fs = std::filesystem;

constexpr const char* reader = "tedit-scan-reader";
constexpr const char* mesher = "tedit-scan-mesher";

/// Places of a file go behind its name.
error in_file(error why, const fs::path& file) {
  why.where = file.string() + (why.where.empty() ? "" : ", " + why.where);
  return why;
}

/// A program of CAD's that dies is told what helps there.
error about_death(cad::program_end end) {
  if (end.died)
    end.why.remedy =
      "Nothing else is lost. Repair the surface in the program that it comes from, or simplify it";
  return std::move(end.why);
}

expected<void> read_into(const import_request& request, const fs::path& folder,
                         imported_surface& made, const execution& run) {
  auto end = cad::run_program(reader, "the reader", folder,
                              {fs::absolute(request.file).string(), request.kind, request.unit},
                              request.limits, run);
  if (!end.done)
    return fail(about_death(std::move(end)));
  auto facts = cad::load_facts(folder);
  auto surface = load_surface(folder);
  if (!facts || !surface)
    return fail(facts ? surface.error() : facts.error());
  made.part.model.facts = std::move(*facts);
  made.part.warnings = made.part.model.facts.notices;
  made.file = std::move(*surface);
  return {};
}

expected<void> mesh_into(const import_request& request, const fs::path& folder,
                         imported_surface& made, const execution& run) {
  auto end = cad::run_program(mesher, "the mesher", folder, {request.size}, request.limits,
                              run.part(0, 0.9));
  if (end.died)
    end.why.code = ec::mesher_failed;
  if (!end.done)
    return fail(about_death(std::move(end)));
  run.report(0.9, "building the mesh");
  return cad::take_mesh(folder, made.part);
}

}  // namespace

expected<imported_surface> import_surface(const import_request& request, const execution& run) {
  for (const auto* name : {reader, mesher})
    if (auto there = cad::find_program(name); !there)
      return fail(there.error());
  const cad::private_folder folder("tedit-import-");
  if (folder.path().empty())
    return fail(cad::no_private_folder());
  stopwatch clock;
  imported_surface made;
  if (auto read = read_into(request, folder.path(), made, run.part(0, 0.3)); !read)
    return fail(in_file(read.error(), request.file));
  made.part.read_ms = clock.restart();
  if (auto meshed = mesh_into(request, folder.path(), made, run.part(0.3, 1)); !meshed)
    return fail(in_file(meshed.error(), request.file));
  made.part.mesh_ms = clock.milliseconds();
  return made;
}

double deviation_of(const mesh_version& mesh, const surface_part& file) {
  constexpr double mm_per_metre = 1e3;
  triangle_surface boundary;
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v)
    boundary.points.push_back(mm_per_metre * mesh.position(v));
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      boundary.triangles.push_back({mesh.facet(f).v[0], mesh.facet(f).v[1], mesh.facet(f).v[2]});
  return largest_distance(file.surface, boundary) / mm_per_metre;
}

}  // namespace tedit::scan
