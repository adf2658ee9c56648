// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/section.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace tedit {

namespace {

constexpr tet_id poll_every = 1 << 14;

/// Collects the points on edges, each once.
class cutter {
public:
  cutter(const mesh_version& mesh, const vec3& at, const vec3& normal)
      : mesh_(mesh), normal_(normal), heights_(mesh.vertex_slots()) {
    for (vertex_id v = 0; v < mesh.vertex_slots(); ++v)
      heights_[v] = mesh.is_live_vertex(v) ? dot(mesh.position(v) - at, normal) : 0;
  }

  /// Three points when one vertex is alone on its side, four when two are.
  void cut(const tet& t) {
    std::array<vertex_id, 4> above{};
    std::array<vertex_id, 4> below{};
    int n = 0;
    int m = 0;
    for (const auto v : t.v)
      if (heights_[v] >= 0)
        above[n++] = v;
      else
        below[m++] = v;
    if (n == 0 || m == 0)
      return;
    if (n == 1)
      add({point(above[0], below[0]), point(above[0], below[1]), point(above[0], below[2])});
    else if (m == 1)
      add({point(below[0], above[0]), point(below[0], above[1]), point(below[0], above[2])});
    else {
      const std::array<std::uint32_t, 4> loop{point(above[0], below[0]), point(above[0], below[1]),
                                              point(above[1], below[1]), point(above[1], below[0])};
      add({loop[0], loop[1], loop[2]});
      add({loop[0], loop[2], loop[3]});
    }
  }

  [[nodiscard]] plane_section take() { return std::move(result_); }

private:
  std::uint32_t point(vertex_id p, vertex_id q) {
    const auto a = std::min(p, q);
    const auto b = std::max(p, q);
    const auto key = static_cast<std::uint64_t>(a) << 32 | b;
    const auto [found, fresh] =
      numbers_.try_emplace(key, static_cast<std::uint32_t>(result_.points.size()));
    if (fresh)
      result_.points.push_back({a, b, heights_[a] / (heights_[a] - heights_[b])});
    return found->second;
  }

  void add(std::array<std::uint32_t, 3> corners) {
    const vec3 p = result_.position(mesh_, corners[0]);
    const vec3 n =
      cross(result_.position(mesh_, corners[1]) - p, result_.position(mesh_, corners[2]) - p);
    const double side = dot(n, normal_);
    if (side == 0)
      return;  // Of no area: the plane goes through a vertex or an edge.
    if (side < 0)
      std::swap(corners[1], corners[2]);
    result_.triangles.push_back(corners);
  }

  const mesh_version& mesh_;
  vec3 normal_;
  std::vector<double> heights_;  ///< By vertex slot; the normal's length is in it.
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
  plane_section result_;
};

}  // namespace

expected<plane_section> cut_by_plane(const mesh_version& mesh, const vec3& at, const vec3& normal,
                                     const execution& run) {
  const double length = std::sqrt(dot(normal, normal));
  if (!std::isfinite(length) || length == 0 || !std::isfinite(dot(at, at)))
    return fail(ec::invalid_argument, "the section's point and normal give no plane",
                "Give finite numbers and a normal that is not zero");
  cutter work(mesh, at, normal / length);
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (t % poll_every == 0 && run.cancel.cancelled())
      return fail(ec::cancelled, "the section was cancelled");
    if (mesh.is_live_tet(t))
      work.cut(mesh.tet_at(t));
  }
  return work.take();
}

}  // namespace tedit
