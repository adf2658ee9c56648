// SPDX-License-Identifier: AGPL-3.0-or-later
// 3MF and PLY, read back by readers of their own.
#include <zlib.h>

#include <cstring>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "mesh/build_version.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/import.hpp"
#include "mesh/io/vtu_field.hpp"
#include "mesh/io/zip_file.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/two_regions.hpp"

namespace tedit {
namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, size);
  return value;
}

/// The files of a zip archive, found through its directory, with their sizes and sums checked.
std::map<std::string, std::string> unzip(const std::string& zip) {
  std::map<std::string, std::string> files;
  const auto end = zip.rfind("PK\x05\x06");
  EXPECT_NE(end, zip.npos);
  std::size_t at = number_at(zip, end + 16, 4);
  for (auto left = number_at(zip, end + 10, 2); left > 0; --left) {
    EXPECT_EQ(zip.substr(at, 4), "PK\x01\x02");
    const auto packed = number_at(zip, at + 20, 4);
    const auto size = number_at(zip, at + 24, 4);
    const auto name = zip.substr(at + 46, number_at(zip, at + 28, 2));
    const std::size_t local = number_at(zip, at + 42, 4);
    EXPECT_EQ(zip.substr(local, 4), "PK\x03\x04");
    EXPECT_EQ(zip.substr(local + 30, name.size()), name);
    std::string text(size, '\0');
    z_stream z{};
    inflateInit2(&z, -15);
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(zip.data() + local + 30 + name.size()));
    z.avail_in = packed;
    z.next_out = reinterpret_cast<Bytef*>(text.data());
    z.avail_out = size;
    EXPECT_EQ(inflate(&z, Z_FINISH), Z_STREAM_END) << name;
    EXPECT_EQ(z.total_out, size);
    inflateEnd(&z);
    EXPECT_EQ(crc32(0, reinterpret_cast<const Bytef*>(text.data()), size),
              number_at(zip, at + 16, 4));
    files[name] = std::move(text);
    at += 46 + name.size();
  }
  EXPECT_EQ(at, end);
  return files;
}

pugi::xml_document model_of(const std::string& bytes) {
  pugi::xml_document document;
  const auto text = unzip(bytes)["3D/3dmodel.model"];
  EXPECT_TRUE(document.load_buffer(text.data(), text.size()));
  return document;
}

/// What an object encloses, in the file's unit, and whether each edge has one facet each way.
struct read_object {
  double volume = 0;
  bool closed = true;
};

read_object read_mesh_of(const pugi::xml_node& object) {
  std::vector<vec3> points;
  for (const auto& v : object.child("mesh").child("vertices").children("vertex"))
    points.push_back(
      {v.attribute("x").as_double(), v.attribute("y").as_double(), v.attribute("z").as_double()});
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  read_object result;
  for (const auto& t : object.child("mesh").child("triangles").children("triangle")) {
    const std::array<std::size_t, 3> v{t.attribute("v1").as_uint(), t.attribute("v2").as_uint(),
                                       t.attribute("v3").as_uint()};
    for (std::size_t i = 0; i < 3; ++i)
      ++edges[{v[i], v[(i + 1) % 3]}];
    result.volume += dot(points.at(v[0]), cross(points.at(v[1]), points.at(v[2]))) / 6;
  }
  for (const auto& [edge, count] : edges)
    result.closed = result.closed && count == 1 && edges.contains({edge.second, edge.first});
  return result;
}

std::size_t children(const pugi::xml_node& node, const char* name) {
  const auto all = node.children(name);
  return static_cast<std::size_t>(std::distance(all.begin(), all.end()));
}

