// SPDX-License-Identifier: AGPL-3.0-or-later
// From every format that is read to every format that is written: ids, names, regions, unit and
// places survive, or the exception that stands here.
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/build_version.hpp"
#include "mesh/face_key.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/import.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/scratch.hpp"

namespace tedit {
namespace {

std::vector<std::string> both_ways() {
  std::vector<std::string> names;
  for (const auto& format : file_formats)
    if (format.reads && format.writes && (TEDIT_HAS_MED || format.name != "med"))
      names.emplace_back(format.name);
  return names;
}

/// How far a coordinate may move, of the part's size: nothing where numbers have all their digits.
double tolerance_of(const std::string& format) {
  return format == "bdf" ? 1e-9 : 1e-15;  // 16 characters; else the rounding of a unit.
}

/// Where the corners of a triangle are, whatever vertices are called, rounded so that they compare.
using place = std::array<std::int64_t, 3>;
using triangle_place = std::array<place, 3>;

place rounded(vec3 p, double size) {
  const auto one = [&](double x) { return std::llround(x / size * 1e7); };
  return {one(p.x), one(p.y), one(p.z)};
}

struct facts {
  std::map<triangle_place, surface_id> surface_of;
  std::map<std::array<place, 4>, region_id> region_of;
  std::vector<surface_info> surfaces;
  std::vector<region_info> regions;
  std::vector<vec3> positions;  ///< In the order of the file.

  friend bool operator==(const facts& a, const facts& b) {
    return a.surface_of == b.surface_of && a.region_of == b.region_of && a.surfaces == b.surfaces &&
           a.regions == b.regions;
  }
};

constexpr double part_size = 0.1;  // m, of all parts here.

triangle_place place_of(const mesh_version& mesh, const std::array<vertex_id, 3>& v) {
  triangle_place result{rounded(mesh.position(v[0]), part_size),
                        rounded(mesh.position(v[1]), part_size),
                        rounded(mesh.position(v[2]), part_size)};
  std::ranges::sort(result);
  return result;
}

facts facts_of(const mesh_version& mesh) {
  facts result;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      result.surface_of[place_of(mesh, mesh.facet(f).v)] = mesh.facet(f).surface;
  for (std::size_t i = 0; i < mesh.data().interfaces.size(); ++i)
    result.surface_of[place_of(mesh, mesh.data().interfaces[i].v)] =
      mesh.data().interfaces[i].surface;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t))
      continue;
    std::array<place, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
      corners[i] = rounded(mesh.position(mesh.tet_at(t).v[i]), part_size);
    std::ranges::sort(corners);
    result.region_of[corners] = mesh.region_of(t);
  }
  result.surfaces = mesh.surfaces();
  result.regions = mesh.regions();
  return result;
}

expected<imported_mesh> through(const std::string& format, const mesh_version& mesh,
                                const std::string& unit) {
  std::string bytes;
  if (const auto ok = write_as(format, &bytes, mesh, {.length_unit = unit}); !ok)
    return fail(ok.error());
  return import_mesh_bytes(bytes, unit);
}

void expect_the_same(const mesh_version& before, const mesh_version& after, double tolerance) {
  EXPECT_TRUE(facts_of(after) == facts_of(before));
  ASSERT_EQ(after.vertex_count(), before.vertex_count());
  EXPECT_NEAR(total_volume(after), total_volume(before), 1e-7 * total_volume(before));
  std::vector<vec3> a;
  std::vector<vec3> b;
  for (vertex_id v = 0; v < before.vertex_slots(); ++v)
    if (before.is_live_vertex(v))
      a.push_back(before.position(v));
  for (vertex_id v = 0; v < after.vertex_slots(); ++v)
    if (after.is_live_vertex(v))
      b.push_back(after.position(v));
  double off = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    off = std::max(off, norm(a[i] - b[i]));
  EXPECT_LE(off, tolerance * part_size);
}

