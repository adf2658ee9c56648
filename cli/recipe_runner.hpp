// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <set>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "client/client.hpp"
#include "client/recipe_player.hpp"

namespace tedit::cli {

using client::export_step;
using client::import_step;
using client::recipe;
using client::solve_step;

/// Versions whose solve failed, as the server tells without being asked. Thread-safe.
class failed_solves {
public:
  void add(const std::string& version);
  [[nodiscard]] bool contains(const std::string& version) const;

private:
  mutable std::mutex mutex_;
  std::set<std::string> versions_;
};

/// Carries out a recipe as a client of a server. Steps that only a window carries out are passed
/// over.
class recipe_runner : public client::performer {
public:
  recipe_runner(const recipe& steps, session& s, client::client& server,
                std::shared_ptr<const failed_solves> failures, std::filesystem::path out)
      : recipe_(steps),
        session_(s),
        server_(server),
        failures_(std::move(failures)),
        out_(std::move(out)) {}

  /// Whether all steps that change the part can be carried out without a window. Errors:
  /// `bad_input` naming the step: without it the others would work on another part.
  [[nodiscard]] static expected<void> check(const recipe& steps);

  /// Stops at the first step that fails; its error names the step. `mesh` is imported first.
  [[nodiscard]] expected<void> run(const std::optional<import_step>& mesh);

  [[nodiscard]] expected<bool> is_ready_for(const client::recipe_step* next) override;
  [[nodiscard]] expected<void> perform(const client::recipe_step& step) override;

  [[nodiscard]] const nlohmann::ordered_json& report() const { return report_; }
  [[nodiscard]] std::string table() const;
  /// What each edit did to surfaces and load cases, and what each solve says about the part.
  [[nodiscard]] const std::string& details() const { return details_; }
  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }
  [[nodiscard]] std::size_t passed_over() const noexcept { return passed_over_; }

private:
  expected<void> step(const import_step& s);
  expected<void> step(const client::load_case_step& s);
  expected<void> step(const client::remove_load_case_step& s);
  expected<void> step(const client::edit_step& s);
  expected<void> step(const client::undo_step& s);
  expected<void> step(const client::redo_step& s);
  expected<void> step(const client::go_to_step& s);
  expected<void> step(const solve_step& s);
  expected<void> step(const export_step& s);
  expected<void> step(const client::compare_step& s);  ///< recipe_compare.cpp
  expected<void> write_files(const client::compare_step& s, const client::comparison& made);
  expected<void> step(const client::apply_step& s);
  expected<void> step(const client::window_step& s);
  void loads_changed(const char* how, const std::string& name);
  expected<void> take_head(const std::string& what, const client::committed& done, double ms);
  [[nodiscard]] client::solve_settings settings_of(const solve_step& s) const;
  expected<solve_outcome> ask(const client::solve_settings& settings);
  expected<std::vector<client::field_event>> await_fields(const client::solve_settings& settings);
  void add_rows(const std::vector<client::field_event>& fields, bool known);
  expected<void> write(const std::string& format, const std::filesystem::path& path);
  expected<void> draw(const export_step& s, const std::filesystem::path& png);
  [[nodiscard]] std::filesystem::path path_of(const std::string& name) const;
  [[nodiscard]] std::string version_name() const { return "v" + std::to_string(head_.number); }

  const recipe& recipe_;
  session& session_;
  client::client& server_;
  std::shared_ptr<const failed_solves> failures_;
  std::filesystem::path out_;
  client::version_info head_;
  /// What was asked for: the server solves every new head with it.
  std::optional<client::solve_settings> followed_;

  /// The last solve of a version.
  struct solved_version {
    client::solve_settings settings;
    solve_outcome outcome;
  };
  std::map<std::string, solved_version> solved_;  ///< By version.
  std::vector<std::vector<std::string>> rows_;
  nlohmann::ordered_json report_ = nlohmann::ordered_json::array();
  std::string details_;
  std::vector<std::string> files_;
  std::size_t passed_over_ = 0;
};

}  // namespace tedit::cli
