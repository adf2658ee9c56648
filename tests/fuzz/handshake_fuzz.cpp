// SPDX-License-Identifier: AGPL-3.0-or-later
#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/ssl.h>

#include "actors/links/tls_identity.hpp"
#include "certs/authority.hpp"
#include "certs/openssl.hpp"
#include "tests/fuzz/promise.hpp"
#include "tests/support/scratch.hpp"

namespace {

using namespace tedit;
using actors::tls_context;
using actors::tls_side;

/// A server and a worker of one authority, which are made once.
struct two_nodes {
  two_nodes() {
    const auto ca = folder.path() / "ca";
    test::value(certs::init(ca));
    test::value(certs::issue(ca, {certs::role::server, "rack", {"localhost"}}, at("rack")));
    test::value(certs::issue(ca, {certs::role::solver, "worker", {}}, at("worker")));
    door = test::value(tls_context::make(tls_side::door, {certs::role::solver}, at("rack"),
                                         ca / certs::revoked_file));
    dial = test::value(tls_context::make(tls_side::dial, {certs::role::server}, at("worker"), {}));
  }
  [[nodiscard]] std::filesystem::path at(const char* name) const { return folder.path() / name; }

  test::scratch_folder folder;
  std::shared_ptr<const tls_context> door;
  std::shared_ptr<const tls_context> dial;
};

const two_nodes& nodes() {
  static const two_nodes made;
  return made;
}

using ssl_ptr = std::unique_ptr<SSL, certs::openssl_end<SSL_free>>;

/// One side of a connection whose bytes are in memory.
class side {
public:
  explicit side(const tls_context& context) : tls_(SSL_new(context.native())) {
    SSL_set_bio(tls_.get(), BIO_new(BIO_s_mem()), BIO_new(BIO_s_mem()));
    if (context.side() == tls_side::door)
      SSL_set_accept_state(tls_.get());
    else
      SSL_set_connect_state(tls_.get());
  }
  void give(std::span<const std::uint8_t> bytes) {
    if (!bytes.empty())
      BIO_write(SSL_get_rbio(tls_.get()), bytes.data(), static_cast<int>(bytes.size()));
  }
  /// What it has to say.
  std::vector<std::uint8_t> taken() {
    std::vector<std::uint8_t> bytes(BIO_ctrl_pending(SSL_get_wbio(tls_.get())));
    if (!bytes.empty())
      BIO_read(SSL_get_wbio(tls_.get()), bytes.data(), static_cast<int>(bytes.size()));
    return bytes;
  }
  /// Goes on as far as the bytes lead; whether it can go on once it has more.
  bool step() {
    ERR_clear_error();
    const int result = SSL_do_handshake(tls_.get());
    if (result == 1)
      return true;
    const bool waits = SSL_get_error(tls_.get(), result) == SSL_ERROR_WANT_READ;
    if (!waits) {
      const auto why = actors::explain_failure(tls_.get(), ERR_peek_error());
      fuzz::require(!actors::refusal_text(why.why).empty(), "a refusal has words");
    }
    ERR_clear_error();
    return waits;
  }
  [[nodiscard]] bool is_done() const { return SSL_is_init_finished(tls_.get()) == 1; }
  [[nodiscard]] SSL* tls() const { return tls_.get(); }

private:
  ssl_ptr tls_;
};

/// Replaces, drops or adds bytes of one flight: three bytes say where, how and what.
std::vector<std::uint8_t> damaged(std::vector<std::uint8_t> flight, fuzz::input& how) {
  for (auto changes = how.number(1) % 4; changes > 0 && !flight.empty(); --changes) {
    const auto at = static_cast<std::size_t>(how.number(2) % flight.size());
    const auto what = how.number(1);
    const auto value = static_cast<std::uint8_t>(how.number(1));
    if (what % 3 == 0)
      flight[at] = value;
    else if (what % 3 == 1)
      flight.resize(at);
    else
      flight.insert(flight.begin() + static_cast<std::ptrdiff_t>(at), value);
  }
  return flight;
}

/// An honest worker, and a network that damages what it is told to.
void shake_hands(fuzz::input in) {
  side door(*nodes().door);
  side dial(*nodes().dial);
  for (int flight = 0; flight < 6; ++flight) {
    if (!dial.step())
      return;
    door.give(damaged(dial.taken(), in));
    if (!door.step())
      return;
    dial.give(damaged(door.taken(), in));
  }
  if (!door.is_done())
    return;
  const auto peer = actors::peer_of(door.tls());
  fuzz::require(peer && peer->name == "worker" && peer->what == certs::role::solver,
                "who is let in is who it is");
}

}  // namespace

/// Either the bytes are all that a stranger says, whom the door must not let in, or they say how a
/// network damages the handshake of two honest nodes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in({data, size});
  if (in.number(1) % 2 == 1) {
    shake_hands(in);
    return 0;
  }
  side door(*nodes().door);
  door.give(in.rest());
  static_cast<void>(door.step());
  fuzz::require(!door.is_done(), "nobody is let in without a key");
  return 0;
}
