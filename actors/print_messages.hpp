// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <caf/actor.hpp>
#include <caf/allowed_unsafe_message_type.hpp>

#include "mesh/print/print_checks.hpp"

/// What a session is asked about the printing of a version, and what it answers; within one
/// process, as the messages of actors/local_messages.hpp.
namespace tedit::actors {

struct print_request {
  std::uint64_t ticket = 0;
  std::optional<std::uint32_t> number;  ///< Of the version; nothing: the head.
  print_settings settings;
  caf::actor client = {};  ///< Hears of progress; null: nobody.
};

struct print_checked {
  std::string document;
  std::uint32_t number = 0;
  print_settings settings;  ///< As asked for.
  version_ptr mesh;
  std::shared_ptr<const print_report> what;
};

}  // namespace tedit::actors

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::print_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::print_checked)
