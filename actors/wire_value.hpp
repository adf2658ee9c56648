// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>

#include <caf/error.hpp>
#include <caf/meta/type_name.hpp>

#include "protocol/forms.hpp"

namespace tedit::actors {

/// A value in a message that may go to another process: actors of one process share it as it is,
/// and only where it leaves the process does it become bytes (protocol/forms.hpp). What another
/// process sent is read when it arrives; `get` says whether that worked.
template <class T>
class wire_value {
public:
  /// Holds none: `get` fails.
  wire_value() = default;
  explicit wire_value(std::shared_ptr<const T> value) : value_(std::move(value)) {}
  explicit wire_value(T value) : value_(std::make_shared<const T>(std::move(value))) {}

  /// Errors: `protocol_error`, and those of the value's own checks.
  [[nodiscard]] expected<std::shared_ptr<const T>> get() const {
    if (!value_)
      return fail(fault_ ? *fault_ : error{ec::protocol_error, "a message lacks a value", {}, {}});
    return value_;
  }

  template <class Inspector>
  friend typename Inspector::result_type inspect(Inspector& f, wire_value& x) {
    std::string bytes;
    if constexpr (Inspector::reads_state) {
      if (x.value_)
        bytes = protocol::to_bytes(*x.value_);
      return f(bytes);
    } else {
      if (auto failed = f(bytes))
        return failed;
      x.take(protocol::from_bytes<T>(bytes));
      return caf::none;
    }
  }

private:
  void take(expected<T> read) {
    if (read)
      value_ = std::make_shared<const T>(std::move(*read));
    else
      fault_ = std::make_shared<const error>(std::move(read.error()));
  }

  std::shared_ptr<const T> value_;
  std::shared_ptr<const error> fault_;  ///< Why what arrived is no value.
};

}  // namespace tedit::actors