/// Two tets of two regions that share a face, an interface with an id of its own, names with all
/// kinds of characters, a negative id and one beyond 31 bits.
version_ptr two_regions(bool odd_ids) {
  raw_mesh raw;
  raw.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1.0 / 3, 0}, {0, 0, 1e-5}, {1, 1, 1}};
  raw.tets = {{{0, 1, 2, 3}}, {{1, 2, 3, 4}}};
  raw.tet_regions = {4, 2};
  const surface_id big = odd_ids ? 5'000'000'000 : 5'000;
  const surface_id negative = odd_ids ? -7 : 7;
  raw.triangles = {{{0, 1, 2}, negative}, {{0, 1, 3}, negative}, {{0, 2, 3}, negative},
                   {{1, 2, 4}, big},      {{1, 3, 4}, big},      {{2, 3, 4}, 12},
                   {{1, 2, 3}, 30}};
  raw.surface_names = {{negative, "three: squares, of <3> & \"more\""},
                       {big, "Bohrung \xc3\xa4 8"}};
  raw.region_names = {{4, "Steel 42"}, {2, ""}};
  return build_version(std::move(raw), 1e-3)->version;
}

TEST(FormatMatrix, ThereAreTheseFormatsBothWays) {
  EXPECT_THAT(both_ways(), ::testing::IsSupersetOf({"msh", "msh2", "vtu", "inp", "bdf", "unv"}));
  EXPECT_EQ(std::ranges::count(both_ways(), "med"), TEDIT_HAS_MED);
}

TEST(FormatMatrix, IdsNamesRegionsAndInterfacesSurviveEveryPair) {
  std::map<std::pair<std::string, bool>, imported_mesh> firsts;
  for (const auto& from : both_ways())
    for (const auto& to : both_ways()) {
      SCOPED_TRACE(from + " to " + to);
      const bool msh = from.starts_with("msh") || to.starts_with("msh");  // Ids have 32 bits there.
      const auto mesh = two_regions(!msh);
      const std::pair key(from, msh);
      if (!firsts.contains(key))
        firsts.emplace(key, test::value(through(from, *mesh, "mm")));
      const auto& first = firsts.at(key);
      const auto second = through(to, *first.version, first.length_unit);
      ASSERT_TRUE(second.has_value()) << render(second.error());

      expect_the_same(*mesh, *second->version, tolerance_of(from) + tolerance_of(to));
    }
}

TEST(FormatMatrix, RealPartsSurviveEachFormat) {
  for (const auto* part :
       {"as1_assembly/as1_assembly.coarse.msh", "ctc01_plate/ctc01_plate.coarse.physical.msh"}) {
    const auto mesh = import_mesh(test::parts_folder / part, "mm");
    ASSERT_TRUE(mesh.has_value());
    for (const auto& format : both_ways()) {
      SCOPED_TRACE(std::string(part) + " as " + format);
      const auto again = through(format, *mesh->version, "in");
      ASSERT_TRUE(again.has_value()) << render(again.error());
      expect_the_same(*mesh->version, *again->version, 20 * tolerance_of(format));
    }
  }
}

TEST(FormatMatrix, TheUnitOfTheFileCounts) {
  const auto mesh = two_regions(false);
  for (const auto& format : both_ways()) {
    SCOPED_TRACE(format);
    if (!find_format(format)->keeps.unit)
      continue;
    std::string bytes;
    ASSERT_TRUE(write_as(format, &bytes, *mesh, {.length_unit = "cm"}).has_value());

    const auto again = import_mesh_bytes(bytes, "ft");

    ASSERT_TRUE(again.has_value()) << render(again.error());
    EXPECT_EQ(again->length_unit, format == "vtu" ? "m" : "cm");
    EXPECT_NEAR(total_volume(*again->version), total_volume(*mesh), 1e-9 * total_volume(*mesh));
    EXPECT_THAT(again->warnings, ::testing::Contains(::testing::HasSubstr(
                                   "the file says that its lengths are in " + again->length_unit)));
  }
}

}  // namespace
}  // namespace tedit
