// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/loader/number_texts.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "ops/loader/picks.hpp"

namespace tedit::ops {

namespace {

/// Of numbers in a list, of points in a polyline.
constexpr std::size_t most_items = 10'000;

/// Places of the part in one text: each takes a walk over its surfaces.
constexpr std::size_t most_picks = 100;

/// Numbers between semicolons.
using number_group = std::vector<double>;
using number_groups = std::vector<number_group>;

const char* form_of(parameter_type type) {
  switch (type) {
    case parameter_type::axis:
      return "it is a point and a direction, as \"0, 0, 1; 0, 0, 1\"";
    case parameter_type::plane:
      return "it is a point and a normal, as \"0, 0, 1; 0, 0, 1\"";
    case parameter_type::polyline:
      return "it is points of three numbers each, as \"0, 0, 0; 1, 0, 0; 1, 2.5, 0\"";
    case parameter_type::list:
      return "it is numbers, as \"0.5, 1, 2\"";
    default:
      return "it is three numbers, as \"1, 2.5, 0\"";
  }
}

bool is_gap(char c) {
  return c == ' ' || c == ',' || c == '\t' || c == '\n' || c == '\r';
}

/// The numbers of a text without semicolons; nothing where a word is none, or there are too many.
std::optional<number_group> group_in(std::string_view text) {
  number_group group;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    if (is_gap(*at)) {
      ++at;
      continue;
    }
    double number = 0;
    const auto [next, code] = std::from_chars(at, end, number);
    if (code != std::errc{} || (next != end && !is_gap(*next)) || group.size() == 3 * most_items)
      return std::nullopt;
    group.push_back(number);
    at = next;
  }
  return group;
}

bool is_both(parameter_type type) {
  return type == parameter_type::axis || type == parameter_type::plane;
}

void append(number_group& to, vec3 v) {
  to.insert(to.end(), {v.x, v.y, v.z});
}

/// What a place of the part is as the value, or as the given one of its points.
expected<number_group> numbers_at(const parameter_description& p, const mesh_version* mesh,
                                  std::string_view text, std::size_t nth, bool alone) {
  if (!mesh)
    return wrong_value(p, "\"" + std::string(text.substr(0, 60)) +
                            "\" is a place of a part, and there is no part to look at");
  const auto found = find_pick(*mesh, text);
  if (!found)
    return fail(found.error().code, "parameter " + p.id + ": " + found.error().message,
                found.error().remedy);
  number_group result;
  if (alone && p.type == parameter_type::polyline) {
    for (const auto& point : found->polyline)
      append(result, point);
    if (result.empty())
      return wrong_value(p, "only an edge gives all points of a polyline");
    return result;
  }
  const bool whole = alone && is_both(p.type);
  const bool way = p.type == parameter_type::direction || (is_both(p.type) && (whole || nth == 1));
  if (way && norm(found->direction) == 0)
    return wrong_value(p,
                       "what is there is neither flat, round nor straight, and has no direction");
  if (whole || !way)
    append(result, found->point);
  if (way)
    append(result, found->direction);
  return result;
}

/// Directions are no lengths: they stay as they are in millimetres.
void scale_lengths(parameter_type type, double scale, std::size_t nth, number_group& numbers) {
  if (type == parameter_type::direction || (is_both(type) && nth > 0))
    return;
  for (std::size_t i = 0;
       i < (is_both(type) ? std::min<std::size_t>(3, numbers.size()) : numbers.size()); ++i)
    numbers[i] *= scale;
}

/// In SI. Errors: where a group but the last is empty, too, or there are too many.
expected<number_groups> groups_in(const parameter_description& p, std::string_view text,
                                  const mesh_version* mesh, double scale) {
  const bool picks = p.type != parameter_type::vector && p.type != parameter_type::list;
  const bool alone = text.find(';') == std::string_view::npos;
  number_groups groups;
  while (true) {
    const auto end = std::min(text.find(';'), text.size());
    const auto part = text.substr(0, end);
    std::optional<number_group> group;
    if (picks && is_pick(part)) {
      if (groups.size() >= most_picks)
        return wrong_value(p, "it names more than " + std::to_string(most_picks) + " places");
      auto found = numbers_at(p, mesh, part, groups.size(), alone);
      if (!found)
        return fail(std::move(found.error()));
      group = std::move(*found);
    } else {
      group = group_in(part);
      if (group)
        scale_lengths(p.type, scale, groups.size(), *group);
    }
    const bool last = end == text.size();
    if (!group || (group->empty() && !last) || groups.size() > 3 * most_items)
      return wrong_value(p, form_of(p.type));
    if (!group->empty())
      groups.push_back(std::move(*group));
    if (last)
      return groups;
    text.remove_prefix(end + 1);
  }
}

/// All of them, where each group but the only one is a point.
std::optional<number_group> points_in(const number_groups& groups) {
  number_group all;
  for (const auto& group : groups) {
    if (group.empty() || group.size() % 3 != 0 || (groups.size() > 1 && group.size() != 3))
      return std::nullopt;
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

/// As many as the kind has; nothing for other shapes.
std::optional<number_group> numbers_in(parameter_type type, const number_groups& groups) {
  if (groups.empty())
    return std::nullopt;
  if (type == parameter_type::list) {
    number_group all;
    for (const auto& group : groups)
      all.insert(all.end(), group.begin(), group.end());
    return all;
  }
  auto points = points_in(groups);
  if (!points || type == parameter_type::polyline)
    return points;
  return points->size() == (is_both(type) ? 6 : 3) ? points : std::nullopt;
}

/// The shortest text that reads back as the same number.
std::string shortest_text(double value) {
  std::array<char, 32> text{};
  const auto [end, code] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

std::string joined(const number_group& numbers, bool as_points) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0)
      text += as_points && i % 3 == 0 ? "; " : ", ";
    text += shortest_text(numbers[i]);
  }
  return text;
}

vec3 point_at(const number_group& numbers, std::size_t i) {
  return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

expected<void> check_polyline(const parameter_description& p, const number_group& numbers) {
  const std::size_t count = numbers.size() / 3;
  const double least = std::max(p.min.value_or(2), 1.0);
  const double most = std::min(p.max.value_or(most_items), double{most_items});
  if (static_cast<double>(count) < least || static_cast<double>(count) > most)
    return wrong_value(p, "it has " + std::to_string(count) + " points, and takes " +
                            number_text(least) + " to " + number_text(most));
  for (std::size_t i = 1; i < count; ++i)
    if (point_at(numbers, i) == point_at(numbers, i - 1))
      return wrong_value(
        p, "points " + std::to_string(i) + " and " + std::to_string(i + 1) + " are the same");
  return {};
}

expected<void> check_list(const parameter_description& p, const number_group& numbers) {
  if (numbers.size() > most_items)
    return wrong_value(p, "it has more than " + std::to_string(most_items) + " numbers");
  const auto range = range_of(p);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i] < range.least || numbers[i] > range.most)
      return wrong_value(p, "number " + std::to_string(i + 1) + ", " + number_text(numbers[i]) +
                              ", is out of range");
  return {};
}

