// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/broken/table.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <sqlite3.h>
#include <nlohmann/json.hpp>

#include "mesh/io/zip_file.hpp"
#include "tests/broken/allocations.hpp"

namespace tedit::test {

namespace {

using nlohmann::json;
using ::testing::HasSubstr;

const std::filesystem::path tests_folder = TEDIT_TEST_DATA "/..";

std::string file_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw std::runtime_error("there is no file " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

/// "7f 45": blanks are for people.
std::string bytes_of_hex(const std::string& hex) {
  std::string digits;
  std::string bytes;
  for (const char c : hex)
    if (c != ' ')
      digits += c;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return bytes;
}

/// Where a text stands: what an edit does not find, it cannot break.
std::size_t place_of(const std::string& bytes, const std::string& text) {
  const auto at = bytes.find(text);
  if (at == std::string::npos)
    throw std::runtime_error("\"" + text + "\" is not in the file");
  return at;
}

/// Only letters of ASCII, as Windows writes "Unicode".
std::string utf16(const std::string& bytes) {
  std::string wide = "\xFF\xFE";
  for (const char c : bytes)
    wide += std::string{c, '\0'};
  return wide;
}

std::string with_crlf(const std::string& bytes) {
  std::string text;
  for (const char c : bytes)
    text += c == '\n' ? "\r\n" : std::string(1, c);
  return text;
}

std::string zipped(const std::string& bytes, const std::string& name) {
  zip_packer packer(name);
  packer.add(bytes);
  const std::vector<zipped_file> files{packer.finish()};
  std::ostringstream out(std::ios::binary);
  write_zip(out, files);
  return std::move(out).str();
}

std::string times(const json& text) {
  std::string result;
  for (int i = 0; i < text[1].get<int>(); ++i)
    result += text[0].get<std::string>();
  return result;
}

/// Other bytes in the place of as many behind a text (or from the beginning), after `skip` bytes.
void write_over(std::string& bytes, const json& how) {
  const auto behind = how.value("behind", "");
  const auto at = place_of(bytes, behind) + behind.size() + how.value("skip", std::size_t{0});
  const auto others = bytes_of_hex(how["hex"]);
  if (at + others.size() > bytes.size())
    throw std::runtime_error("there are no bytes to write over");
  bytes.replace(at, others.size(), others);
}

/// Statements on a database, of which the file is an image.
void run_sql(std::string& bytes, const std::string& sql) {
  constexpr std::size_t log_marks = 18;  // Two bytes: 1 without a log, as in memory, 2 with one.
  const auto marks = bytes.substr(log_marks, 2);
  bytes.replace(log_marks, 2, "\1\1");
  sqlite3* db = nullptr;
  auto size = static_cast<sqlite3_int64>(bytes.size());
  auto* image = static_cast<unsigned char*>(sqlite3_malloc64(bytes.size()));
  std::ranges::copy(bytes, image);
  const bool done = sqlite3_open(":memory:", &db) == SQLITE_OK &&
                    sqlite3_deserialize(db, "main", image, size, size,
                                        SQLITE_DESERIALIZE_FREEONCLOSE |
                                          SQLITE_DESERIALIZE_RESIZEABLE) == SQLITE_OK &&
                    sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
  const std::string why = sqlite3_errmsg(db);
  if (auto* made = done ? sqlite3_serialize(db, "main", &size, 0) : nullptr) {
    bytes.assign(reinterpret_cast<const char*>(made), static_cast<std::size_t>(size));
    sqlite3_free(made);
    bytes.replace(log_marks, 2, marks);
  }
  sqlite3_close(db);
  if (!done)
    throw std::runtime_error(sql + ": " + why);
}

using edit = void (*)(std::string& bytes, const json& how);

const std::map<std::string, edit> edits{
  {"replace",
   [](std::string& bytes, const json& how) {
     const auto from = how[0].get<std::string>();
     bytes.replace(place_of(bytes, from), from.size(), how[1].get<std::string>());
   }},
  {"cut_before", [](std::string& bytes, const json& how) { bytes.resize(place_of(bytes, how)); }},
  {"cut_at",
   [](std::string& bytes, const json& how) {
     const auto at = how.get<long>();
     bytes.resize(at < 0 ? bytes.size() - static_cast<std::size_t>(-at)
                         : static_cast<std::size_t>(at));
   }},
  {"drop",
   [](std::string& bytes, const json& how) {
     const auto text = how.get<std::string>();
     bytes.erase(place_of(bytes, text), text.size());
   }},
  {"write_over", write_over},
  {"append", [](std::string& bytes, const json& how) { bytes += how.get<std::string>(); }},
  {"append_times", [](std::string& bytes, const json& how) { bytes += times(how); }},
  {"insert_times",
   [](std::string& bytes, const json& how) { bytes.insert(place_of(bytes, how[2]), times(how)); }},
  {"prepend", [](std::string& bytes, const json& how) { bytes = how.get<std::string>() + bytes; }},
  {"prepend_hex", [](std::string& bytes, const json& how) { bytes = bytes_of_hex(how) + bytes; }},
  {"whole", [](std::string& bytes, const json& how) { bytes = how.get<std::string>(); }},
  {"whole_hex", [](std::string& bytes, const json& how) { bytes = bytes_of_hex(how); }},
  {"file", [](std::string& bytes,
              const json& how) { bytes = file_bytes(tests_folder / how.get<std::string>()); }},
  {"sql", [](std::string& bytes, const json& how) { run_sql(bytes, how); }},
  {"utf16", [](std::string& bytes, const json&) { bytes = utf16(bytes); }},
  {"crlf", [](std::string& bytes, const json&) { bytes = with_crlf(bytes); }},
  {"zip", [](std::string& bytes, const json& how) { bytes = zipped(bytes, how); }}};

/// Each edit is an object with one key.
std::string edited(std::string bytes, const json& list) {
  for (const auto& one : list)
    for (const auto& [kind, how] : one.items())
      edits.at(kind)(bytes, how);
  return bytes;
}

broken_file made(const json& table, const json& row) {
  broken_file file;
  file.name = row["name"];
  try {
    file.bytes = edited(file_bytes(tests_folder / table["base"].get<std::string>()),
                        row.value("edits", json::array()));
    if (table.contains("then"))
      file.bytes = edited(std::move(file.bytes), row.value("then", table["then"]));
  } catch (const std::exception& failure) {
    throw std::runtime_error(file.name + ": " + failure.what());
  }
  file.is_taken = row.contains("taken");
  file.message = file.is_taken ? row["taken"].get<std::string>() : row.value("message", "");
  file.code = row.value("code", "");
  file.where = row.value("where", "");
  file.remedy = row.value("remedy", "");
  return file;
}

/// Most that a reader may ask for at once: a million members of a deck's sets, whose ranges take
/// few letters, or some times what the file holds.
std::size_t most_at_once(std::size_t file) {
  constexpr std::size_t members = std::size_t{8'400'000};
  return members + 16 * file;
}

/// With TEDIT_TELL_BROKEN set, what is said goes out for people to read.
void tell(const std::string& table, const broken_file& file, const expected<std::string>& said) {
  if (std::getenv("TEDIT_TELL_BROKEN") == nullptr)
    return;
  json row{{"table", table}, {"name", file.name}};
  if (said)
    row["taken"] = *said;
  else
    row.update({{"code", std::string(code_name(said.error().code))},
                {"where", said.error().where},
                {"message", said.error().message},
                {"remedy", said.error().remedy}});
  std::cout << "TOLD " << row.dump(-1, ' ', false, json::error_handler_t::replace) << '\n';
}

void expect_refused(const broken_file& file, const error& why) {
  EXPECT_EQ(code_name(why.code), file.code);
  EXPECT_EQ(why.where, file.where);
  EXPECT_THAT(why.message, HasSubstr(file.message));
  EXPECT_THAT(why.remedy, HasSubstr(file.remedy));
  // A row without words would hold of any message.
  EXPECT_NE(file.message, "");
  EXPECT_NE(file.remedy, "");
}

}  // namespace

std::vector<broken_file> broken_files(const std::string& table) {
  const auto text = json::parse(file_bytes(tests_folder / "data/broken" / (table + ".json")));
  std::vector<broken_file> files;
  for (const auto& row : text["files"])
    files.push_back(made(text, row));
  return files;
}

void expect_told(const std::string& table, const told_reader& read) {
  for (const auto& file : broken_files(table)) {
    SCOPED_TRACE(table + ": " + file.name);
    std::size_t largest = 0;
    const auto said = [&] {
      const largest_allocation watched;
      auto result = read(file.bytes);
      largest = watched.bytes();
      return result;
    }();
    tell(table, file, said);
    EXPECT_LE(largest, most_at_once(file.bytes.size()));
    EXPECT_EQ(said.has_value(), file.is_taken) << (said ? *said : render(said.error()));
    if (said && file.is_taken) {
      EXPECT_THAT(*said, HasSubstr(file.message));
    } else if (!said && !file.is_taken) {
      expect_refused(file, said.error());
    }
  }
}

}  // namespace tedit::test
