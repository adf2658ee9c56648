// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "client/client.hpp"

namespace tedit::test {

/// The value of an expected; throws its error's words when there is none.
template <class T>
T value(expected<T> result) {
  if (!result)
    throw std::runtime_error(render(result.error()));
  return std::move(*result);
}

/// A client that does what it likes, on threads of its own, for as long as the object lives.
class bad_client {
public:
  bad_client() = default;
  bad_client(const bad_client&) = delete;
  bad_client& operator=(const bad_client&) = delete;
  virtual ~bad_client() = default;

  /// What it has done, in a few words.
  [[nodiscard]] virtual std::string deeds() const { return "no neighbour"; }
};

/// Keeps so many exports of a document asked for, and reads what comes.
std::unique_ptr<bad_client> make_exporter(const client::connect_options& server,
                                          const std::string& document, int at_once);

/// Asks for so many exports and never reads a byte.
std::unique_ptr<bad_client> make_deaf(const client::connect_options& server,
                                      const std::string& document, int exports);

/// Keeps up to 300 connections that never finish their handshake, and opens new ones without pause:
/// connected only, half a header, no Hello.
std::unique_ptr<bad_client> make_half_open(const client::connect_options& server);

/// Tries wrong tokens on eight threads as fast as it can.
std::unique_ptr<bad_client> make_guesser(const client::connect_options& server);

}  // namespace tedit::test
