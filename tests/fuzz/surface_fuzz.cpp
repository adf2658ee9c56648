// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <sstream>

#include "mesh/io/zip_file.hpp"
#include "scan/reader/file_surface.hpp"
#include "scan/reader/mend.hpp"
#include "scan/reader/part_of_file.hpp"
#include "tests/fuzz/promise.hpp"

namespace {

using namespace tedit;

std::string archive_of(std::string_view model) {
  zip_packer packer("3D/3dmodel.model");
  packer.add(model);
  const std::array files{packer.finish()};
  std::ostringstream out(std::ios::binary);
  write_zip(out, files);
  return std::move(out).str();
}

void check_triangles(const triangle_surface& surface) {
  for (const auto& p : surface.points)
    fuzz::require(is_finite(p), "all points are finite");
  for (const auto& t : surface.triangles)
    fuzz::require(std::ranges::all_of(t, [&](auto v) { return v < surface.points.size(); }),
                  "all corners are points");
}

void check_read(const scan::file_surface& read) {
  const auto count = read.surface.triangles.size();
  check_triangles(read.surface);
  fuzz::require(count > 0 && count <= scan::most_triangles, "there are triangles, not too many");
  fuzz::require(read.group_of.empty() || read.group_of.size() == count, "each has a group");
  fuzz::require(read.body_of.empty() || read.body_of.size() == count, "each has a body");
  for (const auto group : read.group_of)
    fuzz::require(group < read.groups.size(), "groups are there");
  for (const auto body : read.body_of)
    fuzz::require(body < read.bodies.size(), "bodies are there");
}

void check_refused(const error& failure) {
  fuzz::require_reason(failure);
  fuzz::require(!failure.remedy.empty(), "a refusal has a remedy:", render(failure));
  fuzz::require(failure.code == ec::bad_input || failure.code == ec::unsupported_format ||
                  failure.code == ec::non_manifold,
                "a refusal is about the file:", render(failure));
}

void check_part(scan::file_surface read) {
  const auto made = scan::make_part(std::move(read), "mm", [](double, const char*) {});
  if (!made)
    return check_refused(made.error());
  check_triangles(made->part.surface);
  fuzz::require(scan::is_closed(made->part.surface), "a part is closed");
  fuzz::require(made->part.patch_of.size() == made->part.surface.triangles.size(),
                "each triangle is of a patch");
}

}  // namespace

/// The first byte says which format the others are: "s" STL, "o" OBJ, "p" PLY, "3" 3MF, "m" the
/// model of a 3MF, for what is packed is seldom hit.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0)
    return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const auto text = data[0] == 'm' ? archive_of(bytes) : std::string(bytes);
  const auto* kind = data[0] == 's'   ? "stl"
                     : data[0] == 'o' ? "obj"
                     : data[0] == 'p' ? "ply"
                                      : "3mf";
  auto read = scan::read_surface(kind, text);
  if (!read) {
    check_refused(read.error());
    return 0;
  }
  check_read(*read);
  constexpr std::size_t soon_mended = 2000;
  if (read->surface.triangles.size() <= soon_mended)
    check_part(std::move(*read));
  return 0;
}
