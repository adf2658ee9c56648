// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tedit::gateway {

/// A client that is connected and has said who it is.
struct present_client {
  std::string user;
  std::string role;
  std::string client;   ///< As it introduced itself.
  std::string address;  ///< With its port.
  std::chrono::steady_clock::time_point since = std::chrono::steady_clock::now();
};

/// All of a gateway. Thread-safe.
class client_list : public std::enable_shared_from_this<client_list> {
public:
  /// It is on the list for as long as what is returned lives.
  [[nodiscard]] std::shared_ptr<const void> enter(present_client who) {
    const std::lock_guard lock(mutex_);
    const auto place = all_.insert(all_.end(), std::move(who));
    return {nullptr, [self = shared_from_this(), place](const void*) {
              const std::lock_guard leaving(self->mutex_);
              self->all_.erase(place);
            }};
  }

  [[nodiscard]] std::vector<present_client> all() const {
    const std::lock_guard lock(mutex_);
    return {all_.begin(), all_.end()};
  }

private:
  mutable std::mutex mutex_;
  std::list<present_client> all_;
};

}  // namespace tedit::gateway
