// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <iosfwd>
#include <mutex>

#include "client/client.hpp"
#include "client/connection.hpp"

namespace tedit::client {

using body = v1::ServerMessage;

template <class Request>
void set_terms(const change_terms& terms, Request& request) {
  request.set_expected_version(terms.expected_version);
  request.set_edit_id(terms.edit_id);
}

/// What a client is made of; its requests are spread over client.cpp, comparison.cpp, files.cpp,
/// library.cpp, notes.cpp and print_check.cpp.
struct client::impl {
  impl(const connect_options& given, events handlers)
      : options(given), link(follow_renames(std::move(handlers))) {}

  /// Requests have the new name before anybody is told.
  events follow_renames(events handlers) {
    handlers.on_renamed = [this, tell = std::move(handlers.on_renamed)](const std::string& name) {
      {
        const std::lock_guard lock(mutex);
        if (!document.empty())
          document = name;
      }
      if (tell)
        tell(name);
    };
    return handlers;
  }

  /// A request that is answered soon.
  expected<connection::answer> ask(v1::ClientMessage request, body::BodyCase wanted) {
    return link.ask(std::move(request), wanted, options.request_timeout, {});
  }

  /// A request that takes its time.
  expected<connection::answer> ask(v1::ClientMessage request, body::BodyCase wanted,
                                   const execution& run) {
    return link.ask(std::move(request), wanted, options.long_request_timeout, run);
  }

  /// Errors: `invalid_argument` when no document is open.
  expected<std::string> open_document() {
    const std::lock_guard lock(mutex);
    if (document.empty())
      return fail(ec::invalid_argument, "no document is open", "Open a document first.");
    return document;
  }

  expected<void> close_document();
  expected<v1::ApplyEdit> describe_edit(const std::string& operation,
                                        const std::vector<surface_id>& surfaces,
                                        const ops::parameters& values,
                                        const std::string& expected_version,
                                        const fem::carry_settings& loads);
  expected<void> send_pieces(std::ifstream& file, std::uint64_t size, std::uint64_t upload,
                             std::uint64_t first_id, const execution& run);
  expected<connection::answer> ask_with_file(std::ifstream& file, std::uint64_t size,
                                             std::uint64_t upload, v1::ClientMessage request,
                                             body::BodyCase wanted, const execution& run);
  /// Sends the file, then the request that makes a document of it.
  expected<connection::answer> ask_for_document(v1::ClientMessage request,
                                                const std::filesystem::path& path,
                                                const execution& run);

  /// Bytes of one piece of an upload.
  [[nodiscard]] std::uint64_t piece() const {
    constexpr std::uint64_t piece_bytes = std::uint64_t{256} << 10;
    constexpr std::uint64_t piece_overhead = 256;  // Room for all of the message beside its data.
    const auto largest = link.max_message();
    return std::min(piece_bytes, largest > 2 * piece_overhead ? largest - piece_overhead : 1);
  }

  const connect_options options;
  connection link;
  std::atomic<std::uint64_t> next_upload{1};
  std::mutex mutex;
  std::string document;  ///< The open one; guarded.
};

}  // namespace tedit::client
