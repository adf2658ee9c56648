// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/worker_roles.hpp"

#include <gtest/gtest.h>

namespace tedit::actors {
namespace {

TEST(WorkerRoles, AreFoundByTheirNames) {
  EXPECT_EQ(role_named("modeling"), worker_role::modeling);
  EXPECT_EQ(role_named("optimizer"), worker_role::optimizer);
  EXPECT_EQ(role_named("solver"), worker_role::solver);
  EXPECT_EQ(role_named("Solver"), std::nullopt);
  EXPECT_EQ(role_named(""), std::nullopt);
  for (const auto& row : worker_roles)
    EXPECT_EQ(name_of(*role_named(row.name)), row.name);
}

TEST(WorkerRoles, OnlyModelingRunsPlugins) {
  EXPECT_TRUE(facts_of(worker_role::modeling).runs_plugins);
  EXPECT_FALSE(facts_of(worker_role::optimizer).runs_plugins);
  EXPECT_FALSE(facts_of(worker_role::solver).runs_plugins);
}

}  // namespace
}  // namespace tedit::actors
