// SPDX-License-Identifier: AGPL-3.0-or-later
// The kernels of conjugate gradients.
#include "tests/gpu/kernel_test.hpp"

namespace tedit::fem::vulkan {
namespace {

class KrylovKernels : public kernel_test {
protected:
  static krylov_scalars with(std::uint32_t state, float factor) {
    krylov_scalars result{};
    result.state = state;
    result.factor = factor;
    return result;
  }

  /// Runs krylov_scalars on these partial sums.
  krylov_scalars after(std::uint32_t mode, const krylov_scalars& before,
                       const std::vector<float>& partials, std::uint32_t sums) {
    const auto scalars = put(std::vector{before});
    const auto from = put(partials);
    gates_ = put(device_program::closed_gates());
    run(kernels().krylov_scalars[mode],
        {{krylov_at::partials, &from}, {krylov_at::scalars, &scalars}, {krylov_at::gates, &gates_}},
        krylov_push{.rows = 1, .sums = sums});
    return get<krylov_scalars>(scalars, 1)[0];
  }

  [[nodiscard]] std::uint32_t groups_of_first_gate() const {
    return get<std::array<std::uint32_t, 4>>(gates_, TEDIT_GATES)[0][0];
  }

  gpu::buffer gates_;
};

TEST_F(KrylovKernels, StartFiltersTheResidualAndClearsTheCorrection) {
  const auto u = put(vectors{{9, 9, 9, 9}, {9, 9, 9, 9}});
  const auto r = put(vectors{{1, 2, 3, 0}, {4, 5, 6, 0}});
  const auto s = blocks(2, {1, 0, 0, 0, 0, 1});

  run(kernels().krylov_start, {{krylov_at::u, &u}, {krylov_at::r, &r}, {krylov_at::filter, &s}},
      krylov_push{.rows = 2});

  EXPECT_EQ(get(u, 2), (vectors{{}, {}}));
  EXPECT_EQ(get(r, 2), (vectors{{1, 0, 3, 0}, {4, 0, 6, 0}}));
}

TEST_F(KrylovKernels, FirstCopiesZ) {
  const auto z = put(vectors{{1, 2, 3, 0}});
  const auto p = put(vectors{{}});

  run(kernels().krylov_first, {{krylov_at::z, &z}, {krylov_at::p, &p}}, krylov_push{.rows = 1});

  EXPECT_EQ(get(p, 1), (vectors{{1, 2, 3, 0}}));
}

TEST_F(KrylovKernels, AdvanceGoesAlongTheDirectionWhileTheCaseRuns) {
  for (const auto state : {TEDIT_KRYLOV_RUNNING, TEDIT_KRYLOV_CONVERGED}) {
    const auto u = put(vectors{{1, 1, 1, 0}});
    const auto p = put(vectors{{1, 2, 3, 0}});
    const auto q = put(vectors{{1, 1, 1, 0}});
    const auto r = put(vectors{{4, 5, 6, 0}});
    const auto s = blocks(1, {1, 0, 0, 0, 0, 1});
    const auto scalars = put(std::vector{with(state, 2)});

    run(kernels().krylov_advance,
        {{krylov_at::u, &u},
         {krylov_at::p, &p},
         {krylov_at::q, &q},
         {krylov_at::r, &r},
         {krylov_at::filter, &s},
         {krylov_at::scalars, &scalars}},
        krylov_push{.rows = 1});

    const bool runs = state == TEDIT_KRYLOV_RUNNING;
    EXPECT_EQ(get(u, 1), runs ? (vectors{{3, 5, 7, 0}}) : (vectors{{1, 1, 1, 0}}));
    EXPECT_EQ(get(r, 1), runs ? (vectors{{2, 0, 4, 0}}) : (vectors{{4, 5, 6, 0}}));
  }
}

TEST_F(KrylovKernels, ProductLeavesBothSums) {
  const auto z = put(vectors{{1, 2, 3, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}});
  const auto r = put(vectors{{1, 1, 1, 0}, {2, 0, 0, 0}, {0, 3, 0, 0}});
  const auto partials = put(std::vector<float>(4));

  run(kernels().krylov_product,
      {{krylov_at::z, &z}, {krylov_at::r, &r}, {krylov_at::partials, &partials}},
      krylov_push{.rows = 3, .first_sum = 1});

  EXPECT_EQ(get<float>(partials, 4), (std::vector<float>{0, 0, 6 + 2 + 3, 3 + 4 + 9}));
}

TEST_F(KrylovKernels, TurnAddsBetaTimesTheOldDirection) {
  const auto z = put(vectors{{1, 2, 3, 0}});
  const auto p = put(vectors{{1, 1, 1, 0}});
  const auto scalars = put(std::vector{with(TEDIT_KRYLOV_RUNNING, 0.5F)});

  run(kernels().krylov_turn,
      {{krylov_at::z, &z}, {krylov_at::p, &p}, {krylov_at::scalars, &scalars}},
      krylov_push{.rows = 1});

  EXPECT_EQ(get(p, 1), (vectors{{1.5, 2.5, 3.5, 0}}));
}

TEST_F(KrylovKernels, ScalarsOfAWholeIteration) {
  krylov_scalars set{};
  set.smallest = 0.5F;
  set.reduction2 = 0.01F;
  set.enough = 0.25F;

  // r.z = 3 + 5, r.r = 4 + 4 in two partial sums each.
  const auto begun = after(TEDIT_KRYLOV_BEGIN, set, {3, 4, 5, 4}, 2);
  EXPECT_EQ(begun.delta, 8);
  EXPECT_EQ(begun.start, 8);
  EXPECT_EQ(begun.threshold, 0.01F * 8);
  EXPECT_EQ(begun.enough, 2);
  EXPECT_EQ(begun.radau, 2);  // 1 / smallest
  EXPECT_EQ(begun.state, std::uint32_t{TEDIT_KRYLOV_RUNNING});
  EXPECT_EQ(groups_of_first_gate(), 1u);

  // p.q = 4: alpha = 8 / 4.
  const auto advanced = after(TEDIT_KRYLOV_ALPHA, begun, {1, 3}, 2);
  EXPECT_EQ(advanced.factor, 2);
  EXPECT_EQ(advanced.alpha[0], 2);
  EXPECT_EQ(advanced.gained, 16);

  // r.z = 2: beta = 2 / 8; r.r = 1 is enough.
  const auto turned = after(TEDIT_KRYLOV_BETA, advanced, {2, 1}, 1);
  EXPECT_EQ(turned.factor, 0.25F);
  EXPECT_EQ(turned.beta[0], 0.25F);
  EXPECT_EQ(turned.iterations, 1u);
  EXPECT_EQ(turned.state, std::uint32_t{TEDIT_KRYLOV_CONVERGED});
  EXPECT_EQ(groups_of_first_gate(), 0u);
}

TEST_F(KrylovKernels, AStepThatGoesNowhereBreaksDown) {
  krylov_scalars set{};
  set.smallest = 1;
  set.delta = 1;

  const auto result = after(TEDIT_KRYLOV_ALPHA, set, {-1}, 1);

  EXPECT_EQ(result.state, std::uint32_t{TEDIT_KRYLOV_BROKEN_DOWN});
  EXPECT_EQ(groups_of_first_gate(), 0u);
}

}  // namespace
}  // namespace tedit::fem::vulkan
