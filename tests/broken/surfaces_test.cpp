// SPDX-License-Identifier: AGPL-3.0-or-later
// Broken files of surfaces.
#include <gtest/gtest.h>

#include "scan/reader/file_surface.hpp"
#include "tests/broken/table.hpp"

namespace tedit::test {
namespace {

class BrokenSurfaces : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Formats, BrokenSurfaces, ::testing::Values("stl", "obj", "ply", "3mf"),
                         [](const auto& format) { return std::string(format.param); });

TEST_P(BrokenSurfaces, AreRefusedWithPlaceCauseAndRemedy) {
  expect_told(GetParam(), [](std::span<const char> bytes) -> expected<std::string> {
    const auto read = scan::read_surface(GetParam(), bytes);
    if (!read)
      return fail(read.error());
    std::string notices;
    for (const auto& one : read->notices)
      notices += one + "\n";
    return notices;
  });
}

}  // namespace
}  // namespace tedit::test
