// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <istream>
#include <string>
#include <string_view>

#include "verification/calculix.hpp"

namespace tedit::verification {

namespace {

// Columns of a row of results: " -1", the node's number, values without anything between them.
constexpr std::size_t number_begin = 3;
constexpr std::size_t number_width = 10;
constexpr std::size_t value_width = 12;
constexpr std::size_t components = 6;

template <class T>
bool read_column(std::string_view line, std::size_t begin, std::size_t width, T& value) {
  if (line.size() < begin + width)
    return false;
  auto text = line.substr(begin, width);
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc() && end == text.data() + text.size();
}

/// False where the row is none of stress.
bool read_row(std::string_view line, std::size_t& node, std::array<double, components>& value) {
  if (!line.starts_with(" -1") || !read_column(line, number_begin, number_width, node))
    return false;
  for (std::size_t i = 0; i < components; ++i)
    if (!read_column(line, number_begin + number_width + i * value_width, value_width, value[i]) ||
        !std::isfinite(value[i]))
      return false;
  return true;
}

}  // namespace

expected<std::vector<double>> read_calculix_stress(std::istream& frd, std::size_t node_count) {
  std::vector<double> stress(components * node_count);
  std::vector<bool> seen(node_count);
  bool inside = false;
  for (std::string line; std::getline(frd, line);) {
    if (line.starts_with(" -4"))
      inside = line.starts_with(" -4  STRESS");
    std::size_t node = 0;
    std::array<double, components> value{};
    if (!inside || !read_row(line, node, value) || node < 1 || node > node_count)
      continue;
    std::ranges::copy(value, stress.begin() + static_cast<std::ptrdiff_t>(components * (node - 1)));
    seen[node - 1] = true;
  }
  if (const auto missing = std::ranges::find(seen, false); missing != seen.end())
    return fail(ec::bad_input, "the results of CalculiX lack the stress of node " +
                                 std::to_string(missing - seen.begin() + 1));
  return stress;
}

}  // namespace tedit::verification
