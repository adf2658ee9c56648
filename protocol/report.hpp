// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "edit/report.hpp"
#include "fem/solve_report.hpp"

namespace tedit::v1 {
class EditReport;
class Envelope;
class Solved;
class SolveReport;
}  // namespace tedit::v1

namespace tedit::protocol {

void to_message(const edit_report& report, v1::EditReport* out);
[[nodiscard]] edit_report from_message(const v1::EditReport& message);
void to_message(const solve_report& report, v1::SolveReport* out);
[[nodiscard]] solve_report from_message(const v1::SolveReport& message);
void to_message(const solve_envelope& envelope, v1::Envelope* out);
[[nodiscard]] solve_envelope from_message(const v1::Envelope& message);
/// The document is not set.
void to_message(const solve_outcome& outcome, v1::Solved* out);
/// A message without any report gives one that is empty.
[[nodiscard]] solve_outcome from_message(const v1::Solved& message);

}  // namespace tedit::protocol
