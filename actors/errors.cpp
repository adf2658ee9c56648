// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/errors.hpp"

#include <caf/actor_system.hpp>
#include <caf/atom.hpp>
#include <caf/make_message.hpp>
#include <caf/message.hpp>
#include <caf/sec.hpp>

namespace tedit::actors {

namespace {

constexpr caf::atom_value category = caf::atom("tedit");

/// What comes behind the three texts of an error.
constexpr std::size_t rival_at = 3;

bool has_texts(const caf::message& context) {
  return context.size() >= rival_at && context.match_element<std::string>(0) &&
         context.match_element<std::string>(1) && context.match_element<std::string>(2);
}

}  // namespace

caf::error to_caf(const error& e, const rival& other) {
  return {static_cast<std::uint8_t>(e.code), category,
          caf::make_message(e.message, e.remedy, e.where, other.version, other.number, other.client,
                            other.cause, other.operation, other.time)};
}

std::optional<rival> rival_in(const caf::error& e) {
  const auto& context = e.context();
  if (e.category() != category ||
      !context.match_elements<std::string, std::string, std::string, std::string, std::uint32_t,
                              std::string, std::string, std::string, std::string>())
    return std::nullopt;
  const auto text = [&](std::size_t i) { return context.get_as<std::string>(rival_at + i); };
  return rival{text(0), context.get_as<std::uint32_t>(rival_at + 1), text(2), text(3), text(4),
               text(5)};
}

caf::error to_caf(const error& e) {
  const auto code = static_cast<std::uint8_t>(e.code);
  if (e.most)
    return {code, category,
            caf::make_message(e.message, e.remedy, e.where, e.most->parameter, e.most->value)};
  return {code, category, caf::make_message(e.message, e.remedy, e.where)};
}

error from_caf(const caf::error& e, const std::string& what) {
  if (e.category() == category) {
    error result{static_cast<ec>(e.code()), what, {}, {}, {}};
    const auto& context = e.context();
    if (has_texts(context)) {
      result.message = context.get_as<std::string>(0);
      result.remedy = context.get_as<std::string>(1);
      result.where = context.get_as<std::string>(2);
    }
    if (context.match_elements<std::string, std::string, std::string, std::string, double>())
      result.most = {context.get_as<std::string>(3), context.get_as<double>(4)};
    return result;
  }
  if (e == caf::sec::request_timeout)
    return {ec::timeout, what + " did not end within its time limit", "Try again", {}};
  return {ec::service_unavailable,
          what + " failed: its worker is gone (" + caf::to_string(e) + ")",
          "The server restarts workers by itself; try again",
          {}};
}

bool worth_a_retry(const error& e) {
  return e.code == ec::service_unavailable || e.code == ec::not_found;
}

}  // namespace tedit::actors
