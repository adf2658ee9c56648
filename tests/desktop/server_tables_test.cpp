// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/server_tables.hpp"

#include <gtest/gtest.h>

#include <QLocale>

#include <cmath>
#include <limits>

namespace tedit::desktop {
namespace {

class ServerTables : public testing::Test {
protected:
  ServerTables() { QLocale::setDefault(QLocale::C); }
  ~ServerTables() override { QLocale::setDefault(before_); }

  static QStringList words(const std::vector<table_cell>& row) {
    QStringList all;
    for (const auto& cell : row)
      all << cell.words;
    return all;
  }

private:
  const QLocale before_;
};

TEST_F(ServerTables, SayWhatEachNodeIs) {
  client::server_status now;
  now.nodes = {{"rack-1", "10.0.0.7:40112", "solver", "working", "NVIDIA H100", "0.1.0", 16,
                std::uint64_t{128} << 30, 7500, 12}};

  const auto all = node_table(now);

  ASSERT_EQ(all.rows.size(), 1U);
  EXPECT_EQ(words(all.rows[0]),
            (QStringList{"rack-1", "Stress", "working", "NVIDIA H100", "12", "2 h 5 min", "16",
                         "128.0 GiB", "0.1.0", "10.0.0.7:40112"}));
  EXPECT_EQ(all.columns.size(), words(all.rows[0]).size());
  EXPECT_EQ(all.rows[0][7].order.toULongLong(), std::uint64_t{128} << 30);
}

TEST_F(ServerTables, WhatANodeSaysOfItselfStandsInOneLineAndNumbersMaySayAnything) {
  client::server_status now;
  now.nodes = {{"a\n\tb", "", "painter", "dancing", "", "", 0,
                std::numeric_limits<std::uint64_t>::max(), std::nan(""), 0}};

  const auto all = node_table(now);
  const auto row = words(all.rows[0]);

  EXPECT_EQ(row.mid(0, 4), (QStringList{"a b", "painter", "dancing", "-"}));
  EXPECT_EQ(row[5], "-");
  EXPECT_EQ(all.rows[0][5].order.toDouble(), -1);
  EXPECT_EQ(row[7], "8.0 EiB");
}

TEST_F(ServerTables, MemoryHasItsBudgetWhereThereIsOne) {
  client::server_status now;
  now.memory = {{"documents", std::uint64_t{3} << 20, 0},
                {"versions", 1024, std::uint64_t{2} << 30}};

  const auto all = memory_table(now);

  EXPECT_EQ(words(all.rows[0]), (QStringList{"Open documents", "3.0 MiB", "what is open"}));
  EXPECT_EQ(words(all.rows[1]), (QStringList{"Versions that were read", "1.0 KiB", "2.0 GiB"}));
}

TEST_F(ServerTables, TimesAreNoFinerThanAPersonAsks) {
  EXPECT_EQ(time_gone_by(0), "0 s");
  EXPECT_EQ(time_gone_by(59.9), "59 s");
  EXPECT_EQ(time_gone_by(60), "1 min");
  EXPECT_EQ(time_gone_by(3 * 3600 + 5 * 60), "3 h 5 min");
  EXPECT_EQ(time_gone_by(9 * 86'400), "9 days");
  for (const double odd : {-1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e300})
    EXPECT_EQ(time_gone_by(odd), "-");
}

TEST_F(ServerTables, AreCopiedAsLinesAndCells) {
  const word_table some{"Workers", {"Work", "State"}, {{{"Edits", {}}, {"ready", {}}}}};
  const word_table none{"Other machines", {"Name"}, {}};

  EXPECT_EQ(as_text({"TEdit 1 at ws://h/v1"}, {some, none}),
            "TEdit 1 at ws://h/v1\n\nWorkers\nWork\tState\nEdits\tready\n");
}

}  // namespace
}  // namespace tedit::desktop
