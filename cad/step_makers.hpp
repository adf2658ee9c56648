// SPDX-License-Identifier: AGPL-3.0-or-later
// How each operation's edit is made on a B-rep: what steps.cpp asks for by the operation's name.
#pragma once

#include <string>
#include <vector>

#include "cad/editing.hpp"
#include "edit/report.hpp"
#include "mesh/version.hpp"
#include "ops/tools/tools.hpp"

namespace tedit::cad {

struct edit_made {
  const mesh_version& before;
  const edit_request& wanted;
  const edit_report& report;
  ops::parameters values;  ///< Complete.

  [[nodiscard]] double number(const char* id) const { return std::get<double>(values.at(id)); }
  [[nodiscard]] const std::string& text(const char* id) const {
    return std::get<std::string>(values.at(id));
  }
  [[nodiscard]] const std::vector<surface_id>& surfaces() const {
    return report.surfaces_used.empty() ? wanted.surfaces : report.surfaces_used;
  }
};

/// Or why not, for a person.
using step_or_reason = tl::expected<cad_step, std::string>;

[[nodiscard]] inline tl::unexpected<std::string> because(std::string reason) {
  return tl::unexpected(std::move(reason));
}

/// A step on the edit's surfaces; `distance` in m.
[[nodiscard]] cad_step on_surfaces(step_kind kind, const edit_made& edit, double distance = 0);

// Tools that are placed: tool_steps.cpp.
[[nodiscard]] step_or_reason drilling(const edit_made& edit);
[[nodiscard]] step_or_reason boss_extrusion(const edit_made& edit);
[[nodiscard]] step_or_reason pocket_extrusion(const edit_made& edit);
[[nodiscard]] step_or_reason plane_cut(const edit_made& edit);
[[nodiscard]] step_or_reason embossing(const edit_made& edit);
[[nodiscard]] step_or_reason ribbing(const edit_made& edit);
[[nodiscard]] step_or_reason sweeping(const edit_made& edit);
[[nodiscard]] step_or_reason combining(const edit_made& edit);
[[nodiscard]] step_or_reason hollowing(const edit_made& edit);

// Features that are made again: copy_steps.cpp.
[[nodiscard]] step_or_reason moving(const edit_made& edit);
[[nodiscard]] step_or_reason repeating(const edit_made& edit);

/// More triangles of a file than these take OpenCASCADE longer than an edit may take.
inline constexpr std::size_t most_facets = 2000;

}  // namespace tedit::cad
