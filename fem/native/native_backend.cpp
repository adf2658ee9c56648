// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/native_backend.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <thread>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "fem/element.hpp"
#include "fem/native/block_matrix.hpp"

namespace tedit::fem {

namespace {

/// y = S x for a symmetric block given as xx, xy, xz, yy, yz, zz.
vec3 apply_symmetric(const std::array<double, 6>& s, const double* x) {
  return {s[0] * x[0] + s[1] * x[1] + s[2] * x[2], s[1] * x[0] + s[3] * x[1] + s[4] * x[2],
          s[2] * x[0] + s[4] * x[1] + s[5] * x[2]};
}

vec3 load(const double* at) {
  return {at[0], at[1], at[2]};
}

void store(vec3 value, double* at) {
  at[0] = value.x;
  at[1] = value.y;
  at[2] = value.z;
}

Eigen::Matrix3d to_matrix(const std::array<double, 6>& s) {
  Eigen::Matrix3d m;
  m << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
  return m;
}

class native_system final : public linear_system {
public:
  native_system(const problem& p, const stopwatch& clock)
      : problem_(p), corners_(p), k_(assemble_blocks(p, corners_)), diagonal_(diagonal_blocks(k_)) {
    precondition(p.filter);
    assembly_ms_ = clock.milliseconds();
  }

  expected<void> set_filter(std::span<const std::array<double, 6>> filter) override {
    precondition(filter);
    return {};
  }

  expected<inner_result> solve(std::span<const double> residual, std::span<double> correction,
                               double reduction, int max_iterations, const execution& run) override;

  expected<void> multiply(std::span<const double> x, std::span<double> y) override {
    fem::multiply(k_, x, y);
    return {};
  }

  expected<void> element_stress(std::span<const double> displacement,
                                std::span<double> stress) override;
  expected<void> nodal_stress(std::span<const double> element_stress,
                              std::span<double> nodal) override;

  double assembly_ms() const override { return assembly_ms_; }

  std::uint64_t device_bytes() const override {
    return k_.block.size() * (sizeof(block3) + 4) + problem_.node_count() * (9 + 12 + 15) * 8;
  }

private:
  void precondition(std::span<const std::array<double, 6>> filter) {
    filter_.assign(filter.begin(), filter.end());
    inverse_.resize(filter.size());
    parallel_for(filter.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t n = first; n < last; ++n)
        inverse_[n] = preconditioner_block(n);
    });
  }

  /// S (S D S + I - S)^-1 S: the inverse of D within the free directions.
  [[nodiscard]] std::array<double, 6> preconditioner_block(std::size_t n) const {
    const Eigen::Matrix3d s = to_matrix(filter_[n]);
    const Eigen::Matrix3d d =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(diagonal_[n].data());
    const double scale = d.trace() > 0 ? d.trace() / 3 : 1;
    const Eigen::Matrix3d held = scale * (Eigen::Matrix3d::Identity() - s);
    const Eigen::Matrix3d inverse = s * (s * d * s + held).inverse() * s;
    return {inverse(0, 0), inverse(0, 1), inverse(0, 2),
            inverse(1, 1), inverse(1, 2), inverse(2, 2)};
  }

  double begin(std::span<const double> residual);
  double curvature();
  double advance(double alpha, std::span<double> correction);

  const problem& problem_;
  incidence corners_;
  block_matrix k_;
  std::vector<block3> diagonal_;
  std::vector<std::array<double, 6>> filter_;
  std::vector<std::array<double, 6>> inverse_;
  std::vector<double> r_;  ///< Residual.
  std::vector<double> c_;  ///< Direction.
  std::vector<double> q_;  ///< S K c, then P^-1 r.
  double assembly_ms_ = 0;
};

/// r = S b, c = P^-1 r; returns r.c.
double native_system::begin(std::span<const double> residual) {
  for (auto* vector : {&r_, &c_, &q_})
    vector->resize(residual.size());
  return parallel_sum(problem_.node_count(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t n = first; n < last; ++n) {
      const vec3 r = apply_symmetric(filter_[n], &residual[3 * n]);
      store(r, &r_[3 * n]);
      const vec3 s = apply_symmetric(inverse_[n], &r_[3 * n]);
      store(s, &c_[3 * n]);
      sum += dot(r, s);
    }
    return sum;
  });
}

