// SPDX-License-Identifier: AGPL-3.0-or-later
// What a monitoring system sees of a server.
#include <map>
#include <set>
#include <sstream>

#include "actors/gateway/gateway.hpp"
#include "tests/scenarios/http.hpp"
#include "tests/scenarios/served.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

/// The values by name with labels, and the names.
struct seen_metrics {
  explicit seen_metrics(const std::string& answer) {
    std::istringstream in(answer.substr(answer.find("\r\n\r\n") + 4));
    for (std::string line; std::getline(in, line);) {
      const auto end = line.rfind(' ');
      if (line.starts_with("# TYPE "))
        names.insert(line.substr(7, line.find(' ', 7) - 7));
      else if (!line.starts_with("#"))
        values[line.substr(0, end)] = std::stod(line.substr(end + 1));
    }
  }
  std::set<std::string> names;
  std::map<std::string, double> values;
};

TEST(Metrics, SayWhatAServerHasDone) {
  const scratch_folder folder;
  served host(folder);
  const auto user = host.connect();
  const auto port = port_of(host.url());
  value(user->open("plate", true, true));
  value(user->import_file(plate_mesh, "mm", {}));
  value(user->set_load_case(value(protocol::load_case_from_file(plate_loads))));
  value(user->edit("fill_hole", {1, 2}, {}, {}));
  value(user->solve({.device = "cpu"}, {}));
  value(user->undo());
  EXPECT_FALSE(user->edit("no_such_operation", {1}, {}, {}).has_value());

  const auto answer = get(port, "/metrics");
  EXPECT_THAT(answer, HasSubstr("200 OK"));
  EXPECT_THAT(answer, HasSubstr("text/plain; version=0.0.4"));
  const seen_metrics seen(answer);
  EXPECT_GE(seen.names.size(), 40U);
  const auto of = [&](const std::string& name) {
    const auto found = seen.values.find(name);
    EXPECT_NE(found, seen.values.end()) << name;
    return found == seen.values.end() ? -1 : found->second;
  };
  EXPECT_EQ(of("tedit_connections"), 1);
  EXPECT_EQ(of("tedit_documents_open"), 1);
  EXPECT_EQ(of("tedit_subscriptions"), 1);
  EXPECT_EQ(of("tedit_requests_running"), 0);
  EXPECT_EQ(of("tedit_heads_moved_total{kind=\"import\"}"), 1);
  EXPECT_EQ(of("tedit_heads_moved_total{kind=\"edit\"}"), 1);
  EXPECT_EQ(of("tedit_heads_moved_total{kind=\"undo\"}"), 1);
  EXPECT_EQ(of("tedit_request_seconds_count{kind=\"apply_edit\"}"), 2);
  EXPECT_EQ(of("tedit_requests_refused_total{code=\"operation_not_found\"}"), 1);
  EXPECT_GE(of("tedit_solves_total"), 1);
  EXPECT_GE(of("tedit_job_seconds_count{role=\"solver\"}"), 1);
  EXPECT_EQ(of("tedit_workers{role=\"modeling\"}"), 1);
  EXPECT_EQ(of("tedit_role_ready{role=\"solver\"}"), 1);
  EXPECT_GE(of("tedit_commit_seconds_count"), 4);
  EXPECT_GT(of("tedit_kept_bytes{what=\"pages\"}"), 1e6);
  EXPECT_GT(of("tedit_received_bytes_total"), 1e6);
  EXPECT_GT(of("tedit_sent_bytes_total"), 1e5);
  EXPECT_GT(of("process_resident_memory_bytes"), 1e7);
  EXPECT_THAT(get(port, "/readyz"), HasSubstr("200 OK"));
}

TEST(Metrics, AServerIsReadyOnceAllItsWorkersAre) {
  const scratch_folder folder;
  auto options = options_for(folder, true);
  options.solver_workers = 0;
  const auto host = start(options);
  const auto port = host->port();

  EXPECT_THAT(get(port, "/readyz"), HasSubstr("503 "));
  const auto deadline = std::chrono::steady_clock::now() + patience;
  auto said = get(port, "/readyz");
  while (said.find("degraded") == said.npos && std::chrono::steady_clock::now() < deadline)
    said = get(port, "/readyz");
  EXPECT_THAT(said, HasSubstr("503 "));
  EXPECT_THAT(said, HasSubstr("\"solver\":\"degraded\""));
}

TEST(Metrics, OfOtherMachinesOnlyWhoKnowsTheTokenSeesThem) {
  gateway::gateway_parts parts;
  parts.guard = std::make_shared<gateway::token_guard>("secret");
  parts.connections = [] { return std::size_t{3}; };

  EXPECT_EQ(gateway::metrics_for({false, ""}, parts).status, 401U);
  EXPECT_EQ(gateway::metrics_for({false, "Secret"}, parts).status, 401U);
  EXPECT_THAT(gateway::metrics_for({false, ""}, parts).body, HasSubstr("Authorization: Bearer"));
  EXPECT_EQ(gateway::metrics_for({false, "secret"}, parts).status, 200U);
  EXPECT_THAT(gateway::metrics_for({true, ""}, parts).body, HasSubstr("tedit_connections 3\n"));
}

}  // namespace
}  // namespace tedit::test
