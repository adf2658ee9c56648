// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>
#include <type_traits>

#include "client/client.hpp"

namespace tedit::desktop {

/// Where a server is reached.
struct server_address {
  QString url;    ///< "ws://HOST:PORT/v1", or "wss://..." with TLS.
  QString token;  ///< Proves that we may use it.
  /// How long it may take to answer when it is connected to.
  std::chrono::milliseconds patience{5000};
};

/// A server of wss:// whose certificate is not trusted.
struct untrusted_server {
  std::string place;  ///< "HOST:PORT".
  client::server_certificate certificate;
  std::string known;  ///< Fingerprint of the one that is trusted; empty: none is.
};

/// A request that runs; copies share it.
class ticket {
public:
  /// Asks the server to end it; the reply is then an error `cancelled`, unless it was done.
  void cancel() const { token_.cancel(); }
  [[nodiscard]] const cancel_token& token() const { return token_; }

private:
  cancel_token token_;
};

/// The connection to a server, as the event loop wants it: nothing here waits. Requests run on
/// threads of their own; replies, progress and events come on this object's thread. A lost
/// connection is taken up again by itself. Not thread-safe: use it on its own thread.
class remote : public QObject {
  Q_OBJECT

public:
  enum class state { offline, connecting, connected, lost };

  explicit remote(QObject* parent = nullptr);
  ~remote() override;  ///< Ends the connection and what runs on it.

  /// Connects, instead of to the server before. `connected` or `refused` follows.
  void connect_to(const server_address& address);
  /// Ends the connection; `state_changed` follows.
  void disconnect_now();

  [[nodiscard]] state current() const noexcept { return state_; }
  [[nodiscard]] const server_address& address() const noexcept { return address_; }
  /// For a connection of one's own to the same server. One that is known by its certificate
  /// (client/known_servers.hpp) must show that one.
  [[nodiscard]] client::connect_options options() const;
  /// Requests that have no answer yet.
  [[nodiscard]] int running() const noexcept { return running_; }
  /// Time of the last status request to its answer, ms; negative before the first.
  [[nodiscard]] double latency_ms() const noexcept { return latency_ms_; }
  /// How the server and its workers were at the last status request.
  [[nodiscard]] const client::server_status& server() const noexcept { return server_; }
  /// How long the last status request has been without its answer, ms; 0 when it has it.
  [[nodiscard]] double silence_ms() const;
  /// The server's program and version, as it names them; empty without a connection.
  [[nodiscard]] QString program() const;
  /// What kinds of mesh files it reads and writes; offline those that are usual.
  [[nodiscard]] std::vector<client::offered_format> formats() const;
  /// The surface of the open document as it is held now. Cheap.
  [[nodiscard]] client::surface_model surface() const;

  template <class T>
  using work = std::function<expected<T>(client::client&, const execution&)>;
  template <class T>
  using reply = std::function<void(expected<T>)>;
  using progress = std::function<void(double fraction, const QString& stage)>;

  /// Runs a blocking call of the client library aside. `done` is called once, here; not any more
  /// when this object is gone. Without a connection it is called with `service_unavailable`.
  template <class T>
  ticket run(work<T> call, reply<T> done, const progress& advanced = {}) {
    auto result = std::make_shared<expected<T>>(fail(not_connected()));
    return start([call = std::move(call), result](client::client& c,
                                                  const execution& e) { *result = call(c, e); },
                 [done = std::move(done), result] { done(std::move(*result)); }, advanced);
  }

signals:
  void state_changed();  ///< Also while the server is silent.
  void connected();      ///< Also again after the connection was lost.
  void refused(const tedit::error& reason);
  /// After `refused`, when the server's certificate was the reason.
  void untrusted(const tedit::desktop::untrusted_server& what);
  void surface_arrived(const tedit::client::surface_event& event);
  void field_arrived(std::shared_ptr<const tedit::client::field_event> field);
  void committed(const tedit::client::committed& what);
  void load_cases_changed(const tedit::client::load_cases_event& event);
  void annotated(const tedit::client::version_info& version);
  /// How it stands on the CAD model has become known.
  void cad_known(const tedit::client::version_info& version);
  /// Somebody else opened the document; `gone`: has it open no more.
  void participant_changed(const tedit::client::participant& who, bool gone);
  void renamed(const QString& document);
  /// The server sends more than comes through.
  void fell_behind(const tedit::client::backlog& what);
  void solve_status(const tedit::client::solve_status& status);
  void solved(const tedit::solve_outcome& outcome);

private:
  using shared_client = std::shared_ptr<client::client>;

  ticket start(std::function<void(client::client&, const execution&)> call,
               std::function<void()> done, progress advanced);
  [[nodiscard]] static error not_connected();
  [[nodiscard]] client::events make_events();
  void try_connect();
  void connection_made(expected<shared_client> made, int generation,
                       const client::server_certificate& shown);
  void not_connected_because(const error& reason, const client::server_certificate& shown);
  void watch();
  void measure_latency();
  void set_state(state next);
  void drop_client();

  server_address address_;
  shared_client client_;
  state state_ = state::offline;
  QThreadPool pool_;
  QTimer watch_;
  QTimer retry_;
  int retry_ms_ = 0;
  int generation_ = 0;  ///< Of the connection: events of an earlier one are not for us.
  int running_ = 0;
  int beats_ = 0;
  bool asks_status_ = false;
  QElapsedTimer asked_;  ///< Since the last status request.
  double latency_ms_ = -1;
  client::server_status server_;
};

}  // namespace tedit::desktop
