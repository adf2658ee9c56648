// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include "client-qt/model/document.hpp"
#include "client/recipe.hpp"

namespace tedit::desktop {

/// Carries out a recipe on the open document, step by step: an import opens a part, each edit makes
/// a version, a solve waits for the field, which is that of the document's own solve settings.
/// Exports are left out. The first step that fails ends it; the document tells why by `failed`,
/// with the step as the place where this object finds it. It is a row in the document's work, with
/// its Cancel. Needs a connection; ends with the document that it works on.
class recipe_player : public QObject {
  Q_OBJECT

public:
  recipe_player(document& part, client::recipe steps, QObject* parent = nullptr);
  ~recipe_player() override;

  void start();
  [[nodiscard]] bool is_running() const noexcept { return poll_.isActive(); }

signals:
  /// "step 2 of 9 (edit)".
  void began(const QString& step);
  /// `exports`: steps that were left out.
  void finished(int exports);
  void stopped(const QString& step);
  void ended();  ///< After either.

private:
  void next();
  void end();
  void stop();
  void refuse(error reason);
  [[nodiscard]] bool is_ready() const;
  [[nodiscard]] QString step_name() const;
  expected<void> perform(const client::import_step& s);
  expected<void> perform(const client::load_case_step& s);
  expected<void> perform(const client::edit_step& s);
  expected<void> perform(const client::undo_step& s);
  expected<void> perform(const client::redo_step& s);
  expected<void> perform(const client::solve_step& s);
  expected<void> perform(const client::export_step& s);

  document& part_;
  client::recipe recipe_;
  std::size_t at_ = 0;  ///< Steps that were begun.
  QString name_;        ///< The document that it works on.
  bool wants_field_ = false;
  bool imports_ = false;  ///< The part that it works on is not there yet.
  int exports_ = 0;
  int job_ = 0;
  QTimer poll_;
};

}  // namespace tedit::desktop
