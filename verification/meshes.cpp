// SPDX-License-Identifier: AGPL-3.0-or-later
#include "verification/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/build_version.hpp"
#include "mesh/quality.hpp"

namespace tedit::verification {

namespace {

/// The grid of a block before its points are moved.
class grid {
public:
  explicit grid(std::array<int, 3> cells) : cells_(cells) {}

  [[nodiscard]] vertex_id at(std::array<int, 3> i) const {
    return static_cast<vertex_id>((i[2] * (cells_[1] + 1) + i[1]) * (cells_[0] + 1) + i[0]);
  }

  void add_points(const placement& place, raw_mesh& raw) const {
    const auto [n, m, l] = cells_;
    for (int k = 0; k <= l; ++k)
      for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i)
          raw.positions.push_back(place({1.0 * i / n, 1.0 * j / m, 1.0 * k / l}));
  }

  /// Six tets: the six ways from the lowest to the highest corner along the axes.
  void add_cell(std::array<int, 3> low, raw_mesh& raw) const {
    // The first three ways turn right-handed, the others have two corners swapped.
    constexpr std::array<std::array<int, 3>, 6> ways{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
    for (std::size_t way = 0; way < ways.size(); ++way) {
      auto corner = low;
      tet t;
      t.v[0] = at(corner);
      for (int step = 0; step < 3; ++step) {
        ++corner[ways[way][step]];
        t.v[step + 1] = at(corner);
      }
      if (way >= 3)
        std::swap(t.v[2], t.v[3]);
      raw.tets.push_back(t);
      raw.tet_regions.push_back(1);
    }
  }

  void add_side(int axis, bool high, surface_id id, raw_mesh& raw) const {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (int i = 0; i < cells_[u]; ++i)
      for (int j = 0; j < cells_[v]; ++j) {
        const auto corner = [&](int a, int b) {
          std::array<int, 3> where{};
          where[axis] = high ? cells_[axis] : 0;
          where[u] = i + a;
          where[v] = j + b;
          return at(where);
        };
        raw.triangles.push_back({{corner(0, 0), corner(1, 0), corner(1, 1)}, id, true});
        raw.triangles.push_back({{corner(0, 0), corner(1, 1), corner(0, 1)}, id, true});
      }
  }

private:
  std::array<int, 3> cells_;
};

double volume_of(const raw_mesh& raw, const tet& t) {
  const auto& x = raw.positions;
  return signed_volume(x[t.v[0]], x[t.v[1]], x[t.v[2]], x[t.v[3]]);
}

/// All tets of a grid have one sign, or its placement folds. A mirrored grid is turned as a whole.
expected<void> orient(raw_mesh& raw) {
  std::size_t negative = 0;
  for (const auto& t : raw.tets)
    negative += volume_of(raw, t) <= 0 ? 1 : 0;
  if (negative != 0 && negative != raw.tets.size())
    return fail(ec::invalid_mesh, "the placement turns " + std::to_string(negative) + " of " +
                                    std::to_string(raw.tets.size()) + " tets inside out");
  if (negative != 0)
    for (auto& t : raw.tets)
      std::swap(t.v[2], t.v[3]);
  return {};
}

expected<version_ptr> build(raw_mesh raw) {
  auto built = build_version(std::move(raw), 1);
  if (!built)
    return fail(built.error());
  return built->version;
}

/// A triangulated spherical triangle and its copies on several radii.
class octant {
public:
  octant(int along, int layers) : along_(along), layers_(layers) {}

  void add_points(double a, double b, raw_mesh& raw) const {
    for (int layer = 0; layer <= layers_; ++layer) {
      // Geometric: prisms keep their shape from layer to layer.
      const double r = a * std::pow(b / a, 1.0 * layer / layers_);
      for (int i = 0; i <= along_; ++i)
        for (int j = 0; i + j <= along_; ++j)
          raw.positions.push_back(r * normalized({1.0 * i, 1.0 * j, 1.0 * (along_ - i - j)}));
    }
  }

  void add_cells(raw_mesh& raw) const {
    for (int i = 0; i < along_; ++i)
      for (int j = 0; i + j < along_; ++j) {
        add_column({point(i, j), point(i + 1, j), point(i, j + 1)}, raw);
        if (i + j + 1 < along_)
          add_column({point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)}, raw);
      }
  }

  void add_walls(raw_mesh& raw) const {
    for (int i = 0; i < along_; ++i) {
      add_wall(point(0, i), point(0, i + 1), x_zero, raw);
      add_wall(point(i, 0), point(i + 1, 0), y_zero, raw);
      add_wall(point(i, along_ - i), point(i + 1, along_ - i - 1), z_zero, raw);
    }
  }

private:
  [[nodiscard]] vertex_id point(int i, int j) const {
    return static_cast<vertex_id>(i * (along_ + 1) - i * (i - 1) / 2 + j);
  }

  [[nodiscard]] vertex_id lifted(vertex_id v, int layer) const {
    return v + static_cast<vertex_id>(layer * ((along_ + 1) * (along_ + 2) / 2));
  }

