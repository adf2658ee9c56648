// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scan/exchange.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>

#include "mesh/facet_distance.hpp"
#include "mesh/io/file.hpp"

namespace tedit::scan {

namespace {

constexpr std::uint64_t surface_magic = 0x3146525344455454;

struct surface_header {
  std::uint64_t magic = surface_magic;
  std::uint64_t points = 0;
  std::uint64_t triangles = 0;
  std::uint64_t patches = 0;
};

template <class T>
void put(std::ofstream& out, const T* first, std::size_t count) {
  out.write(reinterpret_cast<const char*>(first), static_cast<std::streamsize>(count * sizeof(T)));
}

/// What lies in the file, taken piece by piece.
class surface_bytes {
public:
  explicit surface_bytes(const std::vector<char>& bytes) : bytes_(bytes) {}

  template <class T>
  bool take(std::vector<T>& into, std::uint64_t count) {
    if (count > (bytes_.size() - at_) / sizeof(T))
      return false;
    into.resize(count);
    std::memcpy(static_cast<void*>(into.data()), bytes_.data() + at_, count * sizeof(T));
    at_ += count * sizeof(T);
    return true;
  }

private:
  const std::vector<char>& bytes_;
  std::size_t at_ = 0;
};

bool is_sound(const surface_part& part) {
  const auto points = part.surface.points.size();
  return std::ranges::all_of(
           part.surface.triangles,
           [&](const auto& t) { return t[0] < points && t[1] < points && t[2] < points; }) &&
         std::ranges::all_of(part.patch_of, [&](auto p) { return p < part.shapes.size(); }) &&
         std::ranges::all_of(part.shapes, [](const auto& shape) {
           return shape.form >= surface_form::free && shape.form <= surface_form::sphere;
         });
}

}  // namespace

bool save_surface(const surface_part& part, const std::filesystem::path& folder) {
  std::ofstream out(folder / surface_file, std::ios::binary);
  const surface_header header{surface_magic, part.surface.points.size(),
                              part.surface.triangles.size(), part.shapes.size()};
  put(out, &header, 1);
  put(out, part.surface.points.data(), header.points);
  put(out, part.surface.triangles.data(), header.triangles);
  put(out, part.patch_of.data(), header.triangles);
  put(out, part.shapes.data(), header.patches);
  put(out, part.solid_of.data(), header.patches);
  return static_cast<bool>(out.flush());
}

expected<surface_part> load_surface(const std::filesystem::path& folder) {
  const auto bytes = read_file(folder / surface_file);
  if (!bytes)
    return fail(bytes.error());
  surface_bytes from(*bytes);
  std::vector<surface_header> header;
  surface_part part;
  if (!from.take(header, 1) || header[0].magic != surface_magic ||
      !from.take(part.surface.points, header[0].points) ||
      !from.take(part.surface.triangles, header[0].triangles) ||
      !from.take(part.patch_of, header[0].triangles) ||
      !from.take(part.shapes, header[0].patches) || !from.take(part.solid_of, header[0].patches) ||
      !is_sound(part))
    return fail(ec::internal, "the surface of the import's folder is damaged", "Try again");
  return part;
}

double largest_distance(const triangle_surface& from, const triangle_surface& to) {
  std::vector<std::array<vec3, 3>> there;
  for (const auto& t : from.triangles)
    there.push_back({from.points[t[0]], from.points[t[1]], from.points[t[2]]});
  const facet_distance distance(std::move(there));
  const auto extent = distance.extent();
  const double size = norm(extent.high - extent.low);
  double largest = 0;
  double guess = 1e-3 * size;  // What is near is found by a look at few.
  const auto look = [&](vec3 p) {
    double d = distance(p, guess);
    while (d >= guess && guess < 4 * size) {
      guess *= 4;
      d = distance(p, guess);
    }
    largest = std::max(largest, d);
  };
  for (const auto& t : to.triangles) {
    const vec3 a = to.points[t[0]];
    const vec3 b = to.points[t[1]];
    const vec3 c = to.points[t[2]];
    for (const vec3 p : {a, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (a + b + c) / 3})
      look(p);
  }
  return largest;
}

}  // namespace tedit::scan
