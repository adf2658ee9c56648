// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/fuzz/promise.hpp"
#include "tests/states/client_fixture.hpp"

namespace {

using namespace tedit;

/// One connection with its actor, in virtual time; the hub and the document are made up, and answer
/// when the input says so.
class connection_under_fire final : public gateway::Client {
public:
  /// @param known who connects has said hello with the right token.
  explicit connection_under_fire(bool known) {
    if (known)
      hello();
    given_ = line_->dealt_with;
  }
  void TestBody() override {}

  /// What happens next, as the input says.
  void step(fuzz::input& in) {
    switch (in.number(1) % 8) {
      case 0:
        return answer_opening(first_);
      case 1:
        return answer_work();
      case 2:
        return tell(moved_to(second_));
      case 3:
        line_->queued = line_->queued > 0 ? 0 : more_than_is_sent_ahead;
        return line_->queued > 0 ? void() : drain();
      case 4:
        return pass(std::chrono::milliseconds(in.number(2)));
      default:
        return message(in.take(in.number(2)));
    }
  }

  /// After what has happened: nobody is told anything before hello, and what is read ahead of the
  /// actor is bounded, because each message is accounted for.
  void check() {
    pass(simulation::milliseconds(10));
    if (line_->welcomed == 0)
      for (const auto& one : line_->messages)
        fuzz::require(one.has_error(), "strangers are told errors alone");
    for (const auto& one : line_->messages)
      if (one.has_error())
        fuzz::require(!one.error().message().empty() && !one.error().code().empty(),
                      "a refusal says why");
    fuzz::require(line_->closed_with != 0 || line_->dealt_with == given_,
                  "each message is accounted for");
  }

private:
  void message(std::span<const std::uint8_t> bytes) {
    if (line_->closed_with != 0)
      return;  // The transport delivers nothing after that.
    given_ += bytes.size();
    caf::anon_send(client_, std::string(bytes.begin(), bytes.end()));
    pass(simulation::milliseconds(1));
  }

  void answer_opening(const version_ptr& mesh) {
    within_server([&] {
      auto& asked = server().openings;
      while (!asked.empty()) {
        auto one = take(asked);
        one.promise.deliver(actors::opened_document{one.wanted, server_});
      }
    });
    within_server([&] {
      auto& asked = server().attachments;
      while (!asked.empty()) {
        actors::session_snapshot snapshot;
        snapshot.document = "part";
        snapshot.version = mesh;
        take(asked).promise.deliver(snapshot);
      }
    });
  }

  void answer_work() {
    within_server([&] {
      auto& s = server();
      while (!s.imports.empty())
        take(s.imports).promise.deliver(moved_to(first_));
      while (!s.edits.empty())
        take(s.edits).promise.deliver(moved_to(third_));
      while (!s.versions.empty())
        take(s.versions)
          .promise.deliver(actors::to_caf({ec::not_found, "there is no such version", {}, {}}));
    });
  }

  std::size_t given_ = 0;  ///< Bytes of messages.
};

}  // namespace

/// The first byte says whether hello was said; the rest is what happens on the connection: messages
/// of the client (two bytes of length before them), answers of the server, time.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in({data, size});
  connection_under_fire line(in.number(1) % 2 == 1);
  for (int i = 0; i < 64 && !in.at_end(); ++i)
    line.step(in);
  line.check();
  return 0;
}
