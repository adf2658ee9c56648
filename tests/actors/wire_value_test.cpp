// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/wire_value.hpp"

#include <gtest/gtest.h>
#include <caf/actor_system.hpp>
#include <caf/binary_deserializer.hpp>
#include <caf/binary_serializer.hpp>

#include "actors/messages.hpp"
#include "actors/node/system_config.hpp"

namespace tedit::actors {
namespace {

class WireValue : public ::testing::Test {
protected:
  system_config config{false};
  caf::actor_system system{config};

  template <class T>
  std::vector<char> sent(T message) {
    std::vector<char> bytes;
    caf::binary_serializer out{system, bytes};
    EXPECT_FALSE(out(message));
    return bytes;
  }

  template <class T>
  T received(const std::vector<char>& bytes) {
    T result;
    caf::binary_deserializer in{system, bytes};
    EXPECT_FALSE(in(result));
    return result;
  }
};

TEST_F(WireValue, StaysTheSameObjectInsideAndIsEqualOutside) {
  fem::load_case loads{"pull", {}, {{{1}, fem::fixed{}}}, {{{2}, fem::force{{0, 0, -1000}}}}};
  const auto list = std::make_shared<const load_case_list>(load_case_list{loads});
  const wire_value value(list);

  EXPECT_EQ(*value.get(), list);
  const auto there = received<wire_value<load_case_list>>(sent(value));
  ASSERT_TRUE(there.get().has_value());
  EXPECT_NE(*there.get(), list);
  EXPECT_EQ(**there.get(), *list);
}

TEST_F(WireValue, WhatCannotBeReadIsAnErrorAndNotTheEndOfTheMessage) {
  const auto rubbish = received<wire_value<edit_report>>(sent(std::string("\xff\xff\xff rubbish")));
  ASSERT_FALSE(rubbish.get().has_value());
  EXPECT_EQ(rubbish.get().error().code, ec::protocol_error);
  EXPECT_EQ(wire_value<edit_report>().get().error().code, ec::protocol_error);
}

TEST_F(WireValue, AManifestThatIsNotThatOfItsIdArrivesAsNone) {
  const auto mesh = mesh_version::create({});
  auto ref = version_ref{mesh->id(), {mesh, &mesh->pages()}};
  EXPECT_NE(received<version_ref>(sent(ref)).pages, nullptr);
  ref.id.low ^= 1;
  EXPECT_EQ(received<version_ref>(sent(ref)).pages, nullptr);
}

TEST_F(WireValue, WhatAnOperationSaysComesBackFromItsBytes) {
  operation_result before;
  before.version = {mesh_version::create({})->id(), nullptr};
  before.said.touched = {1, 2, 4'000'000'000};
  before.said.volume_change = -1e-9;
  before.said.improve = improvement::thorough;
  before.said.thorough.rounds = 7;
  before.said.surfaces_used = {-3, 1'000'000'000'000};
  before.said.notices = {"careful"};
  before.said.figures = {{"depth_mm", 0.5, "mm", "taken off"}};
  before.said.bodies_added = 2;

  const auto after = received<operation_result>(sent(before)).said;

  EXPECT_EQ(after.touched, before.said.touched);
  EXPECT_EQ(after.volume_change, before.said.volume_change);
  EXPECT_EQ(after.improve, before.said.improve);
  EXPECT_EQ(after.thorough.rounds, 7);
  EXPECT_EQ(after.surfaces_used, before.said.surfaces_used);
  EXPECT_EQ(after.notices, before.said.notices);
  EXPECT_EQ(after.figures, before.said.figures);
  EXPECT_EQ(after.bodies_added, 2u);
}

}  // namespace
}  // namespace tedit::actors
