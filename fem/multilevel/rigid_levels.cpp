// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/rigid_levels.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/multilevel/lanczos.hpp"
#include "fem/multilevel/node_smoother.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

matrix36 rigid_modes(vec3 d) {
  matrix36 m;
  m << 1, 0, 0, 0, d.z, -d.y, 0, 1, 0, -d.z, 0, d.x, 0, 0, 1, d.y, -d.x, 0;
  return m;
}

/// A column that had no sum yet; `number` is its place in the table.
row_sum::block& row_sum::add(std::uint32_t column, std::uint32_t* number) {
  *number = static_cast<std::uint32_t>(column_.size());
  column_.push_back(column);
  if (column_.size() == numbers_.most()) {
    numbers_.start(2 * column_.size());
    for (std::uint32_t i = 0; i < column_.size(); ++i)
      *numbers_.at(column_[i]).first = i;
  }
  if (block_.size() < column_.size())
    block_.resize(2 * column_.size());
  auto& added = block_[column_.size() - 1];
  added.fill(0);
  return added;
}

void row_sum::finish(std::vector<std::uint32_t>& column, std::vector<matrix6>& blocks) {
  std::vector<std::uint32_t> order(column_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return column_[i]; });
  column.reserve(column.size() + order.size());
  blocks.reserve(blocks.size() + order.size());
  for (const auto i : order) {
    column.push_back(column_[i]);
    blocks.emplace_back(view(block_[i].data()));
  }
  column_.clear();
  numbers_.start(0);
}

matrix6 remove_null_motions(const matrix6& gram, row_sum::view diagonal) {
  constexpr double none = 1e-6;
  // The smallest eigenvalue is the determinant over the product of the others, which is largest
  // where they are equal: mostly that tells that there is nothing to look for.
  const double trace = gram.trace();
  if (gram.determinant() > none * trace * std::pow(trace / 5, 5))
    return matrix6::Identity();
  const Eigen::SelfAdjointEigenSolver<matrix6> modes(gram);
  const double largest = modes.eigenvalues()[5];
  matrix6 keep = matrix6::Identity();
  const double stiffness = diagonal.trace() > 0 ? diagonal.trace() / 6 : 1;
  for (int i = 0; i < 6; ++i)
    if (modes.eigenvalues()[i] <= none * largest) {
      const matrix6 null = modes.eigenvectors().col(i) * modes.eigenvectors().col(i).transpose();
      keep -= null;
      diagonal += stiffness * null;
    }
  return keep;
}

matrix6 inverse_of(const matrix6& m) {
  Eigen::LDLT<matrix6> factor(m);
  if (factor.info() == Eigen::Success && factor.isPositive() && factor.rcond() > 1e-14)
    return factor.solve(matrix6::Identity());
  const matrix6 shifted = m + 1e-8 * m.trace() * matrix6::Identity();
  return shifted.inverse();
}

matrix6 parent_modes(const level_memory& level, const level_memory& parents, std::size_t i) {
  const auto& child = level.frames[i];
  const auto& parent = parents.frames[level.group[i]];
  matrix6 m = matrix6::Identity();
  m.topRightCorner<3, 3>() =
    rigid_modes((child.centre - parent.centre) / parent.radius).rightCols<3>();
  m.bottomRightCorner<3, 3>() *= child.radius / parent.radius;
  return level.keep[i] * m;
}