TEST(ZipFile, TheSameTextInOtherPiecesIsTheSameFile) {
  std::string text;
  for (int i = 0; i < 40'000; ++i)
    text += std::to_string(i * 7919) + "\n";
  zip_packer whole("a");
  whole.add(text);
  zip_packer pieces("a");
  for (std::size_t i = 0; i < text.size(); i += 1000)
    pieces.add(std::string_view(text).substr(i, 1000));
  const std::array files{whole.finish(), pieces.finish()};

  std::ostringstream out;
  write_zip(out, std::span(files).first(1));

  EXPECT_EQ(unzip(out.str())["a"], text);
  std::ostringstream other;
  write_zip(other, std::span(files).last(1));
  EXPECT_EQ(unzip(other.str())["a"], text);
  EXPECT_TRUE(fits_zip(files));
  const std::array large{zipped_file{"a", "", 0, 0xFFFFFFFF}};
  EXPECT_FALSE(fits_zip(large));
}

TEST(ThreeMf, ABoxIsTwelveTrianglesInMillimetres) {
  const auto box = test::box_mesh({1, 1, 1}, {0.01, 0.02, 0.03});
  std::string bytes;
  std::string again;
  const file_terms terms{.length_unit = "mm", .title = "A <box> & \"more\""};

  ASSERT_TRUE(formats::threemf::write(&bytes, *box, terms).has_value());
  ASSERT_TRUE(formats::threemf::write(&again, *box, terms).has_value());

  EXPECT_EQ(bytes, again);
  EXPECT_EQ(unzip(bytes).size(), 3U);
  EXPECT_TRUE(formats::threemf::recognises(bytes));
  const auto document = model_of(bytes);
  const auto model = document.child("model");
  EXPECT_STREQ(model.attribute("unit").value(), "millimeter");
  EXPECT_STREQ(model.child("metadata").attribute("name").value(), "Title");
  EXPECT_STREQ(model.child("metadata").text().get(), "A <box> & \"more\"");
  const auto object = model.child("resources").child("object");
  EXPECT_EQ(children(object.child("mesh").child("triangles"), "triangle"), 12U);
  EXPECT_EQ(children(object.child("mesh").child("vertices"), "vertex"), 8U);
  EXPECT_FALSE(object.attribute("pid"));
  const auto read = read_mesh_of(object);
  EXPECT_NEAR(read.volume, 10 * 20 * 30, 1e-9);
  EXPECT_TRUE(read.closed);
  EXPECT_STREQ(model.child("build").child("item").attribute("objectid").value(),
               object.attribute("id").value());
}

TEST(ThreeMf, RegionsAreClosedPartsOfOneObject) {
  // 0.5 x 0.5 x 0.5 m each, and the face between them belongs to both.
  const auto mesh = test::two_regions();
  std::string bytes;

  ASSERT_TRUE(formats::threemf::write(&bytes, *mesh, {"cm"}).has_value());

  const auto document = model_of(bytes);
  const auto resources = document.child("model").child("resources");
  EXPECT_STREQ(document.child("model").attribute("unit").value(), "centimeter");
  std::vector<std::string> names;
  for (const auto& object : resources.children("object")) {
    if (!object.child("mesh"))
      continue;
    names.emplace_back(object.attribute("name").value());
    const auto read = read_mesh_of(object);
    EXPECT_NEAR(read.volume, 50 * 50 * 50, 1e-6);
    EXPECT_TRUE(read.closed);
  }
  EXPECT_THAT(names, ::testing::ElementsAre("region 4", "region 90"));
  EXPECT_EQ(children(resources, "object"), 3U);
  EXPECT_EQ(children(document.child("model").child("build"), "item"), 1U);
}

TEST(ThreeMf, SurfacesAreMaterialsAndVerticesHaveColoursOfAGroup) {
  const auto box = test::box_mesh({1, 1, 1}, {1, 1, 1});
  std::string bytes;

  ASSERT_TRUE(
    formats::threemf::write(&bytes, *box, {.colours = {.of_surfaces = {{6, {255, 0, 16}}}}})
      .has_value());
  auto document = model_of(bytes);
  auto resources = document.child("model").child("resources");
  const auto base = resources.child("basematerials").last_child();
  EXPECT_STREQ(base.attribute("displaycolor").value(), "#FF0010FF");
  EXPECT_STREQ(base.attribute("name").value(), "surface 6");
  int coloured = 0;
  for (const auto& t :
       resources.child("object").child("mesh").child("triangles").children("triangle"))
    coloured += t.attribute("p1").as_int() == 1;
  EXPECT_EQ(coloured, 2);

  file_colours colours{.of_vertices = std::vector<std::uint8_t>(8, 1),
                       .palette = {{0, 0, 0}, {1, 2, 3}}};
  ASSERT_TRUE(formats::threemf::write(&bytes, *box, {.colours = colours}).has_value());
  document = model_of(bytes);
  resources = document.child("model").child("resources");
  EXPECT_STREQ(resources.child("m:colorgroup").last_child().attribute("color").value(),
               "#010203FF");
  const auto triangle =
    resources.child("object").child("mesh").child("triangles").child("triangle");
  EXPECT_STREQ(triangle.attribute("p3").value(), "1");

  colours = {.of_facets = std::vector<std::uint8_t>(12, 1), .palette = colours.palette};
  ASSERT_TRUE(formats::threemf::write(&bytes, *box, {.colours = colours}).has_value());
  document = model_of(bytes);
  resources = document.child("model").child("resources");
  EXPECT_EQ(children(resources.child("m:colorgroup"), "m:color"), 2U);
  EXPECT_STREQ(resources.child("object").attribute("pid").value(), "1");
  const auto triangles = resources.child("object").child("mesh").child("triangles");
  for (const auto& one : triangles.children("triangle"))
    for (const auto* corner : {"p1", "p2", "p3"})
      EXPECT_STREQ(one.attribute(corner).value(), "1");
}

TEST(ThreeMf, RefusesAUnitThatItDoesNotKnow) {
  const auto box = test::box_mesh({1, 1, 1}, {1, 1, 1});
  std::string bytes;

  const auto written = formats::threemf::write(&bytes, *box, {"nm"});

  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().code, ec::invalid_argument);
  EXPECT_EQ(written.error().message, "a 3MF file cannot be in nm");
  EXPECT_TRUE(bytes.empty());
}

