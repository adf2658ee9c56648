// SPDX-License-Identifier: AGPL-3.0-or-later
// Broken files of meshes and decks.
#include <gtest/gtest.h>

#include "mesh/io/import.hpp"
#include "tests/broken/table.hpp"

namespace tedit::test {
namespace {

expected<std::string> told_of_mesh(std::span<const char> bytes) {
  const auto mesh = import_mesh_bytes(bytes, "mm");
  if (!mesh)
    return fail(mesh.error());
  std::string notices;
  for (const auto& one : mesh->warnings)
    notices += one + "\n";
  return notices;
}

/// Without libmed there is nobody who reads it.
std::vector<const char*> formats_with_tets() {
  std::vector<const char*> names{"msh", "vtu", "inp", "bdf", "unv"};
  if (TEDIT_HAS_MED)
    names.push_back("med");
  return names;
}

class BrokenMeshes : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Formats, BrokenMeshes, ::testing::ValuesIn(formats_with_tets()),
                         [](const auto& format) { return std::string(format.param); });

TEST_P(BrokenMeshes, AreRefusedWithPlaceCauseAndRemedy) {
  expect_told(GetParam(), told_of_mesh);
}

}  // namespace
}  // namespace tedit::test
