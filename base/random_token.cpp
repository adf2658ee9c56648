// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/random_token.hpp"

#include <sys/random.h>

#include <array>

#include "base/hex.hpp"

namespace tedit {

expected<std::string> make_token() {
  std::array<unsigned char, 32> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    return fail(ec::io_error, "the system gives no random numbers");
  return to_hex(bytes);
}

}  // namespace tedit
