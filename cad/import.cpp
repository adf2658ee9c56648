// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/import.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>

#include "base/short_number.hpp"
#include "base/stopwatch.hpp"
#include "cad/file_kind.hpp"
#include "cad/geometry_file.hpp"
#include "cad/mesh_file.hpp"
#include "cad/private_folder.hpp"
#include "cad/reading.hpp"

namespace tedit::cad {

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Where the geometry is in other files the reader finds nothing, and cannot say why.
error with_other_files(error why, const fs::path& file) {
  const auto others = files_referred_to(text_of(file));
  if (others.empty())
    return why;
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(others.size(), 3); ++i)
    names += (i > 0 ? ", " : "") + others[i];
  why.message = "the file has no solid of its own: it refers to " + std::to_string(others.size()) +
                (others.size() == 1 ? " other file (" : " other files (") + names +
                (others.size() > 3 ? ", ...)" : ")");
  why.remedy =
    "Export the assembly as one STEP file with all geometry in it, not as one file for "
    "each part";
  why.where = file.string();
  return why;
}

/// What the text of a file that could not be read shows of why: the reader is asked once more, for
/// it is confined. The first words stay, but of a BREP file; the line and the entity are added.
error with_fault_of_text(error why, file_kind kind, const fs::path& file,
                         const std::function<program_end(std::string_view)>& ask) {
  const auto end = ask(reads_text);
  if (end.done || end.died || end.why.code != ec::bad_input)
    return why;
  // What OpenCASCADE says of a damaged BREP file goes by what its memory held before.
  if (kind == file_kind::brep)
    why.message = "OpenCASCADE cannot read the BREP file";
  why.message += "; " + end.why.message;
  why.where = file.string() + end.why.where.substr(fs::absolute(file).string().size());
  why.remedy = end.why.remedy;
  return why;
}

/// Reads the CAD file; a STEP file that costs the reader its life is tried without annotations.
expected<part_facts> read_part(const import_request& request, file_kind kind,
                               const fs::path& folder, const execution& run) {
  const auto file = fs::absolute(request.file).string();
  const auto read = [&](std::string_view how) {
    return run_program("tedit-cad-reader", "the reader", folder,
                       {file, std::string(name_of(kind)), std::string(how)}, request.limits, run);
  };
  auto end = read(reads_all);
  if (end.died && kind == file_kind::step) {
    const auto first = end;
    end = read(reads_plain);
    if (end.died)
      end.why.message = first.why.message + ", and once more without annotations" +
                        (end.doing == first.doing ? "" : ", while " + end.doing);
  }
  if (end.done)
    return load_facts(folder);
  if (kind == file_kind::step && !end.died && end.why.code == ec::bad_input)
    end.why = with_other_files(std::move(end.why), request.file);
  if (end.why.code == ec::bad_input && end.why.where.empty())
    end.why = with_fault_of_text(std::move(end.why), kind, request.file, read);
  if (end.why.where.empty())
    end.why.where = request.file.string();
  return fail(std::move(end.why));
}

/// The last surface that Gmsh named in what it printed.
std::optional<int> last_surface_of(const fs::path& folder) {
  constexpr std::streamoff enough = 65536;
  std::ifstream in(folder / log_file, std::ios::binary | std::ios::ate);
  in.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(in.tellg()) - enough));
  const std::string said{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  constexpr std::string_view words = "Meshing surface ";
  const auto at = said.rfind(words);
  if (at == std::string::npos || said.find("Done meshing 2D", at) != std::string::npos)
    return std::nullopt;
  return std::atoi(said.c_str() + at + words.size());
}

error about_mesher(const program_end& end, const part_facts& facts, const fs::path& folder) {
  auto why = end.why;
  const auto surface = last_surface_of(folder);
  if (!end.died)
    return why;
  why.code = ec::mesher_failed;
  if (surface && *surface >= 1 && *surface <= static_cast<int>(facts.faces.size())) {
    const auto& name = facts.faces[static_cast<std::size_t>(*surface) - 1].name;
    why.message +=
      ", at surface " + std::to_string(*surface) + (name.empty() ? "" : " (" + name + ")");
  }
  why.remedy = std::string("Mesh it coarser or finer; if neither works, simplify ") +
               (surface ? "that face" : "the part") + " in the CAD program (short edges, gaps)";
  return why;
}

