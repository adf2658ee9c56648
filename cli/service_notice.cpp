// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/service_notice.hpp"

#include <sys/socket.h>
#include <sys/un.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>

#include "base/unique_fd.hpp"

namespace tedit::cli {

void tell_service_manager(const std::string& state) {
  const char* place = std::getenv("NOTIFY_SOCKET");
  sockaddr_un at{};
  const auto size = place ? std::strlen(place) : 0;
  if (size < 2 || size >= sizeof(at.sun_path) || (place[0] != '/' && place[0] != '@'))
    return;
  at.sun_family = AF_UNIX;
  std::memcpy(at.sun_path, place, size);
  if (place[0] == '@')  // A name of its own instead of a file.
    at.sun_path[0] = '\0';
  const unique_fd to(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  if (to)
    static_cast<void>(::sendto(to.get(), state.data(), state.size(), MSG_NOSIGNAL,
                               reinterpret_cast<const sockaddr*>(&at),
                               static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + size)));
}

}  // namespace tedit::cli
