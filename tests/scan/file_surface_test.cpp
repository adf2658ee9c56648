// SPDX-License-Identifier: AGPL-3.0-or-later
// What the readers of surface files take, and how they refuse what is broken.
#include "scan/reader/file_surface.hpp"

#include <gmock/gmock.h>

#include "mesh/io/formats.hpp"
#include "tests/scan/surfaces.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/scratch.hpp"

namespace tedit::scan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::span<const char> bytes_of(const std::string& text) {
  return {text.data(), text.size()};
}

TEST(StlFile, HasItsTrianglesInBothKinds) {
  const auto cube = test::cube_soup(10);
  for (const auto& text : {test::stl_of(cube), test::stl_text_of(cube, "box")}) {
    const auto read = test::value(read_stl(bytes_of(text)));

    ASSERT_EQ(read.surface.triangles.size(), 12U);
    EXPECT_EQ(read.surface.points.size(), 36U);
    EXPECT_EQ(read.surface.points[2], (vec3{0, 10, 10}));
    EXPECT_THAT(read.groups, IsEmpty());
  }
}

TEST(StlFile, OfSeveralSolidsHasAGroupForEach) {
  const auto cube = test::cube_soup(10);
  const test::soup first(cube.begin(), cube.begin() + 4);
  const test::soup rest(cube.begin() + 4, cube.end());
  const auto read = test::value(
    read_stl(bytes_of(test::stl_text_of(first, "inlet") + test::stl_text_of(rest, "walls of it"))));

  ASSERT_EQ(read.groups.size(), 2U);
  EXPECT_EQ(read.groups[0].name, "inlet");
  EXPECT_EQ(read.groups[1].name, "walls of it");
  EXPECT_EQ(read.group_of[3], 0U);
  EXPECT_EQ(read.group_of[4], 1U);
}

struct broken_file {
  const char* what;
  expected<file_surface> (*read)(std::span<const char>);
  std::string text;
  const char* message;
  std::string where;
};

void expect_refused(const broken_file& one) {
  const auto read = one.read(bytes_of(one.text));
  ASSERT_FALSE(read) << one.what;
  EXPECT_THAT(read.error().message, HasSubstr(one.message)) << one.what;
  EXPECT_EQ(read.error().where, one.where) << one.what;
  EXPECT_NE(read.error().remedy, "") << one.what;
}

std::string with_count(std::string stl, std::uint32_t count) {
  std::memcpy(stl.data() + 80, &count, sizeof(count));
  return stl;
}

TEST(StlFile, RefusesWhatIsBrokenWithThePlace) {
  const auto stl = test::stl_of(test::cube_soup(10));
  auto not_a_number = stl;
  const float nan = std::nanf("");
  std::memcpy(not_a_number.data() + 84 + 50 + 12 + 4, &nan, sizeof(nan));
  const auto text = test::stl_text_of(test::cube_soup(10), "box");
  auto word = text;
  word.replace(word.find("vertex"), 6, "corner");
  const std::vector<broken_file> files{
    {"cut off", read_stl, stl.substr(0, 300),
     "says that it has 12 triangles, but its bytes end after 4", "byte 80"},
    {"header alone", read_stl, stl.substr(0, 60), "its header alone has 84", "byte 60"},
    {"a count of 2^31", read_stl, with_count(stl, 0x80000000U),
     "says that it has 2147483648 triangles, but its bytes end after 12", "byte 80"},
    {"not a number", read_stl, not_a_number,
     "triangle 2 of the STL file has a corner that is no finite number", "byte 146"},
    {"no triangles", read_stl, with_count(stl.substr(0, 84), 0), "holds no triangle", ""},
    {"text cut off", read_stl, text.substr(0, text.find("  vertex", text.find("  vertex") + 1)),
     "the STL file ends within a facet", "line 4"},
    {"a word", read_stl, word, "\"corner\" is no word of an STL file", "line 4"}};
  for (const auto& one : files)
    expect_refused(one);
}

constexpr const char* tet_obj =
  "# four walls\nmtllib a.mtl\nv 0 0 0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nv 0 0 1\n"
  "g floor\nf 1 3 2\ng walls\nusemtl red\nf 1//1 2//1 4//1\nf 2/1 3/2 4/3\nf -2 -4 -1\n";

TEST(ObjFile, HasItsGroups) {
  const auto read = test::value(read_obj(bytes_of(tet_obj)));

  ASSERT_EQ(read.surface.triangles.size(), 4U);
  EXPECT_EQ(read.surface.triangles[3], (triangle_corners{2, 0, 3}));
  ASSERT_EQ(read.groups.size(), 2U);
  EXPECT_EQ(read.groups[1].name, "walls");
  EXPECT_THAT(read.group_of, ElementsAre(0, 1, 1, 1));
}

TEST(ObjFile, OfTEditHasTheIdsAndTheUnit) {
  const std::string text =
    "# TEdit boundary, unit cm\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "g Floor_12\nf 1 3 2\ng surface_7\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  const auto read = test::value(read_obj(bytes_of(text)));

  EXPECT_EQ(read.unit, "cm");
  EXPECT_EQ(read.groups[0].name, "Floor");
  EXPECT_EQ(read.groups[0].id, 12);
  EXPECT_EQ(read.groups[1].name, "");
  EXPECT_EQ(read.groups[1].id, 7);
}

