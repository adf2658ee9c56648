// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "client/surface_reference.hpp"
#include "edit/report.hpp"
#include "fem/load_case.hpp"
#include "mesh/types.hpp"
#include "ops/sdk/operation.hpp"

/// Recipes: the one language of steps that the command line and the desktop client carry out, and
/// that the desktop client records. docs/recipes.md describes the file.
namespace tedit::client {

// -- steps that work on the part ---------------------------------------------------------

struct import_step {
  std::filesystem::path mesh;  ///< Or a part that is meshed first: client/part_files.hpp.
  std::string length_unit = "mm";
  std::string size = {};  ///< Of such a part, one of `part_sizes`; empty: medium.
  std::map<std::string, double> local_sizes_mm = {};  ///< Longest edges, by surface, of a CAD part.

  friend bool operator==(const import_step&, const import_step&) = default;
};
/// A file that a recipe names is read with the recipe.
struct load_case_step {
  fem::load_case loads;
  std::vector<surface_reference> references = {};  ///< Their places are among the surfaces.

  friend bool operator==(const load_case_step&, const load_case_step&) = default;
};
struct remove_load_case_step {
  std::string name;

  friend bool operator==(const remove_load_case_step&, const remove_load_case_step&) = default;
};
struct edit_step {
  edit_request request;
  std::string label = {};                          ///< For later steps: what it made.
  std::vector<surface_reference> references = {};  ///< Their places are among the surfaces.

  friend bool operator==(const edit_step&, const edit_step&) = default;
};
struct undo_step {
  friend bool operator==(const undo_step&, const undo_step&) = default;
};
struct redo_step {
  friend bool operator==(const redo_step&, const redo_step&) = default;
};
/// Makes any version the head, by its number in the document.
struct go_to_step {
  std::uint32_t version = 0;

  friend bool operator==(const go_to_step&, const go_to_step&) = default;
};
struct solve_step {
  std::vector<std::string> load_cases;  ///< Names, solved together; empty: the first one.
  bool all_load_cases = false;          ///< All that the version has, instead of names.
  double energy_tolerance = 0;          ///< 0: none.

  friend bool operator==(const solve_step&, const solve_step&) = default;
};
/// The CAD model with all edits, of a part that came from CAD.
inline constexpr const char* step_format = "step";

/// Files with `{version}` in their names get the number of the version in the session (0 is the
/// imported one).
struct export_step {
  /// By their format, a name in mesh/formats.hpp or `step_format`; in the file the keys `msh`,
  /// `stl`, `vtu`, ...
  std::map<std::string, std::string> files;
  std::string png;
  std::string title;
  std::optional<std::pair<double, double>> range_mpa;  ///< Legend of the picture.

  friend bool operator==(const export_step&, const export_step&) = default;
};

/// What two versions differ in, by their numbers in the document. Files as in an export.
struct compare_step {
  std::uint32_t before = 0;
  std::optional<std::uint32_t> after;  ///< The present version when it is not given.
  std::string load_case;               ///< Whose fields are compared in `vtu` and `png`.
  std::string json;                    ///< The figures.
  std::string vtu;                     ///< The difference at the boundary of the version after.
  std::string png;                     ///< The same, of the von Mises stress.
  std::string title;                   ///< Of the picture.

  friend bool operator==(const compare_step&, const compare_step&) = default;
};

// -- steps that only a window carries out ------------------------------------------------

/// An edit of what is selected, as by the form of the operation: the request names no surfaces.
struct apply_step {
  edit_request request;

  friend bool operator==(const apply_step&, const apply_step&) = default;
};
/// How the part is looked at, or what a hand does. `json` is the whole step as one JSON object,
/// whose fields have been checked: types, ranges and sizes, but not whether the part has what they
/// name.
struct window_step {
  std::string kind;
  std::string json;

  friend bool operator==(const window_step&, const window_step&) = default;
};

using recipe_step =
  std::variant<import_step, load_case_step, remove_load_case_step, edit_step, undo_step, redo_step,
               go_to_step, solve_step, export_step, compare_step, apply_step, window_step>;

/// The name of a step's kind as it stands in the file: "edit".
[[nodiscard]] const char* kind_of(const recipe_step& step);

/// Whether only a window carries it out.
[[nodiscard]] bool is_of_window(const recipe_step& step);

struct recipe {
  std::string name;
  std::string device = "auto";
  double tolerance = 1e-6;
  int order = 2;  ///< Of the elements.
  std::vector<recipe_step> steps;

  friend bool operator==(const recipe&, const recipe&) = default;
};

// -- as a file ----------------------------------------------------------------------------

/// Reads a recipe, or a list of steps alone, with the load cases that it names. Meshes and load
/// cases are sought from its folder. Errors: `io_error`, `bad_input` naming the step and the field;
/// nothing that is unknown, of another type, not finite or too large passes.
[[nodiscard]] expected<recipe> read_recipe(const std::filesystem::path& file);
[[nodiscard]] expected<recipe> recipe_from_json(std::string_view text,
                                                const std::filesystem::path& folder = {});

/// One line, without its end; read again it is the same step.
[[nodiscard]] std::string to_json(const recipe_step& step);
/// An object with a step on each line; settings only where they are not the usual ones.
[[nodiscard]] std::string to_json(const recipe& what);

/// Whether a file is JSON with a list of steps: a recipe, maybe one with faults. A load case is
/// none. Cost: it is read.
[[nodiscard]] bool is_recipe(const std::filesystem::path& file);

}  // namespace tedit::client
