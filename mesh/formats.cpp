// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/formats.hpp"

#include <algorithm>
#include <cctype>

namespace tedit {

namespace {

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

/// "a, b or c".
template <class Items, class Words>
std::string one_of(const Items& items, const Words& words) {
  std::string result;
  for (std::size_t i = 0; i < items.size(); ++i)
    result += (i == 0 ? "" : i + 1 < items.size() ? ", " : " or ") + words(items[i]);
  return result;
}

/// In the middle of a sentence, where no abbreviation begins it.
std::string uncapitalized(std::string_view title) {
  std::string result(title);
  if (result.size() > 1 && std::islower(static_cast<unsigned char>(result[1])))
    result[0] = lower(result[0]);
  return result;
}

}  // namespace

const file_format* find_format(std::string_view name) {
  const auto* found = std::ranges::find(file_formats, name, &file_format::name);
  return found == file_formats.end() ? nullptr : found;
}

namespace {

/// Calls `visit` with each word of a text.
template <class Visit>
void for_each_word(std::string_view text, const Visit& visit) {
  while (!text.empty()) {
    const auto word = text.substr(0, text.find(' '));
    visit(word);
    text.remove_prefix(std::min(text.size(), word.size() + 1));
  }
}

}  // namespace

const file_format* format_of_suffix(std::string_view suffix) {
  std::string name(suffix);
  std::ranges::transform(name, name.begin(), lower);
  const file_format* result = find_format(name);
  for (const auto& format : file_formats)
    for_each_word(format.also, [&](std::string_view word) {
      if (!result && word == name)
        result = &format;
    });
  return result;
}

std::vector<std::string_view> read_suffixes() {
  std::vector<std::string_view> result;
  for (const auto& format : file_formats)
    if (format.reads) {
      result.push_back(format.name);
      for_each_word(format.also, [&](std::string_view word) { result.push_back(word); });
    }
  return result;
}

std::string read_formats_text() {
  return "A mesh: " +
         one_of(read_suffixes(), [](std::string_view name) { return "." + std::string(name); });
}

expected<const file_format*> format_for(const std::filesystem::path& file) {
  const auto suffix = file.extension().string();
  const auto name = suffix.substr(std::min<std::size_t>(1, suffix.size()));
  const auto* found = format_of_suffix(name);
  if (found && found->writes)
    return found;
  auto refused = no_such_format(name, written_formats());
  refused.where = file.string();
  return fail(std::move(refused));
}

error no_such_format(std::string_view name, std::span<const std::string_view> there_are) {
  return {ec::invalid_argument,
          name.empty() ? "the file's name has no suffix that says its format"
                       : "there is no file format \"" + std::string(name) + "\" to write",
          "Take " + one_of(there_are, [](std::string_view one) { return std::string(one); }),
          {}};
}

std::vector<std::string_view> written_formats() {
  std::vector<std::string_view> result;
  for (const auto& format : file_formats)
    if (format.writes)
      result.push_back(format.name);
  return result;
}

std::string written_formats_text() {
  return one_of(written_formats(), [](std::string_view name) {
    return "." + std::string(name) + " (" + uncapitalized(find_format(name)->title) + ")";
  });
}

std::string coloured_formats_text() {
  auto names = written_formats();
  std::erase_if(names, [](std::string_view name) { return !find_format(name)->keeps.colours; });
  return one_of(names, [](std::string_view name) { return "." + std::string(name); });
}

}  // namespace tedit
