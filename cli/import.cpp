// SPDX-License-Identifier: AGPL-3.0-or-later
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "actors/cad/first_version.hpp"
#include "base/number_range.hpp"
#include "base/part_sizes.hpp"
#include "base/stopwatch.hpp"
#include "cli/command.hpp"
#include "cli/import_mesh_file.hpp"
#include "cli/mesh_report.hpp"
#include "cli/part_document.hpp"
#include "mesh/io/formats.hpp"
#include "sandbox/sandbox.hpp"
#include "scan/part_file.hpp"

namespace tedit::cli {

namespace {

struct import_options {
  scan::part_file_request request;
  std::vector<std::string> local_sizes;
  std::vector<std::string> load_cases;
  bool has_size = false;  ///< --size was given.
  std::string output;
  unsigned time_limit_s = 120;
  unsigned memory_mb = 4096;
};

/// "#rrggbb", as HTML and CSS have it.
nlohmann::ordered_json colour_word(const std::optional<cad::colour>& looks) {
  if (!looks)
    return nullptr;
  char text[8];
  const auto byte = [&](int i) {
    return static_cast<unsigned>(std::lround(255 * std::clamp((*looks)[i], 0.0, 1.0)));
  };
  std::snprintf(text, sizeof(text), "#%02x%02x%02x", byte(0), byte(1), byte(2));
  return text;
}

/// The rows of `tedit info` with what CAD says of them.
void add_colours(nlohmann::ordered_json& rows,
                 const std::map<std::int64_t, std::optional<cad::colour>>& looks) {
  for (auto& row : rows) {
    const auto known = looks.find(row["id"].get<std::int64_t>());
    row["colour"] = known != looks.end() ? colour_word(known->second) : nullptr;
  }
}

std::map<std::int64_t, std::optional<cad::colour>> colours_of(
  const std::vector<cad::face_facts>& faces) {
  std::map<std::int64_t, std::optional<cad::colour>> looks;
  for (const auto& face : faces)
    for (const int id : face.ids)
      looks.emplace(id, face.looks);
  return looks;
}

/// Regions are numbered by their places.
std::map<std::int64_t, std::optional<cad::colour>> colours_of(
  const std::vector<cad::solid_facts>& solids) {
  std::map<std::int64_t, std::optional<cad::colour>> looks;
  for (std::size_t i = 0; i < solids.size(); ++i)
    looks.emplace(i + 1, solids[i].looks);
  return looks;
}

/// The same for a file; faces without a colour have none there, either.
file_colours file_colours_of(const cad::imported_part& part) {
  file_colours colours;
  for (const auto& [surface, looks] : colours_of(part.model.facts.faces))
    if (looks) {
      auto& bytes = colours.of_surfaces[surface];
      for (std::size_t k = 0; k < bytes.size(); ++k)
        bytes[k] = static_cast<std::uint8_t>(std::lround(255 * std::clamp((*looks)[k], 0.0, 1.0)));
    }
  return colours;
}

struct stage_times {
  double read = 0;
  double mesh = 0;
  double repair = 0;
  double total = 0;
};

nlohmann::ordered_json to_json(const scan::file_part& made, const mesh_report& report,
                               const stage_times& ms) {
  const auto& part = made.part;
  auto json = to_json(*part.version, report);
  add_colours(json["surfaces"], colours_of(part.model.facts.faces));
  add_colours(json["regions"], colours_of(part.model.facts.solids));
  double volume_mm3 = 0;
  for (std::size_t i = 0; i < part.model.facts.solids.size(); ++i)
    volume_mm3 += part.model.facts.solids[i].volume_mm3;
  json["cad_volume_m3"] = 1e-9 * volume_mm3;
  json["length_unit"] = "mm";
  json["cad_unit"] = part.model.facts.length_unit;
  json["edge_length_m"] = 1e-3 * part.report.size_mm;
  json["surface_moved_m"] = 1e-3 * part.report.moved_mm;
  if (made.deviation_m)
    json["deviation_m"] = *made.deviation_m;
  json["warnings"] = part.warnings;
  json["timings_ms"] = {
    {"read", ms.read}, {"mesh", ms.mesh}, {"repair", ms.repair}, {"total", ms.total}};
  return json;
}

/// "12 (3 with a name, 4 with a colour)".
std::string count_words(const nlohmann::ordered_json& rows) {
  std::size_t names = 0;
  std::size_t colours = 0;
  for (const auto& row : rows) {
    names += !row["name"].get_ref<const std::string&>().empty();
    colours += !row["colour"].is_null();
  }
  return std::to_string(rows.size()) + " (" + std::to_string(names) + " with a name, " +
         std::to_string(colours) + " with a colour)";
}

std::string describe(const import_options& options, const scan::file_part& made,
                     const mesh_report& report, const nlohmann::ordered_json& json) {
  const auto& part = made.part;
  std::string text = options.request.file.string() + "\n";
  const auto line = [&](const std::string& label, const std::string& value) {
    text += "  " + label + std::string(18 - label.size(), ' ') + value + "\n";
  };
  const auto& unit = part.model.facts.length_unit;
  line("unit", unit == "mm" ? unit : unit + ", mm in the mesh");
  line("size", pretty(report.size_m.x * 1e3) + " x " + pretty(report.size_m.y * 1e3) + " x " +
                 pretty(report.size_m.z * 1e3) + " mm");
  line("regions", count_words(json["regions"]));
  line("surfaces", count_words(json["surfaces"]));
  line("tets", std::to_string(part.version->tet_count()) + " (" + options.request.size +
                 ", edges up to " + pretty(part.report.size_mm, 3) + " mm)");
  line("volume", pretty(report.volume_m3 * 1e9, 6) + " mm3");
  line("radius ratio",
       "min " + pretty(report.quality.min) + ", median " + pretty(report.quality.median));
  if (made.deviation_m)
    line("deviation", pretty(*made.deviation_m * 1e3, 3) + " mm from the file's surface, at most");
  const auto seconds = [&](const char* stage) {
    return std::string(stage) + " " + pretty(json["timings_ms"][stage].get<double>() / 1e3, 3);
  };
  line("seconds", seconds("read") + ", " + seconds("mesh") + ", " + seconds("repair") + ", " +
                    seconds("total"));
  if (!options.output.empty())
    text +=
      options.output + (is_document(options.output)
                          ? made.deviation_m ? ": a document with the mesh\n"
                                             : ": a document with the mesh and the CAD model\n"
                          : ": the mesh\n");
  return text;
}

/// "12=0.5", "Bore=0.5".
expected<std::vector<cad::local_size>> local_sizes_of(const std::vector<std::string>& texts) {
  std::vector<cad::local_size> result;
  for (const auto& text : texts) {
    const auto at = text.rfind('=');
    const auto* end = text.data() + text.size();
    double mm = 0;
    const auto read = at == std::string::npos
                        ? std::from_chars_result{end, std::errc::invalid_argument}
                        : std::from_chars(text.data() + at + 1, end, mm);
    if (read.ec != std::errc() || read.ptr != end || at == 0)
      return fail(ec::usage, "--local-size " + text + " is no surface with a length",
                  "Write the surface's number or name, = and the longest edge in mm: 12=0.5");
    if (auto ok = check_number(mm, {1e-3, 1e6, "mm"}, "--local-size " + text, ec::usage); !ok)
      return fail(ok.error());
    result.push_back({text.substr(0, at), mm});
  }
  return result;
}

/// What imports say is for windows and clients, too: here the remedy names the options that it
/// means.
error with_options(error why) {
  const std::pair<const char*, const char*> known[] = {
    {"memory", "--memory-mb"}, {"time", "--time-limit"}, {"coarser", "--size"}, {"unit", "--unit"}};
  std::string options;
  for (const auto& [word, option] : known)
    if (why.remedy.find(word) != std::string::npos)
      options += (options.empty() ? "" : ", ") + std::string(option);
  if (!options.empty())
    why.remedy += " (" + options + ")";
  return why;
}

/// Errors: `usage` for what a mesh has already.
expected<mesh_import> mesh_import_of(const import_options& options) {
  if (options.has_size || !options.local_sizes.empty())
    return fail(ec::usage, options.request.file.string() + " is a mesh: it has its sizes already",
                "Leave out --size and --local-size; the operations refine and coarsen change it");
  return mesh_import{options.request.file,
                     options.request.unit.empty() ? "mm" : options.request.unit, options.load_cases,
                     options.output};
}

int import_as_mesh(const import_options& options, session& s) {
  const auto wanted = mesh_import_of(options);
  return wanted ? run_import_mesh(*wanted, s) : print_error(s, wanted.error());
}

expected<void> write_part(const import_options& options, const scan::file_part& made,
                          const std::vector<fem::load_case>& load_cases) {
  const auto& part = made.part;
  if (options.output.empty())
    return {};
  if (auto ok = check_load_cases(*part.version, load_cases); !ok)
    return ok;
  if (is_document(options.output))
    return actors::create_document(options.output,
                                   {.mesh = part.version,
                                    .model = made.model(),
                                    .file_name = options.request.file.filename().string(),
                                    .warnings = part.warnings,
                                    .load_cases = load_cases});
  const auto format = output_format(options.output);
  if (!format)
    return fail(format.error());
  return write_as((*format)->name, options.output, *part.version,
                  {.length_unit = "mm",
                   .colours = file_colours_of(part),
                   .title = options.request.file.stem().string()});
}

int run_import(import_options options, session& s) {
  const stopwatch total;
  if (is_mesh_file(options.request.file))
    return import_as_mesh(options, s);
  auto local = local_sizes_of(options.local_sizes);
  if (!local)
    return print_error(s, local.error());
  options.request.local_sizes = std::move(*local);
  if (!options.output.empty() && !is_document(options.output))
    if (const auto format = output_format(options.output); !format)
      return print_error(s, format.error());
  const auto load_cases = first_load_cases(options.load_cases, options.output);
  if (!load_cases)
    return print_error(s, load_cases.error());
  options.request.limits.time = std::chrono::seconds(options.time_limit_s);
  options.request.limits.memory_bytes = std::uint64_t{options.memory_mb} << 20;
  if (const auto can = sandbox::check(); !can && !sandbox::is_switched_off())
    notice(s, "note: " + render(can.error()));
  const auto run = make_execution(s);
  const auto made = scan::import_part_file(options.request, run.part(0, 0.95));
  if (!made)
    return print_error(s, with_options(made.error()));
  const auto* part = &made->part;
  stage_times ms{part->read_ms, part->mesh_ms, made->repair_ms, 0};
  if (const auto written = write_part(options, *made, *load_cases); !written)
    return print_error(s, written.error());
  for (const auto& warning : part->warnings)
    notice(s, "note: " + warning);
  const auto report = make_mesh_report(*part->version);
  ms.total = total.milliseconds();
  const auto json = to_json(*made, report, ms);
  print_result(s, json, describe(options, *made, report, json));
  return 0;
}

}  // namespace

void add_import(CLI::App& app, action& chosen) {
  auto options = std::make_shared<import_options>();
  auto* command = app.add_subcommand(
    "import",
    "Mesh a CAD file (STEP, IGES, BREP) or a closed surface (STL, OBJ, PLY, 3MF), or take a mesh, "
    "and make a document of it");
  command
    ->add_option(
      "part", options->request.file,
      "A STEP, IGES or BREP file with solids, an STL, OBJ, PLY or 3MF file with a closed "
      "surface; or " +
        read_formats_text())
    ->required();
  command
    ->add_option(
      "--unit", options->request.unit,
      "What the coordinates of an STL, OBJ, PLY or mesh file are in, where it does not say it: "
      "mm, cm, m or inch [mm]")
    ->check(CLI::IsMember({"mm", "cm", "m", "inch", "in"}));
  auto* size = command->add_option(
    "--size", options->request.size,
    "How fine: coarse (one tet through the mean wall, 6 edges on a circle), medium "
    "(two, 8) or fine (three, 12)");
  size->check(CLI::IsMember(std::vector<std::string>(part_sizes.begin(), part_sizes.end())))
    ->capture_default_str();
  command->add_option("--local-size", options->local_sizes,
                      "SURFACE=MM, again and again: the longest edge on a surface of a CAD file, "
                      "by its number or name; edges grow from there");
  command->add_option("-o,--output", options->output,
                      "Write the mesh, in mm: " + written_formats_text() +
                        "; or a document (.tedit) with the mesh and the CAD model");
  command
    ->add_option("--load-case", options->load_cases,
                 "Into the document: materials, supports and loads (JSON); again for more. A deck "
                 "brings its own")
    ->allow_extra_args(false);
  command
    ->add_option("--time-limit", options->time_limit_s,
                 "Seconds after which reading, or meshing, is given up")
    ->capture_default_str()
    ->check(CLI::Range(1U, 86400U));
  command
    ->add_option("--memory-mb", options->memory_mb,
                 "The most memory that reading, or meshing, may take")
    ->capture_default_str()
    ->check(CLI::Range(256U, 1048576U));
  command->callback([options, size, &chosen] {
    options->has_size = size->count() > 0;
    chosen = [options](session& s) { return run_import(*options, s); };
  });
}

}  // namespace tedit::cli
