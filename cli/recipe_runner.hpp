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

/// What became of a step that was begun.
struct step_record {
  std::size_t number = 0;  ///< In the recipe, from 1; 0: the import of a mesh that was given.
  std::string kind;
  bool passed_over = false;  ///< Only a window carries it out.
  std::optional<error> failure;
  double ms = 0;
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
  /// Those that were begun, in order.
  [[nodiscard]] const std::vector<step_record>& steps() const noexcept { return steps_; }
  /// The server's document; empty before it is open.
  [[nodiscard]] const std::string& document() const noexcept { return document_; }
  [[nodiscard]] const client::version_info& head() const noexcept { return head_; }
  /// The last solve of the head; null without one.
  [[nodiscard]] const solve_outcome* outcome() const;
  /// Draws the head's field, which there must be, `size` ("640x400") pixels large, with the legend
  /// of the recipe's last export that fixes one. Errors: those of an export.
  [[nodiscard]] expected<void> picture(const std::string& title, const std::string& size,
                                       const std::filesystem::path& png);

private:
  expected<void> step(const import_step& s);
  expected<void> import_part(const import_step& s);
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
  [[nodiscard]] expected<std::vector<std::vector<surface_id>>> meanings(
    const std::vector<client::surface_reference>& references);
  void loads_changed(const char* how, const std::string& name);
  expected<void> take_head(const std::string& what, const client::committed& done, double ms);
  [[nodiscard]] client::solve_settings settings_of(const solve_step& s) const;
  expected<solve_outcome> ask(const client::solve_settings& settings);
  expected<std::vector<client::field_event>> await_fields(const client::solve_settings& settings);
  void add_rows(const std::vector<client::field_event>& fields, bool known);
  expected<void> write(const std::string& format, const std::filesystem::path& path);
  expected<void> write_step(const std::filesystem::path& path);
  expected<void> draw(const export_step& s, const std::filesystem::path& png,
                      const std::vector<std::string>& more = {});
  expected<void> note(std::size_t number, const std::string& kind,
                      const std::function<expected<void>()>& work);
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
  std::vector<step_record> steps_;
  std::size_t performed_ = 0;
  client::surface_references known_;
  std::string document_;
};

}  // namespace tedit::cli
