// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/print_check.hpp"

#include <algorithm>
#include <functional>

#include "client/impl.hpp"
#include "protocol/print_message.hpp"

namespace tedit::client {

expected<print_check> read_print_check(const v1::PrintChecked& message,
                                       const incoming_stream& stream) {
  print_check result{message.version(),
                     message.version_id(),
                     protocol::settings_from(message),
                     protocol::findings_from(message),
                     message.thin_places(),
                     message.overhanging_places()};
  auto facets = stream.u32("facets", 1);
  if (!facets)
    return fail(facets.error());
  const auto marks = stream.bytes("marks");
  if (!marks)
    return fail(marks.error());
  const auto is_mark = [](char c) {
    return c >= static_cast<char>(print_mark::thin) && c <= static_cast<char>(print_mark::both);
  };
  if (marks->size() != facets->size() || !std::ranges::all_of(*marks, is_mark) ||
      std::ranges::adjacent_find(*facets, std::greater_equal<>{}) != facets->end())
    return fail(ec::protocol_error, "the marks of a check for printing do not fit to its " +
                                      std::to_string(facets->size()) + " facets");
  result.facets = std::move(*facets);
  for (const char c : *marks)
    result.marks.push_back(static_cast<print_mark>(c));
  return result;
}

expected<print_check> client::check_print(const print_settings& settings,
                                          std::optional<std::uint32_t> version,
                                          const execution& run) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  auto* wanted = request.mutable_check_print();
  protocol::write_print_settings(settings, wanted);
  wanted->set_document(*document);
  if (version)
    wanted->set_version(*version);
  auto got = impl_->ask(std::move(request), body::kPrintChecked, run);
  if (!got)
    return fail(std::move(got.error()));
  return read_print_check(got->message.print_checked(), *got->bulk);
}

}  // namespace tedit::client
