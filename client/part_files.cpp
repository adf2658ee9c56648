// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/part_files.hpp"

#include <algorithm>
#include <string>

namespace tedit::client {

namespace {

/// Without the dot, in lower case.
std::string suffix_of(const std::filesystem::path& file) {
  auto suffix = file.extension().string();
  suffix.erase(0, 1);
  for (auto& c : suffix)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return suffix;
}

}  // namespace

bool is_cad_file(const std::filesystem::path& file) {
  return std::ranges::find(cad_suffixes, suffix_of(file)) != cad_suffixes.end();
}

bool is_surface_file(const std::filesystem::path& file) {
  return std::ranges::find(surface_suffixes, suffix_of(file)) != surface_suffixes.end();
}

}  // namespace tedit::client
