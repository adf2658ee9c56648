// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <unistd.h>

#include "actors/store/document.hpp"

namespace tedit::store {

namespace fs = std::filesystem;

using ::testing::HasSubstr;

/// A page whose bytes depend on `seed`, compressible like real ones.
inline page_ptr make_page(std::uint32_t seed, std::size_t size = 1000) {
  std::vector<std::byte> bytes(size);
  for (std::size_t i = 0; i < size; ++i)
    bytes[i] = static_cast<std::byte>((seed + i / 7) * 31);
  return page::from_bytes(bytes);
}

/// Version `number`, child of the one before, with one page and the head on it.
inline change make_change(std::uint32_t number) {
  change c;
  c.new_pages = {make_page(number)};
  version_row v;
  v.number = number;
  if (number > 0)
    v.parent = number - 1;
  v.id = c.new_pages[0]->id();
  v.manifest = {std::byte{1}, std::byte{0}, std::byte{static_cast<unsigned char>(number)}};
  v.operation = R"({"name":"fill"})";
  v.load_cases = "[]";
  v.report = R"({"tets":7})";
  c.new_version = v;
  c.head = number;
  c.what = "edit";
  c.details = "{}";
  return c;
}

/// A folder of its own per test, removed in the end.
class Document : public ::testing::Test {
protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "tedit-document-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
    file = folder / "part.tedit";
  }
  void TearDown() override { fs::remove_all(folder); }

  /// All that lies in the folder, but for the locks and the names of before.
  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : fs::directory_iterator(folder))
      if (const auto name = entry.path().filename().string();
          name != ".tedit-lock" && name != ".tedit-names")
        result.insert(name);
    return result;
  }

  /// With its file there: of a new one, by a commit of nothing.
  std::unique_ptr<document> open() const {
    auto opened = document::open(file);
    EXPECT_TRUE(opened.has_value()) << (opened ? "" : render(opened.error()));
    if (opened && !std::filesystem::exists(file)) {
      EXPECT_TRUE((*opened)->commit({}));
    }
    return opened ? std::move(*opened) : nullptr;
  }

  error refusal() const {
    const auto opened = document::open(file);
    EXPECT_FALSE(opened.has_value());
    return opened ? error{} : opened.error();
  }

  /// Runs SQL on the file behind the document's back.
  void tamper(const std::string& sql) const {
    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(file.c_str(), &db), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(db);
    sqlite3_close(db);
  }

  /// The text of the first column of the first row.
  std::string look_up(const std::string& sql) const {
    sqlite3* db = nullptr;
    sqlite3_stmt* row = nullptr;
    std::string text;
    sqlite3_open(file.c_str(), &db);
    sqlite3_prepare_v2(db, sql.c_str(), -1, &row, nullptr);
    if (sqlite3_step(row) == SQLITE_ROW)
      text = reinterpret_cast<const char*>(sqlite3_column_text(row, 0));
    sqlite3_finalize(row);
    sqlite3_close(db);
    return text;
  }

  fs::path folder;
  fs::path file;
};

}  // namespace tedit::store
