// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scan/part_file.hpp"

#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "cad/file_kind.hpp"
#include "cad/repair.hpp"
#include "scan/file_kind.hpp"
#include "scan/import.hpp"

namespace tedit::scan {

namespace {

struct read_file_part {
  cad::imported_part part;
  std::optional<surface_part> surface;  ///< Of a file without CAD.
};

expected<read_file_part> read_cad(const part_file_request& request, const execution& run) {
  if (!request.unit.empty())
    return fail(ec::invalid_argument,
                "a unit is for STL, OBJ and PLY files: a CAD file says its own",
                "Leave the unit out");
  return cad::import_part({request.file, request.size, request.local_sizes, request.limits}, run)
    .map([](cad::imported_part&& part) {
      return read_file_part{std::move(part), std::nullopt};
    });
}

expected<read_file_part> read_surface(const part_file_request& request, const std::string& kind,
                                      const execution& run) {
  if (!request.local_sizes.empty())
    return fail(ec::invalid_argument,
                "local sizes are for CAD files: the surfaces of this file are found while it is "
                "meshed",
                "Mesh it without, and make it finer afterwards with the operation refine");
  const std::string unit = request.unit.empty()     ? "mm"
                           : request.unit == "inch" ? "in"
                                                    : request.unit;
  return import_surface({request.file, kind, unit, request.size, request.limits}, run)
    .map([](imported_surface&& surface) {
      return read_file_part{std::move(surface.part), std::move(surface.file)};
    });
}

/// Of the longest edge: by more than this share a surface is not moved without a word.
constexpr double much_moved = 0.01;

void tell_how_far_it_moved(cad::imported_part& part) {
  const auto& report = part.report;
  if (report.moved_mm > much_moved * report.size_mm)
    part.warnings.push_back(
      "flat tets at narrow places were mended: the surface moved there by up to " +
      format_number("%.3g", report.moved_mm) +
      " mm. A finer size, or a local size of the surfaces there, keeps it");
}

}  // namespace

expected<file_part> import_part_file(const part_file_request& request, const execution& run) {
  const auto kind = cad::kind_of(request.file) ? std::nullopt : kind_of(request.file);
  auto read =
    kind ? read_surface(request, *kind, run.part(0, 0.7)) : read_cad(request, run.part(0, 0.7));
  if (!read)
    return fail(std::move(read.error()));
  file_part made{std::move(read->part), std::nullopt, 0};
  const stopwatch clock;
  if (auto repaired = cad::repair_part(made.part, run.part(0.7, 1)); !repaired)
    return fail(std::move(repaired.error()));
  made.repair_ms = clock.milliseconds();
  if (read->surface)
    made.deviation_m = deviation_of(*made.part.version, *read->surface);
  else
    tell_how_far_it_moved(made.part);
  return made;
}

}  // namespace tedit::scan
