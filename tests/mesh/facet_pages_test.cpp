// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/facet_pages.hpp"

#include <algorithm>
#include <functional>
#include <thread>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "mesh/builder.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

/// 4,800 facets in three pages, 9,261 vertices in five.
version_ptr large_box() {
  static const auto made = test::box_mesh({20, 20, 20}, {1, 2, 3});
  return made;
}

/// The same version of pages that nobody has looked at.
version_ptr copy_of(const mesh_version& mesh) {
  return *mesh_version::from_manifest(mesh.pages(), [&](const hash128& id) {
    page_ptr found;
    mesh.for_each_page([&](const page_ptr& p) {
      if (p->id() == id)
        found = page::from_bytes(p->bytes());
    });
    return found;
  });
}

std::vector<std::shared_ptr<const facet_page>> pages_of(const mesh_version& mesh) {
  std::vector<std::shared_ptr<const facet_page>> result;
  for (std::size_t p = 0; p < mesh.data().facets.pages().size(); ++p)
    result.push_back(facet_page_of(mesh, p));
  return result;
}

TEST(FacetPages, TheSurfacesOfABoxAreItsSides) {
  const auto sizes = surface_sizes(*test::box_mesh({2, 3, 4}, {1, 2, 3}));

  ASSERT_EQ(sizes.size(), 6u);
  EXPECT_EQ(sizes.at(1).facets, 24u);  // x = 0: 3 x 4 squares of two.
  EXPECT_NEAR(sizes.at(1).area_m2, 6, 1e-14);
  EXPECT_EQ(sizes.at(4).facets, 16u);  // y = 2: 2 x 4.
  EXPECT_NEAR(sizes.at(4).area_m2, 3, 1e-14);
  EXPECT_EQ(sizes.at(6).facets, 12u);  // z = 3: 2 x 3.
  EXPECT_NEAR(sizes.at(6).area_m2, 2, 1e-14);
}

TEST(FacetPages, FacetsBetweenRegionsCountInAreasOnly) {
  const auto plain = test::box_mesh({2, 2, 2}, {1, 1, 1});
  mesh_builder builder(plain);
  const auto seam = builder.add_surface("seam");
  builder.set_interfaces({{{0, 1, 3}, 0, seam}});  // Half a square of 1/2 x 1/2.
  const auto mesh = builder.freeze();

  EXPECT_FALSE(surface_sizes(*mesh).contains(seam));
  EXPECT_NEAR(surface_areas(*mesh).at(seam), 0.125, 1e-15);
  EXPECT_NEAR(surface_areas(*mesh).at(1), 1, 1e-14);
}

TEST(FacetPages, OnlyPagesWithAChangedCornerAreReadAgain) {
  const auto before = large_box();
  const auto known = pages_of(*before);
  ASSERT_EQ(known.size(), 3u);
  mesh_builder builder(before);
  const auto last = before->vertex_slots() - 1;  // A corner of the box, in the last pages.
  builder.set_position(last, before->position(last) + vec3{0, 0, 0.5});
  const auto after = builder.freeze();
  ASSERT_EQ(after->data().facets.pages(), before->data().facets.pages());

  const auto now = pages_of(*after);

  int kept = 0;
  for (std::size_t p = 0; p < now.size(); ++p) {
    const bool has_it = now[p]->positions.back().first == last >> paged_array<vec3>::shift;
    EXPECT_EQ(now[p] == known[p], !has_it) << p;
    kept += !has_it;
  }
  EXPECT_GT(kept, 0);
  EXPECT_DOUBLE_EQ(now.back()->extent.high.z, 3.5);
  EXPECT_EQ(pages_of(*after), now);
}

// Each takes away what the other just read: under AddressSanitizer it was read after it was freed.
TEST(FacetPages, TwoVersionsOfTheSamePagesAreReadAtOnce) {
  auto data = large_box()->data();
  auto facets = data.facets.to_vector();
  for (std::size_t f = 0; f < facets.size(); ++f)
    facets[f].surface = static_cast<surface_id>(f + 1);  // To read takes as long as to make.
  data.facets = paged_array<boundary_facet>::from(facets);
  const auto before = mesh_version::create(data);
  auto positions = data.positions.to_vector();
  for (auto& x : positions)
    x = x * 2;
  data.positions = paged_array<vec3>::from(positions);
  const auto after = mesh_version::create(data);
  ASSERT_EQ(after->data().facets.pages(), before->data().facets.pages());
  const auto areas = [](const mesh_version& mesh, double whole) {
    for (int i = 0; i < 50; ++i) {
      double sum = 0;
      for (const auto& [id, size] : surface_sizes(mesh))
        sum += size.area_m2;
      EXPECT_NEAR(sum, whole, 1e-9);
    }
  };

  std::jthread other(areas, std::cref(*after), 88);
  areas(*before, 22);
}

