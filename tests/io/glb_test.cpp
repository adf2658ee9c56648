// SPDX-License-Identifier: AGPL-3.0-or-later
// GLB, read back by a reader of its own.
#include <cstring>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mesh/io/formats.hpp"
#include "mesh/io/import.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/parts.hpp"

namespace tedit {
namespace {

struct glb_file {
  nlohmann::json about;
  std::string bytes;  ///< Of the binary chunk.

  [[nodiscard]] std::vector<double> numbers(std::size_t accessor) const {
    const auto& row = about["accessors"][accessor];
    const auto& view = about["bufferViews"][row["bufferView"].get<std::size_t>()];
    const std::map<std::string, std::size_t> widths{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
    const auto count = row["count"].get<std::size_t>() * widths.at(row["type"]);
    const char* at = bytes.data() + view["byteOffset"].get<std::size_t>();
    const auto type = row["componentType"].get<int>();
    const std::size_t size = type == 5123 ? 2 : 4;
    EXPECT_EQ(view["byteLength"], count * size);
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + count * size, bytes.size());
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0U);
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i, at += size)
      if (type == 5126)
        result.push_back(item<float>(at));
      else
        result.push_back(type == 5123 ? item<std::uint16_t>(at) : item<std::uint32_t>(at));
    return result;
  }

  [[nodiscard]] const nlohmann::json& primitives() const {
    return about["meshes"][0]["primitives"];
  }

  [[nodiscard]] const nlohmann::json& material(std::size_t primitive) const {
    return about["materials"][primitives()[primitive]["material"].get<std::size_t>()];
  }

private:
  template <class T>
  static T item(const char* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
  }
};

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

glb_file read_glb(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word_at(bytes, 4), 2U);
  EXPECT_EQ(word_at(bytes, 8), bytes.size());
  const std::size_t text = word_at(bytes, 12);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(text % 4, 0U);
  const std::size_t binary = word_at(bytes, 20 + text);
  EXPECT_EQ(bytes.substr(24 + text, 4), std::string("BIN\0", 4));
  EXPECT_EQ(28 + text + binary, bytes.size());
  glb_file result{nlohmann::json::parse(bytes.substr(20, text)), bytes.substr(28 + text)};
  EXPECT_EQ(result.about["asset"]["version"], "2.0");
  EXPECT_EQ(result.about["buffers"][0]["byteLength"], binary);
  return result;
}

/// What the triangles of all primitives enclose.
double volume_of(const glb_file& file) {
  const auto p = file.numbers(file.primitives()[0]["attributes"]["POSITION"]);
  const auto point = [&](double corner) {
    const auto at = 3 * static_cast<std::size_t>(corner);
    return vec3{p.at(at), p.at(at + 1), p.at(at + 2)};
  };
  double sum = 0;
  for (const auto& one : file.primitives()) {
    const auto corners = file.numbers(one["indices"]);
    for (std::size_t i = 0; i < corners.size(); i += 3)
      sum += dot(point(corners[i]), cross(point(corners[i + 1]), point(corners[i + 2]))) / 6;
  }
  return sum;
}

TEST(Glb, ABoxIsSixPrimitivesInMetresWithItsBox) {
  const auto box = test::box_mesh({1, 1, 1}, {0.01, 0.02, 0.03});
  std::string bytes;
  std::string again;
  const file_terms terms{.length_unit = "mm", .title = "A \"box\""};

  ASSERT_TRUE(formats::glb::write(&bytes, *box, terms).has_value());
  ASSERT_TRUE(formats::glb::write(&again, *box, terms).has_value());

  EXPECT_EQ(bytes, again);
  EXPECT_TRUE(formats::glb::recognises(bytes));
  const auto file = read_glb(bytes);
  EXPECT_EQ(file.about["meshes"][0]["name"], "A \"box\"");
  ASSERT_EQ(file.primitives().size(), 6U);
  EXPECT_EQ(file.material(0)["name"], "surface 1");
  EXPECT_EQ(file.material(5)["extras"]["surface"], 6);
  EXPECT_NEAR(volume_of(file), 0.01 * 0.02 * 0.03, 1e-12);
  const auto& positions = file.about["accessors"][0];
  EXPECT_EQ(positions["count"], 8);
  EXPECT_EQ(positions["min"], nlohmann::json({0.F, 0.F, 0.F}));
  EXPECT_EQ(positions["max"], nlohmann::json({0.01F, 0.02F, 0.03F}));
  // z of the part points along y of the scene: a quarter turn back about x.
  const auto turn = file.about["nodes"][0]["rotation"].get<std::vector<double>>();
  EXPECT_THAT(turn, ::testing::ElementsAre(-std::sqrt(0.5), 0, 0, std::sqrt(0.5)));
}

