// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/node/membership.hpp"

#include <charconv>
#include <chrono>
#include <utility>

#include <caf/send.hpp>
#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "actors/links/dial.hpp"
#include "actors/links/link.hpp"
#include "actors/node/system_config.hpp"
#include "actors/pages/page_store.hpp"
#include "base/logging/logging.hpp"
#include "base/memory.hpp"
#include "base/processors.hpp"
#include "base/text.hpp"

namespace tedit::actors {

namespace {

/// Pages of recent versions that stay in a worker, so that the next order moves only what is new.
constexpr std::size_t recent_bytes = std::size_t{768} << 20;

}  // namespace

struct membership::impl {
  explicit impl(std::unique_ptr<dial> over) : connection(std::move(over)) {}

  ~impl() {
    // The system's end waits for all actors.
    for (const auto& one : owned)
      caf::anon_send_exit(one, caf::exit_reason::user_shutdown);
    caf::anon_send_exit(pages, caf::exit_reason::user_shutdown);
    self.reset();
    connection.reset();
  }

  std::unique_ptr<dial> connection;  ///< Null over an inherited link.
  system_config config{true};
  caf::actor_system system{config};
  std::shared_ptr<page_cache> cache = std::make_shared<page_cache>(recent_bytes);
  page_store_actor pages = system.spawn(make_page_store, cache);
  std::optional<caf::scoped_actor> self{std::in_place, system};
  caf::actor entrance;
  std::vector<caf::actor> owned;
};

membership::membership(std::unique_ptr<impl> made) : impl_(std::move(made)) {}
membership::~membership() = default;

caf::actor_system& membership::system() {
  return impl_->system;
}

const caf::actor& membership::entrance() const {
  return impl_->entrance;
}

const page_store_actor& membership::pages() const {
  return impl_->pages;
}

const std::shared_ptr<page_cache>& membership::cache() const {
  return impl_->cache;
}

caf::scoped_actor& membership::self() {
  return *impl_->self;
}

expected<std::unique_ptr<membership>> membership::join(std::unique_ptr<impl> made, unique_fd link,
                                                       const cancel_token& stop) {
  auto entrance = join_link(made->system, std::move(link), stop);
  if (!entrance)
    return fail(entrance.error());
  made->entrance = std::move(*entrance);
  (*made->self)->monitor(made->entrance);
  // Without it the process would refuse all work; it ends instead.
  (*made->self)->monitor(made->pages);
  return std::unique_ptr<membership>(new membership(std::move(made)));
}

expected<std::unique_ptr<membership>> membership::join(const join_place& where,
                                                       const cancel_token& stop) {
  auto connection = dial::connect({where.certificates, where.host, where.port}, stop);
  if (!connection)
    return fail(connection.error());
  logging::info("joined {} at {}:{}", (*connection)->server().name, where.host, where.port);
  auto link = (*connection)->take_link();
  return join(std::make_unique<impl>(std::move(*connection)), std::move(link), stop);
}

expected<std::unique_ptr<membership>> membership::join(unique_fd link, const cancel_token& stop) {
  return join(std::make_unique<impl>(nullptr), std::move(link), stop);
}

void membership::own(const caf::actor& one) {
  impl_->owned.push_back(one);
  (*impl_->self)->monitor(one);
}

bool membership::stays(std::chrono::milliseconds time) {
  bool there = true;
  (*impl_->self)
    ->receive(
      [&](const caf::down_msg& down) {
        there = false;
        if (down.source != impl_->entrance->address())
          logging::error("an actor of this worker ended: {}", caf::to_string(down.reason));
      },
      caf::after(time) >> [] {});
  return there;
}

node_facts facts_of_this_machine(std::string device, const std::string& version) {
  node_facts result;
  result.version = version;
  result.device = std::move(device);
  result.threads = processors();
  result.memory_bytes = whole_memory();
  return result;
}

std::string tidy(std::string text) {
  constexpr std::size_t longest = 200;
  std::erase_if(text, [](unsigned char c) { return c < 0x20 || c == 0x7F; });
  text = to_utf8(text);
  return std::string(cut_text(text, longest));
}

std::vector<std::string> about_this_server(const std::string& version) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return {version,
          std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(now).count())};
}

expected<server_facts> ask_about(caf::scoped_actor& self, const caf::actor& enlister) {
  expected<server_facts> result;
  self->request(enlister, std::chrono::seconds(10), about_atom::value)
    .receive(
      [&](const std::vector<std::string>& said) {
        std::int64_t ms = 0;
        const auto* const end = said.size() == 2 ? said[1].data() + said[1].size() : nullptr;
        if (end == nullptr || std::from_chars(said[1].data(), end, ms).ptr != end)
          result = fail(ec::service_unavailable, "the server does not say its version and time",
                        "Install the same version on both machines");
        else
          result = server_facts{tidy(said[0]), static_cast<double>(ms) / 1000};
      },
      [&](const caf::error&) {
        result = fail(ec::service_unavailable,
                      "the server does not answer what it is: it is busy, or of another version",
                      "Try again; else install the same version on both machines");
      });
  return result;
}

expected<void> enlist_at(caf::scoped_actor& self, const caf::actor& enlister, node_enlistment who) {
  expected<void> result;
  self->request(enlister, std::chrono::seconds(10), std::move(who))
    .receive(
      [&](const node_answer& answer) {
        if (!answer.accepted)
          result =
            fail(answer.later ? ec::service_unavailable : ec::invalid_argument,
                 "the server turned this worker away: " + tidy(answer.reason), tidy(answer.remedy));
      },
      [&](const caf::error&) {
        result = fail(ec::service_unavailable,
                      "the server did not say whether this worker may join: it is busy, or gone",
                      "Try again; it may be starting anew");
      });
  return result;
}

}  // namespace tedit::actors
