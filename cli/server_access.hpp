// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "client/types.hpp"

namespace tedit::cli {

/// How to connect to a running server: its URL, and the token in `token_file` or, when that is
/// empty, where "tedit serve" puts it. Errors: those of `load_config`, `token_path`, `read_token`.
[[nodiscard]] expected<client::connect_options> reach_server(const std::string& url,
                                                             const std::string& token_file);

}  // namespace tedit::cli
