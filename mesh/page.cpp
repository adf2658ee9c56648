// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/page.hpp"

#include <algorithm>

namespace tedit {

page::page(std::size_t size) : data_(std::make_unique<std::byte[]>(size)), size_(size) {
  // nop
}

page_ptr page::from_bytes(std::span<const std::byte> bytes) {
  auto result = std::make_shared<page>(bytes.size());
  std::ranges::copy(bytes, result->mutable_bytes().begin());
  return result;
}

const hash128& page::id() const {
  std::call_once(hashed_, [this] { id_ = hash_bytes(bytes()); });
  return id_;
}

}  // namespace tedit
