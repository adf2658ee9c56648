// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <tuple>

#include "base/raw_vector.hpp"
#include "fem/multilevel/lanes.hpp"
#include "fem/problem.hpp"

namespace tedit::fem {
class node_numbering;
}

namespace tedit::fem::native {

/// K x of straight-sided ten-node tets in single precision, element by element: no matrix. Elements
/// are cut into patches that gather and sum in fast memory; a second pass adds the patches' shares
/// of each node in a fixed order, so that the bits do not depend on the number of threads.
///
/// The strain of such an element is linear, so its values at the corners are all of it: at corner k
/// the displacement gradient is sum_{b != k} (4 (u_kb - u_k) - (u_b - u_k)) (x) grad L_b, with u_kb
/// at the middle of edge kb. Only differences of displacements enter, as in `block_matrix`. With
/// corner stresses sigma_k the exact integrals are S_k = V/20 (sigma_k + sum_l sigma_l).
///
/// Memory: 64 bytes an element and about 60 for the patches' sums, against 1,600 of an assembled
/// matrix; eight cases at once take about 360 for their sums.
class quadratic_operator {
public:
  /// `p` must have elements of order 2; it is not needed afterwards.
  explicit quadratic_operator(const problem& p);

  /// After `elements` (ascending) of the problem changed, some may be gone. Cost: their patches,
  /// and a copy of all patches' lists.
  void update(const problem& p, std::span<const std::uint32_t> elements);

  [[nodiscard]] std::size_t rows() const { return share_first_.size() - 1; }
  [[nodiscard]] std::uint64_t bytes() const;

  /// Calls `sink(i, row i of K x)` for all rows, on all cores; returns the sums of what it returns,
  /// if anything. Not for two threads at once.
  template <class L, class Sink>
  case_sums<L> for_rows(const float* x, const Sink& sink) const {
    sum_patches<L>(x);
    const auto& sums = shares<L>();
    return sum_lanes<L>(
      rows(), [&](std::size_t first, std::size_t last, typename L::sum& sum) TEDIT_INLINED {
        for (std::size_t i = first; i < last; ++i) {
          typename L::node row{};
          for (auto s = share_first_[i], end = share_first_[i + 1]; s < end; ++s)
            row += sums[share_[s]];
          take_row<L>(sink, i, row, sum);
        }
      });
  }

private:
  struct element {
    std::array<float, 9> gradient;  ///< grad L_1, L_2, L_3, 1/m.
    float lambda;                   ///< Lame's constants times V/20.
    float mu;
    std::array<std::uint16_t, 10> node;  ///< Within the patch.
  };
  static_assert(sizeof(element) == 64);

  struct patch {
    std::uint32_t first_element, last_element;
    std::uint32_t first_node, last_node;  ///< Into `patch_nodes_` and `shares_`.
  };

  void set_element(const problem& p, std::size_t e);
  void make_patches(const problem& p);
  void number_patch(const problem& p, const patch& part, node_numbering& numbering,
                    std::vector<std::uint32_t>& nodes);
  void make_shares(std::size_t nodes);
  template <class L>
  [[nodiscard]] std::vector<typename L::node>& shares() const {
    return std::get<std::vector<typename L::node>>(shares_);
  }

  template <class L>
  void sum_patches(const float* x) const;
  template <class L>
  void prefetch(const float* x, const patch& part, std::size_t e) const;

  raw_vector<element> elements_;
  std::vector<patch> patches_;
  std::vector<std::uint32_t> patch_nodes_;
  std::vector<std::uint32_t> share_first_, share_;  ///< Where the sums of each node lie.
  /// The patches' sums, by lane type; allocated when first used.
  mutable std::tuple<std::vector<one_case::node>, std::vector<cases_of<4>::node>,
                     std::vector<cases_of<8>::node>>
    shares_;
};

/// The same as of a matrix.
template <class L = one_case, class Sink>
case_sums<L> for_rows(const quadratic_operator& k, const float* x, const Sink& sink) {
  return k.for_rows<L>(x, sink);
}

}  // namespace tedit::fem::native
