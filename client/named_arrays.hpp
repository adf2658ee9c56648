// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tedit::client {

/// Arrays of a result by their names (`fem::result_arrays`). There are few: they are sought one by
/// one, so who goes over all vertices looks an array up once.
template <class T>
class named_arrays {
public:
  /// The array of this name; an empty one when it did not come.
  [[nodiscard]] const std::vector<T>& of(std::string_view name) const {
    static const std::vector<T> none;
    const auto found = std::ranges::find(all_, name, &row::first);
    return found == all_.end() ? none : found->second;
  }

  /// The array of this name to write into; it is made when there is none.
  [[nodiscard]] std::vector<T>& operator[](std::string_view name) {
    const auto found = std::ranges::find(all_, name, &row::first);
    return found == all_.end() ? all_.emplace_back(name, std::vector<T>()).second : found->second;
  }

  [[nodiscard]] auto begin() const { return all_.begin(); }
  [[nodiscard]] auto end() const { return all_.end(); }

private:
  using row = std::pair<std::string, std::vector<T>>;
  std::vector<row> all_;
};

}  // namespace tedit::client
