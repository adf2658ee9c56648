// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "ops/conformance/kit.hpp"
#include "ops/loader/catalogue.hpp"

namespace tedit::ops::kit {

namespace {

bool is_snake_case(const std::string& id) {
  static const std::regex form("[a-z][a-z0-9]*(_[a-z0-9]+)*");
  return id.size() <= 40 && std::regex_match(id, form);
}

std::string ids(plugin_trial& b) {
  b.load();
  const auto& d = b.description();
  std::set<std::string> seen;
  const auto judge = [](const std::string& what, const std::string& id) {
    if (!is_snake_case(id))
      throw failure{what + " \"" + id + "\" is not snake_case of at most 40 characters",
                    "Use small letters, digits and single underscores, a letter first"};
  };
  judge("the operation's id", d.id);
  for (const auto& p : d.parameters) {
    judge("the parameter id", p.id);
    if (!seen.insert(p.id).second)
      throw failure{"the parameter id \"" + p.id + "\" stands twice", "Give each its own id"};
  }
  return d.id + " with " + std::to_string(d.parameters.size()) + " parameter(s)";
}

std::string texts(plugin_trial& b) {
  b.load();
  const auto& d = b.description();
  const auto judge = [](const std::string& what, const std::string& text) {
    if (text.find_first_not_of(" \n") == std::string::npos)
      throw failure{what + " is empty", "People read it in forms and help: write it"};
  };
  judge("the operation's name", d.name);
  judge("the operation's summary", d.summary);
  if (d.selection.maximum > 0 || d.selection.minimum > 0)
    judge("the selection's help", d.selection.help);
  for (const auto& p : d.parameters) {
    judge("the name of parameter " + p.id, p.name);
    judge("the help of parameter " + p.id, p.help);
  }
  return "all there";
}

std::string version_text(plugin_trial& b) {
  b.load();
  static const std::regex form("[0-9]+\\.[0-9]+\\.[0-9]+(-[0-9A-Za-z.-]+)?");
  const auto& version = b.description().version;
  if (!std::regex_match(version, form))
    throw failure{"the version is \"" + version + "\"",
                  "Write major.minor.patch, for example 1.0.0"};
  return version;
}

/// Made of points or ways, in m.
bool is_place(parameter_type type) {
  switch (type) {
    case parameter_type::point:
    case parameter_type::vector:
    case parameter_type::axis:
    case parameter_type::plane:
    case parameter_type::polyline:
      return true;
    default:
      return false;
  }
}

std::string units(plugin_trial& b) {
  b.load();
  static const std::set<std::string> si{
    "m",   "m^2", "m^3", "1/m",   "rad", "s", "1/s", "Hz",  "kg",    "kg/m^3", "N",
    "N/m", "N m", "Pa",  "N/m^3", "J",   "W", "K",   "m/s", "m/s^2", "J/m^3",  "1"};
  for (const auto& p : b.description().parameters) {
    const bool number = p.type == parameter_type::real || p.type == parameter_type::integer ||
                        p.type == parameter_type::list;
    const bool place = is_place(p.type);
    if (place && p.unit != "m")
      throw failure{"the place or way " + p.id + " has the unit \"" + p.unit + "\"", "Give it m"};
    if (p.unit.empty() || place || (number && si.contains(p.unit)))
      continue;
    if (!number)
      throw failure{"parameter " + p.id + " is no number and has the unit \"" + p.unit + "\"",
                    "Leave its unit empty"};
    throw failure{"the unit \"" + p.unit + "\" of parameter " + p.id + " is no SI unit",
                  "Take m, m^2, m^3, rad, N, Pa, kg, s or one made of them; clients convert"};
  }
  return "SI or none";
}

void judge_range(const parameter_description& p) {
  if (p.min && p.max && !(*p.min <= *p.max))
    throw failure{"the range of parameter " + p.id + " is empty", "min must not exceed max"};
  if ((p.min && !std::isfinite(*p.min)) || (p.max && !std::isfinite(*p.max)))
    throw failure{"the range of parameter " + p.id + " is not finite",
                  "Leave min or max out when there is no limit"};
  const bool counted = p.type == parameter_type::polyline || p.type == parameter_type::list;
  const bool number =
    p.type == parameter_type::real || p.type == parameter_type::integer || counted;
  if (!number && (p.min || p.max))
    throw failure{"parameter " + p.id + " is no number and has a range", "Leave min and max out"};
  if (p.type == parameter_type::polyline && (p.min.value_or(2) < 1 || p.max.value_or(2) > 10'000))
    throw failure{"the polyline " + p.id + " may have no or more than 10,000 points",
                  "min and max say how many points it has"};
  // Of a file they are the endings that a dialog offers, and may be left out.
  if (p.type != parameter_type::file && (p.type == parameter_type::choice) == p.choices.empty())
    throw failure{p.choices.empty() ? "parameter " + p.id + " is a choice of nothing"
                                    : "parameter " + p.id + " lists choices but is none",
                  "Fill `choices` for parameter_type::choice and parameter_type::file only"};
}

std::string defaults(plugin_trial& b) {
  b.load();
  for (const auto& p : b.description().parameters)
    judge_range(p);
  const auto values = complete_parameters(b.description(), {});
  if (!values)
    throw failure{"the defaults are refused: " + render(values.error()),
                  "A default has its parameter's type and lies inside its range"};
  const auto& s = b.description().selection;
  if (s.maximum > 0 && s.minimum > s.maximum)
    throw failure{"the selection takes at least " + std::to_string(s.minimum) + " and at most " +
                    std::to_string(s.maximum) + " surfaces",
                  "Set maximum to 0 for any number"};
  return "inside their ranges";
}

/// All of a description as one text, to compare.
std::string flat(const operation_description& d) {
  std::string text = d.id + "|" + d.name + "|" + d.summary + "|" + d.version + "|" +
                     d.selection.help + "|" + std::to_string(d.selection.minimum) + "|" +
                     std::to_string(d.selection.maximum) + "|" + d.icon + "|" + d.guide + "|" +
                     std::to_string(d.rank) + "|" + d.best_for;
  for (const auto& p : d.parameters) {
    text += "\n" + p.id + "|" + p.name + "|" + p.help + "|" + p.unit + "|" +
            std::to_string(static_cast<int>(p.type)) + "|" + std::to_string(p.min.value_or(0)) +
            "|" + std::to_string(p.max.value_or(0)) + "|" +
            std::to_string(p.default_value.index()) + "|" + p.instead_of;
    for (const auto& choice : p.choices)
      text += "|" + choice;
  }
  return text;
}

std::string same_twice(plugin_trial& b) {
  b.load();
  const auto other = b.make();
  const auto first = flat(b.description());
  if (flat(b.code().describe()) != first || flat(other->describe()) != first)
    throw failure{"two calls of describe() gave different answers",
                  "Return constants: forms and validation are made from one call"};
  return "three calls of two instances agree";
}

}  // namespace

const std::vector<check>& description_checks() {
  static const std::vector<check> list{
    {"ids", "The ids of operation and parameters are snake_case and unique", need::plugin, ids},
    {"texts", "Names, summary and help texts are there", need::plugin, texts},
    {"version", "The operation has a version of three numbers", need::plugin, version_text},
    {"units", "Units are SI", need::plugin, units},
    {"defaults", "Ranges and choices make sense and the defaults lie inside", need::plugin,
     defaults},
    {"same_description", "describe() gives the same answer every time", need::plugin, same_twice}};
  return list;
}

}  // namespace tedit::ops::kit
