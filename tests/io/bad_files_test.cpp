// SPDX-License-Identifier: AGPL-3.0-or-later
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mesh/io/import.hpp"

namespace tedit {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path bad_folder = TEDIT_TEST_DATA "/bad";

nlohmann::json expectations() {
  std::ifstream in(bad_folder / "expectations.json");
  return nlohmann::json::parse(in);
}

/// What an error or warning about a file must say, beside what its kind demands.
const std::map<std::string, std::string> words{
  {"header_only.msh", "no nodes"},
  {"header_only_41bin.msh", "no nodes"},
  {"is_png.msh", "PNG"},
  {"is_step.msh", "STEP"},
  {"trunc_41bin_300.msh", "$"},
  {"trunc_41bin_600.msh", "$"},
  {"trunc_41bin_999.msh", "$"},
  {"elem_missing_node.msh", "which does not exist"},
  {"elem_node_0.msh", "node 0"},
  {"elem_type_999.msh", "unknown element type 999"},
  {"elem_too_few_nodes.msh", "too few numbers"},
  {"count_nodes_2pow31.msh", "more than"},
  {"count_nodes_2pow64.msh", "out of range"},
  {"count_elems_2pow31.msh", "more than"},
  {"count_elems_short.msh", "disagree"},
  {"count_41bin_nodes_2pow31.msh", "more than"},
  {"count_41bin_blocks_2pow64m1.msh", "more than"},
  {"endian_marker_wrong.msh", "neither 1 nor a swapped 1"},
  {"version_5_0.msh", "version 5.0"},
  {"coord_nan.msh", "coordinate of node 41 is \"nan\""},
  {"coord_inf.msh", "coordinate of node 41 is \"inf\""},
  {"coord_comma.msh", "coordinate of node 41 is \"3,25\""},
  {"coord_text.msh", "coordinate of node 41 is \"abc\""},
  {"duplicate_tet.msh", "same tet twice"},
  {"face_in_three_tets.msh", "belongs to 3 tets"},
  {"surface_only.msh", "no volume elements"},
  {"triangle_not_a_face.msh", "no face of any tet"},
  {"triangle_twice_two_ids.msh", "claimed by surface"},
  {"hexes_only.msh", "hexahedron"},
  {"mixed_prism_tet.msh", "prism"},
  {"mixed_pyramid_tet.msh", "pyramid"},
  {"deep_sections.msh", "instead of $MeshFormat"},
  {"inverted_by_vertex_move.msh", "inverted"},
  {"zero_volume_tet.msh", "zero volume"},
  {"tets_only_no_triangles.msh", "had no surface id"},
  {"surface_no_tags.msh", "had no surface id"},
  {"surface_every_5th_triangle_missing.msh", "had no surface id"},
  {"disconnected_two_cubes.msh", "2 separate bodies"},
  {"nonmanifold_vertex_two_cubes.msh", "touches itself"},
  {"one_tet_flipped.msh", "turned"},
};

std::string all_text(const expected<imported_mesh>& result) {
  if (!result)
    return result.error().message + " " + result.error().where;
  std::string text;
  for (const auto& warning : result->warnings)
    text += warning + "\n";
  return text;
}

TEST(BadFiles, EachGetsWhatTheTableSays) {
  for (const auto& row : expectations()) {
    const std::string name = row["file"];
    const std::string kind = row["kind"];
    SCOPED_TRACE(name);

    const auto result = import_mesh(bad_folder / name, "mm");

    if (kind == "accept" || kind == "refuse-sim") {
      EXPECT_TRUE(result.has_value()) << all_text(result);
    } else if (kind == "reject") {
      ASSERT_FALSE(result.has_value());
      EXPECT_FALSE(result.error().message.empty());
      EXPECT_THAT(result.error().where, HasSubstr(name));
    }
    if (const auto word = words.find(name); word != words.end()) {
      EXPECT_THAT(all_text(result), HasSubstr(word->second));
    }
  }
}

TEST(BadFiles, VariantsOfTheBaseHoldTheSameMesh) {
  const auto base = import_mesh(bad_folder / "good_base_41bin.msh", "mm");
  ASSERT_TRUE(base.has_value());

  for (const auto* name :
       {"good_base_41ascii.msh", "good_base_22ascii.msh", "good_base_22bin.msh",
        "good_41_parametric_bin.msh", "good_22_crlf.msh", "good_41_crlf.msh",
        "good_22_no_final_newline.msh", "good_22_leading_spaces_tabs.msh", "good_ids_gaps_22.msh",
        "good_ids_shuffled_22.msh", "big_endian_41bin.msh", "good_ids_beyond_2pow32_41ascii.msh"}) {
    SCOPED_TRACE(name);
    const auto other = import_mesh(bad_folder / name, "mm");
    ASSERT_TRUE(other.has_value()) << other.error().message;
    EXPECT_EQ(other->version->tet_count(), base->version->tet_count());
    EXPECT_EQ(other->version->facet_count(), base->version->facet_count());
    EXPECT_EQ(other->version->surfaces().size(), base->version->surfaces().size());
    EXPECT_NEAR(total_volume(*other->version), total_volume(*base->version),
                1e-12 * total_volume(*base->version));
  }
}

TEST(BadFiles, ScaledFilesKeepPositiveVolumes) {
  for (const auto* name : {"good_scale_1e-9.msh", "good_scale_1e9.msh"}) {
    const auto mesh = import_mesh(bad_folder / name, "mm");
    ASSERT_TRUE(mesh.has_value());
    EXPECT_TRUE(mesh->warnings.empty()) << name << ": " << mesh->warnings.front();
  }
}

TEST(BadFiles, APhysicalNameNeedsBothItsQuotes) {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 ";
  const auto said = [&](const std::string& name) {
    const auto file = head + name + "\n$EndPhysicalNames\n";
    return all_text(import_mesh_bytes(std::span(file.data(), file.size()), "mm"));
  };

  EXPECT_THAT(said("\"wall"), HasSubstr("a physical name must stand in double quotes"));
  EXPECT_THAT(said("wall"), HasSubstr("a physical name must stand in double quotes"));
  EXPECT_THAT(said("\"wall\""), HasSubstr("no nodes"));
}

/// One tet of ten nodes; the middle of its first edge lies `off` the edge.
std::string quadratic_tet(const std::string& off) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n10\n"
         "1 0 0 0\n2 2 0 0\n3 0 2 0\n4 0 0 2\n5 1 " +
         off +
         " 0\n6 1 1 0\n7 0 1 0\n8 0 0 1\n9 0 1 1\n10 1 0 1\n$EndNodes\n"
         "$Elements\n1\n1 11 2 1 1 1 2 3 4 5 6 7 8 9 10\n$EndElements\n";
}