namespace {

void multiply(const rigid_level& level, const float* x, float* y) {
  parallel_for(
    level.nodes(),
    [&](std::size_t first, std::size_t last, std::size_t) {
      using vector6f = Eigen::Matrix<float, 6, 1>;
      for (std::size_t i = first; i < last; ++i) {
        vector6f sum = vector6f::Zero();
        for (auto s = level.rows.begin(i); s < level.rows.end(i); ++s)
          sum += Eigen::Map<const Eigen::Matrix<float, 6, 6>>(level.block[s].data()) *
                 Eigen::Map<const vector6f>(x + 6 * std::size_t{level.column[s]});
        Eigen::Map<vector6f>(y + 6 * i) = sum;
      }
    },
    512);
}

void estimate_lambda(const multilevel_settings& settings, rigid_level& level) {
  const float lambda = largest_ritz_value(
    6 * std::size_t{level.nodes()}, 0, settings.lambda_steps,
    [&](const float* x, float* y) { multiply(level, x, y); },
    [&](const float* x, float* y) {
      for (std::size_t i = 0; i < level.nodes(); ++i)
        Eigen::Map<Eigen::Matrix<float, 6, 1>>(y + 6 * i) =
          Eigen::Map<const Eigen::Matrix<float, 6, 6>>(level.inverse[i].data()) *
          Eigen::Map<const Eigen::Matrix<float, 6, 1>>(x + 6 * i);
    });
  level.lambda = settings.lambda_safety * lambda;
}

float norm_of(const rigid_level::block6& block) {
  return Eigen::Map<const Eigen::Matrix<float, 6, 6>>(block.data()).norm();
}

node_graph graph_of(const rigid_level& level) {
  node_graph graph;
  std::vector<float> scale(level.nodes(), 0);
  const auto for_entries = [&](const auto& visit) {
    polled_for(
      level.nodes(),
      [&](std::size_t at) {
        const auto i = static_cast<std::uint32_t>(at);
        for (auto s = level.rows.begin(i); s < level.rows.end(i); ++s)
          visit(i, level.column[s], s);
      },
      1024);
  };
  for_entries([&](std::uint32_t i, std::uint32_t j, std::uint32_t s) {
    if (i == j)
      scale[i] = 1 / std::sqrt(norm_of(level.block[s]));
  });
  graph.first.assign(1, 0);
  for_entries([&](std::uint32_t i, std::uint32_t j, std::uint32_t s) {
    graph.first.resize(i + 1, static_cast<std::uint32_t>(graph.column.size()));
    if (i == j)
      return;
    graph.column.push_back(j);
    graph.weight.push_back(norm_of(level.block[s]) * scale[i] * scale[j]);
  });
  graph.first.resize(level.nodes() + 1, static_cast<std::uint32_t>(graph.column.size()));
  return graph;
}

std::vector<rigid_frame> parent_frames(const std::vector<rigid_frame>& frames,
                                       const member_lists& children) {
  std::vector<rigid_frame> result(children.owners());
  for (std::size_t a = 0; a < result.size(); ++a) {
    const auto nodes = children.of(a);
    const auto count = static_cast<double>(nodes.size());
    for (const auto n : nodes)
      result[a].centre += frames[n].centre / count;
    double square = 0;
    for (const auto n : nodes) {
      const vec3 d = frames[n].centre - result[a].centre;
      // The children's own spread counts, too, so that a single child keeps its radius.
      square += (dot(d, d) + frames[n].radius * frames[n].radius) / count;
    }
    result[a].radius = std::sqrt(square);
  }
  return result;
}

/// Sparse Cholesky factors of the coarsest matrix.
class sparse_factor final : public coarsest_solver {
public:
  /// Whether the matrix has factors; of none nothing may be solved.
  [[nodiscard]] bool compute(const rigid_level& level) {
    if (level.nodes() == 0)
      return true;  // Every node is held.
    std::vector<Eigen::Triplet<double>> entries;
    for (std::uint32_t i = 0; i < level.nodes(); ++i)
      for (auto s = level.rows.begin(i); s < level.rows.end(i); ++s) {
        const matrix6 block = wide(level.block[s]);
        for (int r = 0; r < 6; ++r)
          for (int c = 0; c < 6; ++c)
            entries.emplace_back(static_cast<int>(6 * i) + r,
                                 static_cast<int>(6 * level.column[s]) + c, block(r, c));
      }
    const auto size = static_cast<Eigen::Index>(std::size_t{6} * level.nodes());
    Eigen::SparseMatrix<double> m(size, size);
    m.setFromTriplets(entries.begin(), entries.end());
    // Eigen takes a pivot that is no number for a good one.
    if (!Eigen::Map<const Eigen::VectorXd>(m.valuePtr(), m.nonZeros()).allFinite())
      return false;
    for (double shift = 0; shift < 1e-2; shift = std::max(1e-12, 100 * shift)) {
      factor_.setShift(shift * m.diagonal().mean());
      factor_.compute(m);
      if (factor_.info() == Eigen::Success)
        return true;
    }
    return false;
  }

  void solve(std::span<const float> right, std::span<float> result) const override {
    const auto size = static_cast<Eigen::Index>(right.size());
    if (size == 0)
      return;
    const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXf>(right.data(), size).cast<double>();
    Eigen::Map<Eigen::VectorXf>(result.data(), size) = factor_.solve(b).cast<float>();
  }

private:
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor_;
};

}  // namespace

expected<std::unique_ptr<coarsest_solver>> factor(const rigid_level& coarsest) {
  auto made = std::make_unique<sparse_factor>();
  if (!made->compute(coarsest))
    return fail(ec::not_converged,
                "the preconditioner cannot be set up: the matrix of its coarsest level (" +
                  std::to_string(6 * std::size_t{coarsest.nodes()}) +
                  " unknowns) is not positive definite",
                "Check for very thin tets (tedit info), and for materials whose stiffness differs "
                "by many powers of ten");
  return made;
}

expected<void> add_rigid_levels(const multilevel_settings& settings, const execution& run,
                                hierarchy& h) {
  auto& memory = h.memory->levels;
  for (;;) {
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the solve was cancelled");
    auto& level = h.levels.back();
    estimate_lambda(settings, level);
    if (level.nodes() <= settings.coarsest)
      break;
    auto groups = aggregate_pairs(graph_of(level));
    if (groups.count > 0.8 * level.nodes())
      break;  // Separate pieces that do not coarsen any further.
    memory.back().group = std::move(groups.of);
    auto frames =
      parent_frames(memory.back().frames, member_lists(memory.back().group, groups.count));
    memory.push_back({std::move(frames), {}, {}});
    h.levels.emplace_back();
    build_coarser_level(h);
  }
  auto solver = factor(h.levels.back());
  if (!solver)
    return fail(solver.error());
  h.coarsest = std::move(*solver);
  return {};
}

}  // namespace tedit::fem
