// SPDX-License-Identifier: AGPL-3.0-or-later
// Several people in one document, over real sockets and on a real part.
#include <condition_variable>
#include <mutex>
#include <set>

#include "mesh/build_version.hpp"
#include "mesh/io/file.hpp"
#include "mesh/io/formats.hpp"
#include "tests/scenarios/fixture.hpp"

namespace tedit::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;

/// What a client hears of others.
class company {
public:
  client::events handlers() {
    client::events result;
    result.on_participant = [this](const client::participant& who, bool gone) {
      const std::lock_guard lock(mutex_);
      said_.push_back((gone ? "-" : "+") + who.name);
      came_.notify_all();
    };
    return result;
  }
  std::vector<std::string> wait_for(std::size_t count) {
    std::unique_lock lock(mutex_);
    came_.wait_for(lock, patience, [&] { return said_.size() >= count; });
    return said_;
  }

private:
  std::mutex mutex_;
  std::condition_variable came_;
  std::vector<std::string> said_;
};

class People : public ::testing::Test {
protected:
  void SetUp() override {
    ann = connect_as("ann", heard.handlers());
    const auto state = value(ann->open("part", false, false));
    ASSERT_EQ(state.participants.size(), 1U);
    EXPECT_EQ(state.participants.front().id, state.own_participant);
    base = value(ann->import_file(plate_mesh, "mm", {})).head.version_id;
    bob = connect_as("bob", {});
    bobs = value(bob->open("part", false, false));
  }

  std::unique_ptr<client::client> connect_as(const std::string& name, client::events handlers) {
    client::connect_options line;
    line.url = server->url();
    line.token = server_token;
    line.client_name = name;
    line.timeout = patience;
    return value(client::client::connect(line, std::move(handlers)));
  }

  expected<client::committed> carry(const std::string& operation,
                                    const std::vector<surface_id>& surfaces,
                                    const ops::parameters& values = {}) {
    return bob->edit(operation, surfaces, values, {}, base, {}, {}, true);
  }

  const std::vector<surface_id> first_hole{1, 2}, second_hole{92, 93};
  scratch_folder folder;
  server_options options = options_for(folder, false);
  std::unique_ptr<tedit::server> server = start(options);
  company heard;
  std::unique_ptr<client::client> ann, bob;
  client::document_state bobs;
  std::string base;
};

version_ptr plate() {
  return value(build_version(value(read_any(value(read_file(plate_mesh)))).mesh, 1e-3)).version;
}

/// Surfaces that share a vertex with these.
std::vector<surface_id> beside(const std::vector<surface_id>& surfaces) {
  const auto part = plate();
  std::set<vertex_id> rim;
  std::set<surface_id> found;
  const auto for_each = [&](auto&& what) {
    for (facet_id f = 0; f < part->facet_slots(); ++f)
      what(part->facet(f));
  };
  const auto is_one = [&](surface_id id) { return std::ranges::count(surfaces, id) > 0; };
  for_each([&](const boundary_facet& f) {
    if (is_one(f.surface))
      rim.insert(f.v.begin(), f.v.end());
  });
  for_each([&](const boundary_facet& f) {
    if (!is_one(f.surface) && std::ranges::any_of(f.v, [&](auto v) { return rim.contains(v); }))
      found.insert(f.surface);
  });
  return {found.begin(), found.end()};
}

TEST_F(People, AnEditElsewhereIsCarriedOverAndIsWhatItWouldBeOnTheNewHead) {
  value(ann->edit("fill_hole", first_hole, {}, {}));
  const auto carried = value(carry("fill_hole", second_hole));
  EXPECT_EQ(carried.head.parent, 1U);
  EXPECT_THAT(carried.report->notices, testing::Contains(HasSubstr("carried over from version 0")));

  value(ann->go_to(1));
  const auto asked_there = value(ann->edit("fill_hole", second_hole, {}, {}));
  EXPECT_EQ(asked_there.head.version_id, carried.head.version_id);
  EXPECT_THAT(asked_there.report->notices, Not(testing::Contains(HasSubstr("carried over"))));
}

TEST_F(People, AnEditOfAWallThatWasChangedIsRefusedAndNothingIsDone) {
  value(ann->edit("fill_hole", first_hole, {}, {}));
  const auto walls = beside(first_hole);
  ASSERT_FALSE(walls.empty());
  const auto refused = carry("erode", {walls.front()}, {{"depth", 1e-4}});

  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ec::conflict) << render(refused.error());
  EXPECT_THAT(refused.error().message,
              HasSubstr("surface " + std::to_string(walls.front()) + " that the edit names"));
  ASSERT_TRUE(refused.error().rival);
  EXPECT_EQ(refused.error().rival->client, "ann");
  EXPECT_EQ(value(bob->get_history()).versions.size(), 2U);
}

/// Where Ann's plug is: no surface is selected, the tets are other ones.
TEST_F(People, AnEditOfTetsThatWereChangedIsRefused) {
  const auto filled = value(ann->edit("fill_hole", first_hole, {}, {}));
  const auto part = plate();
  vec3 middle{};
  double corners = 0;
  for (facet_id f = 0; f < part->facet_slots(); ++f)
    if (std::ranges::count(first_hole, part->facet(f).surface))
      for (const auto v : part->facet(f).v) {
        middle = middle + part->position(v);
        ++corners;
      }
  middle = (1 / corners) * middle;
  const auto at =
    std::to_string(middle.x) + "," + std::to_string(middle.y) + "," + std::to_string(middle.z);
  const auto refused = carry("refine", {}, {{"at", at}, {"size", .002}, {"radius", .004}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ec::conflict) << render(refused.error());
  EXPECT_THAT(refused.error().message, HasSubstr("of the tets that the edit would change"));
}

TEST_F(People, WhoIsThereAndWhoDidWhatIsKnown) {
  ASSERT_EQ(bobs.participants.size(), 2U);
  EXPECT_EQ(bobs.participants.front().name, "ann");
  EXPECT_EQ(bobs.participants.back().id, bobs.own_participant);
  EXPECT_THAT(heard.wait_for(1), ElementsAre("+bob"));
  value(bob->edit("fill_hole", first_hole, {}, {}));
  bob.reset();
  EXPECT_THAT(heard.wait_for(2), ElementsAre("+bob", "-bob"));

  for (const bool again : {false, true}) {
    if (again) {  // It is in the document.
      ann.reset();
      server.reset();
      server = start(options);
      ann = connect_as("ann", {});
      value(ann->open("part", false, false));
    }
    const auto versions = value(ann->get_history()).versions;
    ASSERT_EQ(versions.size(), 2U);
    EXPECT_EQ(versions[0].made_by, "ann");
    EXPECT_EQ(versions[1].made_by, "bob");
    EXPECT_THAT(versions[1].made_at, MatchesRegex("20[0-9-]+T[0-9:]+Z"));
  }
}

}  // namespace
}  // namespace tedit::test
