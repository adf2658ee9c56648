// SPDX-License-Identifier: AGPL-3.0-or-later
// What a client holds of a surface after any run of versions: slots that are freed and taken again,
// vertices that come to the boundary and leave it, versions that come back, previews in between.
#include "actors/gateway/surface_stream.hpp"

#include <random>

#include "client/inbox.hpp"
#include "mesh/builder.hpp"
#include "mesh/facet_pages.hpp"
#include "tests/simulation/shown.hpp"
#include "tests/states/client_fixture.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::gateway {
namespace {

constexpr std::array<std::array<int, 3>, 4> faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// A stream, the line, and what the client at its other end makes of it.
class SurfaceStream : public ::testing::Test {
protected:
  SurfaceStream()
      : inbox_(handlers_, [this](std::uint64_t, client::incoming_stream data) {
          preview_ = std::move(data);
        }) {
    inbox_.open("part", {});
    inbox_.opened("part");
  }

  /// Sends what it takes to show this version; whether that was anything.
  bool show(const version_ptr& mesh) {
    auto update = stream_.update_to("part", mesh);
    if (!update)
      return false;
    deliver(std::move(*update));
    return true;
  }

  /// What the client makes of a preview on the surface that it holds.
  client::surface_model with_preview(const version_ptr& base, const version_ptr& mesh) {
    deliver(stream_.preview(
      {"part", base, mesh, std::make_shared<const edit_report>(), actors::no_load_cases()}));
    auto shown = inbox_.surface();
    const auto read = client::read_preview(preview_header_, preview_);
    EXPECT_TRUE(read && shown.apply(read->surface));
    return shown;
  }

  void deliver(bulk data) {
    outbox out(line_);
    bool sent = false;
    out.add([&]() -> std::optional<bulk> {
      sent = true;
      return std::move(data);
    });
    out.pump();
    ASSERT_TRUE(sent);
    for (const auto& message : line_->messages) {
      const auto bytes = message.ByteSizeLong();
      if (message.has_surface_update()) {
        ASSERT_TRUE(inbox_.take(message.surface_update(), bytes));
      }
      if (message.has_edit_preview()) {
        preview_header_ = message.edit_preview();
        ASSERT_TRUE(inbox_.take(message.edit_preview().surface().stream(), 1, bytes));
      }
      if (message.has_chunk()) {
        ASSERT_TRUE(inbox_.take(message.chunk(), bytes));
      }
    }
    last_ = line_->messages.front();
    line_->messages.clear();
  }

