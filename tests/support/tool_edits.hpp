// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "mesh/finish_edit.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/services/host_services.hpp"

namespace tedit::test {

/// Applies operations that place tools, as the host does: values completed, the candidate checked.
class tool_edits : public ::testing::Test {
protected:
  template <class Operation>
  expected<ops::edit_result> run(const Operation& apply, const ops::operation_description& about,
                                 const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                                 const ops::parameters& given) {
    const auto values = ops::complete_parameters(about, given, mesh.get());
    if (!values)
      return fail(values.error());
    return apply(mesh, ops::selection{surfaces}, *values, ctx_);
  }

  /// The candidate passes all that the host asks of an edit, and is whole.
  static void expect_good(const version_ptr& base, const ops::edit_result& result) {
    edit_claim claim;
    claim.touched = result.touched;
    claim.volume_change = result.volume_change;
    claim.quality_floor = result.quality_floor;
    claim.bodies_added = result.bodies_added;
    const auto done = finish_edit(base, result.candidate, claim, result.improve, {}, {});
    EXPECT_TRUE(done) << render(done.error());
    EXPECT_EQ(check_version(*result.candidate).total, check_version(*base).total);
  }

  /// The area (m^2) of the surface with this name, 0 where there is none.
  static double area_of(const mesh_version& mesh, const std::string& name) {
    double sum = 0;
    for (const auto& row : mesh.surfaces())
      if (row.name == name)
        for (const auto f : facets_of(mesh, std::array{row.id}))
          sum += norm(area_vector(mesh, mesh.facet(f)));
    return sum;
  }

  std::unique_ptr<ops::services> host_ = ops::make_host_services();
  ops::context ctx_{{}, host_.get(), [](std::string_view) {}, 0};
};

}  // namespace tedit::test
