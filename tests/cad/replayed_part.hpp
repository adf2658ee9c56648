// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cad/import.hpp"
#include "cad/replay.hpp"
#include "edit/make_edit.hpp"
#include "mesh/checks.hpp"
#include "tests/cad/import_program.hpp"

namespace tedit::test {

/// A part from its CAD file, to be edited on the mesh and on the model.
class replayed_part : public ::testing::Test {
protected:
  void open(const std::string& file) {
    auto part = cad::import_part({cad_parts + file, "coarse", {}}, {});
    ASSERT_TRUE(part) << render(part.error());
    mesh_ = part->version;
    model_ = std::move(part->model);
  }

  [[nodiscard]] checked_edit edit(const edit_request& wanted) const {
    auto made = make_edit(plugins_, mesh_, wanted, {}, {}, {});
    EXPECT_TRUE(made) << render(made.error());
    return made ? std::move(*made) : checked_edit{};
  }

  /// What comes of `wanted` on the model where the mesh is that of `made`.
  [[nodiscard]] cad::replayed_edit replay(const edit_request& wanted,
                                          const checked_edit& made) const {
    const auto offered = plugins_.find(wanted.operation);
    auto replayed = cad::replay_edit(
      {model_, (*offered)->description, mesh_, made.version, wanted, made.report}, {});
    EXPECT_TRUE(replayed) << render(replayed.error());
    return replayed ? std::move(*replayed) : cad::replayed_edit{};
  }

  /// The part goes on as edited.
  void go_on(const checked_edit& made, cad::replayed_edit replayed) {
    mesh_ = made.version;
    model_ = std::move(replayed.model);
  }

  ops::catalogue plugins_ = ops::load_default_catalogue();
  version_ptr mesh_;
  cad::cad_model model_;
};

/// A box of 10 x 20 x 30 mm from its STEP file; surface 1 is x = 0 ("left wall").
class Replay : public replayed_part {
protected:
  void SetUp() override {
    TEDIT_NEEDS_CAD();
    open("box.step");
  }
};

}  // namespace tedit::test