TEST(FacetPages, TheFactsOfAVersionBeforeAnEditStayRight) {
  const auto before = large_box();
  const auto area = surface_areas(*before);
  mesh_builder builder(before);
  for (vertex_id v = 0; v < before->vertex_slots(); ++v)
    builder.set_position(v, 2 * before->position(v));
  const auto after = builder.freeze();

  EXPECT_NEAR(surface_areas(*after).at(3), 4 * area.at(3), 1e-12);
  EXPECT_EQ(surface_areas(*before), area);
}

TEST(FacetPages, FacetsOfSurfacesComeInSlotOrder) {
  const auto mesh = large_box();
  const std::vector<surface_id> wanted{6, 2};
  std::vector<facet_id> expected;
  for (facet_id f = 0; f < mesh->facet_slots(); ++f)
    if (mesh->facet(f).surface == 2 || mesh->facet(f).surface == 6)
      expected.push_back(f);

  EXPECT_EQ(expected.size(), 1600u);
  EXPECT_EQ(facets_of(*mesh, wanted), expected);
  EXPECT_TRUE(facets_of(*mesh, std::vector<surface_id>{99}).empty());
}

TEST(FacetPages, BoundaryVerticesAreThoseOfTheSides) {
  const auto vertices = boundary_vertices(*test::box_mesh({2, 2, 2}, {1, 1, 1}));

  ASSERT_EQ(vertices.size(), 26u);  // 27 less the one in the middle.
  EXPECT_TRUE(std::ranges::is_sorted(vertices));
  EXPECT_FALSE(std::ranges::binary_search(vertices, 13u));
}

TEST(FacetPages, ADamagedFacetIsLeftOut) {
  auto data = test::box_mesh({2, 2, 2}, {1, 1, 1})->data();
  paged_array_builder<boundary_facet> facets(data.facets);
  facets.write(0).v[1] = 12345;
  const auto surface = facets[0].surface;
  data.facets = facets.freeze();

  const auto sizes = surface_sizes(*mesh_version::create(data));

  EXPECT_EQ(sizes.at(surface).facets, 7u);  // Of eight.
}

RC_GTEST_PROP(FacetPages, WhateverMeetsABoxIsFoundNearIt, ()) {
  const auto mesh = large_box();
  const auto number = [](int high) { return *rc::gen::inRange(0, high) / 100.0; };
  box within;
  within.add(vec3{number(120), number(220), number(320)});
  within.add(vec3{number(120), number(220), number(320)});

  std::vector<facet_id> found;
  for_each_facet_near(*mesh, within, [&](facet_id f) { found.push_back(f); });

  RC_ASSERT(std::ranges::is_sorted(found));
  for (facet_id f = 0; f < mesh->facet_slots(); ++f) {
    const auto& v = mesh->facet(f).v;
    const auto extent =
      box_of(std::array{mesh->position(v[0]), mesh->position(v[1]), mesh->position(v[2])});
    RC_ASSERT(!extent.meets(within) || std::ranges::binary_search(found, f));
  }
}

/// Edits one after the other, each asked at once: what pages keep is never that of another version.
RC_GTEST_PROP(FacetPages, SumsAreThoseOfAVersionThatNobodyLookedAt, ()) {
  auto mesh = large_box();
  const auto edits = *rc::gen::inRange(1, 5);
  for (int i = 0; i < edits; ++i) {
    mesh_builder builder(mesh);
    const auto v = *rc::gen::inRange(0u, mesh->vertex_slots());
    builder.set_position(v, mesh->position(v) + vec3{0.001, 0.002, 0.003});
    builder.set_surface(*rc::gen::inRange(0u, mesh->facet_slots()), *rc::gen::inRange(1, 7));
    const auto before = mesh;
    mesh = builder.freeze();

    for (const auto& one : {mesh, before}) {
      const auto fresh = copy_of(*one);
      const auto sizes = surface_sizes(*one);
      const auto others = surface_sizes(*fresh);
      RC_ASSERT(sizes.size() == others.size());
      for (const auto& [id, size] : sizes) {
        RC_ASSERT(others.at(id).facets == size.facets);
        RC_ASSERT(others.at(id).area_m2 == size.area_m2);
      }
    }
  }
}

}  // namespace
}  // namespace tedit
