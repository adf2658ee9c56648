// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/number_range.hpp"

/// Values of a recipe. Whatever is wrong is thrown as an `error` (`bad_input`) whose message begins
/// with `what`; it does not leave the reader.
namespace tedit::client {

using nlohmann::json;

inline constexpr std::size_t most_ids = 100'000;

[[noreturn]] void refuse(std::string message, std::string remedy = {});

double number_from(const json& value, const number_range& range, const std::string& what);
/// Neither cut off nor wrapped around.
std::int64_t whole_from(const json& value, const std::string& what);
std::string text_from(const json& value, const std::string& what);
bool flag_from(const json& value, const std::string& what);
/// What the text says. Thrown as well for brackets that are nested too deep.
json parse_json(std::string_view text);

/// A whole file. Errors: `io_error` without words, also for one of more bytes.
[[nodiscard]] expected<std::string> text_of_file(const std::filesystem::path& file,
                                                 std::size_t most_bytes);

/// The list, which has `least` to `most` elements.
const json& list_from(const json& value, std::size_t least, std::size_t most,
                      const std::string& what);

}  // namespace tedit::client
