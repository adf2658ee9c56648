// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/isosurface/isosurface.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace tedit::ops {

namespace {

/// A point of the grid; its bits in 64: 21 for each axis.
struct grid_point {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;

  [[nodiscard]] std::uint64_t key() const {
    constexpr std::int64_t bias = 1 << 20;
    return static_cast<std::uint64_t>(x + bias) << 42 | static_cast<std::uint64_t>(y + bias) << 21 |
           static_cast<std::uint64_t>(z + bias);
  }
  [[nodiscard]] grid_point plus(int dx, int dy, int dz) const { return {x + dx, y + dy, z + dz}; }
  [[nodiscard]] grid_point corner(int i) const { return plus(i & 1, i >> 1 & 1, i >> 2 & 1); }
  /// The cell whose corner i this is.
  [[nodiscard]] grid_point minus(int i) const {
    return plus(-(i & 1), -(i >> 1 & 1), -(i >> 2 & 1));
  }
};

/// Of a cell: its edges by their corners (bit 0: x, 1: y, 2: z), four for each axis.
constexpr std::array<std::array<int, 2>, 12> cell_edges{
  {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// Of a cell: its faces by their corners, in a circle.
constexpr std::array<std::array<int, 4>, 6> cell_faces{
  {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};

int edge_between(int a, int b) {
  for (int e = 0; e < 12; ++e)
    if ((cell_edges[e][0] == a && cell_edges[e][1] == b) ||
        (cell_edges[e][0] == b && cell_edges[e][1] == a))
      return e;
  return -1;
}

/// Which of a cell's twelve edges the same piece of the surface crosses, by a number for each
/// piece; -1 for edges that are not crossed. On a face with inside at two opposite corners only,
/// these are kept apart: the cell on the other side does the same.
std::array<int, 12> pieces_of(const std::array<bool, 8>& inside) {
  std::array<int, 12> root{};
  for (int e = 0; e < 12; ++e)
    root[e] = inside[cell_edges[e][0]] != inside[cell_edges[e][1]] ? e : -1;
  const auto find = [&](int e) {
    while (root[e] != e)
      e = root[e];
    return e;
  };
  for (const auto& face : cell_faces) {
    std::array<int, 4> crossed{};
    int n = 0;
    for (int i = 0; i < 4; ++i)
      if (inside[face[i]] != inside[face[(i + 1) % 4]])
        crossed[n++] = i;
    const auto edge = [&](int i) { return edge_between(face[i], face[(i + 1) % 4]); };
    if (n == 2)
      root[find(edge(crossed[0]))] = find(edge(crossed[1]));
    if (n == 4)
      for (int i = 0; i < 4; ++i)
        if (inside[face[i]])
          root[find(edge(i))] = find(edge((i + 3) % 4));
  }
  std::array<int, 12> result{};
  for (int e = 0; e < 12; ++e)
    result[e] = root[e] < 0 ? -1 : find(e);
  return result;
}

/// Where a piece of the surface crosses an edge of the grid, and which way it looks there.
struct crossing {
  vec3 at;
  vec3 normal;
};

/// The point with the least squared distance from the planes of the crossings, as near to their
/// middle as can be where these leave it free; within the cell.
vec3 sharp_point(const std::vector<crossing>& crossings, vec3 middle, vec3 low, double cell) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (const auto& c : crossings) {
    const Eigen::Vector3d n(c.normal.x, c.normal.y, c.normal.z);
    a += n * n.transpose();
    b += dot(c.normal, c.at - middle) * n;
  }
  // Directions in which the planes hardly differ are left free (Ju et al., section 2.3).
  constexpr double flat = 0.05;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(a);
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (axes.eigenvalues()[i] > flat * axes.eigenvalues()[2]) {
      const Eigen::Vector3d axis = axes.eigenvectors().col(i);
      step += axis.dot(b) / axes.eigenvalues()[i] * axis;
    }
  const auto within = [&](double x, double from) { return std::clamp(x, from, from + cell); };
  return {within(middle.x + step.x(), low.x), within(middle.y + step.y(), low.y),
          within(middle.z + step.z(), low.z)};
}

class contourer {
public:
  contourer(const distance_field& field, const isosurface_settings& settings, const execution& run)
      : field_(field), settings_(settings), run_(run) {
    origin_ =
      settings.extent.low - 2 * settings.cell * vec3{1, 1, 1} + settings.cell * settings.shift;
  }

  expected<contoured_surface> contour() {
    const vec3 size = settings_.extent.high - origin_;
    const double longest = std::max({size.x, size.y, size.z}) / settings_.cell + 3;
    if (longest > 1 << 19)
      return fail(too_fine());
    int span = 1;
    while (span < longest)
      span *= 2;
    if (auto ok = collect({}, span); !ok)
      return fail(ok.error());
    complete_cells();
    for (const auto& cell : cells_)
      place_vertices(cell);
    for (const auto& cell : cells_)
      add_quads(cell);
    return contoured_surface{std::move(result_), std::move(middles_)};
  }

private:
  [[nodiscard]] vec3 place(grid_point p) const {
    return origin_ + settings_.cell * vec3{double(p.x), double(p.y), double(p.z)};
  }

  [[nodiscard]] static error too_fine() {
    return {ec::invalid_parameter, "it is too thin for the size of the part: too many triangles",
            "Take a larger thickness"};
  }

  double value(grid_point p) {
    const auto [found, is_new] = values_.emplace(p.key(), 0);
    if (is_new)
      found->second = field_(place(p)).value;
    return found->second;
  }

  bool inside(grid_point p) { return value(p) < 0; }

  /// The cells below that the surface may run through: elsewhere the middle is too far from it.
  expected<void> collect(grid_point low, int span) {
    if (run_.cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    const double half = 0.5 * span * settings_.cell;
    const vec3 middle = place(low) + half * vec3{1, 1, 1};
    if (std::abs(field_(middle).value) > 1.0001 * std::sqrt(3.0) * half)
      return {};
    if (span == 1) {
      std::array<bool, 8> in{};
      for (int i = 0; i < 8; ++i)
        in[i] = inside(low.corner(i));
      if (std::ranges::count(in, true) % 8 != 0)
        cells_.push_back(low);
      return cells_.size() > settings_.most_cells ? expected<void>(fail(too_fine()))
                                                  : expected<void>();
    }
    for (int i = 0; i < 8; ++i)
      if (auto ok =
            collect(low.plus((i & 1) * span / 2, (i >> 1 & 1) * span / 2, (i >> 2 & 1) * span / 2),
                    span / 2);
          !ok)
        return ok;
    return {};
  }

  /// Adds all cells around a crossed edge: a field that changes faster than the place does (at the
  /// rim of an open wall) may have hidden some, and the surface would have a hole there.
  void complete_cells() {
    std::unordered_set<std::uint64_t> known;
    for (const auto& cell : cells_)
      known.insert(cell.key());
    for (std::size_t i = 0; i < cells_.size(); ++i)
      for (const auto& edge : cell_edges) {
        const auto cell = cells_[i];
        if (inside(cell.corner(edge[0])) == inside(cell.corner(edge[1])))
          continue;
        const int axis = edge[0] ^ edge[1];  // Its bit.
        const auto start = cell.corner(edge[0]);
        for (int corner = 0; corner < 8; ++corner)
          if (const auto beside = start.minus(corner);
              (corner & axis) == 0 && known.insert(beside.key()).second)
            cells_.push_back(beside);
      }
  }

  /// By halving and, where the field is straight, at once.
  crossing find_crossing(grid_point a, grid_point b) {
    vec3 p = place(a);
    vec3 q = place(b);
    double fp = value(a);
    double fq = value(b);
    field_sample at;
    vec3 x;
    for (int i = 0; i < 40; ++i) {
      const double share = i % 3 == 2 ? 0.5 : fp / (fp - fq);
      x = p + share * (q - p);
      at = field_(x);
      if (std::abs(at.value) < 1e-9 * settings_.cell || norm(q - p) < 1e-9 * settings_.cell)
        break;
      ((at.value < 0) == (fp < 0) ? p : q) = x;
      ((at.value < 0) == (fp < 0) ? fp : fq) = at.value;
    }
    return {x, at.gradient};
  }

  void place_vertices(grid_point cell) {
    std::array<bool, 8> in{};
    for (int i = 0; i < 8; ++i)
      in[i] = inside(cell.corner(i));
    const auto pieces = pieces_of(in);
    auto& vertices = vertices_[cell.key()];
    vertices.fill(no_id);
    for (int piece = 0; piece < 12; ++piece) {
      std::vector<crossing> crossings;
      for (int e = 0; e < 12; ++e)
        if (pieces[e] == piece)
          crossings.push_back(
            find_crossing(cell.corner(cell_edges[e][0]), cell.corner(cell_edges[e][1])));
      if (crossings.empty())
        continue;
      for (int e = 0; e < 12; ++e)
        if (pieces[e] == piece)
          vertices[e] = static_cast<std::uint32_t>(result_.points.size());
      vec3 middle;
      for (const auto& c : crossings)
        middle += c.at / static_cast<double>(crossings.size());
      result_.points.push_back(sharp_point(crossings, middle, place(cell), settings_.cell));
      middles_.push_back(middle);
    }
  }

  /// At the three edges that begin in the cell's first corner: each belongs to four cells.
  void add_quads(grid_point cell) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto end = cell.plus(axis == 0, axis == 1, axis == 2);
      const bool first = inside(cell);
      if (first == inside(end))
        continue;
      // Around the edge, right-handed about the axis; the edge's number in each of the cells.
      constexpr std::array<std::array<int, 3>, 3> u{{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
      constexpr std::array<std::array<int, 3>, 3> w{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
      std::array<std::uint32_t, 4> quad{};
      for (int i = 0; i < 4; ++i) {
        const int du = i == 0 || i == 3 ? 1 : 0;
        const int dw = i < 2 ? 1 : 0;
        const auto of =
          cell.plus(-du * u[axis][0] - dw * w[axis][0], -du * u[axis][1] - dw * w[axis][1],
                    -du * u[axis][2] - dw * w[axis][2]);
        const int corner = du * bits(u[axis]) + dw * bits(w[axis]);
        quad[i] = vertices_.at(of.key())[edge_between(corner, corner | 1 << axis)];
      }
      if (!first)
        std::swap(quad[1], quad[3]);
      add_quad(quad);
    }
  }

  static int bits(const std::array<int, 3>& step) { return step[0] | step[1] << 1 | step[2] << 2; }

  void add_quad(const std::array<std::uint32_t, 4>& q) {
    const auto& p = result_.points;
    const bool other = norm(p[q[1]] - p[q[3]]) < norm(p[q[0]] - p[q[2]]);
    const int s = other ? 1 : 0;
    result_.triangles.push_back({q[s], q[s + 1], q[s + 2]});
    result_.triangles.push_back({q[s], q[s + 2], q[(s + 3) % 4]});
  }

  const distance_field& field_;
  const isosurface_settings& settings_;
  const execution& run_;
  vec3 origin_;
  std::unordered_map<std::uint64_t, double> values_;
  std::vector<grid_point> cells_;
  std::unordered_map<std::uint64_t, std::array<std::uint32_t, 12>> vertices_;
  closed_surface result_;
  std::vector<vec3> middles_;
};

}  // namespace

expected<contoured_surface> isosurface(const distance_field& field,
                                       const isosurface_settings& settings, const execution& run) {
  return contourer(field, settings, run).contour();
}

}  // namespace tedit::ops
