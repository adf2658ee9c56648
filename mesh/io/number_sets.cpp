// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/number_sets.hpp"

#include "mesh/io/line_cursor.hpp"

namespace tedit {

number_sets_of_deck::entry& number_sets_of_deck::set(const std::string& name) {
  const auto [at, fresh] = places_.try_emplace(upper(name), entries_.size());
  if (fresh)
    entries_.push_back(std::make_unique<entry>(entry{name, {}}));
  return *entries_[at->second];
}

const number_sets_of_deck::entry* number_sets_of_deck::find(const std::string& name) const {
  const auto at = places_.find(upper(name));
  return at == places_.end() ? nullptr : entries_[at->second].get();
}

bool number_sets_of_deck::add(entry& to, std::uint64_t number) {
  if (left_ == 0)
    return false;
  --left_;
  to.numbers.push_back(number);
  return true;
}

bool number_sets_of_deck::add_range(entry& to, std::uint64_t first, std::uint64_t last,
                                    std::uint64_t step) {
  if (step == 0 || last < first || (last - first) / step >= left_)
    return false;
  for (std::uint64_t i = 0; i <= (last - first) / step; ++i)
    to.numbers.push_back(first + i * step);
  left_ -= (last - first) / step + 1;
  return true;
}

bool number_sets_of_deck::add_all(entry& to, const entry& from) {
  if (from.numbers.size() > left_)
    return false;
  left_ -= from.numbers.size();
  const auto count = from.numbers.size();  // It may be the same set.
  for (std::size_t i = 0; i < count; ++i)
    to.numbers.push_back(from.numbers[i]);
  return true;
}

std::vector<const number_sets_of_deck::entry*> number_sets_of_deck::all() const {
  std::vector<const entry*> result;
  for (const auto& one : entries_)
    result.push_back(one.get());
  return result;
}

}  // namespace tedit
