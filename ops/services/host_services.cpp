// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/services/host_services.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "mesh/place_text.hpp"
#include "ops/boolean/boolean.hpp"
#include "ops/boolean/thin_remains.hpp"
#include "ops/services/notices.hpp"

namespace tedit::ops {

namespace {

/// Of the change of volume: what walls gained is told from here on.
constexpr double told_share = 0.05;

/// m^3: gained by walls since it was last told. Workers serve several edits at once, each on a
/// thread.
thread_local double gained = 0;

/// What was left thin since that was last told, the thinnest.
thread_local std::optional<thin_remain> left;

class host_services : public telling_services {
public:
  std::vector<std::string> take_notices() override {
    std::vector<std::string> notices;
    if (const double change = std::exchange(gained, 0); change != 0) {
      std::array<char, 32> text{};
      std::snprintf(text.data(), text.size(), "%+.3g", 1e9 * change);
      notices.push_back("the round walls at the tool follow their arcs closer now: " +
                        std::string(text.data()) + " mm3 of the change of volume come of that");
    }
    if (const auto thin = std::exchange(left, std::nullopt))
      notices.push_back("only " + thickness_text(*thin) +
                        " mm of the part are left between two of its walls near " +
                        place_text(thin->at));
    return notices;
  }

  expected<tet_filling> tetrahedralise(const closed_surface& shell, const execution& run) override {
    return tetrahedralise_surface(shell, run);
  }

  expected<planar_filling> triangulate(const planar_polygon& polygon, double spacing) override {
    return triangulate_polygon(polygon, spacing);
  }

  expected<boolean_result> boolean(const version_ptr& mesh, const tool_surface& tool,
                                   const boolean_request& request, const execution& run) override {
    return noting(combine_with_tool(mesh, tool, {}, request, run));
  }

  expected<boolean_result> boolean_onto(const version_ptr& mesh, const tool_surface& tool,
                                        const std::vector<std::optional<surface_id>>& continues,
                                        const boolean_request& request,
                                        const execution& run) override {
    return noting(combine_with_tool(mesh, tool, continues, request, run));
  }

private:
  static expected<boolean_result> noting(expected<combined>&& found) {
    if (!found)
      return fail(found.error());
    if (std::abs(found->rounder) > told_share * std::abs(found->made.volume_change))
      gained += found->rounder;
    if (found->thin && (!left || found->thin->thickness < left->thickness))
      left = found->thin;
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
