// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>

#include "base/error.hpp"

namespace tedit {

/// Makes sure that there is an X display: starts Xvfb when $DISPLAY is empty. Keep the object alive
/// while drawing. Errors: `service_unavailable` naming the package.
class virtual_display {
public:
  [[nodiscard]] static expected<virtual_display> open();
  virtual_display(virtual_display&& other) noexcept : server_(std::exchange(other.server_, -1)) {}
  virtual_display(const virtual_display&) = delete;
  virtual_display& operator=(const virtual_display&) = delete;
  virtual_display& operator=(virtual_display&&) = delete;
  ~virtual_display();

private:
  explicit virtual_display(int server) : server_(server) {}
  int server_ = -1;  ///< Process id of an Xvfb of ours.
};

}  // namespace tedit
