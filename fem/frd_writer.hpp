// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "fem/solver.hpp"

namespace tedit::fem {

/// A solution as a results file of CalculiX (FRD, text), as CGX, PrePoMax and FreeCAD read it:
/// the problem's nodes and elements (linear tets as type 3, quadratic ones as type 6), DISP (m) and
/// STRESS (Pa; xx, yy, zz, xy, yz, zx) at all nodes; a node in the middle of an edge has the mean
/// stress of its ends. Numbers have the six digits of the format. Each case is a step. Cost:
/// O(mesh). The caller checks the stream.
void write_frd(const problem& p, const std::vector<const solution*>& cases,
               const std::vector<std::string>& names, std::ostream& out);

}  // namespace tedit::fem
