// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/links/knock_limits.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>

namespace tedit::actors {

namespace {

/// Makes room for one more: the one goes whose time is furthest back.
template <class Map, class Time>
void keep_few(Map& all, Time time) {
  if (all.size() < knock_limits::most_addresses)
    return;
  all.erase(std::ranges::min_element(
    all, [&](const auto& a, const auto& b) { return time(a.second) < time(b.second); }));
}

}  // namespace

void knock_limits::refill(time_point now) {
  const std::chrono::duration<double> passed = now - filled_;
  filled_ = now;
  left_ = std::min<double>(rates_.at_once, left_ + passed.count() * rates_.per_second);
}

bool knock_limits::is_known(const std::string& address, time_point now) const {
  const auto found = known_.find(address);
  return found != known_.end() && now - found->second < rates_.known_for;
}

bool knock_limits::admits(const std::string& address, time_point now) {
  refill(now);
  if (const auto found = failures_.find(address); found != failures_.end()) {
    if (now - found->second.last >= rates_.forgotten_after)
      failures_.erase(found);
    else if (now < found->second.free)
      return false;
  }
  if (left_ < 1)
    return is_known(address, now);
  left_ -= 1;
  return true;
}

void knock_limits::failed(const std::string& address, time_point now) {
  if (!failures_.contains(address))
    keep_few(failures_, [](const failures& one) { return one.last; });
  auto& one = failures_[address];
  one.last = now;
  if (++one.count <= rates_.free_failures)
    return;
  auto pause = rates_.first_pause;
  for (auto i = one.count - rates_.free_failures; i > 1 && pause < rates_.longest_pause; --i)
    pause *= 2;
  one.free = now + std::min(pause, rates_.longest_pause);
}

void knock_limits::came_in(const std::string& address, time_point now) {
  failures_.erase(address);
  if (!known_.contains(address))
    keep_few(known_, [](time_point last) { return last; });
  known_[address] = now;
}

std::string owner_part(const std::string& address) {
  in6_addr v6{};
  if (::inet_pton(AF_INET6, address.substr(0, address.find('%')).c_str(), &v6) != 1)
    return address;
  std::array<char, INET6_ADDRSTRLEN> text{};
  if (IN6_IS_ADDR_V4MAPPED(&v6))
    return ::inet_ntop(AF_INET, &v6.s6_addr[12], text.data(), text.size());
  std::fill(v6.s6_addr + 8, v6.s6_addr + 16, std::uint8_t{0});
  ::inet_ntop(AF_INET6, &v6, text.data(), text.size());
  return std::string(text.data()) + "/64";
}

}  // namespace tedit::actors
