// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/broken/allocations.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace tedit::test {

namespace {

thread_local bool counts = false;
thread_local std::size_t largest = 0;

}  // namespace

largest_allocation::largest_allocation() {
  largest = 0;
  counts = true;
}

largest_allocation::~largest_allocation() {
  counts = false;
}

std::size_t largest_allocation::bytes() {
  return largest;
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

void* taken(std::size_t size) {
  if (counts)
    largest = std::max(largest, size);
  if (void* memory = std::malloc(std::max<std::size_t>(size, 1)))
    return memory;
  throw std::bad_alloc();
}

}  // namespace

#endif

}  // namespace tedit::test

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

void* operator new(std::size_t size) {
  return tedit::test::taken(size);
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

#endif
