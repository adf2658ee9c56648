// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cli/command.hpp"

namespace tedit::cli {

/// "tedit doc loads": the load cases of a document's current version, and changes of them.
void add_doc_loads(CLI::App& doc, action& chosen);

}  // namespace tedit::cli
