// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/csv_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tedit::client {
namespace {

using ::testing::HasSubstr;
using texts = std::vector<std::string>;

csv_table table_of(const std::string& text) {
  const auto table = csv_from_text(text);
  EXPECT_TRUE(table) << text << (table ? "" : render(table.error()));
  return table ? *table : csv_table{};
}

std::string table_refusal(const std::string& text) {
  const auto table = csv_from_text(text);
  EXPECT_FALSE(table) << text;
  if (table)
    return {};
  EXPECT_EQ(table.error().code, ec::bad_input);
  EXPECT_FALSE(table.error().remedy.empty()) << table.error().message;
  return render(table.error());
}

TEST(CsvTable, ColumnsAndRowsWithTheirLines) {
  const csv_table wanted{{"a", "b"}, {{2, {"1", "2"}}, {3, {"", " x "}}}};
  EXPECT_EQ(table_of("a,b\n1,2\n, x \n"), wanted);
  EXPECT_EQ(table_of("a,b\n1,2\n, x "), wanted);
  EXPECT_EQ(table_of("a,b\r\n1,2\r\n, x \r\n"), wanted);
  EXPECT_EQ(table_of("\xEF\xBB\xBF a , b\n1,2\n, x "), wanted);
}

TEST(CsvTable, QuotesHoldSeparatorsQuotesAndLineEnds) {
  const auto table = table_of("name,\"the, text\"\n\"a \"\"b\"\"\",\"two\r\nlines\"\n\nc,\"\"\n");
  EXPECT_EQ(table.columns, (texts{"name", "the, text"}));
  EXPECT_EQ(table.rows[0], (csv_row{2, {"a \"b\"", "two\r\nlines"}}));
  EXPECT_EQ(table.rows[1], (csv_row{5, {"c", ""}}));
}

TEST(CsvTable, ASemicolonSeparatesWhereTheHeaderHasNoComma) {
  EXPECT_EQ(table_of("a;b\n1,5;2\n").rows[0].cells, (texts{"1,5", "2"}));
  EXPECT_EQ(table_of("a;b,c\n1;2,3\n").rows[0].cells, (texts{"1;2", "3"}));
  EXPECT_EQ(table_of("\"a,b\";c\n1;2\n").columns, (texts{"a,b", "c"}));
}

TEST(CsvTable, WhatIsNoTableIsRefusedWithItsLine) {
  EXPECT_THAT(table_refusal(""), HasSubstr("no rows"));
  EXPECT_THAT(table_refusal("a,b\n"), HasSubstr("no rows"));
  EXPECT_THAT(table_refusal("a,b\n1,2\n3\n"), HasSubstr("line 3 of the table has 1 cells"));
  EXPECT_THAT(table_refusal("a,b\n1,2,3\n"), HasSubstr("line 2 of the table has 3 cells"));
  EXPECT_THAT(table_refusal("a,a\n1,2\n"), HasSubstr("two columns \"a\""));
  EXPECT_THAT(table_refusal("a,\n1,2\n"), HasSubstr("column without a name"));
  EXPECT_THAT(table_refusal("a\n\"1\n2\n"),
              HasSubstr("line 2 of the table has a quote that is not"));
  EXPECT_THAT(table_refusal("a\n1\"\n"), HasSubstr("a quote inside a cell"));
  EXPECT_THAT(table_refusal("a\n\"1\"x\n"), HasSubstr("goes on after the closing quote"));
  EXPECT_THAT(table_refusal("a\n\xFF\n"), HasSubstr("UTF-8"));
  EXPECT_THAT(table_refusal(std::string("a\n\0\n", 4)), HasSubstr("UTF-8"));
}

TEST(CsvTable, LimitsAreSaid) {
  EXPECT_THAT(table_refusal("a\n" + std::string(4097, 'x')), HasSubstr("more than 4096 bytes"));
  EXPECT_EQ(table_of("a\n" + std::string(4096, 'x')).rows.size(), 1U);
  EXPECT_THAT(table_refusal("a" + std::string(200, ',') + "\n"), HasSubstr("more than 200 cells"));
  std::string many = "a\n";
  for (int i = 0; i < 10'000; ++i)
    many += "1\n";
  EXPECT_EQ(table_of(many).rows.size(), most_table_rows);
  EXPECT_THAT(table_refusal(many + "1\n"), HasSubstr("more than 10000 rows"));
  EXPECT_THAT(table_refusal(std::string(most_table_bytes + 1, 'a')), HasSubstr("16 MiB"));
}

RC_GTEST_PROP(CsvTable, WhatIsWrittenInQuotesIsReadAgain, ()) {
  const auto text = rc::gen::container<std::string>(rc::gen::element('a', '"', ',', '\n', '\r'));
  const auto cells = *rc::gen::nonEmpty(rc::gen::container<texts>(text));
  std::string file;
  std::string header;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::string quoted;
    for (const char c : cells[i])
      quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    header += (i == 0 ? "c" : ",c") + std::to_string(i);
    file += (i == 0 ? "\"" : ",\"") + quoted + "\"";
  }
  RC_PRE(cells.size() > 1 || !cells.front().empty());
  RC_ASSERT(csv_from_text(header + ",end\n" + file + ",x\n")->rows.front().cells.front() ==
            cells.front());
  RC_ASSERT(csv_from_text(header + "\n" + file)->rows.front().cells == cells);
}

}  // namespace
}  // namespace tedit::client
