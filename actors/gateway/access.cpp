// SPDX-License-Identifier: AGPL-3.0-or-later
// What a client may do by its token, and for how long.
#include <algorithm>

#include "actors/gateway/client_actor.hpp"
#include "actors/gateway/permissions.hpp"
#include "base/logging/logging.hpp"
#include "base/utc.hpp"

namespace tedit::gateway {

namespace {

error withdrawn(const grant& access) {
  return {ec::permission_denied,
          "the token of " + access.user + " was withdrawn",
          "Ask who keeps the server for another (tedit users token)",
          {}};
}

}  // namespace

error token_ended(const grant& access) {
  return {ec::permission_denied,
          "the token of " + access.user + " ended at " + utc_text(access.until.value_or(0)),
          "Ask who keeps the server for another (tedit users token)",
          {}};
}

void client_state::admit(const grant& who, const std::string& client) {
  known = true;
  to->authenticated();
  access = who;
  client_name = who.user.empty() ? client : who.user + ", " + client;
  const std::string role(name_of(who.role));
  here = {who.user, role, client, to->peer()};
  listed = parts.clients->enter(here);
  logging::info("client {}: {} ({})", to->peer(), client_name, role);
  look_later();
}

/// The server's own token holds as long as the server runs.
void client_state::look_later() {
  if (access.token == 0)
    return;
  auto wait = parts.access_every;
  if (access.until)
    wait = std::clamp(std::chrono::milliseconds(1000 * (*access.until - seconds_now())),
                      std::chrono::milliseconds(10), wait);
  self->delayed_send(self, wait, access_atom::value);
}

void client_state::look_at_access() {
  const auto now = parts.guard->admits(access.token);
  if (now && !now->has_ended(seconds_now())) {
    if (now->role != access.role) {
      here.role = name_of(now->role);
      listed = parts.clients->enter(here);
      logging::info("client {}: has the role {} by now", to->peer(), here.role);
    }
    access = *now;
    return look_later();
  }
  const auto why = now ? token_ended(*now) : withdrawn(access);
  logging::info("client {}: {}", to->peer(), why.message);
  metrics::count_of("tedit_tokens_ended_total",
                    "Connections that ended because their token had ended or was withdrawn.")
    .add();
  reject(0, why);  // Said with no request; the client takes it as the reason of the end.
  to->close(1008, why.message);
  turned_away = true;
}

expected<void> client_state::may(const v1::ClientMessage& message) const {
  if (access.has_ended(seconds_now()))
    return fail(token_ended(access));
  return check_role(access.role, message);
}

}  // namespace tedit::gateway
