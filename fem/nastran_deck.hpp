// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "fem/problem.hpp"

namespace tedit::fem {

struct nastran_settings {
  std::string title;                                   ///< One line.
  std::function<std::uint64_t(tet_id)> property = {};  ///< Of a tet; empty: that of its material.
  std::function<void(std::ostream&)> head = {};        ///< Writes comments before the first card.
  std::function<void(std::ostream&)> sets = {};        ///< Writes cards behind the elements.
  /// Writes what stands for materials, supports and loads, which is `cards`, with what a program
  /// that reads the deck should know of it; empty: `cards` alone.
  std::function<void(std::ostream&, const std::string& cards)> around_cards = {};
};

struct nastran_counts {
  std::size_t held_nodes = 0;
  std::size_t components = 0;  ///< Held along an axis: SPC.
  std::size_t equations = 0;   ///< Held directions oblique to the axes: MPC.
  std::size_t loads = 0;       ///< Nodes with a FORCE.
};

/// Writes the problem as a deck of Nastran for a static solution (SOL 101), in SI units: node i of
/// the problem is GRID i + 1, elements likewise (CTETRA of 4 or 10 nodes). Held directions are SPC
/// along an axis and MPC otherwise, a prescribed one with a GRID of its own; the problem's nodal
/// forces are FORCE. Reals have the 16 characters of large fields. Errors: `invalid_argument` for
/// more nodes than a deck can number. Cost: O(mesh). The caller checks the stream.
[[nodiscard]] expected<nastran_counts> write_nastran_deck(const problem& p,
                                                          const nastran_settings& settings,
                                                          std::ostream& out);

}  // namespace tedit::fem
