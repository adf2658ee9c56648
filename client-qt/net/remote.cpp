// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/net/remote.hpp"

#include <QMetaObject>

#include <algorithm>
#include <tuple>

#include "client/known_servers.hpp"
#include "client/server_url.hpp"

namespace tedit::desktop {

namespace {

using namespace std::chrono_literals;

constexpr int watch_ms = 500;
constexpr int beats_a_status = 6;  // One status request every three seconds.
constexpr double noticeable_ms = 1000;
constexpr int first_retry_ms = 500;
constexpr int longest_retry_ms = 8000;
constexpr int most_requests = 16;  // Threads that wait for answers; more wait in the pool.

/// Empty for a server that is not known by its certificate.
std::string known_fingerprint(const std::string& url) {
  const auto where = client::parse_server_url(url);
  const auto known = client::known_servers::of_user();
  if (!where || !where->secure || !known)
    return {};
  return known->find(where->place()).value_or(std::string());
}

}  // namespace

remote::remote(QObject* parent) : QObject(parent) {
  pool_.setMaxThreadCount(most_requests);
  watch_.setInterval(watch_ms);
  connect(&watch_, &QTimer::timeout, this, &remote::watch);
  retry_.setSingleShot(true);
  connect(&retry_, &QTimer::timeout, this, &remote::try_connect);
}

remote::~remote() {
  drop_client();
  pool_.waitForDone();
}

// -- the connection ------------------------------------------------------------------

void remote::connect_to(const server_address& address) {
  disconnect_now();
  address_ = address;
  retry_ms_ = 0;
  try_connect();
}

void remote::disconnect_now() {
  retry_.stop();
  drop_client();
  set_state(state::offline);
}

/// A client is destroyed where its last call ends; nobody waits for that here.
void remote::drop_client() {
  watch_.stop();
  ++generation_;
  if (client_) {
    client_->abort();
    pool_.start([old = std::exchange(client_, nullptr)]() mutable { old.reset(); });
  }
}

client::connect_options remote::options() const {
  client::connect_options result;
  result.url = address_.url.toStdString();
  result.token = address_.token.toStdString();
  result.client_name = "tedit-qt " TEDIT_VERSION;
  result.timeout = address_.patience;
  result.trust.fingerprint = known_fingerprint(result.url);
  return result;
}

void remote::try_connect() {
  if (state_ != state::lost)
    set_state(state::connecting);
  const int generation = ++generation_;
  auto handlers = make_events();
  pool_.start([this, options = options(), generation, handlers = std::move(handlers)]() mutable {
    client::server_certificate shown;
    options.trust.on_certificate = [&](const client::server_certificate& one) { shown = one; };
    auto made = client::client::connect(options, handlers);
    auto shared = made ? expected<shared_client>(shared_client(std::move(*made)))
                       : expected<shared_client>(fail(std::move(made.error())));
    QMetaObject::invokeMethod(
      this,
      [this, shared = std::move(shared), generation, shown] {
        connection_made(shared, generation, shown);
      },
      Qt::QueuedConnection);
  });
}

void remote::connection_made(expected<shared_client> made, int generation,
                             const client::server_certificate& shown) {
  if (generation != generation_)
    return;
  if (made) {
    client_ = std::move(*made);
    retry_ms_ = 0;
    watch_.start();
    set_state(state::connected);
    emit connected();
    measure_latency();
    return;
  }
  not_connected_because(made.error(), shown);
}

/// One that shows another certificate by now is not asked again and again.
void remote::not_connected_because(const error& reason, const client::server_certificate& shown) {
  if (state_ == state::lost && reason.code != ec::untrusted_server) {
    retry_ms_ = std::clamp(2 * retry_ms_, first_retry_ms, longest_retry_ms);
    retry_.start(retry_ms_);
    return;
  }
  set_state(state::offline);
  emit refused(reason);
  const auto where = client::parse_server_url(address_.url.toStdString());
  if (reason.code == ec::untrusted_server && where)
    emit untrusted({where->place(), shown, known_fingerprint(address_.url.toStdString())});
}

void remote::watch() {
  if (client_ && !client_->connected()) {
    drop_client();
    set_state(state::lost);
    retry_ms_ = first_retry_ms;
    retry_.start(retry_ms_);
  } else if (++beats_ % beats_a_status == 0) {
    measure_latency();
  }
  if (silence_ms() > noticeable_ms)
    emit state_changed();
}

double remote::silence_ms() const {
  return asks_status_ && state_ == state::connected ? static_cast<double>(asked_.elapsed()) : 0;
}

void remote::measure_latency() {
  if (std::exchange(asks_status_, true))
    return;
  asked_.start();
  auto clock = std::make_shared<QElapsedTimer>();
  using answer = std::pair<double, client::server_status>;
  run<answer>(
    [clock](client::client& c, const execution&) -> expected<answer> {
      clock->start();
      auto status = c.status();
      if (!status)
        return fail(std::move(status.error()));
      return answer(static_cast<double>(clock->nsecsElapsed()) * 1e-6, std::move(*status));
    },
    [this](expected<answer> got) {
      asks_status_ = false;
      if (got)
        std::tie(latency_ms_, server_) = std::move(*got);
      emit state_changed();
    });
}

void remote::set_state(state next) {
  if (std::exchange(state_, next) != next)
    emit state_changed();
}

// -- requests ------------------------------------------------------------------------

error remote::not_connected() {
  return {ec::service_unavailable,
          "there is no connection to a server",
          "Wait until it is back, or connect to another one",
          {}};
}

ticket remote::start(std::function<void(client::client&, const execution&)> call,
                     std::function<void()> done, progress advanced) {
  ticket result;
  execution run;
  run.cancel = result.token();
  if (advanced)
    run.progress = [this, advanced = std::move(advanced)](double fraction, std::string_view stage) {
      QMetaObject::invokeMethod(
        this,
        [advanced, fraction,
         text = QString::fromUtf8(stage.data(), static_cast<qsizetype>(stage.size()))] {
          advanced(fraction, text);
        },
        Qt::QueuedConnection);
    };
  ++running_;
  pool_.start([this, client = client_, call = std::move(call), done = std::move(done), run] {
    if (client)
      call(*client, run);
    QMetaObject::invokeMethod(
      this,
      [this, done] {
        --running_;
        done();
        emit state_changed();
      },
      Qt::QueuedConnection);
  });
  return result;
}

QString remote::program() const {
  return client_ ? QString::fromStdString(client_->server_program()) : QString();
}

std::vector<client::offered_format> remote::formats() const {
  return client_ ? client_->formats() : client::usual_formats();
}

client::surface_model remote::surface() const {
  return client_ ? client_->surface() : client::surface_model{};
}

// -- events --------------------------------------------------------------------------

/// The handlers run on the client's I/O thread; each hands its event over and returns.
client::events remote::make_events() {
  const int mine = generation_;  // Of the connection that is being made.
  const auto here = [this, mine](auto emit_it) {
    QMetaObject::invokeMethod(
      this,
      [this, mine, emit_it] {
        if (mine == generation_)
          emit_it();
      },
      Qt::QueuedConnection);
  };
  client::events handlers;
  handlers.on_surface = [this, here](const client::surface_event& event) {
    here([this, event] { emit surface_arrived(event); });
  };
  handlers.on_field = [this, here](const client::field_event& field) {
    here([this, kept = std::make_shared<const client::field_event>(field)] {
      emit field_arrived(kept);
    });
  };
  handlers.on_committed = [this, here](const client::committed& what) {
    here([this, what] { emit committed(what); });
  };
  handlers.on_load_cases = [this, here](const client::load_cases_event& event) {
    here([this, event] { emit load_cases_changed(event); });
  };
  handlers.on_annotated = [this, here](const client::version_info& version) {
    here([this, version] { emit annotated(version); });
  };
  handlers.on_cad = [this, here](const client::version_info& version) {
    here([this, version] { emit cad_known(version); });
  };
  handlers.on_participant = [this, here](const client::participant& who, bool gone) {
    here([this, who, gone] { emit participant_changed(who, gone); });
  };
  handlers.on_renamed = [this, here](const std::string& name) {
    here([this, name = QString::fromStdString(name)] { emit renamed(name); });
  };
  handlers.on_backlog = [this, here](const client::backlog& what) {
    here([this, what] { emit fell_behind(what); });
  };
  handlers.on_solve_status = [this, here](const client::solve_status& status) {
    here([this, status] { emit solve_status(status); });
  };
  handlers.on_solved = [this, here](const solve_outcome& outcome) {
    here([this, outcome] { emit solved(outcome); });
  };
  return handlers;
}

}  // namespace tedit::desktop
