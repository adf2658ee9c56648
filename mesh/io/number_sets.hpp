// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tedit {

/// Named sets of node or element numbers, as decks have them; names are alike in any case.
class number_sets_of_deck {
public:
  struct entry {
    std::string name;  ///< As the file first wrote it.
    std::vector<std::uint64_t> numbers;
  };

  /// All sets together may have `most` members; a range of few characters must not take memory.
  explicit number_sets_of_deck(std::uint64_t most) : left_(most) {}

  /// The set of this name, made where there is none.
  entry& set(const std::string& name);
  [[nodiscard]] const entry* find(const std::string& name) const;

  /// False where there would be too many members, or no end to them.
  [[nodiscard]] bool add(entry& to, std::uint64_t number);
  [[nodiscard]] bool add_range(entry& to, std::uint64_t first, std::uint64_t last,
                               std::uint64_t step);
  [[nodiscard]] bool add_all(entry& to, const entry& from);

  /// In the order of their first lines.
  [[nodiscard]] std::vector<const entry*> all() const;

private:
  std::uint64_t left_;
  std::map<std::string, std::size_t> places_;
  std::vector<std::unique_ptr<entry>> entries_;
};

}  // namespace tedit
