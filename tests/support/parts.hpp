// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tedit::test {

/// The real parts that come with the tests, a folder each.
inline const std::filesystem::path parts_folder = TEDIT_TEST_DATA "/parts";

/// A cube of six tets in millimetres: the least that all of the program works with.
inline const std::filesystem::path cube_mesh = TEDIT_TEST_DATA "/bad/good_six_tets_cube.msh";

}  // namespace tedit::test
