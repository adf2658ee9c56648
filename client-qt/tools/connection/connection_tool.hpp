// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

/// The server: this computer's, which is started when it is needed, or another. Says over the view
/// when it is silent or lost.
class connection_tool : public QObject {
  Q_OBJECT

public:
  explicit connection_tool(window_context& in);

  /// Runs it once there is a server; this computer's is started when there is none.
  void when_connected(std::function<void()> then);
  void connect_to(const server_address& address);
  /// Asks a person for the address.
  void ask();
  /// Whether the connection leads to this computer's own server.
  [[nodiscard]] bool is_local() const;

private:
  void show_state();
  void ask_for_trust(const untrusted_server& what);

  window_context& in_;
  std::function<void()> once_connected_;
  QString local_url_;  ///< Of this computer's server, once it runs.
};

}  // namespace tedit::desktop
