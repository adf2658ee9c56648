// SPDX-License-Identifier: AGPL-3.0-or-later
// A finer mesh of the same part: each tet is cut into eight at the middles of its edges.
// usage: bench_refine MESH OUT.msh
#include <algorithm>
#include <cstdio>
#include <unordered_map>

#include "mesh/build_version.hpp"
#include "mesh/io/file.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/read_mesh.hpp"

namespace tedit {
namespace {

class refined_mesh {
public:
  explicit refined_mesh(const raw_mesh& coarse) : fine_(coarse) {
    fine_.node_numbers.clear();
    fine_.tet_numbers.clear();
    fine_.tets.clear();
    fine_.tet_regions.clear();
    fine_.triangles.clear();
    for (std::size_t t = 0; t < coarse.tets.size(); ++t)
      cut(coarse.tets[t].v, coarse.tet_regions[t]);
    for (const auto& triangle : coarse.triangles)
      cut(triangle);
  }

  [[nodiscard]] raw_mesh take() { return std::move(fine_); }

private:
  vertex_id middle(vertex_id a, vertex_id b) {
    const auto key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [found, is_new] =
      middles_.emplace(key, static_cast<vertex_id>(fine_.positions.size()));
    if (is_new)
      fine_.positions.push_back(0.5 * (fine_.positions[a] + fine_.positions[b]));
    return found->second;
  }

  void add(std::array<vertex_id, 4> corners, region_id region) {
    fine_.tets.push_back({corners});
    fine_.tet_regions.push_back(region);
  }

  /// Four tets at the corners; the octahedron between them is cut along its shortest diagonal, so
  /// that no cut makes worse shapes than the one before (Bey, "Tetrahedral grid refinement", 1995).
  void cut(const std::array<vertex_id, 4>& v, region_id region) {
    const auto ab = middle(v[0], v[1]), ac = middle(v[0], v[2]), ad = middle(v[0], v[3]);
    const auto bc = middle(v[1], v[2]), bd = middle(v[1], v[3]), cd = middle(v[2], v[3]);
    add({v[0], ab, ac, ad}, region);
    add({ab, v[1], bc, bd}, region);
    add({ac, bc, v[2], cd}, region);
    add({ad, bd, cd, v[3]}, region);
    const auto length = [&](vertex_id a, vertex_id b) {
      return norm(fine_.positions[a] - fine_.positions[b]);
    };
    // Each diagonal with the four other corners around it, seen from its beginning.
    struct ring {
      vertex_id from, to;
      std::array<vertex_id, 4> around;
    };
    const std::array<ring, 3> rings{
      {{ab, cd, {ac, ad, bd, bc}}, {ac, bd, {ab, bc, cd, ad}}, {ad, bc, {ab, ac, cd, bd}}}};
    const auto& best = *std::ranges::min_element(
      rings, {}, [&](const ring& one) { return length(one.from, one.to); });
    for (std::size_t i = 0; i < 4; ++i)
      add({best.from, best.to, best.around[i], best.around[(i + 1) % 4]}, region);
  }

  void cut(const raw_mesh::triangle& whole) {
    const auto [a, b, c] = whole.v;
    const auto ab = middle(a, b), ac = middle(a, c), bc = middle(b, c);
    for (const auto& part : {std::array{a, ab, ac}, {ab, b, bc}, {ac, bc, c}, {ab, bc, ac}})
      fine_.triangles.push_back({part, whole.surface, whole.has_surface});
  }

  raw_mesh fine_;
  std::unordered_map<std::uint64_t, vertex_id> middles_;
};

int refine(const char* from, const char* to) {
  const auto bytes = read_file(from);
  if (!bytes)
    return std::fprintf(stderr, "%s\n", bytes.error().message.c_str()), 1;
  const auto coarse = read_any(std::span<const char>(*bytes));
  if (!coarse)
    return std::fprintf(stderr, "%s\n", coarse.error().message.c_str()), 1;
  const auto fine = build_version(refined_mesh(coarse->mesh).take(), 1);
  if (!fine)
    return std::fprintf(stderr, "%s\n", fine.error().message.c_str()), 1;
  if (const auto ok = formats::msh::write(std::filesystem::path(to), *fine->version, {"m"}); !ok)
    return std::fprintf(stderr, "%s\n", ok.error().message.c_str()), 1;
  std::printf("%u tets, %u vertices\n", fine->version->tet_count(), fine->version->vertex_count());
  return 0;
}

}  // namespace
}  // namespace tedit

int main(int argc, char** argv) {
  if (argc != 3)
    return std::fprintf(stderr, "usage: bench_refine MESH OUT.msh\n"), 2;
  return tedit::refine(argv[1], argv[2]);
}
