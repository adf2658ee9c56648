// SPDX-License-Identifier: AGPL-3.0-or-later
// A server of an older release: what it does not know is refused before it is sent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/gateway/transport.hpp"
#include "client/client.hpp"
#include "tedit/v1/envelope.pb.h"

namespace tedit::client {
namespace {

using ::testing::HasSubstr;

/// Introduces itself and opens documents; the rest is answered with `internal`.
class old_server final : public gateway::connection_handler {
public:
  old_server(std::shared_ptr<gateway::connection> to, std::uint32_t minor)
      : to_(std::move(to)), minor_(minor) {}

  void on_message(std::string bytes) override {
    v1::ClientMessage request;
    ASSERT_TRUE(request.ParseFromString(bytes));
    v1::ServerMessage answer;
    answer.set_request_id(request.request_id());
    if (request.has_hello()) {
      to_->authenticated();
      answer.mutable_welcome()->set_protocol_major(1);
      answer.mutable_welcome()->set_protocol_minor(minor_);
    } else if (request.has_open_document()) {
      auto* state = answer.mutable_document_state();
      state->set_document("part");
      // A kind of load that this client does not know reaches it as none.
      if (request.open_document().name() == "newer") {
        state->add_load_cases()->set_name("usual");
        state->add_load_cases()->set_name("of tomorrow");
        state->mutable_load_cases(1)->add_loads()->add_surfaces(3);
      }
    } else {
      answer.mutable_error()->set_code("internal");
    }
    to_->send(std::make_shared<const std::string>(answer.SerializeAsString()));
  }
  void on_drained() override {}
  void on_closed(const std::string&) override {}

private:
  std::shared_ptr<gateway::connection> to_;
  std::uint32_t minor_;
};

std::unique_ptr<gateway::transport> serve(std::uint32_t minor) {
  gateway::transport_options options;
  options.accept = [=](std::shared_ptr<gateway::connection> to) {
    return std::make_unique<old_server>(std::move(to), minor);
  };
  return std::move(*gateway::transport::start(std::move(options)));
}

/// How each request ends with a server of this protocol_minor, by the minor that knows it.
std::multimap<std::uint32_t, error> ends_with(std::uint32_t minor) {
  const auto door = serve(minor);
  connect_options line;
  line.url = "ws://127.0.0.1:" + std::to_string(door->port()) + "/v1";
  const auto made = client::connect(line, {});
  auto& user = **made;
  EXPECT_TRUE(user.open("part", false, false).has_value());
  std::multimap<std::uint32_t, error> result;
  result.emplace(0, user.undo().error());
  result.emplace(2, user.select({}, {}).error());
  result.emplace(3, user.edit("close", {1}, {}, {}, {}, {fem::load_policy::move}).error());
  result.emplace(4, user.go_to(0).error());
  result.emplace(4, user.cut({}, {1, 0, 0}, {}, {}).error());
  result.emplace(7, user.undo({"v", {}}).error());
  result.emplace(7, user.redo({"v", {}}).error());
  result.emplace(7, user.go_to(0, {"v", {}}).error());
  result.emplace(7, user.set_load_case({}, {"v", {}}).error());
  result.emplace(7, user.remove_load_case("bend", {"v", {}}).error());
  result.emplace(0, user.set_load_case({}).error());
  for (const fem::load& newer :
       {fem::load{{1}, fem::normal_force{1}}, fem::load{{1}, fem::moment{}},
        fem::load{{1}, fem::remote_force{}}, fem::load{{1}, fem::bearing_force{}},
        fem::load{{1}, fem::pressure{1, {0, 0, 1}}}})
    result.emplace(8, user.set_load_case({"n", {}, {}, {newer}}).error());
  result.emplace(0, user.undo({{}, "id"}).error());
  result.emplace(5, user.preview_edit("close", {1}, {}, {}).error());
  result.emplace(8, user.preview_edit("close", {1}, {}, {}, {}, {}, true).error());
  result.emplace(5, user.remove_load_case("bend").error());
  result.emplace(8, user.surface_of(0).error());
  result.emplace(
    9, user.add_document(TEDIT_EXAMPLES "/ctc01_plate/load_case.json", "x", true, {}).error());
  result.emplace(9, user.export_file(file_format::document, {}, {}, {}).error());
  result.emplace(9, user.rename_document("wing").error());
  result.emplace(5, user.annotate(0, "first", {}).error());
  result.emplace(5, user.watch_fields({}).error());
  return result;
}

class OldServer : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(OldServer, IsNotAskedForWhatItDoesNotKnow) {
  for (const auto& [since, e] : ends_with(GetParam())) {
    EXPECT_EQ(e.code, since > GetParam() ? ec::protocol_error : ec::internal) << since;
    if (since > GetParam()) {
      EXPECT_THAT(e.message, HasSubstr("the server is too old"));
      EXPECT_FALSE(e.remedy.empty());
    }
  }
}

TEST(NewerServer, LoadCasesThatCannotBeReadAreNamedAndNotPassedOver) {
  const auto door = serve(9);
  connect_options line;
  line.url = "ws://127.0.0.1:" + std::to_string(door->port()) + "/v1";
  const auto user = client::connect(line, {});
  ASSERT_TRUE(user.has_value()) << render(user.error());

  const auto state = (*user)->open("newer", false, false);

  ASSERT_TRUE(state.has_value()) << render(state.error());
  ASSERT_EQ(state->load_cases.size(), 1u);
  EXPECT_EQ(state->load_cases[0].name, "usual");
  ASSERT_EQ(state->warnings.size(), 1u);
  EXPECT_THAT(state->warnings[0], HasSubstr("\"of tomorrow\" cannot be read and is not shown: load "
                                            "0 says no kind"));
}

INSTANTIATE_TEST_SUITE_P(Client, OldServer, ::testing::Range(0U, 10U));

}  // namespace
}  // namespace tedit::client
