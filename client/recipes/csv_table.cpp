// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/csv_table.hpp"

#include <algorithm>
#include <set>

#include "base/text.hpp"
#include "client/recipes/values.hpp"

namespace tedit::client {

namespace {

[[noreturn]] void refuse_line(std::size_t line, const std::string& what,
                              const std::string& remedy) {
  refuse("line " + std::to_string(line) + " of the table " + what, remedy);
}

/// ';' where the first line has it, and no comma, outside quotes.
char separator_of(std::string_view text) {
  bool quoted = false;
  bool semicolon = false;
  for (const char c : text) {
    quoted ^= c == '"';
    if (quoted)
      continue;
    if (c == ',')
      return ',';
    if (c == '\n' || c == '\r')
      break;
    semicolon |= c == ';';
  }
  return semicolon ? ';' : ',';
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  const auto last = text.find_last_not_of(" \t");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

/// Takes a table apart, cell by cell.
class csv_reader {
public:
  explicit csv_reader(std::string_view text) : text_(text), separator_(separator_of(text)) {}

  [[nodiscard]] bool at_end() const { return at_ == text_.size(); }

  /// One line of cells, which may have line ends in quotes.
  csv_row row() {
    csv_row result{line_, {}};
    while (true) {
      result.cells.push_back(!at_end() && text_[at_] == '"' ? quoted() : bare());
      if (result.cells.back().size() > most_cell_bytes)
        refuse_line(line_, "has a cell of more than " + std::to_string(most_cell_bytes) + " bytes",
                    "Shorten it, or check that all quotes are closed");
      if (result.cells.size() > most_table_columns)
        refuse_line(line_, "has more than " + std::to_string(most_table_columns) + " cells",
                    "Leave out columns that the recipe does not use");
      if (at_end() || text_[at_] != separator_)
        break;
      ++at_;
    }
    end_line();
    return result;
  }

private:
  std::string bare() {
    const auto end = text_.find_first_of(std::string("\r\n\"") + separator_, at_);
    if (end != std::string_view::npos && text_[end] == '"')
      refuse_line(line_, "has a quote inside a cell that does not begin with one",
                  "Put the whole cell in quotes, and write a quote inside as \"\"");
    const auto size = std::min(end, text_.size()) - at_;
    at_ += size;
    return std::string(text_.substr(at_ - size, size));
  }

  std::string quoted() {
    const auto begin = line_;
    std::string cell;
    for (++at_;; ++at_) {
      if (at_end())
        refuse_line(begin, "has a quote that is not closed", "End the cell with a quote");
      if (text_[at_] == '"' && (++at_ == text_.size() || text_[at_] != '"'))
        break;
      line_ += text_[at_] == '\n' ? 1 : 0;
      cell += text_[at_];
    }
    if (!at_end() && text_[at_] != separator_ && text_[at_] != '\r' && text_[at_] != '\n')
      refuse_line(
        line_,
        "goes on after the closing quote of a cell" +
          (begin == line_ ? std::string() : " that began in line " + std::to_string(begin)),
        "Write a quote inside a cell as \"\"");
    return cell;
  }

  void end_line() {
    if (!at_end() && text_[at_] == '\r')
      ++at_;
    if (!at_end() && text_[at_] == '\n')
      ++at_;
    ++line_;
  }

  std::string_view text_;
  char separator_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

bool is_empty(const csv_row& row) {
  return row.cells.size() == 1 && row.cells.front().empty();
}

std::vector<std::string> columns_of(const csv_row& header) {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const auto& cell : header.cells) {
    names.push_back(trimmed(cell));
    if (names.back().empty())
      refuse_line(header.line, "has a column without a name", "The first line names all columns");
    if (!known.insert(names.back()).second)
      refuse_line(header.line, "has two columns \"" + names.back() + "\"", "Rename one of them");
  }
  return names;
}

/// A spreadsheet's own file is none from its first line on.
std::string line_of_other_bytes(std::string_view text) {
  std::size_t line = 1;
  for (; text.find('\n') != std::string_view::npos; ++line) {
    const auto one = text.substr(0, text.find('\n'));
    if (!is_utf8(one) || one.find('\0') != std::string_view::npos)
      break;
    text.remove_prefix(one.size() + 1);
  }
  return "line " + std::to_string(line) + " of the table is no text in UTF-8";
}

csv_table table_from(std::string_view text) {
  text = without_mark(text);
  if (!is_utf8(text) || text.find('\0') != std::string_view::npos)
    refuse(line_of_other_bytes(text), "Save it as \"CSV UTF-8\"");
  csv_reader in(text);
  csv_table result;
  while (!in.at_end()) {
    auto row = in.row();
    if (is_empty(row))
      continue;
    if (result.columns.empty()) {
      result.columns = columns_of(row);
      continue;
    }
    if (row.cells.size() != result.columns.size())
      refuse_line(row.line,
                  "has " + std::to_string(row.cells.size()) + " cells, and the first line names " +
                    std::to_string(result.columns.size()) + " columns",
                  "Give each row a cell for each column; one with a separator in it needs quotes");
    if (result.rows.size() == most_table_rows)
      refuse("the table has more than " + std::to_string(most_table_rows) + " rows", "Divide it");
    result.rows.push_back(std::move(row));
  }
  if (result.rows.empty())
    refuse("the table has no rows", "Its first line names the columns, each other one is a part");
  return result;
}

}  // namespace

expected<csv_table> csv_from_text(std::string_view text) {
  try {
    if (text.size() > most_table_bytes)
      refuse("the table has more than 16 MiB", "Divide it");
    return table_from(text);
  } catch (const error& e) {
    return fail(e);
  }
}

expected<csv_table> read_csv(const std::filesystem::path& file) {
  const auto text = text_of_file(file, most_table_bytes);
  if (!text)
    return fail(ec::io_error, "cannot read the table " + file.string(),
                "Check the path and its permissions; it may have 16 MiB");
  auto table = csv_from_text(*text);
  if (!table)
    table.error().where = file.string();
  return table;
}

}  // namespace tedit::client