  /// Prisms over one triangle. Side faces are cut from the lower end of the smaller number to the
  /// upper end of the larger one, so that neighbours fit.
  void add_column(std::array<vertex_id, 3> corners, raw_mesh& raw) const {
    std::ranges::sort(corners);
    for (int layer = 0; layer < layers_; ++layer) {
      std::array<vertex_id, 6> v;
      for (int i = 0; i < 3; ++i) {
        v[i] = lifted(corners[i], layer);
        v[3 + i] = lifted(corners[i], layer + 1);
      }
      for (const auto& [a, b, c, d] :
           {std::array{0, 1, 2, 5}, std::array{0, 1, 4, 5}, std::array{0, 3, 4, 5}}) {
        tet t{{v[a], v[b], v[c], v[d]}};
        if (volume_of(raw, t) < 0)
          std::swap(t.v[2], t.v[3]);
        raw.tets.push_back(t);
        raw.tet_regions.push_back(1);
      }
      if (layer == 0)
        raw.triangles.push_back({{v[0], v[1], v[2]}, inner, true});
      if (layer == layers_ - 1)
        raw.triangles.push_back({{v[3], v[4], v[5]}, outer, true});
    }
  }

  void add_wall(vertex_id p, vertex_id q, surface_id id, raw_mesh& raw) const {
    if (p > q)
      std::swap(p, q);
    for (int layer = 0; layer < layers_; ++layer) {
      const auto up = [&](vertex_id v) { return lifted(v, layer + 1); };
      const auto down = [&](vertex_id v) { return lifted(v, layer); };
      raw.triangles.push_back({{down(p), down(q), up(q)}, id, true});
      raw.triangles.push_back({{down(p), up(q), up(p)}, id, true});
    }
  }

  int along_;
  int layers_;
};

/// Cosine and sine of a part of 90 degrees, exact at both ends: the rounding of pi would leave a
/// trace on symmetry planes.
std::array<double, 2> quarter_turn(double part) {
  const double angle = 0.5 * std::numbers::pi * part;
  return {part == 1 ? 0 : std::cos(angle), part == 0 ? 0 : std::sin(angle)};
}

}  // namespace

expected<version_ptr> block_mesh(std::array<int, 3> cells, const placement& place) {
  if (std::ranges::min(cells) < 1)
    return fail(ec::invalid_argument, "a block needs at least one cell along each axis");
  raw_mesh raw;
  const grid g(cells);
  g.add_points(place, raw);
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i)
        g.add_cell({i, j, k}, raw);
  if (auto ok = orient(raw); !ok)
    return fail(ok.error());
  for (int axis = 0; axis < 3; ++axis) {
    g.add_side(axis, false, 2 * axis + 1, raw);
    g.add_side(axis, true, 2 * axis + 2, raw);
  }
  return build(std::move(raw));
}

expected<version_ptr> octant_mesh(int along, int layers, double inner_radius, double outer_radius) {
  if (along < 1 || layers < 1 || !(inner_radius > 0) || !(outer_radius > inner_radius))
    return fail(ec::invalid_argument, "an octant needs cells and two growing radii");
  raw_mesh raw;
  const octant o(along, layers);
  o.add_points(inner_radius, outer_radius, raw);
  o.add_cells(raw);
  o.add_walls(raw);
  return build(std::move(raw));
}

placement box(vec3 size) {
  return [size](vec3 p) { return vec3{size.x * p.x, size.y * p.y, size.z * p.z}; };
}

placement shaken_box(vec3 size) {
  const double reach = 0.06 * std::min({size.x, size.y, size.z});
  return [size, reach](vec3 p) {
    using std::numbers::pi;
    const double s = reach * std::sin(pi * p.x) * std::sin(pi * p.y) * std::sin(pi * p.z);
    const vec3 shift{std::sin(7 * p.y), std::cos(5 * p.z), std::sin(3 * p.x + 1)};
    return vec3{size.x * p.x, size.y * p.y, size.z * p.z} + s * shift;
  };
}

vec3 quarter_ring::operator()(vec3 stu) const {
  const double s = std::pow(stu.x, towards_inside);
  const auto [c, d] = quarter_turn(std::pow(stu.y, towards_x));
  return {c * (inside[0] + s * (outside[0] - inside[0])),
          d * (inside[1] + s * (outside[1] - inside[1])), height * stu.z};
}

vec3 tapered_sphere(vec3 stu) {
  using point = std::array<double, 2>;  // r, z
  constexpr double knee = std::numbers::sqrt2 / 2;
  const auto between = [](point a, point b, double t) {
    return point{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
  };
  const auto on_circle = [](double radius, double angle) {
    return point{radius * std::cos(angle), angle == 0 ? 0 : radius * std::sin(angle)};
  };
  const double height = knee + 0.69;
  const auto at = [&](double radius, double shoulder) {
    // Where the circle of this radius reaches the knee's height.
    const double angle = std::asin(knee / radius);
    const point corner{shoulder, height};
    if (stu.y <= 0.4)
      return on_circle(radius, angle * stu.y / 0.4);
    if (stu.y <= 0.8)
      return between(on_circle(radius, angle), corner, (stu.y - 0.4) / 0.4);
    return between(corner, {shoulder, height + 0.4}, (stu.y - 0.8) / 0.2);
  };
  const auto [r, z] = between(at(1, knee), at(1.4, 1), stu.x);
  const auto [c, d] = quarter_turn(stu.z);
  return {c * r, d * r, z};
}

}  // namespace tedit::verification
