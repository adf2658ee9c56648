// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/tracing/tracing.hpp"

#include <sys/stat.h>

#include <fstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/scratch.hpp"

namespace tedit::tracing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The example of the W3C's Trace Context, section 3.2.
constexpr auto example = "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01";

TEST(Traceparent, IsReadAsTheStandardHasIt) {
  const auto read = from_text(example);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->sampled);
  EXPECT_EQ(read->from.trace[0], 0x4b);
  EXPECT_EQ(read->from.trace[15], 0x36);
  EXPECT_EQ(read->from.span[0], 0x00);
  EXPECT_EQ(read->from.span[7], 0xb7);
  EXPECT_EQ(to_text(read->from), example);
  EXPECT_FALSE(from_text("00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-00")->sampled);
  EXPECT_TRUE(from_text("00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-03")->sampled);
  EXPECT_TRUE(from_text("cc-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01-more"));
}

TEST(Traceparent, WhatIsNoneIsNone) {
  for (const auto* text : {"", "00", "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7",
                           "00-4BF92F3577B34DA6A3CE929D0E0E4736-00f067aa0ba902b7-01",
                           "ff-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01",
                           "00-00000000000000000000000000000000-00f067aa0ba902b7-01",
                           "00-4bf92f3577b34da6a3ce929d0e0e4736-0000000000000000-01",
                           "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-0x",
                           "00-4bf92f3577b34da6a3ce929d0e0e4736_00f067aa0ba902b7-01",
                           "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01-more"})
    EXPECT_FALSE(from_text(text)) << text;
}

class Tracing : public ::testing::Test {
protected:
  ~Tracing() override { stop(); }

  void begin(std::uint64_t most_bytes = 1 << 20) {
    test::value(start(file_, "tedit", "1.2.3", most_bytes));
  }

  [[nodiscard]] static std::vector<nlohmann::json> lines_of(const std::filesystem::path& file) {
    std::vector<nlohmann::json> all;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
      all.push_back(nlohmann::json::parse(line));
    return all;
  }

  /// The only span of a line.
  [[nodiscard]] static nlohmann::json span_in(const nlohmann::json& line) {
    return line.at("resourceSpans").at(0).at("scopeSpans").at(0).at("spans").at(0);
  }

  const test::scratch_folder folder_;
  const std::filesystem::path file_ = folder_.path() / "spans.jsonl";
};

TEST_F(Tracing, ARequestIsAPartOfItsCallersTraceAndHasParts) {
  begin();
  auto request = begin_request("apply_edit", example);
  request.note("tedit.document", "part");
  request.note("tedit.request_id", std::int64_t{7});
  bind(1, request.here());
  auto part = begin_part("modeling work", of(1));
  part.fail("the worker died");
  part.end();
  part.end();  // Once is enough.
  unbind(1);
  EXPECT_FALSE(of(1).is_there());
  request.end();

  const auto lines = lines_of(file_);
  ASSERT_EQ(lines.size(), 2U);
  const auto inner = span_in(lines[0]);
  const auto outer = span_in(lines[1]);
  EXPECT_EQ(outer["traceId"], "4bf92f3577b34da6a3ce929d0e0e4736");
  EXPECT_EQ(outer["parentSpanId"], "00f067aa0ba902b7");
  EXPECT_EQ(outer["name"], "apply_edit");
  EXPECT_EQ(outer["kind"], 2) << "a server's";
  EXPECT_FALSE(outer.contains("status"));
  EXPECT_EQ(outer["attributes"][0]["key"], "tedit.document");
  EXPECT_EQ(outer["attributes"][0]["value"]["stringValue"], "part");
  EXPECT_EQ(outer["attributes"][1]["value"]["intValue"], "7");
  EXPECT_EQ(inner["traceId"], outer["traceId"]);
  EXPECT_EQ(inner["parentSpanId"], outer["spanId"]);
  EXPECT_EQ(inner["status"]["code"], 2) << "an error";
  EXPECT_EQ(inner["status"]["message"], "the worker died");
  const auto time = [](const nlohmann::json& span, const char* key) {
    return std::stoull(span[key].get<std::string>());
  };
  EXPECT_LE(time(outer, "startTimeUnixNano"), time(inner, "startTimeUnixNano"));
  EXPECT_LE(time(inner, "startTimeUnixNano"), time(inner, "endTimeUnixNano"));
  EXPECT_LE(time(inner, "endTimeUnixNano"), time(outer, "endTimeUnixNano"));
  const auto about = lines[0]["resourceSpans"][0]["resource"]["attributes"];
  EXPECT_EQ(about[0]["value"]["stringValue"], "tedit");
  EXPECT_EQ(about[1]["value"]["stringValue"], "1.2.3");
}

TEST_F(Tracing, WithoutACallerATraceOfItsOwnBegins) {
  begin();
  auto first = begin_request("solve", "");
  auto second = begin_request("solve", "no trace");
  EXPECT_NE(first.here().trace, second.here().trace);
  first.end();
  EXPECT_FALSE(span_in(lines_of(file_).at(0)).contains("parentSpanId"));
}

TEST_F(Tracing, WhatTheCallerDoesNotRecordIsNotRecorded) {
  begin();
  auto request = begin_request("solve", "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-00");
  auto part = begin_part("work", request.here());
  part.note("key", "value");
  part.end();
  request.end();
  EXPECT_THAT(lines_of(file_), IsEmpty());
}

TEST_F(Tracing, WithoutAFileNothingIsKept) {
  auto request = begin_request("solve", example);
  EXPECT_FALSE(request.here().is_there());
  bind(5, request.here());
  EXPECT_FALSE(of(5).is_there());
}

TEST_F(Tracing, TheFileIsItsUsersAloneAndIsTurnedOverWhenItIsFull) {
  begin(2000);
  for (int i = 0; i < 12; ++i)
    begin_request("request " + std::to_string(i), "").end();
  auto older = file_;
  older += ".1";
  const auto now = lines_of(file_);
  const auto before = lines_of(older);
  ASSERT_FALSE(now.empty());
  ASSERT_FALSE(before.empty());
  EXPECT_EQ(span_in(now.back())["name"], "request 11");
  EXPECT_LE(std::filesystem::file_size(file_), 2000U);
  EXPECT_LE(std::filesystem::file_size(older), 2000U);
  struct stat found {};
  ASSERT_EQ(stat(file_.c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0777U, 0600U);
}

TEST_F(Tracing, AFileThatCannotBeWrittenIsAnError) {
  const auto ok = start(folder_.path() / "not there" / "spans", "tedit", "1", 1 << 20);
  ASSERT_FALSE(ok);
  EXPECT_EQ(ok.error().code, ec::io_error);
  EXPECT_THAT(ok.error().message, HasSubstr("not there/spans for spans"));
  EXPECT_FALSE(is_on());
}

TEST_F(Tracing, TextsOfOthersCannotBreakALine) {
  begin();
  auto request = begin_request("open", "");
  request.note("tedit.document", "a\nb\xff\"c");
  request.end();
  const auto lines = lines_of(file_);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(span_in(lines[0])["attributes"][0]["value"]["stringValue"], "a\nb\uFFFD\"c");
}

}  // namespace
}  // namespace tedit::tracing