TEST(QuadraticTets, WhatACurvedEdgeLosesIsCountedAndMeasured) {
  const auto curved = quadratic_tet("-0.25");
  const auto straight = quadratic_tet("1e-9");  // As a writer rounds.

  const auto bent = all_text(import_mesh_bytes(std::span(curved.data(), curved.size()), "mm"));
  const auto kept = all_text(import_mesh_bytes(std::span(straight.data(), straight.size()), "mm"));

  EXPECT_THAT(bent, HasSubstr("1 tets have nodes on their edges"));
  EXPECT_THAT(bent, HasSubstr("1 of these nodes lie off the straight edge, by up to 0.25 (12 % of "
                              "the edge) at (1, -0.25, 0)"));
  EXPECT_THAT(kept, HasSubstr("1 tets have nodes on their edges"));
  EXPECT_THAT(kept, testing::Not(HasSubstr("off the straight edge")));
}

/// Before any of them is read.
TEST(BadFiles, ABlockOfMoreNodesThanTheFileCanHoldIsRefused) {
  const std::string text =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n3 1 0 1000000000000\n1\n2\n3\n4\n"
    "$EndNodes\n";

  const auto mesh = import_mesh_bytes(std::span(text.data(), text.size()), "mm");

  ASSERT_FALSE(mesh.has_value());
  EXPECT_THAT(mesh.error().message, HasSubstr("1000000000000 nodes in a block, more than the"));
}

/// Imports in a child process whose address space is limited, so that a runaway allocation fails.
int import_in_child(const std::filesystem::path& file) {
  const pid_t child = fork();
  if (child == 0) {
    rusage before{};
    getrusage(RUSAGE_SELF, &before);
    (void)import_mesh(file, "mm");
    rusage after{};
    getrusage(RUSAGE_SELF, &after);
    _exit(after.ru_maxrss - before.ru_maxrss > 100 * 1024 ? 3 : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST(BadFiles, NoneCrashesOrTakesMoreThan100MB) {
  for (const auto& entry : std::filesystem::directory_iterator(bad_folder)) {
    if (entry.path().extension() == ".msh") {
      EXPECT_EQ(import_in_child(entry.path()), 0) << entry.path();
    }
  }
}

TEST(BadFiles, EveryTruncationAndByteChangeIsSurvived) {
  for (const auto* name : {"good_base_41bin.msh", "good_base_22ascii.msh", "good_base_22bin.msh"}) {
    std::ifstream in(bad_folder / name, std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(in)), {});
    for (std::size_t size = 0; size + 32 < whole.size(); size += 997)
      EXPECT_FALSE(import_mesh_bytes(std::span(whole.data(), size), "mm").has_value())
        << name << " cut at " << size;
    std::uint32_t state = 7;
    for (int i = 0; i < 60; ++i) {
      auto changed = whole;
      state = state * 1664525u + 1013904223u;
      changed[state % changed.size()] = static_cast<char>(state >> 24);
      (void)import_mesh_bytes(std::span<const char>(changed),
                              "mm");  // must come back, nothing else
    }
  }
}

}  // namespace
}  // namespace tedit
