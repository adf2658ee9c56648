// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "base/error.hpp"

namespace tedit::client {

/// Servers that a person knows by the fingerprint of their certificate, in a file for its owner
/// alone: a line "HOST:PORT SHA256" for each. Lines that begin with '#' are left as they are.
class known_servers {
public:
  explicit known_servers(std::filesystem::path file) : file_(std::move(file)) {}

  /// The file of who runs this program: $XDG_STATE_HOME/tedit/known_servers (~/.local/state without
  /// the variable). Errors: `invalid_argument` when neither XDG_STATE_HOME nor HOME is set.
  [[nodiscard]] static expected<known_servers> of_user();

  /// The fingerprint of the server at `place` (`server_url::place`); empty: it is not known.
  /// Errors: `io_error`; `bad_input` for a file that is none, naming the line; `invalid_argument`
  /// when others may write to it.
  [[nodiscard]] expected<std::string> find(const std::string& place) const;

  /// From now on the server at `place` is known by this one. Errors: as `find`.
  [[nodiscard]] expected<void> remember(const std::string& place,
                                        const std::string& fingerprint) const;

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

private:
  [[nodiscard]] expected<std::string> content() const;

  std::filesystem::path file_;
};

}  // namespace tedit::client
