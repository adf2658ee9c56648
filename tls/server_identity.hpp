// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/file_stamp.hpp"
#include "tls/context.hpp"

namespace tedit::tls {

/// The files of a public authority's certificate, as its programs leave them.
inline constexpr auto chain_file = "fullchain.pem";
inline constexpr auto chain_key_file = "privkey.pem";

/// What a server shows who connects, from a folder whose files may change while it runs: they are
/// loaded again when they do. The folder is what "tedit certs issue --role server" makes, or has
/// `fullchain.pem` and `privkey.pem`. One thread at a time.
class server_identity {
public:
  /// Errors: `io_error`, `bad_input`, `invalid_argument`, naming the file: missing, cut off, open
  /// to others, not belonging together, ended, of another role than server.
  [[nodiscard]] static expected<server_identity> load(const std::filesystem::path& folder);

  /// Loads again what changed since the last look; on an error the state before goes on, and the
  /// error comes once for each change. Cost: two `stat`; loading some milliseconds.
  [[nodiscard]] expected<void> look();

  [[nodiscard]] const std::shared_ptr<const context>& how() const { return state_.how; }
  [[nodiscard]] const std::string& fingerprint() const { return state_.fingerprint; }
  /// For which it holds, as a Host header has them: IPv6 in brackets.
  [[nodiscard]] const std::vector<std::string>& hosts() const { return state_.hosts; }
  /// When it ends; seconds since 1970.
  [[nodiscard]] std::int64_t until() const { return state_.until; }

private:
  struct state {
    std::shared_ptr<const context> how;
    std::string fingerprint;
    std::vector<std::string> hosts;
    std::int64_t until = 0;
  };
  using stamps = std::array<file_stamp, 2>;

  server_identity() = default;
  [[nodiscard]] expected<state> read() const;

  std::filesystem::path certificate_;
  std::filesystem::path key_;
  bool ours_ = false;  ///< Of "tedit certs": it says its role.
  stamps seen_{};
  state state_;
};

}  // namespace tedit::tls
