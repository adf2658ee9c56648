// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/services/host_services.hpp"

#include "ops/boolean/boolean.hpp"

namespace tedit::ops {

namespace {

class host_services : public services {
public:
  expected<tet_filling> tetrahedralise(const closed_surface& shell, const execution& run) override {
    return tetrahedralise_surface(shell, run);
  }

  expected<planar_filling> triangulate(const planar_polygon& polygon, double spacing) override {
    return triangulate_polygon(polygon, spacing);
  }

  expected<boolean_result> boolean(const version_ptr& mesh, const tool_surface& tool,
                                   const boolean_request& request, const execution& run) override {
    return combine_with_tool(mesh, tool, {}, request, run);
  }

  expected<boolean_result> boolean_onto(const version_ptr& mesh, const tool_surface& tool,
                                        const std::vector<std::optional<surface_id>>& continues,
                                        const boolean_request& request,
                                        const execution& run) override {
    return combine_with_tool(mesh, tool, continues, request, run);
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
