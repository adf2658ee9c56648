// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <caf/actor.hpp>
#include <caf/allowed_unsafe_message_type.hpp>

#include "compare/comparison.hpp"
#include "mesh/field.hpp"
#include "mesh/version.hpp"

/// What a session is asked about the difference of two versions, and what it answers; within one
/// process, as the messages of actors/local_messages.hpp.
namespace tedit::actors {

struct comparison_request {
  std::uint64_t ticket = 0;
  std::uint32_t before = 0;  ///< Numbers of versions.
  std::uint32_t after = 0;
  std::string load_case;  ///< Whose difference is wanted at each vertex; empty: none.
};

struct compared {
  std::string document;
  std::uint32_t before = 0;
  std::uint32_t after = 0;
  std::string load_case;  ///< As asked for.
  version_ptr mesh;       ///< The version after.
  std::shared_ptr<const version_comparison> what;
  /// The fields of `field_difference`; empty when none was asked for or there is none.
  std::shared_ptr<const std::vector<field>> difference;
};

}  // namespace tedit::actors

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::comparison_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::compared)