TEST(Glb, ColoursAreThoseOfTheScreenAsLight) {
  const auto box = test::box_mesh({1, 1, 1}, {1, 1, 1});
  std::string bytes;

  ASSERT_TRUE(formats::glb::write(&bytes, *box, {.colours = {.of_surfaces = {{6, {255, 0, 188}}}}})
                .has_value());

  auto file = read_glb(bytes);
  const auto colour = file.material(5)["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_EQ(colour[0], 1.0);
  EXPECT_EQ(colour[1], 0.0);
  EXPECT_NEAR(colour[2].get<double>(), 0.5, 0.005);  // 188 of 255 is half of the light.
  EXPECT_FALSE(file.primitives()[0]["attributes"].contains("COLOR_0"));

  const file_colours of_vertices{.of_vertices = std::vector<std::uint8_t>(8, 1),
                                 .palette = {{0, 0, 0}, {255, 188, 0}}};
  ASSERT_TRUE(formats::glb::write(&bytes, *box, {.colours = of_vertices}).has_value());
  file = read_glb(bytes);
  const auto& accessor =
    file.about["accessors"][file.primitives()[2]["attributes"]["COLOR_0"].get<std::size_t>()];
  EXPECT_EQ(accessor["normalized"], true);
  const auto values = file.numbers(file.primitives()[2]["attributes"]["COLOR_0"]);
  ASSERT_EQ(values.size(), 32U);
  EXPECT_EQ(values[28], 65535);
  EXPECT_NEAR(values[29], 32768, 330);
  EXPECT_EQ(values[30], 0);
  EXPECT_EQ(file.material(2)["pbrMetallicRoughness"]["baseColorFactor"][0], 1.0) << "white";

  file_colours of_facets{.palette = {{0, 0, 0}, {255, 0, 0}}};
  of_facets.of_facets.assign(box->facet_slots(), 0);
  of_facets.of_facets[3] = 1;
  ASSERT_TRUE(formats::glb::write(&bytes, *box, {.colours = of_facets}).has_value());
  file = read_glb(bytes);
  ASSERT_EQ(file.primitives().size(), 2U);
  EXPECT_EQ(file.numbers(file.primitives()[0]["indices"]).size(), 33U);
  EXPECT_EQ(file.numbers(file.primitives()[1]["indices"]).size(), 3U);
  EXPECT_NEAR(volume_of(file), 1, 1e-7);
}

TEST(Glb, ARealPartKeepsEachSurfaceByItsIdAndWhatItEncloses) {
  const auto part = import_mesh(test::parts_folder / "inch_block/inch_block.coarse.msh", "mm");
  ASSERT_TRUE(part.has_value()) << part.error().message;
  const auto& mesh = *part->version;
  std::string bytes;

  ASSERT_TRUE(formats::glb::write(&bytes, mesh, {}).has_value());

  const auto file = read_glb(bytes);
  std::map<std::int64_t, std::size_t> facets;
  for (std::size_t i = 0; i < file.primitives().size(); ++i)
    facets[file.material(i)["extras"]["surface"]] =
      file.numbers(file.primitives()[i]["indices"]).size() / 3;
  std::map<std::int64_t, std::size_t> wanted;
  double volume = 0;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      ++wanted[mesh.facet(f).surface];
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t))
      volume += signed_volume(mesh.corners(t));
  EXPECT_EQ(facets, wanted);
  EXPECT_NEAR(volume_of(file) / volume, 1, 1e-6);
}

TEST(Glb, ItIsRefusedAsAMeshByItsName) {
  const std::string bytes("glTF\x02\0\0\0", 8);
  const auto read = read_any(bytes);
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().message, "this is a glTF file, not a Gmsh mesh");
}

}  // namespace
}  // namespace tedit
