// SPDX-License-Identifier: AGPL-3.0-or-later
// What `planting.py` includes in the sources of a copy: every planted change is in the program, and
// TEDIT_MUTANT=NUMBER makes one of them act. TEDIT_MUTANT_HITS names a file, a byte for each
// number, in which those that were reached are noted, by child processes too.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <type_traits>

namespace tedit::mutation {

inline constexpr std::size_t most_mutants = 4096;

struct control {
  int active = -1;
  unsigned char* hits = nullptr;

  control() {
    if (const char* wanted = std::getenv("TEDIT_MUTANT"))
      active = std::atoi(wanted);
    const char* file = std::getenv("TEDIT_MUTANT_HITS");
    const int handle = file ? ::open(file, O_RDWR | O_CLOEXEC) : -1;
    if (handle < 0)
      return;
    void* bytes = ::mmap(nullptr, most_mutants, PROT_READ | PROT_WRITE, MAP_SHARED, handle, 0);
    ::close(handle);
    if (bytes != MAP_FAILED)
      hits = static_cast<unsigned char*>(bytes);
  }
};

inline bool acts(int number) {
  static const control now;
  if (now.hits)
    __atomic_store_n(now.hits + number, static_cast<unsigned char>(1), __ATOMIC_RELAXED);
  return now.active == number;
}

/// A bound that is one too large, of a number with decimals half as large again.
template <class T>
requires(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) constexpr T
  bound(int number, T value) {
  if (!acts(number))
    return value;
  return static_cast<T>(std::is_integral_v<T> ? value + 1 : value * 1.5 + 1e-300);
}

/// A number of the other sign.
template <class T>
requires(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) constexpr T
  sign(int number, T value) {
  return acts(number) ? static_cast<T>(-value) : value;
}

}  // namespace tedit::mutation