expected<void> check_numbers(const parameter_description& p, const number_group& numbers) {
  if (!std::ranges::all_of(
        numbers, [](double x) { return std::isfinite(x) && std::abs(x) <= largest_number; }))
    return wrong_value(p, numbers.size() == 3 ? "it is not three finite numbers"
                                              : "not all of its numbers are finite");
  switch (p.type) {
    case parameter_type::direction:
      if (norm(point_at(numbers, 0)) == 0)
        return wrong_value(p, "a direction is not 0, 0, 0");
      return {};
    case parameter_type::axis:
    case parameter_type::plane:
      if (norm(point_at(numbers, 1)) == 0)
        return wrong_value(
          p, p.type == parameter_type::axis ? "its direction is 0, 0, 0" : "its normal is 0, 0, 0");
      return {};
    case parameter_type::polyline:
      return check_polyline(p, numbers);
    case parameter_type::list:
      return check_list(p, numbers);
    default:
      return {};
  }
}

/// The text, or the only number of a list that is given as one.
std::optional<std::string> text_of(const parameter_description& p, const parameter_value& given) {
  if (const auto* text = std::get_if<std::string>(&given))
    return *text;
  if (p.type != parameter_type::list)
    return std::nullopt;
  if (const auto* real = std::get_if<double>(&given))
    return shortest_text(*real);
  if (const auto* whole = std::get_if<std::int64_t>(&given))
    return std::to_string(*whole);
  return std::nullopt;
}

}  // namespace

number_range range_of(const parameter_description& p) {
  return {p.min.value_or(-largest_number), p.max.value_or(largest_number), p.unit};
}

bool is_number_text(parameter_type type) {
  switch (type) {
    case parameter_type::point:
    case parameter_type::direction:
    case parameter_type::vector:
    case parameter_type::axis:
    case parameter_type::plane:
    case parameter_type::polyline:
    case parameter_type::list:
      return true;
    default:
      return false;
  }
}

bool has_lengths(const parameter_description& p) {
  return p.unit == "m" && (p.type == parameter_type::real ||
                           (is_number_text(p.type) && p.type != parameter_type::direction));
}

tl::unexpected<error> wrong_value(const parameter_description& p, const std::string& why) {
  std::string remedy = p.help;
  const bool list = p.type == parameter_type::list && (p.min || p.max);
  if (list || p.type == parameter_type::integer || p.type == parameter_type::real) {
    const auto range = range_of(p);
    remedy = (list ? "Each takes " : "It takes ") + number_text(range.least) + " to " +
             number_text(range.most) + " " + range.unit;
  }
  if (p.type == parameter_type::choice) {
    remedy = "Choose one of";
    for (const auto& choice : p.choices)
      remedy += " " + choice;
  }
  return fail(ec::invalid_parameter, "parameter " + p.id + ": " + why, remedy);
}

expected<parameter_value> typed_numbers(const parameter_description& p,
                                        const parameter_value& given, const mesh_version* mesh,
                                        double scale) {
  const auto text = text_of(p, given);
  if (text && text->find_first_not_of(' ') == std::string::npos &&
      p.default_value == parameter_value(std::string{}))
    return parameter_value(std::string{});
  if (!text)
    return wrong_value(p, form_of(p.type));
  const auto groups = groups_in(p, *text, mesh, scale);
  if (!groups)
    return fail(groups.error());
  const auto numbers = numbers_in(p.type, *groups);
  if (!numbers)
    return wrong_value(p, form_of(p.type));
  if (auto ok = check_numbers(p, *numbers); !ok)
    return fail(std::move(ok.error()));
  return parameter_value(joined(*numbers, p.type != parameter_type::list));
}

}  // namespace tedit::ops
