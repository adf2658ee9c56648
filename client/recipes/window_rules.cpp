// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/recipes/window_rules.hpp"

#include <algorithm>

namespace tedit::client {

namespace {

using check = void (*)(const json& value, const std::string& what);

struct field {
  const char* name;
  check is;
  bool needed = true;
};

/// `own`: the field that `what` names already.
void check_fields(const json& value, const std::vector<field>& fields, const std::string& what,
                  const std::string& own = {}) {
  if (!value.is_object())
    refuse(what + " must be {\"" + fields.front().name + "\": ..., ...}");
  for (const auto& one : fields) {
    if (value.contains(one.name))
      one.is(value[one.name], own == one.name ? what : what + ": \"" + one.name + "\"");
    else if (one.needed)
      refuse(what + " needs \"" + one.name + "\"");
  }
  for (const auto& [name, given] : value.items())
    if (std::ranges::none_of(fields, [&](const auto& one) { return name == one.name; }))
      refuse(what + " has an unknown field \"" + name + "\"");
}

// -- sorts of values -------------------------------------------------------------------------

void flag(const json& value, const std::string& what) {
  flag_from(value, what);
}

void text(const json& value, const std::string& what) {
  text_from(value, what);
}

template <std::int64_t least, std::int64_t most>
void whole(const json& value, const std::string& what) {
  whole_from(value, what);
  number_from(value, {static_cast<double>(least), static_cast<double>(most), {}}, what);
}
constexpr check pin = whole<1, 1'000'000>;
constexpr check pixels_across = whole<320, 16'384>;  // The view is never smaller.
constexpr check pixels_up = whole<240, 16'384>;

template <check is, std::size_t least, std::size_t most>
void list(const json& value, const std::string& what) {
  for (const auto& one : list_from(value, least, most, what))
    is(one, "each of " + what);
}

void id(const json& value, const std::string& what) {
  whole_from(value, what);
}
constexpr check ids = list<id, 0, most_ids>;

void length(const json& value, const std::string& what) {
  number_from(value, {-1e6, 1e6, "m"}, what);
}
constexpr check point = list<length, 3, 3>;

void size(const json& value, const std::string& what) {
  number_from(value, {1e-9, 1e6, "m"}, what);
}

void factor(const json& value, const std::string& what) {
  number_from(value, {-1e9, 1e9, {}}, what);
}

void screen_way(const json& value, const std::string& what) {
  number_from(value, {-16'384, 16'384, {}}, what);
}

void part(const json& value, const std::string& what) {
  number_from(value, {0, 1, {}}, what);
}

void camera(const json& value, const std::string& what) {
  check_fields(value,
               {{"position", point},
                {"focus", point},
                {"up", point},
                {"scale", size, false},
                {"parallel", flag, false}},
               what);
}

void section(const json& value, const std::string& what) {
  if (!value.is_null())
    check_fields(value, {{"at", point}, {"normal", point}}, what);
}

void probe(const json& value, const std::string& what) {
  check_fields(value, {{"number", pin}, {"surface", id}, {"at", point}}, what);
}

void wall(const json& value, const std::string& what) {
  number_from(value, {1e-9, 1e3, "m"}, what);
}

void lean(const json& value, const std::string& what) {
  number_from(value, {0, 90, "degrees"}, what);
}

void print_limits(const json& value, const std::string& what) {
  if (!value.is_null())
    check_fields(
      value,
      {{"thinner_than", wall, false}, {"overhang", lean, false}, {"direction", point, false}},
      what);
}

void patience(const json& value, const std::string& what) {
  if (value != "ready" && value != "final")
    refuse(what + " must be \"ready\" or \"final\"");
}

/// The fields of each kind; its own is the first.
const std::vector<std::vector<field>>& kinds() {
  static const std::vector<std::vector<field>> all{
    {{"click", id}},
    {{"select", ids}},
    {{"choose", text}},
    {{"drag", whole<0, 10'000>}},
    {{"drag_handle", text},
     {"by", list<screen_way, 2, 2>},
     {"moves", whole<1, 10'000>, false},
     {"held", flag, false}},
    {{"command", text}},
    {{"field", text}},
    {{"case", text}},
    {{"deform", factor}},
    {{"bands", whole<0, 1000>}},
    {{"isolines", flag}},
    {{"view", text}},
    {{"camera", camera}},
    {{"section", section}},
    {{"print_check", print_limits}},
    {{"box", list<part, 4, 4>}, {"enclosed", flag, false}},
    {{"hidden", ids}},
    {{"probe", probe}},
    {{"remove_probe", pin}},
    {{"measure", list<pin, 0, 1000>}},
    {{"wait", patience}},
    {{"report", text}},
    {{"screenshot", text},
     {"width", pixels_across, false},
     {"height", pixels_up, false},
     {"window", flag, false}}};
  return all;
}

}  // namespace

std::string window_kinds() {
  std::string result;
  for (const auto& fields : kinds())
    result += std::string(", ") + fields.front().name;
  return result;
}

bool is_window_kind(const std::string& name) {
  return std::ranges::any_of(kinds(), [&](const auto& own) { return name == own.front().name; });
}

void check_window_step(const json& step, const std::string& kind, const std::string& where) {
  for (const auto& fields : kinds())
    if (kind == fields.front().name)
      check_fields(step, fields, where, kind);
}

}  // namespace tedit::client
