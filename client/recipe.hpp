// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "fem/receipt.hpp"
#include "mesh/types.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::client {

/// One edit to make.
struct edit_request {
  std::string operation;
  std::vector<surface_id> surfaces;
  ops::parameters parameters;
  fem::carry_settings loads;  ///< What becomes of loads whose surface goes.
};

// The steps of a recipe, in the order of its file.
struct import_step {
  std::filesystem::path mesh;
  std::string length_unit = "mm";
};
struct load_case_step {
  std::filesystem::path file;
};
struct edit_step {
  edit_request request;
};
struct undo_step {};
struct redo_step {};
struct solve_step {
  std::vector<std::string> load_cases;  ///< Names, solved together; empty: the first one.
  bool all_load_cases = false;          ///< All that the version has, instead of names.
  double energy_tolerance = 0;          ///< 0: none.
};
/// Files with `{version}` in their names get the number of the version in the session (0 is the
/// imported one).
struct export_step {
  std::string vtu;
  std::string png;
  std::string msh;
  std::string stl;
  std::string title;
  std::optional<std::pair<double, double>> range_mpa;  ///< Legend of the picture.
};

using recipe_step = std::variant<import_step, load_case_step, edit_step, undo_step, redo_step,
                                 solve_step, export_step>;

/// A list of steps that `tedit run` and the desktop client carry out; docs/recipes.md describes the
/// file.
struct recipe {
  std::string name;
  std::string device = "auto";
  double tolerance = 1e-6;
  int order = 2;  ///< Of the elements.
  std::vector<recipe_step> steps;
};

/// Reads a recipe; paths in it are relative to its folder. Errors: `io_error`, `bad_input` naming
/// the step and the field.
[[nodiscard]] expected<recipe> read_recipe(const std::filesystem::path& file);

/// The name of a step's kind as it stands in the file: "edit".
[[nodiscard]] const char* kind_of(const recipe_step& step);

/// Whether a file is JSON with a list of steps: a recipe, maybe one with faults. A load case is
/// none. Cost: it is read.
[[nodiscard]] bool is_recipe(const std::filesystem::path& file);

}  // namespace tedit::client
