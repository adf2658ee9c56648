// SPDX-License-Identifier: AGPL-3.0-or-later
// MED files with bytes of chance in them: HDF5 may do with them what it likes, in its own program.
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "mesh/io/import.hpp"

namespace tedit::test {
namespace {

std::string bytes_of(const std::string& name) {
  std::ifstream in(TEDIT_TEST_DATA "/med/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Each file starts a program; more are tried by hand (bench/med_damage.py).
TEST(DamagedMed, IsReadOrRefusedWithCauseAndRemedy) {
  std::size_t refused = 0;
  for (const auto* name : {"meshio.med", "salome.med"})  // Without and with checksums.
    for (unsigned seed = 0; seed < 25; ++seed) {
      SCOPED_TRACE(name + (" with seed " + std::to_string(seed)));
      auto bytes = bytes_of(name);
      ASSERT_FALSE(bytes.empty());
      std::mt19937 chance(seed);
      for (unsigned i = 0; i < 1 + seed % 12; ++i)
        bytes[chance() % bytes.size()] = static_cast<char>(chance());

      const auto mesh = import_mesh_bytes(std::span<const char>(bytes), "mm");

      refused += !mesh;
      if (!mesh) {
        EXPECT_NE(mesh.error().message, "");
        EXPECT_NE(mesh.error().remedy, "");
      }
    }
  EXPECT_GE(refused, 10U);
}

}  // namespace
}  // namespace tedit::test
