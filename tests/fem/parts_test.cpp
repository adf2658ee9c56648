// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "fem/solver.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"
#include "tests/support/parts.hpp"

namespace tedit::fem {
namespace {

namespace fs = std::filesystem;

nlohmann::json read_json(const fs::path& file) {
  std::ifstream in(file);
  return nlohmann::json::parse(in);
}

/// Folders of all parts with the figures of another solver.
std::vector<fs::path> parts_with_reference() {
  std::vector<fs::path> result;
  for (const fs::path parent : {TEDIT_TEST_DATA "/parts", TEDIT_EXAMPLES})
    for (const auto& entry : fs::directory_iterator(parent))
      if (const auto file = entry.path() / "reference.json";
          fs::exists(file) && read_json(file).contains("max_displacement_m"))
        result.push_back(entry.path());
  std::ranges::sort(result);
  return result;
}

TEST(PartsWithReference, AreAllButTheOneThatIsRefused) {
  EXPECT_GE(parts_with_reference().size(), 8u);
}

/// CalculiX 2.20 on the same mesh, supports and loads, with a direct solver.
class PartsAgainstCalculix : public ::testing::TestWithParam<fs::path> {
protected:
  void SetUp() override {
    const auto name = GetParam().filename().string();
    auto mesh = import_mesh(GetParam() / (name + ".coarse.msh"), "mm");
    auto loads = protocol::load_case_from_file(GetParam() / "load_case.json");
    ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
    ASSERT_TRUE(loads.has_value()) << render(loads.error());
    mesh_ = mesh->version;
    loads_ = std::move(*loads);
  }

  /// Solves with elements of this order and holds displacement, compliance and balance against the
  /// figures.
  void expect_agreement(int order, const nlohmann::json& figures) {
    const auto p = make_problem(*mesh_, loads_, order);
    ASSERT_TRUE(p.has_value()) << render(p.error());
    const auto device = open_backend("cpu");
    auto result = solve(*p, **device, {.tolerance = 1e-8}, {});
    ASSERT_TRUE(result.has_value()) << render(result.error());
    nodes_ = p->node_count();
    solved_ = std::move(*result);
    const double displacement = figures["max_displacement_m"];
    const double compliance = figures["compliance_j"];
    EXPECT_NEAR(solved_.max_displacement_m, displacement, 1e-6 * displacement);
    EXPECT_NEAR(solved_.compliance_j, compliance, 1e-6 * compliance);
    EXPECT_LE(norm(solved_.reaction_n + solved_.applied_n), 1e-6 * norm(solved_.applied_n));
  }

  version_ptr mesh_;
  load_case loads_;
  nlohmann::json reference_ = read_json(GetParam() / "reference.json");
  std::size_t nodes_ = 0;
  solution solved_;
};

TEST_P(PartsAgainstCalculix, LinearTetsAgree) {
  expect_agreement(1, reference_);

  const double stress = reference_["max_element_von_mises_pa"];
  EXPECT_NEAR(solved_.max_von_mises_pa, stress, 1e-4 * stress);
}

TEST_P(PartsAgainstCalculix, QuadraticTetsAgree) {
  const auto figures = reference_.value("quadratic", nlohmann::json::object());
  ASSERT_TRUE(figures.contains("compliance_j")) << "no figures of quadratic tets";

  expect_agreement(2, figures);

  EXPECT_EQ(nodes_, figures["nodes"]);
}

INSTANTIATE_TEST_SUITE_P(Open, PartsAgainstCalculix, ::testing::ValuesIn(parts_with_reference()),
                         [](const auto& part) { return part.param.filename().string(); });

TEST(BadElements, AreNamedAndRefused) {
  const auto folder = test::parts_folder / "base_so101";
  const auto mesh = import_mesh(folder / "base_so101.coarse.msh", "mm");
  const auto loads = protocol::load_case_from_file(folder / "load_case.json");

  const auto problem = make_problem(*mesh->version, *loads);

  ASSERT_FALSE(problem.has_value());
  EXPECT_EQ(problem.error().code, ec::degenerate_tet);
  EXPECT_THAT(problem.error().message, ::testing::HasSubstr("tet 19921"));
}

}  // namespace
}  // namespace tedit::fem
