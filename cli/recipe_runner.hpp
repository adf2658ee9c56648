// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <optional>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/recipe.hpp"
#include "fem/solver.hpp"

namespace tedit::cli {

/// Carries out a recipe in this process: a list of versions with undo and redo, the load cases that
/// belong to each, and the results.
class recipe_runner {
public:
  recipe_runner(const recipe& steps, session& s, std::filesystem::path out)
      : recipe_(steps), session_(s), out_(std::move(out)) {}

  /// Stops at the first step that fails; its error names the step.
  [[nodiscard]] expected<void> run();

  [[nodiscard]] const nlohmann::ordered_json& report() const { return report_; }
  [[nodiscard]] std::string table() const;
  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

private:
  struct state {
    version_ptr version;
    std::vector<fem::load_case> load_cases;
    double edit_ms = 0;
    double quality_before = 0;
    double quality_after = 0;
  };
  struct result {
    fem::problem problem;
    fem::solution solution;
  };

  expected<void> step(const import_step& s);
  expected<void> step(const load_case_step& s);
  expected<void> step(const edit_step& s);
  expected<void> step(const undo_step& s);
  expected<void> step(const redo_step& s);
  expected<void> step(const solve_step& s);
  expected<void> step(const export_step& s);
  expected<void> need_version() const;
  expected<void> draw(const export_step& s, const std::filesystem::path& png, const result& shown);
  [[nodiscard]] std::filesystem::path path_of(const std::string& name) const;
  void add_row(const std::string& what, const std::string& edit, const std::string& quality,
               const fem::solution* solved);

  const recipe& recipe_;
  session& session_;
  std::filesystem::path out_;
  std::vector<state> states_;
  std::size_t head_ = 0;
  std::map<hash128, result> results_;
  std::unique_ptr<fem::backend> device_;
  std::optional<ops::catalogue> plugins_;
  std::vector<std::vector<std::string>> rows_;
  nlohmann::ordered_json report_ = nlohmann::ordered_json::array();
  std::vector<std::string> files_;
};

}  // namespace tedit::cli
