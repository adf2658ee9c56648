// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ops/loader/catalogue.hpp"

/// Edits that nobody planned, and what must hold after each: shared by the property tests, the
/// fuzz target and bench/random_edits.
namespace tedit::test {

/// Numbers that choose: of a random generator, a property test or a fuzzer's bytes.
using number_source = std::function<std::uint64_t()>;

struct planned_edit {
  std::string operation;
  std::vector<surface_id> surfaces;
  ops::parameters parameters;
};

/// An operation of the catalogue on one to four surfaces of the mesh, with parameters inside their
/// ranges, at their ends or left out. Lengths are drawn up to 0.05 `size`, m.
[[nodiscard]] planned_edit choose_edit(const ops::catalogue& plugins, const mesh_version& mesh,
                                       double size, const number_source& numbers);

/// What came of an edit: a version, a refusal or a fault.
struct tried_edit {
  version_ptr after;  ///< Null when it was refused.
  error refusal;      ///< Why; only then.
  std::string fault;  ///< Which promise it broke; empty when all hold.
};

/// Operation, improvement and checks as the host does them, then every promise of an edit anew:
/// the version before is the same, a refusal says why; the new version is sound (or was not
/// before), its volume is as claimed, its worst touched tet not below what was promised, each
/// surface of its table has facets, the surface map tells where every id went and came from, and a
/// force on a few surfaces keeps its total when loads are to move. Cost: O(mesh).
[[nodiscard]] tried_edit try_edit(const ops::catalogue& plugins, const version_ptr& before,
                                  const planned_edit& edit);

/// The fault of a sequence applied from the start; refused edits are left out. Empty: none.
[[nodiscard]] std::string first_fault(const ops::catalogue& plugins, const version_ptr& start,
                                      const std::vector<planned_edit>& edits);

/// The same sequence without edits that its fault does not need.
[[nodiscard]] std::vector<planned_edit> shrink(const ops::catalogue& plugins,
                                               const version_ptr& start,
                                               std::vector<planned_edit> edits);

/// Writes a sequence as a recipe that "tedit run" carries out on the mesh file (mm).
void write_recipe(const std::filesystem::path& file, const std::filesystem::path& mesh,
                  const std::string& name, const std::vector<planned_edit>& edits);

}  // namespace tedit::test
