// SPDX-License-Identifier: AGPL-3.0-or-later
// Headers and payloads as a peer could write them, byte by byte.
#include "actors/links/basp_guard.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <caf/atom.hpp>

namespace tedit::actors {
namespace {

using bytes = std::vector<std::byte>;

/// A header of BASP: operation, two bytes of padding, flags, payload length (big endian), and three
/// numbers of eight bytes.
bytes header(unsigned operation, std::uint32_t payload) {
  bytes result(basp_guard::header_bytes);
  result[0] = std::byte(operation);
  for (unsigned i = 0; i < 4; ++i)
    result[4 + i] = std::byte(payload >> (24 - 8 * i));
  return result;
}

/// The payload of a direct message: no forwarders, no type number, the types' names, content.
bytes message(const std::string& types, std::size_t content = 8, unsigned forwarders = 0) {
  bytes result{std::byte(forwarders), std::byte(0), std::byte(0), std::byte(types.size())};
  for (const char c : types)
    result.push_back(std::byte(c));
  result.resize(result.size() + content);
  return result;
}

/// A guard whose peer has greeted already.
basp_guard greeted() {
  basp_guard guard;
  EXPECT_TRUE(guard.admits(header(1, 10)));
  EXPECT_TRUE(guard.admits(bytes(10)));
  return guard;
}

bool admits_message(const bytes& payload) {
  auto guard = greeted();
  return guard.admits(header(2, static_cast<std::uint32_t>(payload.size()))) &&
         guard.admits(payload);
}

TEST(BaspGuard, ASizeThatNeedsMoreThan32BitsIsRefused) {
  bytes payload(3);
  payload.resize(8, std::byte(0x80));  // Five bytes, each of which says that another follows.
  payload.resize(16);
  EXPECT_FALSE(admits_message(payload));
}

TEST(BaspGuard, AConversationPasses) {
  auto guard = greeted();
  for (int round = 0; round < 3; ++round) {
    EXPECT_TRUE(guard.admits(header(6, 0)));
    const auto text = message("@<>+job_id+edit_order");
    EXPECT_TRUE(guard.admits(header(2, static_cast<std::uint32_t>(text.size()))));
    EXPECT_TRUE(guard.admits(text));
    EXPECT_TRUE(guard.admits(header(4, 16)));
    EXPECT_TRUE(guard.admits(bytes(16)));
    EXPECT_TRUE(guard.admits(header(5, 20)));
    EXPECT_TRUE(guard.admits(bytes(20)));
  }
}

TEST(BaspGuard, AHandshakeWithoutPayloadIsTheNullPointerOfCaf) {
  // 01 and 31 zeros.
  EXPECT_FALSE(basp_guard().admits(header(1, 0)));
  EXPECT_FALSE(basp_guard().admits(header(0, 0)));
}

TEST(BaspGuard, TheHandshakeComesFirstOnceOrTwice) {
  for (unsigned operation = 2; operation <= 6; ++operation)
    EXPECT_FALSE(basp_guard().admits(header(operation, operation == 6 ? 0 : 8))) << operation;
  auto guard = greeted();
  EXPECT_TRUE(guard.admits(header(1, 10)));
  EXPECT_TRUE(guard.admits(bytes(10)));
  EXPECT_FALSE(guard.admits(header(1, 10)));
  auto talking = greeted();
  EXPECT_TRUE(talking.admits(header(6, 0)));
  EXPECT_FALSE(talking.admits(header(0, 10)));
}

TEST(BaspGuard, OperationsThatNoNodeOfOursSendsAreRefused) {
  EXPECT_FALSE(greeted().admits(header(3, 8)));  // Routed over a third node.
  for (unsigned operation = 7; operation < 256; ++operation)
    EXPECT_FALSE(greeted().admits(header(operation, 8))) << operation;
}

TEST(BaspGuard, SizesAreBounded) {
  EXPECT_TRUE(greeted().admits(header(2, basp_guard::most_payload)));
  EXPECT_FALSE(greeted().admits(header(2, basp_guard::most_payload + 1)));
  EXPECT_FALSE(greeted().admits(header(2, 0xffffffffU)));
  EXPECT_FALSE(greeted().admits(header(2, 0)));
  EXPECT_FALSE(greeted().admits(header(6, 1)));
  EXPECT_FALSE(basp_guard().admits(bytes(31)));
  EXPECT_FALSE(basp_guard().admits(bytes(33)));
}

/// Whether a message of these types for an actor of this number passes where only 300 is within
/// reach.
bool reaches(std::uint64_t actor, const std::string& types, unsigned flags = 0) {
  basp_guard guard([](std::uint64_t one) { return one == 300; });
  EXPECT_TRUE(guard.admits(header(1, 10)));
  EXPECT_TRUE(guard.admits(bytes(10)));
  const auto text = message(types);
  auto piece = header(2, static_cast<std::uint32_t>(text.size()));
  piece[3] = std::byte(flags);
  for (unsigned i = 0; i < 8; ++i)
    piece[24 + i] = std::byte(actor >> (56 - 8 * i));
  return guard.admits(piece) && guard.admits(text);
}

TEST(BaspGuard, MessagesGoToActorsWithinReachAlone) {
  EXPECT_TRUE(reaches(300, "@<>+job_progress"));
  EXPECT_FALSE(reaches(300, "@<>+@exit"));
  EXPECT_FALSE(reaches(301, "@<>+job_progress"));
  EXPECT_FALSE(reaches(300 + (std::uint64_t{1} << 56), "@<>+job_progress"));
  EXPECT_FALSE(reaches(300, "@<>+job_progress", 1)) << "a number is no name";
}

TEST(BaspGuard, BrokersAskEachOtherWhatTheyAreAndNothingElse) {
  const auto spawn_server = static_cast<std::uint64_t>(caf::atom("SpawnServ"));
  const std::string question = "@<>+@atom+@atom+@str";
  const std::string answer = "@<>+@atom+@str+@strong_actor_ptr+@str";
  EXPECT_TRUE(reaches(spawn_server, question, 1));
  EXPECT_FALSE(reaches(spawn_server, question, 0));
  EXPECT_FALSE(reaches(spawn_server, "@<>+@atom+@str+@message+@strset", 1)) << "to start actors";
  EXPECT_FALSE(reaches(static_cast<std::uint64_t>(caf::atom("ConfigServ")), question, 1));
  EXPECT_TRUE(reaches(7, answer)) << "to a helper of the broker that asked";
  EXPECT_FALSE(reaches(7, answer + "+@str"));
}

TEST(BaspGuard, MessagesThatEndActorsAreRefused) {
  EXPECT_TRUE(admits_message(message("@<>+@str")));
  EXPECT_FALSE(admits_message(message("@<>+@exit")));
  EXPECT_FALSE(admits_message(message("@<>+@i32+@exit")));
}

TEST(BaspGuard, MessagesThatCannotBeReadAreRefused) {
  EXPECT_FALSE(admits_message(message("@<>+@str", 8, 1)));  // Forwarded by somebody.
  EXPECT_FALSE(admits_message(bytes(1)));
  auto numbered = message("@<>+@str");
  numbered[2] = std::byte(14);  // A type by its number, which no message of ours begins with.
  EXPECT_FALSE(admits_message(numbered));
  auto longer_than_itself = message("@<>+@str", 0);
  longer_than_itself[3] = std::byte(0x7f);
  EXPECT_FALSE(admits_message(longer_than_itself));
  EXPECT_FALSE(admits_message(bytes(12, std::byte(0xff))));  // A size that never ends.
}

TEST(BaspGuard, APayloadOfAnotherSizeIsRefused) {
  auto guard = greeted();
  EXPECT_TRUE(guard.admits(header(4, 16)));
  EXPECT_FALSE(guard.admits(bytes(15)));
}

}  // namespace
}  // namespace tedit::actors