  surface_stream stream_;
  std::shared_ptr<quiet_line> line_ = std::make_shared<quiet_line>();
  client::events handlers_;
  client::incoming_stream preview_;
  v1::EditPreview preview_header_;
  v1::ServerMessage last_;
  client::inbox inbox_;
};

/// A random small change of topology or place.
class random_changes {
public:
  explicit random_changes(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

  version_ptr change(const version_ptr& base) {
    mesh_builder builder(base);
    const auto changes = 1 + below(3);
    for (std::size_t i = 0; i < changes; ++i) {
      switch (below(4)) {
        case 0:
          take_away(builder);
          break;
        case 1:
          split(builder);
          break;
        default:
          move(builder);
      }
    }
    return builder.freeze();
  }

private:
  tet_id some_tet(const mesh_builder& builder) {
    for (;;)
      if (const auto t = static_cast<tet_id>(below(builder.tet_slots())); builder.is_live_tet(t))
        return t;
  }

  /// The walls of the hole that is left get surfaces of their own now and then.
  void take_away(mesh_builder& builder) {
    if (builder.tet_count() < 20)
      return;
    const auto t = some_tet(builder);
    const auto corners = builder.tet_at(t).v;
    cavity_change change;
    change.removed = {t};
    const auto surface = below(3) ? surface_id{1} : builder.add_surface("wall");
    for (const auto& face : faces)
      change.facets.push_back(
        {{corners[static_cast<std::size_t>(face[0])], corners[static_cast<std::size_t>(face[1])],
          corners[static_cast<std::size_t>(face[2])]},
         surface});
    (void)builder.apply(change);  // Some do not fit; then nothing has changed.
  }

  /// One tet into four around a new vertex; where a face is on the boundary it stays there.
  void split(mesh_builder& builder) {
    const auto t = some_tet(builder);
    const auto tet_of = builder.tet_at(t);
    const auto at = builder.corners(t);
    const auto v = builder.add_vertex((at[0] + at[1] + at[2] + at[3]) * .25);
    cavity_change change;
    change.removed = {t};
    for (std::size_t i = 0; i < 4; ++i) {
      auto corners = tet_of;
      corners.v[i] = v;
      change.added.push_back({corners, builder.region_of(t)});
    }
    ASSERT_TRUE(builder.apply(change));
  }

  void move(mesh_builder& builder) {
    const auto v = static_cast<vertex_id>(below(builder.vertex_slots()));
    if (builder.is_live_vertex(v))
      builder.set_position(v, builder.position(v) + vec3{1e-3, -1e-3, 2e-3});
  }

  std::mt19937 random_;
};

TEST_F(SurfaceStream, FirstComesAllAndThenTheDifference) {
  const auto first = test::box_mesh({1, 1, 1}, {1, 1, 1});
  EXPECT_TRUE(show(first));
  EXPECT_EQ(last_.surface_update().base_version_id(), "");
  EXPECT_EQ(last_.surface_update().surfaces_size(), 6);
  EXPECT_TRUE(simulation::shows(inbox_.surface(), *first));
  EXPECT_FALSE(show(first));
  const auto second = simulation::nudged(first, 0, .25);
  EXPECT_TRUE(show(second));
  EXPECT_EQ(last_.surface_update().base_version_id(), to_hex(first->id()));
  EXPECT_EQ(last_.surface_update().stream().arrays(1).items(), 1U) << "one vertex";
  EXPECT_EQ(last_.surface_update().stream().arrays(3).items(), 0U) << "no facet";
  EXPECT_TRUE(simulation::shows(inbox_.surface(), *second));
}

TEST_F(SurfaceStream, WhoComesBackWithASurfaceGetsTheDifferenceToIt) {
  const auto first = test::box_mesh({1, 1, 1}, {1, 1, 1});
  const auto second = simulation::nudged(first, 0, .25);
  show(first);
  stream_ = {};  // Another connection.
  EXPECT_TRUE(stream_.is_empty());
  stream_.resume(first);
  EXPECT_FALSE(stream_.is_empty());
  EXPECT_TRUE(show(second));
  EXPECT_EQ(last_.surface_update().base_version_id(), to_hex(first->id()));
  EXPECT_EQ(last_.surface_update().stream().arrays(1).items(), 1U) << "one vertex";
  EXPECT_TRUE(simulation::shows(inbox_.surface(), *second));
}

TEST_F(SurfaceStream, WhoComesBackWithTheHeadsIsToldSoOnce) {
  const auto first = test::box_mesh({1, 1, 1}, {1, 1, 1});
  show(first);
  stream_ = {};
  stream_.resume(first);
  EXPECT_TRUE(show(first));
  EXPECT_EQ(last_.surface_update().version_id(), to_hex(first->id()));
  EXPECT_EQ(last_.surface_update().base_version_id(), to_hex(first->id()));
  EXPECT_EQ(last_.surface_update().stream().bytes(), 0U);
  EXPECT_TRUE(simulation::shows(inbox_.surface(), *first));
  EXPECT_FALSE(show(first));
}

TEST_F(SurfaceStream, WhatIsPreviewedIsNotHeld) {
  const auto first = test::box_mesh({1, 1, 1}, {1, 1, 1});
  const auto second = simulation::nudged(first, 0, .25);
  show(first);
  EXPECT_TRUE(simulation::shows(with_preview(first, second), *second));
  EXPECT_TRUE(show(second));
  EXPECT_EQ(last_.surface_update().base_version_id(), to_hex(first->id()));
  EXPECT_TRUE(simulation::shows(inbox_.surface(), *second));
}

/// Each update is applied to what the client has, which must be the version's boundary then.
TEST_F(SurfaceStream, AfterAnyRunOfVersionsTheClientHoldsTheBoundary) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    random_changes random(seed);
    stream_ = {};
    std::vector<version_ptr> made{test::box_mesh({2, 2, 2}, {1, 1, 1})};
    show(made.front());
    auto head = made.front();
    for (int step = 0; step < 60; ++step) {
      if (random.below(8) == 0) {  // The connection broke.
        stream_ = {};
        stream_.resume(head);
      }
      if (random.below(4) == 0) {
        head = made[random.below(made.size())];
      } else {
        const auto next = random.change(head);
        if (random.below(3) == 0) {
          ASSERT_TRUE(simulation::shows(with_preview(head, next), *next)) << "step " << step;
        }
        made.push_back(next);
        head = next;
      }
      show(head);
      const auto held = inbox_.surface();
      ASSERT_TRUE(simulation::shows(held, *head)) << "step " << step;
      const auto sizes = surface_sizes(*head);
      ASSERT_EQ(held.surfaces().size(), sizes.size()) << "step " << step;
      for (const auto& [id, row] : held.surfaces()) {
        ASSERT_EQ(row.facets, sizes.at(id).facets) << "surface " << id << ", step " << step;
        ASSERT_NEAR(row.area_m2, held.area(id), 1e-12) << "surface " << id << ", step " << step;
      }
    }
  }
}

}  // namespace
}  // namespace tedit::gateway