/// q = S K c; returns c.q.
double native_system::curvature() {
  fem::multiply(k_, c_, q_);
  return parallel_sum(problem_.node_count(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t n = first; n < last; ++n) {
      const vec3 q = apply_symmetric(filter_[n], &q_[3 * n]);
      store(q, &q_[3 * n]);
      sum += dot(q, load(&c_[3 * n]));
    }
    return sum;
  });
}

/// d += alpha c, r -= alpha q, q = P^-1 r; returns r.q.
double native_system::advance(double alpha, std::span<double> correction) {
  return parallel_sum(problem_.node_count(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t i = 3 * first; i < 3 * last; ++i) {
      correction[i] += alpha * c_[i];
      r_[i] -= alpha * q_[i];
    }
    for (std::size_t n = first; n < last; ++n) {
      const vec3 s = apply_symmetric(inverse_[n], &r_[3 * n]);
      store(s, &q_[3 * n]);
      sum += dot(s, load(&r_[3 * n]));
    }
    return sum;
  });
}

// Modified preconditioned conjugate gradients (Baraff & Witkin 1998; the filter as an orthogonal
// projection: Ascher & Boxerman 2003).
expected<inner_result> native_system::solve(std::span<const double> residual,
                                            std::span<double> correction, double reduction,
                                            int max_iterations, const execution& run) {
  std::ranges::fill(correction, 0.0);
  inner_result result;
  const double start = begin(residual);
  if (!(start > 0)) {
    result.recurrence_reduction = 0;
    result.broke_down = start != 0;
    return result;
  }
  double delta = start;
  while (result.iterations < max_iterations && delta > reduction * reduction * start) {
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the solve was cancelled");
    const double bend = curvature();
    if (!(bend > 0)) {
      result.broke_down = true;
      break;
    }
    const double next = advance(delta / bend, correction);
    ++result.iterations;
    if (!(next >= 0)) {
      result.broke_down = true;
      break;
    }
    const double beta = next / delta;
    delta = next;
    parallel_for(problem_.node_count(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t i = 3 * first; i < 3 * last; ++i)
        c_[i] = q_[i] + beta * c_[i];
    });
  }
  result.recurrence_reduction = std::sqrt(delta / start);
  return result;
}

expected<void> native_system::element_stress(std::span<const double> displacement,
                                             std::span<double> stress) {
  const auto& p = problem_;
  parallel_for(p.element_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t e = first; e < last; ++e) {
      const auto g = gradients_of(p, e);
      const auto s = stress_of(displacement_gradient(p, e, g, displacement.data()),
                               p.constants[p.element_materials[e]]);
      std::ranges::copy(s, stress.begin() + static_cast<std::ptrdiff_t>(6 * e));
    }
  });
  return {};
}

expected<void> native_system::nodal_stress(std::span<const double> element_stress,
                                           std::span<double> nodal) {
  const auto& p = problem_;
  parallel_for(p.node_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n) {
      std::array<double, 6> sum{};
      double volume = 0;
      for (const auto corner : corners_.of_node(n)) {
        const std::size_t e = corner / 4;
        const double v = gradients_of(p, e).volume;
        volume += v;
        for (int c = 0; c < 6; ++c)
          sum[c] += v * element_stress[6 * e + c];
      }
      for (int c = 0; c < 6; ++c)
        nodal[6 * n + c] = sum[c] / volume;
    }
  });
  return {};
}

class native_backend final : public backend {
public:
  native_backend() {
    info_.name = "cpu";
    info_.kind = "native";
    info_.driver = std::to_string(std::max(1u, std::thread::hardware_concurrency())) + " threads";
    info_.double_precision = true;
  }

  const device_info& info() const override { return info_; }

  expected<std::unique_ptr<linear_system>> assemble(const problem& p,
                                                    const execution& run) override {
    const stopwatch clock;
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the solve was cancelled");
    try {
      return std::make_unique<native_system>(p, clock);
    } catch (const std::bad_alloc&) {
      return fail(ec::out_of_memory,
                  "the stiffness matrix of " + std::to_string(p.node_count()) +
                    " nodes does not fit into memory",
                  "Close other programs or take a coarser mesh");
    }
  }

private:
  device_info info_;
};

}  // namespace

std::unique_ptr<backend> make_native_backend() {
  return std::make_unique<native_backend>();
}

}  // namespace tedit::fem
