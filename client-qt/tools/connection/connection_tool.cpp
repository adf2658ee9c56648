// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/connection/connection_tool.hpp"

#include <QInputDialog>
#include <QMainWindow>

#include <cmath>
#include <utility>

#include "client-qt/model/quantities.hpp"
#include "client-qt/tools/connection/trust_dialog.hpp"
#include "client/known_servers.hpp"

namespace tedit::desktop {

static constexpr double silent_ms = 4000;  // Then a person wonders.

connection_tool::connection_tool(window_context& in) : in_(in) {
  connect(&in_.server, &local_server::ready, this,
          [this](const server_address& address) { local_url_ = address.url; });
  connect(&in_.server, &local_server::ready, &in_.link, &remote::connect_to);
  connect(&in_.server, &local_server::failed, this,
          [this](const error& reason) { emit in_.part.failed(tr("Start the server"), reason); });
  connect(&in_.link, &remote::connected, this, [this] {
    in_.log.write(tr("connected to %1").arg(in_.link.address().url));
    if (auto then = std::exchange(once_connected_, nullptr))
      then();
  });
  connect(&in_.link, &remote::refused, this,
          [this](const error& reason) { emit in_.part.failed(tr("Connect"), reason); });
  connect(&in_.link, &remote::untrusted, this, &connection_tool::ask_for_trust);
  connect(&in_.link, &remote::state_changed, this, &connection_tool::show_state);
}

bool connection_tool::is_local() const {
  return in_.link.address().url == local_url_;
}

void connection_tool::when_connected(std::function<void()> then) {
  const bool starts_anew = is_local() && in_.server.is_starting();
  if (in_.link.current() == remote::state::connected && !starts_anew) {
    then();
    return;
  }
  once_connected_ = std::move(then);
  if (in_.link.current() == remote::state::offline)
    in_.server.start();
}

void connection_tool::connect_to(const server_address& address) {
  in_.part.files().close();
  in_.link.connect_to(address);
}

void connection_tool::show_state() {
  const auto& link = in_.link;
  if (link.current() == remote::state::lost)
    in_.messages.show_standing(
      tr("The connection to the server is lost. It is taken up again by itself; nothing that was "
         "done is lost."));
  else if (link.silence_ms() > silent_ms)
    in_.messages.show_standing(
      tr("The connection is slow: the server has not answered for %1. What was asked for goes on "
         "when it does, and can be cancelled.")
        .arg(duration(1000 * std::floor(link.silence_ms() / 1000))));
  else if (link.current() == remote::state::connected)
    in_.messages.clear_standing();
}

void connection_tool::ask_for_trust(const untrusted_server& what) {
  auto* dialog = new trust_dialog(what, &in_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, what] {
    const auto kept =
      client::known_servers::of_user().and_then([&](const client::known_servers& known) {
        return known.remember(what.place, what.certificate.fingerprint);
      });
    if (!kept)
      emit in_.part.failed(tr("Connect"), kept.error());
    else
      in_.link.connect_to(in_.link.address());
  });
  dialog->open();
}

void connection_tool::ask() {
  auto* dialog = new QInputDialog(&in_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Connect to a server"));
  dialog->setLabelText(
    tr("Address and token, as \"tedit serve\" prints them: ws://HOST:PORT/v1 TOKEN"));
  connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& text) {
    const auto parts = text.split(' ', Qt::SkipEmptyParts);
    if (parts.size() == 2)
      connect_to({parts[0], parts[1]});
  });
  dialog->open();
}

}  // namespace tedit::desktop
