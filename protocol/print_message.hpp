// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/print/print_checks.hpp"

namespace tedit::v1 {
class CheckPrint;
class PrintChecked;
}  // namespace tedit::v1

namespace tedit::protocol {

/// Places of each kind that a message has; all are counted.
inline constexpr std::size_t most_print_places = 1000;

/// What is asked for; a direction that is not there is z, an angle 45 degrees. Errors:
/// `invalid_argument` for what is out of the ranges of print.proto, with the field's name.
[[nodiscard]] expected<print_settings> read_print_settings(const v1::CheckPrint& request);

/// Document and version are not set.
void write_print_settings(const print_settings& settings, v1::CheckPrint* out);

/// Neither document nor version are set, nor what belongs to the stream. Of each kind the largest
/// places, as many as a message may have.
void to_message(const print_settings& settings, const print_findings& found, v1::PrintChecked* out);
[[nodiscard]] print_settings settings_from(const v1::PrintChecked& message);
[[nodiscard]] print_findings findings_from(const v1::PrintChecked& message);

}  // namespace tedit::protocol
