// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstdlib>
#include <cstring>
#include <map>

#include "base/child_process.hpp"
#include "mesh/face_key.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"
#include "ops/services/host_services.hpp"
#include "ops/tetgen/exchange.hpp"

namespace tedit::ops {

namespace {

template <class T>
void append(std::vector<char>& bytes, const T* first, std::size_t count) {
  const auto* raw = reinterpret_cast<const char*>(first);
  bytes.insert(bytes.end(), raw, raw + count * sizeof(T));
}

/// Unit size about the origin: TetGen's tolerances are absolute in places.
struct normalisation {
  vec3 centre;
  double scale = 1;

  explicit normalisation(const std::vector<vec3>& points) {
    for (const auto& p : points)
      centre += p / static_cast<double>(points.size());
    double far = 0;
    for (const auto& p : points)
      far = std::max(far, norm(p - centre));
    scale = far > 0 ? 1 / far : 1;
  }
};

expected<tet_filling> parse(const std::vector<char>& output, const closed_surface& shell,
                            const normalisation& units) {
  const auto damaged = [] { return fail(ec::mesher_failed, "the mesher's answer is damaged"); };
  exchange_header header;
  if (output.size() < sizeof(header))
    return damaged();
  std::memcpy(&header, output.data(), sizeof(header));
  const std::size_t expected_size = sizeof(header) + 24ull * header.points + 16ull * header.cells;
  if (header.magic != exchange_header{}.magic || output.size() != expected_size ||
      header.points < shell.points.size())
    return damaged();
  tet_filling filling;
  filling.points.resize(header.points);
  filling.tets.resize(header.cells);
  std::memcpy(filling.points.data(), output.data() + sizeof(header), 24ull * header.points);
  std::memcpy(filling.tets.data(), output.data() + sizeof(header) + 24ull * header.points,
              16ull * header.cells);
  for (std::size_t i = 0; i < filling.points.size(); ++i) {
    auto& p = filling.points[i];
    const vec3 back = units.centre + p / units.scale;
    if (i >= shell.points.size()) {
      p = back;
      continue;
    }
    if (norm(back - shell.points[i]) > 1e-9 / units.scale)
      return fail(ec::mesher_failed, "the mesher moved a point of the surface");
    p = shell.points[i];
  }
  return filling;
}

/// Every tet positive, every shell triangle on exactly one tet, nothing else bare.
expected<void> verify(const closed_surface& shell, tet_filling& filling) {
  std::map<std::array<vertex_id, 3>, int> faces;
  for (auto& t : filling.tets) {
    for (const auto v : t)
      if (v >= filling.points.size())
        return fail(ec::mesher_failed, "the mesher's answer is damaged");
    const auto& p = filling.points;
    const int sign = orient3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
    if (sign < 0)
      std::swap(t[2], t[3]);
    // Below this a tet is as good as flat: no smoothing rescues it.
    if (sign == 0 || radius_ratio(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) < 1e-3)
      return fail(ec::mesher_failed, "the mesher made a flat tet");
    for (int face = 0; face < 4; ++face)
      ++faces[make_face_key(tet{{t[0], t[1], t[2], t[3]}}, face).v];
  }
  std::size_t bare = 0;
  for (const auto& [key, count] : faces)
    bare += count == 1;
  for (const auto& triangle : shell.triangles) {
    const auto found = faces.find(make_face_key(triangle).v);
    if (found == faces.end() || found->second != 1)
      return fail(ec::mesher_failed, "the mesher did not keep the surface's triangles");
  }
  if (bare != shell.triangles.size())
    return fail(ec::mesher_failed, "the mesher left gaps");
  return {};
}

}  // namespace

std::filesystem::path mesher_program() {
  if (const char* folder = std::getenv("TEDIT_LIBEXEC"))
    return std::filesystem::path(folder) / "tedit-tetgen";
  return executable_folder() / "tedit-tetgen";
}

expected<tet_filling> tetrahedralise_surface(const closed_surface& shell, const execution& run) {
  if (shell.points.size() < 4 || shell.triangles.size() < 4)
    return fail(ec::mesher_failed, "a closed surface has at least four triangles");
  const normalisation units(shell.points);
  exchange_header header;
  header.points = static_cast<std::uint32_t>(shell.points.size());
  header.cells = static_cast<std::uint32_t>(shell.triangles.size());
  std::vector<char> input;
  append(input, &header, 1);
  for (const auto& p : shell.points) {
    const vec3 scaled = units.scale * (p - units.centre);
    append(input, &scaled, 1);
  }
  append(input, shell.triangles.data(), shell.triangles.size());
  const auto output = run_child({mesher_program().string()}, input, {}, run);
  if (!output)
    return fail(output.error());
  auto filling = parse(*output, shell, units);
  if (!filling)
    return fail(filling.error());
  if (auto ok = verify(shell, *filling); !ok)
    return fail(ok.error());
  return filling;
}

}  // namespace tedit::ops
