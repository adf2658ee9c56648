// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "fem/problem.hpp"

/// A problem as an input deck of CalculiX, so that anybody can check a result with a program that
/// shares no line with ours. CalculiX 2.20 reads the deck as it stands: `ccx -i NAME` for NAME.inp.
namespace tedit::fem {

/// What solves the equations in CalculiX.
enum class calculix_solver {
  spooles,             ///< Direct, in memory.
  iterative_cholesky,  ///< Conjugate gradients: less memory; displacements good to some 1e-5.
};

struct calculix_settings {
  std::string title;  ///< One line for the deck's header.
  calculix_solver solver = calculix_solver::spooles;
  bool fields = true;  ///< Displacement, forces and stress to NAME.frd, for cgx and converters.
  /// Writes further cards of the model behind the elements: sets and surfaces.
  std::function<void(std::ostream&)> sets = {};
  /// Writes what stands for materials, supports and loads, which is `cards`, with what a program
  /// that reads the deck should know of it; empty: `cards` alone.
  std::function<void(std::ostream&, const std::string& cards)> around_cards = {};
};

/// What a deck holds, besides nodes and elements.
struct calculix_counts {
  std::size_t held_nodes = 0;  ///< Nodes with a support of any kind.
  std::size_t boundaries = 0;  ///< Components held along an axis.
  std::size_t equations = 0;   ///< Held directions oblique to the axes.
  std::size_t loads = 0;       ///< Components of nodal loads that are not zero.
};

/// Writes the deck, in SI units: node i of the problem is node i + 1 of the deck, the same holds
/// for elements (C3D4, or C3D10 with straight edges, whose node order is the problem's own).
/// - Held directions: along an axis as *BOUNDARY; an oblique one, n.u = d, as *EQUATION, whose d is
///   the prescribed displacement of a node made for it (set OFFSETS). Its dependent component is
///   the largest of n, so no coefficient exceeds 1.
/// - Loads: the problem's nodal forces as *CLOAD. They are consistent, so pressure, traction and
///   gravity act exactly as in our own solve.
/// - Output: U of all nodes (set NALL) and RF of the held ones (set HELD, with their total) to
///   NAME.dat, with 7 digits. RF is K u: the reaction plus the load on the node.
/// Numbers have all their digits, or as many as fit into the 20 characters that CalculiX reads (at
/// least 13). Cost: O(mesh). The caller checks the stream.
calculix_counts write_calculix_deck(const problem& p, const calculix_settings& settings,
                                    std::ostream& out);

}  // namespace tedit::fem
