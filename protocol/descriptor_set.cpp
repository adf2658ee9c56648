// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/descriptor_set.hpp"

namespace tedit::protocol {

namespace {

constexpr unsigned char schema_bytes[] = {
#include "tedit/v1/descriptor_set.inc"
};

}  // namespace

std::string_view descriptor_set() noexcept {
  return {reinterpret_cast<const char*>(schema_bytes), sizeof schema_bytes};
}

}  // namespace tedit::protocol
