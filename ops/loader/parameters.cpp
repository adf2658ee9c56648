// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "base/attachment.hpp"
#include "base/number_range.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/loader/number_texts.hpp"

namespace tedit::ops {

namespace {

template <class T>
bool parse_number(const std::string& text, T& value) {
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc{} && end == text.data() + text.size();
}

/// The content of a file, or nothing where that is the default.
expected<parameter_value> typed_file(const parameter_description& p, const parameter_value& given) {
  const auto* text = std::get_if<std::string>(&given);
  if (!text)
    return wrong_value(p, "it is the content of a file");
  if (text->empty() && p.default_value == parameter_value(std::string{}))
    return given;
  if (const auto file = read_attachment(*text); !file)
    return fail(ec::invalid_parameter, "parameter " + p.id + ": " + file.error().message,
                file.error().remedy);
  return given;
}

/// A value given as text takes the parameter's type.
expected<parameter_value> typed(const parameter_description& p, const parameter_value& given,
                                const mesh_version* mesh) {
  const auto* text = std::get_if<std::string>(&given);
  switch (p.type) {
    case parameter_type::boolean:
      if (std::holds_alternative<bool>(given))
        return given;
      if (text && (*text == "true" || *text == "yes" || *text == "1"))
        return parameter_value(true);
      if (text && (*text == "false" || *text == "no" || *text == "0"))
        return parameter_value(false);
      return wrong_value(p, "it is true or false");
    case parameter_type::integer: {
      std::int64_t value = 0;
      if (const auto* whole = std::get_if<std::int64_t>(&given))
        return parameter_value(*whole);
      if (const auto* real = std::get_if<double>(&given);
          real && *real == std::floor(*real) && std::abs(*real) < 9e15)
        return parameter_value(static_cast<std::int64_t>(*real));
      if (text && parse_number(*text, value))
        return parameter_value(value);
      return wrong_value(p, "it is a whole number");
    }
    case parameter_type::real: {
      double value = 0;
      if (const auto* whole = std::get_if<std::int64_t>(&given))
        return parameter_value(static_cast<double>(*whole));
      if (std::holds_alternative<double>(given))
        return given;
      if (text && parse_number(*text, value))
        return parameter_value(value);
      return wrong_value(p, "it is a number");
    }
    case parameter_type::text:
    case parameter_type::choice:
      if (text)
        return given;
      return wrong_value(p, "it is a text");
    case parameter_type::point:
    case parameter_type::direction:
    case parameter_type::vector:
    case parameter_type::axis:
    case parameter_type::plane:
    case parameter_type::polyline:
    case parameter_type::list:
      return typed_numbers(p, given, mesh);
    case parameter_type::file:
      return typed_file(p, given);
  }
  return wrong_value(p, "its type is unknown");
}

expected<void> check_range(const parameter_description& p, const parameter_value& value) {
  if (p.type == parameter_type::choice &&
      std::ranges::find(p.choices, std::get<std::string>(value)) == p.choices.end())
    return wrong_value(p, "\"" + std::get<std::string>(value) + "\" is no choice");
  double real = 0;
  if (const auto* whole = std::get_if<std::int64_t>(&value))
    real = static_cast<double>(*whole);
  else if (const auto* given = std::get_if<double>(&value))
    real = *given;
  else
    return {};
  if (!std::isfinite(real))
    return wrong_value(p, "it is not a finite number");
  if (const auto range = range_of(p); real < range.least || real > range.most)
    return wrong_value(p, number_text(real) + " is out of range");
  return {};
}

/// The given values by parameter id: "depth_mm" is "depth" in millimetres for a parameter in
/// metres.
expected<parameters> in_metres(const operation_description& description, const parameters& given,
                               const mesh_version* mesh) {
  parameters result = given;
  for (const auto& p : description.parameters) {
    const auto found = result.find(p.id + "_mm");
    if (!has_lengths(p) || found == result.end())
      continue;
    if (result.contains(p.id))
      return wrong_value(p, "it is given twice, in m and in mm");
    const bool text = is_number_text(p.type);
    const auto value =
      text ? typed_numbers(p, found->second, mesh, 1e-3) : typed(p, found->second, mesh);
    if (!value)
      return fail(value.error());
    result[p.id] = text ? *value : parameter_value(1e-3 * std::get<double>(*value));
    result.erase(p.id + "_mm");
  }
  return result;
}

/// 0 where the request gives what stands in for the parameter.
parameter_value default_of(const parameter_description& p, const operation_description& description,
                           const parameters& given) {
  const bool replaced = std::ranges::any_of(description.parameters, [&](const auto& other) {
    return other.instead_of == p.id && given.contains(other.id);
  });
  return replaced ? parameter_value(std::int64_t{0}) : p.default_value;
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t least = std::max<std::size_t>(2, name.size() / 2) + 1;
  for (const auto& candidate : candidates) {
    std::vector<std::size_t> row(candidate.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < name.size(); ++i) {
      std::size_t diagonal = std::exchange(row[0], i + 1);
      for (std::size_t j = 0; j < candidate.size(); ++j) {
        const std::size_t change = diagonal + (name[i] != candidate[j]);
        diagonal = row[j + 1];
        row[j + 1] = std::min({change, row[j] + 1, row[j + 1] + 1});
      }
    }
    if (row.back() < least) {
      least = row.back();
      best = candidate;
    }
  }
  return best;
}

expected<parameters> complete_parameters(const operation_description& description,
                                         const parameters& values, const mesh_version* mesh) {
  const auto metric = in_metres(description, values, mesh);
  if (!metric)
    return fail(metric.error());
  const auto& given = *metric;
  std::vector<std::string> names;
  parameters result;
  for (const auto& p : description.parameters) {
    names.push_back(p.id);
    const auto found = given.find(p.id);
    auto value =
      typed(p, found == given.end() ? default_of(p, description, given) : found->second, mesh);
    if (!value)
      return fail(value.error());
    if (auto ok = check_range(p, *value); !ok)
      return fail(ok.error());
    result[p.id] = std::move(*value);
  }
  for (const auto& [name, value] : given) {
    if (result.contains(name))
      continue;
    const auto near = nearest_name(name, names);
    return fail(ec::invalid_parameter, description.id + " has no parameter \"" + name + "\"",
                near.empty() ? "\"tedit ops " + description.id + "\" lists its parameters"
                             : "Did you mean " + near + "?");
  }
  return result;
}

}  // namespace tedit::ops
