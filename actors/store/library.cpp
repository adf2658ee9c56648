// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/library.hpp"

#include <algorithm>
#include <cctype>

#include "actors/store/check.hpp"
#include "actors/store/document_view.hpp"
#include "base/guard.hpp"

namespace tedit::actors {

expected<void> check_document_name(const std::string& name) {
  const auto good = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_' || c == '-';
  };
  if (name.empty() || name.size() > longest_document_name || name.front() == '.' ||
      !std::ranges::all_of(name, good))
    return fail(ec::invalid_argument, "\"" + name + "\" cannot name a document",
                "Take at most 64 letters, digits, '.', '_' and '-', not beginning with a dot");
  return {};
}

bool is_temporary(const std::string& name) {
  std::string_view rest(name);
  if (!rest.starts_with(temporary_prefix))
    return false;
  rest.remove_prefix(std::string_view(temporary_prefix).size());
  const auto dash = rest.find('-');
  const auto is_number = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
  };
  return dash != rest.npos && is_number(rest.substr(0, dash)) && is_number(rest.substr(dash + 1));
}

document_list list_folder(const std::filesystem::path& folder) {
  document_list result;
  std::error_code code;
  for (auto entry = std::filesystem::directory_iterator(folder, code);
       !code && entry != std::filesystem::directory_iterator(); entry.increment(code)) {
    const auto& path = entry->path();
    const auto name = path.stem().string();
    std::error_code unknown;
    if (path.extension() != ".tedit" || !check_document_name(name) ||
        !entry->is_regular_file(unknown))
      continue;
    if (const auto state = store::state_of(path)) {
      document_row row;
      row.name = name;
      row.bytes = state->bytes;
      row.changed = state->changed_ms / 1000;
      result.documents.push_back(std::move(row));
    }
  }
  std::ranges::sort(result.documents, {}, &document_row::name);
  return result;
}

expected<void> cancellable_copy(const cancel_token& stop,
                                const std::function<expected<void>()>& copy) {
  auto done = guarded({stop, {}}, copy);
  if (!done && done.error().code == ec::cancelled)
    return fail(ec::cancelled, "the copy was cancelled");
  return done;
}

namespace {

expected<void> copy_if_sound(const file_copy& wanted, std::size_t& versions) {
  const auto document = store::document_view::open(wanted.from);
  if (!document)
    return fail(document.error());
  const auto found = check_document(**document);
  if (!found)
    return fail(found.error());
  if (!found->sound())
    return fail(ec::storage_error, found->damage.front().message,
                "A damaged document is not copied: \"tedit doc check\" says what is whole");
  versions = found->versions;
  return (*document)->copy_to(wanted.to);
}

}  // namespace

expected<std::size_t> copy_sound_file(const file_copy& wanted) {
  std::size_t versions = 0;
  return cancellable_copy(wanted.stop, [&] { return copy_if_sound(wanted, versions); }).map([&] {
    return versions;
  });
}

}  // namespace tedit::actors
