// SPDX-License-Identifier: AGPL-3.0-or-later
// The spans that a server leaves of its clients' requests.
#include <fstream>
#include <map>

#include <nlohmann/json.hpp>

#include "base/tracing/tracing.hpp"
#include "protocol/convert.hpp"
#include "tests/scenarios/fixture.hpp"

namespace tedit::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::Not;

constexpr auto trace = "4bf92f3577b34da6a3ce929d0e0e4736";
constexpr auto part_of_it = "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01";

struct read_span {
  std::string id, parent, name, status;
  std::map<std::string, std::string> notes;
  std::uint64_t began = 0, ended = 0;
};

std::vector<read_span> spans_in(const std::filesystem::path& file) {
  std::vector<read_span> all;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const auto read =
      nlohmann::json::parse(line).at("resourceSpans")[0].at("scopeSpans")[0].at("spans")[0];
    if (read.at("traceId") != trace)
      continue;
    read_span span{read.at("spanId"), read.value("parentSpanId", ""), read.at("name"), {}, {}};
    span.began = std::stoull(read.at("startTimeUnixNano").get<std::string>());
    span.ended = std::stoull(read.at("endTimeUnixNano").get<std::string>());
    if (read.contains("status"))
      span.status = read["status"]["message"];
    for (const auto& note : read.at("attributes"))
      span.notes[note["key"]] = note["value"].begin()->is_string()
                                  ? note["value"].begin()->get<std::string>()
                                  : note["value"].dump();
    all.push_back(std::move(span));
  }
  return all;
}

class Traces : public ::testing::Test {
protected:
  Traces() { options_.traces = file_; }
  ~Traces() override { tracing::stop(); }

  std::unique_ptr<client::client> connect_traced() {
    client::connect_options line;
    line.url = host_->url();
    line.token = server_token;
    line.client_name = "traced";
    line.timeout = patience;
    line.traceparent = [this] { return parent_; };
    return value(client::client::connect(line, {}));
  }

  /// Once the server has ended: then all have.
  std::map<std::string, std::vector<read_span>> by_name() {
    host_.reset();
    std::map<std::string, std::vector<read_span>> result;
    for (auto& span : spans_in(file_))
      result[span.name].push_back(span);
    return result;
  }

  const scratch_folder folder_;
  const std::filesystem::path file_ = folder_.path() / "spans.jsonl";
  server_options options_ = options_for(folder_, true);
  std::unique_ptr<server> host_;
  std::string parent_ = part_of_it;
};

TEST_F(Traces, AnEditSaysWhereItsTimeWentAndItsSolveIsAPartOfIt) {
  host_ = start(options_);
  std::string edited;
  {
    auto user = connect_traced();
    value(user->open("part", false, true));
    value(user->import_file(plate_mesh, "mm", {}));
    value(user->set_load_case(value(protocol::load_case_from_file(plate_loads))));
    parent_.clear();
    value(user->solve({.device = "cpu"}, {}));
    parent_ = part_of_it;
    const auto made = value(user->edit("fill_hole", {1, 2}, {}, {}));
    edited = made.head.version_id;
    parent_.clear();
    value(user->wait_fields(edited, patience));
  }
  auto spans = by_name();
  ASSERT_EQ(spans["apply_edit"].size(), 1U);
  const auto edit = spans["apply_edit"].front();
  EXPECT_EQ(edit.parent, "00f067aa0ba902b7");
  EXPECT_EQ(edit.notes.at("tedit.document"), "part");
  EXPECT_EQ(edit.notes.at("tedit.version"), edited);
  EXPECT_EQ(edit.status, "");
  for (const auto* name : {"modeling wait", "modeling work", "optimizer work", "commit"}) {
    const auto of_edit = std::ranges::count(spans[name], edit.id, &read_span::parent);
    ASSERT_EQ(of_edit, 1) << name;
    const auto part = *std::ranges::find(spans[name], edit.id, &read_span::parent);
    EXPECT_LE(edit.began, part.began) << name;
    EXPECT_LE(part.ended, edit.ended) << name;
  }
  const auto work = *std::ranges::find(spans["modeling work"], edit.id, &read_span::parent);
  EXPECT_EQ(work.notes.at("tedit.operation"), "fill_hole");
  EXPECT_THAT(work.notes, Contains(Key("tedit.worker")));
  const auto solve = std::ranges::find(spans["solver work"], edit.id, &read_span::parent);
  ASSERT_NE(solve, spans["solver work"].end()) << "the solve that follows by itself";
  EXPECT_LE(edit.ended, solve->ended);
  EXPECT_THAT(spans, Not(Contains(Key("solve")))) << "that one had no caller";
}

TEST_F(Traces, WhatIsRefusedSaysWhy) {
  host_ = start(options_);
  {
    auto user = connect_traced();
    value(user->open("part", false, false));
    value(user->import_file(plate_mesh, "mm", {}));
    EXPECT_FALSE(user->edit("fill_hole", {123456}, {}, {}));
  }
  auto spans = by_name();
  ASSERT_EQ(spans["apply_edit"].size(), 1U);
  EXPECT_EQ(spans["apply_edit"].front().status, "surface_not_found");
}

TEST_F(Traces, WithoutAFileNoneAreKept) {
  options_.traces.clear();
  host_ = start(options_);
  {
    auto user = connect_traced();
    value(user->open("part", false, false));
  }
  host_.reset();
  EXPECT_FALSE(std::filesystem::exists(file_));
}

}  // namespace
}  // namespace tedit::test