/// Bytes; the system takes 128 KiB of one.
constexpr std::size_t longest_argument = 100'000;

bool is_meant(const std::string& surface, const face_facts& face, std::size_t place) {
  if (face.ids.empty()
        ? surface == std::to_string(place + 1)
        : std::ranges::any_of(face.ids, [&](int id) { return surface == std::to_string(id); }))
    return true;
  return !face.name.empty() && surface == face.name;
}

/// As the mesher takes them, by the places of faces: "3=0.5,4=0.5". Errors: `surface_not_found`.
expected<std::string> sizes_by_place(const std::vector<local_size>& wanted,
                                     const part_facts& facts) {
  std::string result;
  for (const auto& one : wanted) {
    bool found = false;
    for (std::size_t i = 0; i < facts.faces.size(); ++i)
      if (is_meant(one.surface, facts.faces[i], i)) {
        found = true;
        result +=
          (result.empty() ? "" : ",") + std::to_string(i + 1) + "=" + short_number(one.mm, 17);
      }
    if (result.size() > longest_argument)
      return fail(ec::invalid_argument, "there are too many local sizes",
                  "Give a finer size for the whole part");
    if (!found)
      return fail(ec::surface_not_found,
                  "the part has no surface \"" + one.surface + "\" to give a size of its own",
                  "Its surfaces are 1 to " + std::to_string(facts.faces.size()) +
                    "; a part that was imported lists them with their names");
  }
  return result;
}

expected<void> mesh_part(const import_request& request, const fs::path& folder, imported_part& part,
                         const execution& run) {
  const auto local = sizes_by_place(request.local_sizes, part.model.facts);
  if (!local)
    return fail(local.error());
  const auto end = run_program("tedit-cad-mesher", "the mesher", folder, {request.size, *local},
                               request.limits, run.part(0, 0.9));
  if (!end.done)
    return fail(about_mesher(end, part.model.facts, folder));
  run.report(0.9, "building the mesh");
  const auto geometries = load_geometries(folder);
  return geometries ? take_mesh(folder, part, *geometries)
                    : expected<void>(fail(geometries.error()));
}

/// The CAD file as it comes from the reader, in the folder.
expected<cad_model> read_into(const import_request& request, const fs::path& folder,
                              const execution& run) {
  const auto kind = kind_of(request.file);
  if (!kind)
    return fail(kind.error());
  auto facts = read_part(request, *kind, folder, run);
  if (!facts)
    return fail(facts.error());
  return load_model(folder);
}

}  // namespace

expected<cad_model> read_model(const import_request& request, const execution& run) {
  if (auto there = find_program("tedit-cad-reader"); !there)
    return fail(there.error());
  const private_folder folder("tedit-import-");
  if (folder.path().empty())
    return fail(no_private_folder());
  return read_into(request, folder.path(), run);
}

expected<imported_part> import_part(const import_request& request, const execution& run) {
  if (const auto kind = kind_of(request.file); !kind)
    return fail(kind.error());
  for (const auto* name : {"tedit-cad-reader", "tedit-cad-mesher"})
    if (auto there = find_program(name); !there)
      return fail(there.error());
  const private_folder folder("tedit-import-");
  if (folder.path().empty())
    return fail(no_private_folder());
  stopwatch clock;
  imported_part part;
  auto model = read_into(request, folder.path(), run.part(0, 0.3));
  if (!model)
    return fail(model.error());
  part.read_ms = clock.restart();
  part.model = std::move(*model);
  part.warnings = part.model.facts.notices;
  if (auto meshed = mesh_part(request, folder.path(), part, run.part(0.3, 1)); !meshed) {
    auto why = meshed.error();
    if (why.where.empty())
      why.where = request.file.string();
    return fail(std::move(why));
  }
  part.mesh_ms = clock.milliseconds();
  return part;
}

}  // namespace tedit::cad
