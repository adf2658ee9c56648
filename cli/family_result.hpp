// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/error.hpp"

/// What became of the rows of a table, as data, JSON, text and HTML.
namespace tedit::cli {

enum class family_status { passed, failed, not_run };

[[nodiscard]] const char* status_name(family_status status) noexcept;

/// A step of a row's recipe.
struct family_step {
  std::size_t number = 0;  ///< From 1; 0: the import of the mesh that was given.
  std::string what;        ///< "edit: resize_bore 1, 2".
  family_status status = family_status::not_run;
  bool passed_over = false;  ///< Only a window carries it out.
  double ms = 0;
};

struct family_row {
  std::size_t number = 0;  ///< From 1.
  std::string name;
  std::vector<std::pair<std::string, std::string>> cells;  ///< By column.
  family_status status = family_status::not_run;
  std::vector<family_step> steps;
  std::optional<error> failure;  ///< Without the step's name; also of a cancel.
  std::optional<double> volume_m3;
  std::optional<double> mass_kg;
  std::optional<double> max_displacement_m;
  std::optional<double> max_von_mises_pa;
  std::optional<double> min_safety_factor;
  std::string singularity;  ///< Where the largest stress says nothing about strength: its reason.
  bool preview = false;     ///< The field is one.
  double error_estimate = 0;
  std::vector<std::string> files;
  std::filesystem::path picture;  ///< PNG; empty: none.
  std::string picture_missing;    ///< Why.
  double ms = 0;

  /// The step that failed; null where none did.
  [[nodiscard]] const family_step* failed_step() const;
};

struct family_result {
  std::string name;  ///< Of the recipe.
  std::string table;
  std::string server;
  std::string program;
  unsigned jobs = 1;
  std::vector<family_row> rows;  ///< As in the table.
  std::string report;            ///< The HTML file; empty: none.
  double ms = 0;

  [[nodiscard]] std::size_t count(family_status status) const;
  /// Rows that passed with a safety factor below 1.
  [[nodiscard]] std::size_t yielding() const;
};

[[nodiscard]] nlohmann::ordered_json to_json(const family_result& result);

/// For people: a table, a list of the steps, and why rows failed.
[[nodiscard]] std::string describe(const family_result& result);

/// What is wrong with the name of a report, before hours of work. Errors: `usage`;
/// `service_unavailable` for a PDF where nothing makes one.
[[nodiscard]] expected<void> check_report_name(const std::filesystem::path& file);

/// One file that needs no other, HTML or PDF by its name: figures, pictures, rows that failed
/// first. Errors: `io_error`; those of the program that makes PDF. Cost: pictures are read one
/// after the other.
[[nodiscard]] expected<void> write_report(const family_result& result,
                                          const std::filesystem::path& file);

}  // namespace tedit::cli
