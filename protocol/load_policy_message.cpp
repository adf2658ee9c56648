// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/load_policy_message.hpp"

#include <algorithm>

#include "tedit/v1/report.pb.h"

namespace tedit::protocol {

// The messages' numbers are those of the enumerations, one later.
static_assert(static_cast<int>(fem::load_policy::drop) + 1 == v1::LoadPolicy::DROP);
static_assert(static_cast<int>(fem::load_policy::refuse) + 1 == v1::LoadPolicy::REFUSE);
static_assert(static_cast<int>(fem::receipt_fate::kept) + 1 == v1::ReceiptLine::KEPT);
static_assert(static_cast<int>(fem::receipt_fate::moved) + 1 == v1::ReceiptLine::MOVED);

void to_message(const fem::carry_settings& settings, v1::LoadPolicy* out) {
  out->set_kind(static_cast<v1::LoadPolicy::Kind>(static_cast<int>(settings.policy) + 1));
  out->set_keep_traction(settings.keep_traction);
}

expected<fem::carry_settings> from_message(const v1::LoadPolicy& message) {
  if (message.kind() < v1::LoadPolicy::KIND_UNSPECIFIED || message.kind() > v1::LoadPolicy::REFUSE)
    return fail(ec::invalid_argument, "there is no such policy for loads",
                "Take DROP, MOVE or REFUSE");
  const int number = std::max(0, static_cast<int>(message.kind()) - 1);
  return fem::carry_settings{static_cast<fem::load_policy>(number), message.keep_traction()};
}

void to_message(const fem::receipt_line& line, v1::ReceiptLine* out) {
  out->set_load_case(line.load_case);
  out->set_item(line.item);
  out->set_fate(static_cast<v1::ReceiptLine::Fate>(static_cast<int>(line.fate) + 1));
  out->mutable_surfaces_lost()->Assign(line.surfaces_lost.begin(), line.surfaces_lost.end());
  out->set_area_before_m2(line.area_before);
  out->set_area_after_m2(line.area_after);
  out->set_text(line.text);
  out->mutable_moved_to()->Assign(line.moved_to.begin(), line.moved_to.end());
  out->set_total_before_n(line.total_before);
  out->set_total_after_n(line.total_after);
  out->set_warning(line.warning);
}

fem::receipt_line from_message(const v1::ReceiptLine& m) {
  fem::receipt_line line;
  line.load_case = m.load_case();
  line.item = m.item();
  const int fate = std::clamp<int>(m.fate(), v1::ReceiptLine::KEPT, v1::ReceiptLine::MOVED) - 1;
  line.fate = static_cast<fem::receipt_fate>(fate);
  line.surfaces_lost.assign(m.surfaces_lost().begin(), m.surfaces_lost().end());
  line.area_before = m.area_before_m2();
  line.area_after = m.area_after_m2();
  line.text = m.text();
  line.moved_to.assign(m.moved_to().begin(), m.moved_to().end());
  line.total_before = m.total_before_n();
  line.total_after = m.total_after_n();
  line.warning = m.warning();
  return line;
}

}  // namespace tedit::protocol
