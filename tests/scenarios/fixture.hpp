// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/node/server.hpp"
#include "client/client.hpp"
#include "protocol/convert.hpp"
#include "sandbox/sandbox.hpp"
#include "tests/support/raw_client.hpp"
#include "tests/support/scratch.hpp"

namespace tedit::test {

inline const std::filesystem::path plate_mesh =
  TEDIT_EXAMPLES "/ctc01_plate/ctc01_plate.coarse.msh";
inline const std::filesystem::path plate_loads = TEDIT_EXAMPLES "/ctc01_plate/load_case.json";
#ifdef __SANITIZE_THREAD__
// Solves there take many times longer, on busy cores over a minute.
inline constexpr auto patience = std::chrono::seconds(300);
#else
inline constexpr auto patience = std::chrono::seconds(60);
#endif

/// Facets, their positions and the rows of surfaces agree to the last bit.
inline void expect_same(const client::surface_model& a, const client::surface_model& b) {
  EXPECT_EQ(a.version_id(), b.version_id());
  EXPECT_EQ(a.total_facets(), b.total_facets());
  b.facets().for_each([&](std::uint32_t slot, const client::surface_facet& facet) {
    const auto* mine = a.facets().find(slot);
    ASSERT_TRUE(mine && *mine == facet) << slot;
    for (const auto v : facet.v)
      ASSERT_EQ(*a.positions().find(v), *b.positions().find(v)) << v;
  });
  ASSERT_EQ(a.surfaces().size(), b.surfaces().size());
  for (const auto& [id, row] : b.surfaces())
    EXPECT_EQ(a.surfaces().at(id).area_m2, row.area_m2) << id;
}

/// A server on a free port, with workers as processes of the built program or as threads.
inline server_options options_for(const scratch_folder& folder, bool processes) {
  server_options options;
  options.documents = folder.path();
  options.token = test::server_token;
  options.device = "cpu";
  options.worker_processes = processes;
  options.program = TEDIT_BIN "/tedit";
  options.sandbox = sandbox::is_wanted();
  return options;
}

inline std::unique_ptr<server> start(const server_options& options) {
  return value(server::start(options));
}

inline std::unique_ptr<client::client> connect(const std::string& url,
                                               client::events handlers = {}) {
  client::connect_options options;
  options.url = url;
  options.token = test::server_token;
  options.client_name = "test";
  options.timeout = patience;
  return value(client::client::connect(options, std::move(handlers)));
}

}  // namespace tedit::test
