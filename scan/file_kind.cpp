// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scan/file_kind.hpp"

#include <algorithm>
#include <array>

#include "mesh/formats.hpp"
#include "mesh/io/file.hpp"

namespace tedit::scan {

namespace {

/// Those that hold a boundary alone, with the functions that know their bytes.
struct surface_format {
  std::string_view name;
  file_recogniser* recognises;
};
constexpr std::array surface_formats{
  surface_format{formats::stl::about.name, formats::stl::recognises},
  surface_format{formats::ply::about.name, formats::ply::recognises},
  surface_format{formats::threemf::about.name, formats::threemf::recognises},
  surface_format{formats::obj::about.name, formats::obj::recognises}};

}  // namespace

std::optional<std::string> kind_of(const std::filesystem::path& file) {
  const auto bytes = read_file(file);
  if (!bytes || bytes->empty())
    return std::nullopt;
  for (const auto& one : surface_formats)
    if (one.recognises(*bytes))
      return std::string(one.name);
  const auto suffix = file.extension().string();
  const auto* format = format_of_suffix(suffix.substr(std::min<std::size_t>(1, suffix.size())));
  if (format && std::ranges::find(surface_formats, format->name, &surface_format::name) !=
                  surface_formats.end())
    return std::string(format->name);
  return std::nullopt;
}

}  // namespace tedit::scan
