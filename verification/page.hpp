// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "verification/suite.hpp"

namespace tedit::verification {

/// What a page says besides the report.
struct page_facts {
  std::string program;  ///< Name and version of the program.
  std::string command;  ///< How to repeat it.
  std::string picture;  ///< File name of the convergence picture, beside the page; empty for none.
};

/// The report as a Markdown page: what is verified against what, how to repeat it, all figures, the
/// convergence study, and what was left out.
[[nodiscard]] std::string markdown_page(const suite_report& report, const page_facts& facts);

}  // namespace tedit::verification
