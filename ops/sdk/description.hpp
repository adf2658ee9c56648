// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mesh/vec3.hpp"

/// The part of the SDK that says what an operation is and what it is given; operation.hpp brings
/// it.
namespace tedit::ops {

// -- describing an operation ---------------------------------------------------

/// What a parameter holds; choice is one of the texts in `choices`.
/// All from `point` on are texts, empty where the description lets the operation find one by
/// itself. A point and a direction are three numbers in the axes of the part, as "1, 2.5, 0". A
/// point is in m. A vector is a way in m: unlike a point it is no place, so that a click on the
/// part does not give it. A file is its content (`base/attachment.hpp`), never a path.
enum class parameter_type {
  boolean,
  integer,
  real,
  text,
  choice,
  point,
  direction,
  vector,
  file,
  axis,      ///< A point (m) and a direction, "0, 0, 1; 0, 0, 1".
  plane,     ///< The same two: a point of it and its normal.
  polyline,  ///< Points (m), "0, 0, 0; 1, 0, 0": 2 (or `min`) to 10,000, each another.
  list       ///< Numbers in `unit`, "0.5, 1, 2": 1 to 10,000.
};

/// By type: bool, std::int64_t, double; std::string for all others.
using parameter_value = std::variant<bool, std::int64_t, double, std::string>;

/// One parameter as data: the source of the form, the CLI's help, the protocol's catalogue and
/// the docs, and of the validation before `apply` is called.
struct parameter_description {
  std::string id;    ///< snake_case, stable.
  std::string name;  ///< For people: "Include the entry".
  std::string help;  ///< One or two sentences.
  parameter_type type = parameter_type::real;
  std::string unit;  ///< SI, for example "m"; empty when dimensionless.
  /// Inclusive; of an integer and a real, of each number of a list, of how many points a polyline
  /// has.
  std::optional<double> min;
  std::optional<double> max;
  std::vector<std::string> choices;  ///< For choice; of a file the endings to look for: "svg".
  parameter_value default_value = false;
  /// Id of a number that this one stands in for: where a request gives this one and not that one,
  /// that one is 0 instead of its default.
  std::string instead_of = {};
};

/// What a person picks before the operation can run.
struct selection_description {
  std::string help;         ///< "The wall surfaces of one or more holes".
  std::size_t minimum = 1;  ///< Surfaces.
  std::size_t maximum = 0;  ///< 0: any number.
};

/// What people and programs see of an operation. Example: ops/fill_hole/operation.cpp.
struct operation_description {
  std::string id;       ///< snake_case, unique among all plugins.
  std::string name;     ///< "Fill hole".
  std::string summary;  ///< One sentence.
  std::string version;  ///< The operation's own, semantic.
  selection_description selection;
  std::vector<parameter_description> parameters;
  // How a window shows it, beside all of the above; each may be left out.
  std::string icon = {};   ///< SVG, 24 by 24, drawn in #000: the window puts its own colour there.
  std::string guide = {};  ///< For people: when to use it and what it cannot do. Markdown.
  int rank = 0;            ///< Among what fits a selection: the larger, the earlier it is offered.
  std::string best_for = {};  ///< "hole" or "protrusion": offered first where one was picked.
};

/// An icon of lines like those of this program's own, from the elements of an SVG: "<path d=.../>".
[[nodiscard]] inline std::string line_icon(const std::string& elements) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"24\" height=\"24\" viewBox=\"0 0 24 "
         "24\" "
         "fill=\"none\" stroke=\"#000\" stroke-width=\"1.6\" stroke-linecap=\"round\" "
         "stroke-linejoin=\"round\">" +
         elements + "</svg>";
}

// -- reading its values ---------------------------------------------------------

/// Values by parameter id. The host fills in defaults and has checked types and ranges:
/// `std::get<double>(values.at("distance"))` needs no test.
using parameters = std::map<std::string, parameter_value>;

/// The three numbers of a point, a direction or a vector; nothing where it was left to the
/// operation. The host has checked that they are finite, and those of a direction not all 0.
[[nodiscard]] inline std::optional<vec3> vector_of(const parameters& values,
                                                   const std::string& id) {
  const auto& text = std::get<std::string>(values.at(id));
  std::array<double, 3> v{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (auto& number : v) {
    while (at != end && (*at == ' ' || *at == ','))
      ++at;
    const auto [next, code] = std::from_chars(at, end, number);
    if (code != std::errc{})
      return std::nullopt;
    at = next;
  }
  return vec3{v[0], v[1], v[2]};
}

// -- since SDK 7.4 ---------------------------------------------------------------

/// The numbers of a list, and of all other kinds that are numbers in a text; none where it was left
/// to the operation. The host has checked that they are finite and in range.
[[nodiscard]] inline std::vector<double> numbers_of(const parameters& values,
                                                    const std::string& id) {
  const auto& text = std::get<std::string>(values.at(id));
  std::vector<double> result;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    while (at != end && (*at == ' ' || *at == ',' || *at == ';'))
      ++at;
    double number = 0;
    const auto [next, code] = std::from_chars(at, end, number);
    if (code != std::errc{})
      return result;
    result.push_back(number);
    at = next;
  }
}

/// The points of a polyline, m; none where it was left to the operation. No point is like the one
/// before it; the last may be like the first.
[[nodiscard]] inline std::vector<vec3> points_of(const parameters& values, const std::string& id) {
  const auto numbers = numbers_of(values, id);
  std::vector<vec3> result;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    result.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return result;
}

/// An axis, or a plane by its normal.
struct axis_value {
  vec3 point;      ///< m.
  vec3 direction;  ///< Unit.
};

/// What an axis or a plane is; nothing where it was left to the operation.
[[nodiscard]] inline std::optional<axis_value> axis_of(const parameters& values,
                                                       const std::string& id) {
  const auto both = points_of(values, id);
  if (both.size() != 2)
    return std::nullopt;
  return axis_value{both[0], normalized(both[1])};
}

}  // namespace tedit::ops
