// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/attachment.hpp"
#include "base/number_range.hpp"
#include "ops/conformance/kit.hpp"
#include "ops/loader/catalogue.hpp"

namespace tedit::ops::kit {

namespace {

std::string text_of(const parameter_value& value) {
  if (const auto* flag = std::get_if<bool>(&value))
    return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value))
    return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&value)) {
    char text[32];
    std::snprintf(text, sizeof(text), "%g", *real);
    return text;
  }
  const auto& text = std::get<std::string>(value);
  return text.size() > 20 ? std::to_string(text.size()) + " characters" : "\"" + text + "\"";
}

/// Tries one value where the others have theirs; what the host refuses does not reach the plugin.
void try_value(plugin_trial& b, const std::string& id, const parameter_value& value,
               int& answered) {
  auto given = b.values();
  given[id] = value;
  const auto completed = complete_parameters(b.description(), given);
  if (!completed)
    return;
  const auto& c = b.the_plan().cases.front();
  const auto what = id + " = " + text_of(value) + " on surface " + where(b, c);
  b.mark("applying with " + what);
  check_answer(b, *b.sample_of(c).mesh, b.apply(b.sample_of(c).mesh, c.surfaces, *completed),
               "with " + what);
  ++answered;
}

/// So many points (m) around the z axis, as a text.
std::string helix(double points, double radius) {
  std::string text;
  for (int i = 0; i < points; ++i)
    text += (i > 0 ? "; " : "") + number_text(radius * std::cos(0.7 * i)) + ", " +
            number_text(radius * std::sin(0.7 * i)) + ", " + number_text(1e-3 * i);
  return text;
}

/// Of the kinds that are several numbers in a text, on meshes of some centimetres.
std::vector<parameter_value> several_numbers(const parameter_description& p) {
  const std::string least = number_text(p.min.value_or(0));
  const std::string most = number_text(p.max.value_or(1));
  switch (p.type) {
    case parameter_type::axis:
    case parameter_type::plane:
      return {std::string("0, 0, 0; 0, 0, 1"), std::string("0.02, 0.02, 0.02; -1, 0, 0"),
              std::string("0.01, 0.02, 0.03; 1, 2, -3"), std::string("100, 0, 0; 0, 1e-9, 0")};
    case parameter_type::polyline:
      return {helix(p.min.value_or(2), 0.01), helix(std::min(p.max.value_or(200), 200.0), 0.02)};
    case parameter_type::list:
      return {least, most, least + ", " + most, most + ", " + least + ", " + most};
    default:
      return {};
  }
}

/// The ends of a parameter's range, or all its values.
std::vector<parameter_value> limits_of(const parameter_description& p) {
  auto result = several_numbers(p);
  if (!result.empty())
    return result;
  const auto add = [&](double value) {
    if (p.type == parameter_type::integer)
      result.emplace_back(static_cast<std::int64_t>(value));
    else
      result.emplace_back(value);
  };
  if (p.type == parameter_type::boolean)
    return {true, false};
  if (p.min)
    add(*p.min);
  if (p.max)
    add(*p.max);
  for (const auto& choice : p.choices)
    result.emplace_back(choice);
  return result;
}

std::string at_limits(plugin_trial& b) {
  b.load();
  int answered = 0;
  for (const auto& p : b.description().parameters)
    for (const auto& value : limits_of(p))
      try_value(b, p.id, value, answered);
  return std::to_string(answered) + " values answered";
}

/// Of every byte, as a binary file that means nothing.
std::string rubbish() {
  std::string bytes(1000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<char>(i * i * 31 + i / 7);
  return bytes;
}

/// As many as a list may hold, half of them twice.
std::string many_numbers() {
  std::string text;
  for (int i = 0; i < 10'000; ++i)
    text += (i > 0 ? ", 0.00" : "0.00") + std::to_string(i / 2);
  return text;
}

std::string hostile(plugin_trial& b) {
  b.load();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<parameter_value> values{
    std::nan(""),
    infinity,
    -infinity,
    1e300,
    -1e300,
    5e-324,
    0.0,
    -1.0,
    std::numeric_limits<std::int64_t>::max(),
    std::numeric_limits<std::int64_t>::min(),
    std::int64_t{0},
    std::string(),
    std::string(1 << 20, 'x'),
    std::string("\xff\x01\n%n%s"),
    std::string("0, 0, 0"),
    std::string("1e30, -1e30, 1e-30"),
    std::string("1e30, -1e30, 1e30; 0, 0, 1e-30"),
    std::string("0, 0, 0; 0.02, 0.02, 0; 0.02, 0, 0; 0, 0.02, 0"),
    std::string("0, 0, 0; 0.02, 0, 0; 0, 0, 0; 0.02, 0, 0; 0, 0, 0"),
    std::string("0, 0, 0; 0.01, 0, 0; 0.02, 0, 0; 1e30, 0, 0"),
    many_numbers(),
    attachment_text({"empty.stl", ""}),
    attachment_text({"rubbish.stl", rubbish()}),
    attachment_text({"no_end.stl", "solid part\nfacet nor"}),
    attachment_text({"no_end.svg", "<svg><path d=\"M 1e99"}),
    attachment_text({"no_end.dxf", "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n40\n1e8\n"}),
    true};
  int answered = 0;
  for (const auto& p : b.description().parameters)
    for (const auto& value : values)
      try_value(b, p.id, value, answered);
  return std::to_string(answered) + " values that the description allows answered, " +
         std::to_string(b.description().parameters.size() * values.size() - answered) +
         " refused by the host";
}

std::string described_rightly(plugin_trial& b) {
  b.load();
  if (complete_parameters(b.description(), {{"no_such_parameter", true}}))
    throw failure{"an unknown parameter is accepted", "Do not describe no_such_parameter"};
  for (const auto& p : b.description().parameters) {
    const bool number = p.type == parameter_type::real || p.type == parameter_type::integer;
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()})
      if (number && complete_parameters(b.description(), {{p.id, value}}))
        throw failure{p.id + " accepts " + text_of(value), "Give it the type real or integer"};
    if (number && complete_parameters(b.description(), {{p.id, std::string("wide")}}))
      throw failure{p.id + " accepts a text", "Give it the type real or integer"};
    if (p.type == parameter_type::real && !p.min && !p.max)
      throw failure{"the number " + p.id + " has no limits",
                    "Give it a min or a max: forms and validation are made from them"};
  }
  return "unknown ids, wrong types and numbers that are not finite are kept out";
}

}  // namespace

const std::vector<check>& parameter_checks() {
  static const std::vector<check> list{
    {"parameters_guarded", "The description keeps out what makes no sense", need::plugin,
     described_rightly},
    {"parameters_at_limits", "Parameters at their ends and all choices get an answer that holds",
     need::working_case, at_limits},
    {"hostile_parameters", "Extreme values that the description allows get an answer that holds",
     need::working_case, hostile}};
  return list;
}

}  // namespace tedit::ops::kit