TEST(Ply, HasColoursOfVerticesOrFaces) {
  const auto box = test::box_mesh({1, 1, 1}, {1, 1, 1});
  const auto facets_at = [](const std::string& bytes, std::size_t vertex) {
    return bytes.find("end_header\n") + 11 + 8 * vertex;
  };
  std::string bytes;

  ASSERT_TRUE(formats::ply::write(&bytes, *box, {"m"}).has_value());
  EXPECT_TRUE(formats::ply::recognises(bytes));
  EXPECT_EQ(bytes.size(), facets_at(bytes, 12) + 12 * 13U);

  file_colours colours{.of_vertices = std::vector<std::uint8_t>(8, 1),
                       .palette = {{0, 0, 0}, {1, 2, 3}}};
  ASSERT_TRUE(formats::ply::write(&bytes, *box, {"m", {}, {}, colours}).has_value());
  EXPECT_EQ(bytes.size(), facets_at(bytes, 15) + 12 * 13U);
  EXPECT_EQ(bytes.substr(facets_at(bytes, 0) + 12, 3), "\x01\x02\x03");

  const file_colours of_surface{.of_surfaces = {{6, {9, 8, 7}}}};
  ASSERT_TRUE(formats::ply::write(&bytes, *box, {"m", {}, {}, of_surface}).has_value());
  EXPECT_EQ(bytes.size(), facets_at(bytes, 12) + 12 * 16U);
  int coloured = 0;
  for (std::size_t f = 0; f < 12; ++f) {
    const auto at = facets_at(bytes, 12) + 16 * f;
    EXPECT_EQ(bytes[at], 3);
    const bool on_top = std::ranges::all_of(std::array{1, 5, 9}, [&](std::size_t k) {
      float z = 0;
      std::memcpy(&z, bytes.data() + facets_at(bytes, 0) + 12 * number_at(bytes, at + k, 4) + 8, 4);
      return z == 1;
    });
    EXPECT_EQ(on_top, bytes.substr(at + 13, 3) == "\x09\x08\x07");
    coloured += on_top;
  }
  EXPECT_EQ(coloured, 2);
}

TEST(VtuField, IsFoundByItsNameWithoutItsUnit) {
  const auto box = test::box_mesh({1, 1, 1}, {1, 1, 1});
  std::vector<double> lengths;
  for (int i = 0; i < 8; ++i)
    lengths.insert(lengths.end(), {3.0 * i, 4.0 * i, 0});
  std::string bytes;
  ASSERT_TRUE(formats::vtu::write(&bytes, *box,
                                  {.fields = {{"displacement_m", field_location::vertex, 3,
                                               paged_array<double>::from(lengths)}}})
                .has_value());

  const auto found = read_point_field(bytes, "displacement");
  const auto missing = read_point_field(bytes, "von_mises");
  const auto other = read_point_field("$MeshFormat", "von_mises");

  ASSERT_TRUE(found.has_value()) << found.error().message;
  EXPECT_EQ(found->name, "displacement_m");
  auto sorted = found->values;
  std::ranges::sort(sorted);
  EXPECT_EQ(sorted, (std::vector<double>{0, 5, 10, 15, 20, 25, 30, 35}));
  EXPECT_EQ(missing.error().message, "the file has no field \"von_mises\" at its points");
  EXPECT_EQ(missing.error().remedy, "It has displacement_m");
  EXPECT_EQ(other.error().code, ec::invalid_argument);
}

}  // namespace
}  // namespace tedit
