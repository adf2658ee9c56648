// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/receipt.hpp"

namespace tedit::v1 {
class LoadPolicy;
class ReceiptLine;
}  // namespace tedit::v1

namespace tedit::protocol {

void to_message(const fem::carry_settings& settings, v1::LoadPolicy* out);

/// A kind that is not given drops. Errors: `invalid_argument` for one that this program does not
/// know: a newer client must not lose loads that it wants kept.
[[nodiscard]] expected<fem::carry_settings> from_message(const v1::LoadPolicy& message);

void to_message(const fem::receipt_line& line, v1::ReceiptLine* out);
[[nodiscard]] fem::receipt_line from_message(const v1::ReceiptLine& message);

}  // namespace tedit::protocol
