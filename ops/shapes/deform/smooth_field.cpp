// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/deform/smooth_field.hpp"

#include <Eigen/SparseCholesky>

#include "mesh/flat.hpp"
#include "mesh/quality.hpp"

namespace tedit::ops {

namespace {

using matrix = Eigen::SparseMatrix<double>;
using vector = Eigen::VectorXd;

/// Of the residual: the field is then right to rounding, seen beside the way.
constexpr double tolerance = 1e-12;
constexpr int most_steps = 500;

/// The gradients of the four hat functions, 1/m.
std::array<vec3, 4> gradients(const std::array<vec3, 4>& p, double volume) {
  std::array<vec3, 4> result;
  for (int i = 0; i < 4; ++i) {
    const auto& [a, b, c] = tet_faces[i];
    result[i] = -1 / (6 * volume) * cross(p[b] - p[a], p[c] - p[a]);
  }
  return result;
}

}  // namespace

struct smooth_field::equations {
  std::vector<std::uint8_t> is_free;
  std::vector<int> column;  ///< Of each vertex among the free, or the given ones.
  matrix free;              ///< Laplacian: rows of all vertices, columns of the free ones.
  matrix given;             ///< The same, columns of the others.
  vector per_mass;          ///< 1/m^3, by vertex.
  vector free_mass;         ///< m^3, by free vertex.
  Eigen::SimplicialLDLT<matrix> inner;  ///< Rows and columns of the free ones.

  [[nodiscard]] vector bending(const vector& x) const {
    return free.transpose() * per_mass.cwiseProduct(free * x);
  }

  /// What two Laplacians in a row would be, were slopes not given, too: close enough that few steps
  /// are left.
  [[nodiscard]] vector nearly_solved(const vector& r) const {
    return inner.solve(free_mass.cwiseProduct(inner.solve(r)));
  }

  /// Conjugate gradients from x on. Errors: `cancelled`, `not_converged`.
  [[nodiscard]] expected<vector> solve(const vector& right, vector x, double scale,
                                       const cancel_token& cancel) const {
    vector r = right - bending(x);
    if (r.norm() <= tolerance * scale)
      return x;
    vector z = nearly_solved(r);
    vector p = z;
    double rz = r.dot(z);
    for (int step = 0; step < most_steps; ++step) {
      if (cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      const vector kp = bending(p);
      const double along = rz / p.dot(kp);
      x += along * p;
      r -= along * kp;
      if (!(r.norm() > tolerance * scale))
        return x;
      z = nearly_solved(r);
      const double next = r.dot(z);
      p = z + (next / rz) * p;
      rz = next;
    }
    return fail(ec::not_converged, "the tets there are too flat for a smooth field",
                "Give the part better tets first: improve_mesh");
  }

  [[nodiscard]] std::vector<double> spread(const vector& x, std::vector<double> values) const {
    for (std::size_t v = 0; v < values.size(); ++v)
      if (is_free[v])
        values[v] = x[column[v]];
    return values;
  }
};

namespace {

/// Laplacian and mass of all vertices, tet by tet. Tets without volume say nothing.
void assemble(const field_piece& piece, const std::vector<int>& column,
              std::vector<Eigen::Triplet<double>>& free, std::vector<Eigen::Triplet<double>>& given,
              vector& mass) {
  for (const auto& t : piece.tets) {
    const std::array p{piece.at[t[0]], piece.at[t[1]], piece.at[t[2]], piece.at[t[3]]};
    const double volume = signed_volume(p);
    if (is_flat(p, volume) || volume <= 0)
      continue;
    const auto g = gradients(p, volume);
    for (int i = 0; i < 4; ++i) {
      mass[t[i]] += volume / 4;
      for (int j = 0; j < 4; ++j)
        (piece.is_free[t[j]] ? free : given)
          .emplace_back(static_cast<int>(t[i]), column[t[j]], volume * dot(g[i], g[j]));
    }
  }
}

/// The rows of free vertices.
matrix square(const matrix& rows, const std::vector<std::uint8_t>& is_free,
              const std::vector<int>& column) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(rows.nonZeros()));
  for (int c = 0; c < rows.outerSize(); ++c)
    for (matrix::InnerIterator at(rows, c); at; ++at)
      if (is_free[static_cast<std::size_t>(at.row())])
        entries.emplace_back(column[static_cast<std::size_t>(at.row())], c, at.value());
  matrix result(rows.cols(), rows.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

expected<smooth_field> smooth_field::create(const field_piece& piece) {
  const auto made = std::make_shared<equations>();
  made->is_free = piece.is_free;
  std::array<int, 2> count{};
  for (const auto is_free : piece.is_free)
    made->column.push_back(count[is_free]++);
  const auto rows = static_cast<int>(piece.at.size());
  std::vector<Eigen::Triplet<double>> free;
  std::vector<Eigen::Triplet<double>> given;
  vector mass = vector::Zero(rows);
  assemble(piece, made->column, free, given, mass);
  made->free.resize(rows, count[1]);
  made->free.setFromTriplets(free.begin(), free.end());
  made->given.resize(rows, count[0]);
  made->given.setFromTriplets(given.begin(), given.end());
  made->per_mass = (mass.array() > 0).select(mass.array().inverse(), 0.0);
  made->free_mass.resize(count[1]);
  for (std::size_t v = 0; v < piece.at.size(); ++v)
    if (piece.is_free[v])
      made->free_mass[made->column[v]] = mass[static_cast<int>(v)];
  made->inner.compute(square(made->free, made->is_free, made->column));
  if (made->inner.info() != Eigen::Success || !(made->inner.vectorD().array() > 0).all())
    return fail(ec::degenerate_tet, "the part has tets without volume there",
                "Mend them first: improve_mesh");
  smooth_field result;
  result.equations_ = made;
  return result;
}

expected<std::vector<double>> smooth_field::through(std::vector<double> values,
                                                    const cancel_token& cancel) const {
  const auto& e = *equations_;
  vector fixed(e.given.cols());
  vector start(e.free.cols());
  for (std::size_t v = 0; v < values.size(); ++v)
    (e.is_free[v] ? start : fixed)[e.column[v]] = values[v];
  const vector right = -(e.free.transpose() * e.per_mass.cwiseProduct(e.given * fixed));
  const auto x = e.solve(right, start, right.norm(), cancel);
  if (!x)
    return fail(x.error());
  return e.spread(*x, std::move(values));
}

expected<std::vector<double>> smooth_field::bent_by(const std::vector<double>& load,
                                                    const cancel_token& cancel) const {
  const auto& e = *equations_;
  vector right(e.free.cols());
  for (std::size_t v = 0; v < load.size(); ++v)
    if (e.is_free[v])
      right[e.column[v]] = load[v];
  const auto x = e.solve(right, vector::Zero(right.size()), right.norm(), cancel);
  if (!x)
    return fail(x.error());
  return e.spread(*x, std::vector<double>(load.size(), 0.0));
}

}  // namespace tedit::ops
