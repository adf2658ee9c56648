// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "tests/cli/run_program.hpp"

namespace tedit::test {

inline const std::string plate = TEDIT_EXAMPLES "/ctc01_plate/ctc01_plate.coarse.msh";
inline const std::string plate_loads = TEDIT_EXAMPLES "/ctc01_plate/load_case.json";
inline const std::string parts = TEDIT_TEST_DATA "/parts/";

}  // namespace tedit::test