TEST(ObjFile, RefusesWhatIsBrokenWithTheLine) {
  expect_refused(
    {"vertex", read_obj, "v 0 0 0\nv 1 0 0\nf 1 2 3\n", "a face names vertex 3 of 2", "line 3"});
  expect_refused({"number", read_obj, "v 0 inf 0\n", "y \"inf\" is not a finite number", "line 1"});
  expect_refused({"short", read_obj, "v 0 0\n", "a vertex has 2 coordinates, not 3", "line 1"});
  expect_refused({"nothing", read_obj, "v 0 0 0\n", "holds no triangle", ""});
}

/// A tet whose four faces have two colours; `big`: the bytes of each number turned.
std::string tet_ply(bool text, bool big) {
  std::string file = "ply\nformat ";
  file += text ? "ascii" : big ? "binary_big_endian" : "binary_little_endian";
  file +=
    " 1.0\ncomment made by hand\nelement vertex 4\nproperty double x\nproperty float y\nproperty "
    "float z\nproperty uchar quality\nelement face 4\nproperty uchar red\nproperty uchar "
    "green\nproperty uchar blue\nproperty list uchar int vertex_indices\nend_header\n";
  const auto put = [&](auto value) {
    if (text) {
      file += std::to_string(value) + " ";
      return;
    }
    std::string bytes;
    test::put_bytes(bytes, value);
    file += big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
  };
  for (const auto& [x, y, z] :
       {std::array{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}) {
    put(x);
    put(static_cast<float>(y));
    put(static_cast<float>(z));
    put(std::uint8_t{9});
  }
  const std::array<std::array<std::int32_t, 3>, 4> faces{
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    put(std::uint8_t{255});
    put(static_cast<std::uint8_t>(i == 0 ? 0 : 128));
    put(std::uint8_t{0});
    put(std::uint8_t{3});
    for (const auto v : faces[i])
      put(v);
  }
  return file;
}

TEST(PlyFile, IsTheSameInEachEncoding) {
  for (const auto& [text, big] : {std::pair{true, false}, {false, false}, {false, true}}) {
    const auto read = test::value(read_ply(bytes_of(tet_ply(text, big))));

    ASSERT_EQ(read.surface.triangles.size(), 4U);
    EXPECT_EQ(read.surface.triangles[1], (triangle_corners{0, 1, 3}));
    EXPECT_EQ(read.surface.points[3], (vec3{0, 0, 1}));
    ASSERT_EQ(read.groups.size(), 2U);
    EXPECT_EQ(read.groups[0].name, "#ff0000");
    EXPECT_EQ(read.groups[1].name, "#ff8000");
    EXPECT_THAT(read.group_of, ElementsAre(0, 1, 1, 1));
  }
}

TEST(PlyFile, RefusesWhatIsBrokenWithThePlace) {
  const auto whole = tet_ply(false, false);
  const auto body = whole.find("end_header\n") + 11;
  const auto edited = [&](const char* from, const char* to) {
    auto text = whole;
    text.replace(text.find(from), std::string(from).size(), to);
    return text;
  };
  expect_refused({"cut off", read_ply, whole.substr(0, whole.size() - 20),
                  "the numbers of the PLY file end before its counts",
                  "byte " + std::to_string(body + 112)});
  expect_refused({"too many faces", read_ply, edited("face 4", "face 40"),
                  "the PLY file says that it has 40 of \"face\", more than its bytes can hold",
                  "byte " + std::to_string(body + 69)});
  expect_refused({"a count of 2^31", read_ply, edited("vertex 4", "vertex 2147483648"),
                  "says that it has 2147483648 of \"vertex\", more than its bytes can hold",
                  "byte " + std::to_string(body + 9)});
  expect_refused({"encoding", read_ply, edited("binary_little_endian", "packed"),
                  "\"packed\" is no encoding of a PLY file", "line 2"});
  expect_refused({"type", read_ply, edited("property double x", "property string x"),
                  "\"string\" is no type of a PLY file", "line 5"});
  expect_refused({"no end", read_ply, whole.substr(0, whole.find("element face")),
                  "the header of the PLY file has no end", "line 8"});
}

/// A file as TEdit writes it.
std::string written(const char* format, const file_terms& terms) {
  std::string bytes;
  test::value(write_as(format, file_target(&bytes), *test::box_mesh({1, 1, 1}, {1, 1, 1}), terms));
  return bytes;
}

TEST(ThreemfFile, ThatTEditWroteComesBack) {
  file_terms terms;
  terms.length_unit = "in";
  const auto read = test::value(read_3mf(bytes_of(written("3mf", terms))));

  EXPECT_EQ(read.unit, "in");
  EXPECT_EQ(read.surface.triangles.size(), 12U);
  EXPECT_EQ(read.bodies.size(), 1U);
}

TEST(ThreemfFile, RefusesWhatIsBrokenWithThePlace) {
  const auto whole = written("3mf", {});
  auto bent = whole;
  bent[whole.find("3dmodel.model") + 40] ^= 0x55;
  const auto read = [](const std::string& text) { return read_3mf(bytes_of(text)); };

  EXPECT_THAT(read(whole.substr(0, whole.size() - 30)).error().message,
              HasSubstr("it has no directory, as if it were cut off"));
  EXPECT_THAT(read(bent).error().message, HasSubstr("the archive of the 3MF file is damaged"));
  EXPECT_THAT(read(bent).error().where, HasSubstr("byte "));
}

}  // namespace
}  // namespace tedit::scan
