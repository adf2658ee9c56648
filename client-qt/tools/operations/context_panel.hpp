// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

#include "client-qt/model/document.hpp"
#include "client-qt/model/live_preview.hpp"
#include "client-qt/model/selection.hpp"
#include "client-qt/tools/operations/operation_form.hpp"

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace tedit::desktop {

/// What is selected, what can be done with it, and the form of the operation that was chosen.
class context_panel : public QWidget {
  Q_OBJECT

public:
  context_panel(document& part, selection& picked, QWidget* parent = nullptr);

  /// Shows the form of an operation; an empty id goes back to the list.
  void choose(const QString& operation);
  [[nodiscard]] const QString& chosen() const noexcept { return operation_; }
  [[nodiscard]] operation_form* form() const { return form_; }
  [[nodiscard]] live_preview& preview() noexcept { return preview_; }
  /// Applies the chosen operation to the selection, if both fit.
  void apply();

signals:
  /// A person wants to see these surfaces.
  void place_wanted(const std::vector<tedit::surface_id>& surfaces);

protected:
  void changeEvent(QEvent* event) override;

private:
  void follow();
  void show_selection();
  void show_offers();
  void show_form();
  void show_activity();
  void show_readiness();
  [[nodiscard]] QString not_ready() const;
  [[nodiscard]] std::vector<const offered_operation*> offers() const;

  document& part_;
  selection& picked_;
  live_preview preview_;
  QString operation_;
  QLabel* title_;
  QLabel* details_;
  QLabel* loads_;
  QWidget* growing_;
  QWidget* body_;
  QVBoxLayout* body_layout_ = nullptr;
  QPointer<operation_form> form_;
  QPointer<QPushButton> apply_;
  QPointer<QLabel> hint_;
  QWidget* running_;
  QLabel* stage_;
  QProgressBar* fraction_;
  QPushButton* cancel_;
};

}  // namespace tedit::desktop
