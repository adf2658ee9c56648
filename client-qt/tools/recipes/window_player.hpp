// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include <functional>

#include "client-qt/model/version_store.hpp"
#include "client-qt/tools/recipes/handle_moves.hpp"
#include "client/recipe_player.hpp"

namespace tedit::desktop {

struct toolbox;
struct window_context;

/// Plays a recipe in a window while the window goes on working. What works on the part is asked for
/// as by hand, a solve is the window's own (all load cases, its settings), exports are left out;
/// steps of the window are those of `window_steps.hpp`. A step is carried out when what was begun
/// before is done; one of the window also waits until the views show all of it. The first step that
/// fails ends it, and so does anything that fails in the window meanwhile; what it finds itself the
/// document tells by `failed`.
class window_player : public QObject, private client::performer {
  Q_OBJECT

public:
  window_player(window_context& in, toolbox& tools, std::vector<client::recipe_step> steps,
                QObject* parent = nullptr);

  /// How long a step may wait for those before it, s; 0: as long as it takes.
  void set_patience(int seconds) noexcept { patience_s_ = seconds; }
  /// A part is opened from outside: steps wait for it.
  void await_part() noexcept { awaits_part_ = true; }
  /// Reports and pictures are written; else they are left out like exports.
  void allow_files() noexcept { writes_ = true; }

  void start() { poll_.start(); }
  void cancel();
  [[nodiscard]] bool is_running() const noexcept { return poll_.isActive(); }
  /// The step that was begun last: "step 2 of 9 (edit)".
  [[nodiscard]] QString step_name() const;
  /// Steps that were left out.
  [[nodiscard]] int left_out() const noexcept { return left_out_; }
  /// Whether a part that the recipe imports is on its way.
  [[nodiscard]] bool imports() const noexcept { return imports_; }

signals:
  void began(const QString& step, double fraction);
  void finished();
  void failed(const tedit::error& reason);  ///< It names the step.

private:
  void next();
  void end(const error& reason);
  void refuse(const error& reason);
  expected<bool> is_ready_for(const client::recipe_step* next) override;
  [[nodiscard]] bool is_part_ready() const;
  [[nodiscard]] bool is_view_ready() const;
  [[nodiscard]] bool is_final() const;
  expected<void> perform(const client::recipe_step& step) override;
  using meanings = std::vector<std::vector<surface_id>>;
  /// Goes on once it is known what a step's references mean; at once where there are none.
  expected<void> with_meanings(const std::vector<client::surface_reference>& references,
                               const std::function<expected<void>(const meanings&)>& go_on);
  void note_last_edit();
  expected<void> apply(const edit_request& wanted);
  expected<void> carry_out(const client::import_step& s);
  expected<void> carry_out(const client::load_case_step& s);
  expected<void> carry_out(const client::remove_load_case_step& s);
  expected<void> carry_out(const client::edit_step& s);
  expected<void> carry_out(const client::undo_step& s);
  expected<void> carry_out(const client::redo_step& s);
  expected<void> carry_out(const client::go_to_step& s);
  expected<void> carry_out(const client::solve_step& s);
  expected<void> carry_out(const client::export_step& s);
  expected<void> carry_out(const client::compare_step& s);
  expected<void> carry_out(const client::apply_step& s);
  expected<void> carry_out(const client::window_step& s);

  window_context& in_;
  toolbox& tools_;
  client::recipe_player player_;
  int patience_s_ = 0;
  int waited_ms_ = 0;
  bool awaits_part_ = false;
  bool writes_ = false;
  bool imports_ = false;
  bool wants_field_ = false;  ///< The step before was a solve.
  int left_out_ = 0;
  bool looks_up_ = false;  ///< The server is asked what references mean.
  client::surface_references known_;
  std::string label_;            ///< Of the last edit, which is not noted yet.
  shared_surface before_label_;  ///< The surface that it was made of.
  int drags_left_ = 0;
  std::optional<handle_moves> handle_moves_;
  QTimer poll_;
};

}  // namespace tedit::desktop
