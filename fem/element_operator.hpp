// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "fem/polled.hpp"
#include "fem/problem.hpp"

namespace tedit::fem {

/// The elements in chunks that follow space, for sums over the elements around each node. A chunk
/// numbers its nodes and sums among them; nodes that no other chunk has are done then, the rest
/// (the rim of the chunk) is added up in a second pass over the shared nodes. All sums have a fixed
/// order, so the bits do not depend on the number of threads; and the temporary is the rims instead
/// of a value for every corner of every element.
class element_chunks {
public:
  /// `p` must outlive the chunks. Cost: O(elements), on all cores. Memory: 2 bytes per element and
  /// local node, about 20 per node.
  explicit element_chunks(const problem& p);

  /// After `elements` (ascending) of the problem changed, some may be gone. Cost: their chunks, and
  /// a look at every chunk's list.
  void update(std::span<const std::uint32_t> elements);

  /// Nodes of a chunk, ascending: corners come first.
  [[nodiscard]] std::span<const std::uint32_t> nodes_of(std::size_t c) const {
    return chunks_[c].nodes;
  }

  /// Of every element node, its place among the nodes of the element's chunk.
  [[nodiscard]] const std::uint16_t* places() const { return places_.data(); }

  /// Calls `fill(first, last, chunk, sums)` for every chunk of elements: it adds what they give to
  /// `sums`, one of `Width` zeros for each node of the chunk, by its place. Then `take(node, sum)`
  /// once for every node of the problem, zeros for one without elements. On all cores.
  template <std::size_t Width, class Fill, class Take>
  void sum_at_nodes(const Fill& fill, const Take& take) const {
    using sum = std::array<double, Width>;
    std::vector<sum> rims;
    polled_resize(rims, shared_first_.back());
    parallel_for(problem_.element_count(), [&](std::size_t first, std::size_t last, std::size_t c) {
      const auto& [nodes, slot] = chunks_[c];
      std::vector<sum> sums(nodes.size());
      fill(first, last, c, sums.data());
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (slot[i] == no_id)
          take(nodes[i], sums[i]);
        else
          rims[slot[i]] = sums[i];
    });
    parallel_for(shared_.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t i = first; i < last; ++i) {
        sum all{};
        for (std::size_t s = shared_first_[i]; s < shared_first_[i + 1]; ++s)
          for (std::size_t c = 0; c < Width; ++c)
            all[c] += rims[s][c];
        take(shared_[i], all);
      }
    });
  }

private:
  struct chunk {
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint32_t> slot;  ///< Of each node among the shared; or `no_id`.
  };

  void list_nodes(std::size_t first, std::size_t last, std::vector<std::uint32_t>& nodes);
  void share_nodes();

  const problem& problem_;
  std::vector<std::uint16_t> places_;
  std::vector<chunk> chunks_;
  std::vector<std::uint32_t> shared_;        ///< Nodes of several chunks or none, ascending.
  std::vector<std::uint32_t> shared_first_;  ///< Start of each one's slots.
};

/// K u in fp64 from the elements, without a matrix: the measure of every residual and reaction.
class element_operator {
public:
  /// `p` must outlive the operator. Cost: O(elements), on all cores.
  explicit element_operator(const problem& p) : problem_(p), chunks_(p) {}

  /// As `element_chunks::update`.
  void update(std::span<const std::uint32_t> elements) { chunks_.update(elements); }

  /// result = K u, N, 3 per node. Cost: O(elements), on all cores, the same bits every time.
  void apply(std::span<const double> displacement, std::span<double> result) const;

  [[nodiscard]] const element_chunks& chunks() const { return chunks_; }

private:
  const problem& problem_;
  element_chunks chunks_;
};

}  // namespace tedit::fem
