// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/time.h>

#include <cstdint>
#include <cstdio>

namespace tedit::ops {

// What `tedit-mesher` does, told by the first four bytes of its stdin. Each reads the rest of that
// and writes its answer to stdout; its return is the exit status.

/// See tets_exchange.hpp.
int fill_with_tets(std::uint32_t magic);

/// See corefine_exchange.hpp.
int combine_surfaces(std::uint32_t magic);

/// A header of which the magic number was read.
template <class Header>
bool read_rest(Header& header, std::uint32_t magic) {
  header.magic = magic;
  auto* const rest = reinterpret_cast<char*>(&header) + sizeof(magic);
  return std::fread(rest, sizeof(header) - sizeof(magic), 1, stdin) == 1;
}

/// This process ends (SIGPROF) once it has used so much processor time. Of processors, so that the
/// same question gets the same answer on a machine that has much else to do.
inline bool end_after(std::uint32_t milliseconds) {
  const itimerval left{{}, {milliseconds / 1000, 1000L * (milliseconds % 1000)}};
  return setitimer(ITIMER_PROF, &left, nullptr) == 0;
}

}  // namespace tedit::ops
