// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/page.hpp"

#include <algorithm>

namespace tedit {

page::page(std::size_t size) : data_(std::make_unique<std::byte[]>(size)), size_(size) {
  // nop
}

page::page(std::span<const std::byte> bytes, std::size_t size)
    : data_(std::make_unique_for_overwrite<std::byte[]>(size)), size_(size) {
  const auto rest = std::ranges::copy(bytes, data_.get()).out;
  std::fill(rest, data_.get() + size, std::byte{});
}

page_ptr page::from_bytes(std::span<const std::byte> bytes) {
  return std::make_shared<page>(bytes, bytes.size());
}

const hash128& page::id() const {
  std::call_once(hashed_, [this] { id_ = hash_bytes(bytes()); });
  return id_;
}

std::shared_ptr<const page_facts> page::facts() const {
  const std::scoped_lock lock(keeping_);
  return facts_;
}

void page::keep(std::shared_ptr<const page_facts> made) const {
  const std::scoped_lock lock(keeping_);
  facts_.swap(made);
}

}  // namespace tedit
