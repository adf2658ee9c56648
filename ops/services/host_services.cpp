// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/services/host_services.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ops/boolean/boolean.hpp"
#include "ops/services/notices.hpp"

namespace tedit::ops {

namespace {

/// Of the change of volume: what walls gained is told from here on.
constexpr double told_share = 0.05;

/// m^3: gained by walls since it was last told. Workers serve several edits at once, each on a
/// thread.
thread_local double gained = 0;

class host_services : public telling_services {
public:
  std::vector<std::string> take_notices() override {
    const double change = std::exchange(gained, 0);
    if (change == 0)
      return {};
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%+.3g", 1e9 * change);
    return {"the round walls at the tool follow their arcs closer now: " +
            std::string(text.data()) + " mm3 of the change of volume come of that"};
  }

  expected<tet_filling> tetrahedralise(const closed_surface& shell, const execution& run) override {
    return tetrahedralise_surface(shell, run);
  }

  expected<planar_filling> triangulate(const planar_polygon& polygon, double spacing) override {
    return triangulate_polygon(polygon, spacing);
  }

  expected<boolean_result> boolean(const version_ptr& mesh, const tool_surface& tool,
                                   const boolean_request& request, const execution& run) override {
    return noting_gain(combine_with_tool(mesh, tool, {}, request, run));
  }

  expected<boolean_result> boolean_onto(const version_ptr& mesh, const tool_surface& tool,
                                        const std::vector<std::optional<surface_id>>& continues,
                                        const boolean_request& request,
                                        const execution& run) override {
    return noting_gain(combine_with_tool(mesh, tool, continues, request, run));
  }

private:
  static expected<boolean_result> noting_gain(expected<combined>&& found) {
    if (!found)
      return fail(found.error());
    if (std::abs(found->rounder) > told_share * std::abs(found->made.volume_change))
      gained += found->rounder;
    return std::move(found->made);
  }
};

class draft_services final : public host_services {
public:
  expected<boolean_result> boolean(const version_ptr& mesh, const tool_surface& tool,
                                   const boolean_request& request, const execution& run) override {
    return draft_with_tool(mesh, tool, {}, request, run);
  }

  expected<boolean_result> boolean_onto(const version_ptr& mesh, const tool_surface& tool,
                                        const std::vector<std::optional<surface_id>>& continues,
                                        const boolean_request& request,
                                        const execution& run) override {
    return draft_with_tool(mesh, tool, continues, request, run);
  }
};

}  // namespace

std::unique_ptr<services> make_host_services() {
  return std::make_unique<host_services>();
}

std::unique_ptr<services> make_draft_services() {
  return std::make_unique<draft_services>();
}

}  // namespace tedit::ops
