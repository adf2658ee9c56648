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

class tall_scroll;

/// What is selected, what can be done with it, and the form of the operation that was chosen.
class context_panel : public QWidget {
  Q_OBJECT

public:
  context_panel(document& part, selection& picked, QWidget* parent = nullptr);

  /// Shows the form of an operation; an empty id goes back to the list.
  void choose(const QString& operation);
  /// Whether operations are offered for what is selected; not while it is meant for something else.
  void offer(bool on);
  [[nodiscard]] const QString& chosen() const noexcept { return operation_; }
  [[nodiscard]] operation_form* form() const { return form_; }
  [[nodiscard]] live_preview& preview() noexcept { return preview_; }
  /// What becomes of loads whose surface an edit takes away.
  void set_policy(fem::load_policy policy);
  /// Applies the chosen operation to the selection, if both fit. What takes much of the part away
  /// is asked for in the form first, unless one is `sure`; so without a preview it waits for one.
  void apply(bool sure = false);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

signals:
  void form_opened();
  void form_closed();
  /// The operation, its values or what is selected is another one.
  void followed();
  /// A person wants to see these surfaces.
  void place_wanted(const std::vector<tedit::surface_id>& surfaces);

protected:
  void changeEvent(QEvent* event) override;

private:
  void follow();
  [[nodiscard]] edit_wish wish() const;
  void queue();
  void take_most(const most_that_works& most);
  [[nodiscard]] QWidget* make_policy();
  void show_policy();
  void show_selection();
  [[nodiscard]] QString details() const;
  void show_details();
  void show_offers();
  void show_form();
  [[nodiscard]] QWidget* make_buttons();
  void preview_changed();
  /// The part of the part that the preview takes away; nothing where there is none.
  [[nodiscard]] double share_taken();
  [[nodiscard]] QWidget* make_activity();
  void show_activity();
  void show_readiness();
  [[nodiscard]] int foot_height() const;
  void edited(const client::committed& what);
  [[nodiscard]] QString not_ready() const;
  [[nodiscard]] std::vector<const offered_operation*> offers() const;

  document& part_;
  selection& picked_;
  live_preview preview_;
  QString operation_;
  fem::load_policy policy_ = fem::load_policy::drop;
  bool offers_ = true;
  bool follows_later_ = false;  ///< A preview is wanted once nothing runs.
  bool applies_ = false;        ///< Ours is on its way.
  bool waits_ = false;          ///< To be applied once its preview is there.
  bool asks_ = false;           ///< Whether so much shall be taken off.
  std::string volume_of_;       ///< The version that `volume_` was found for.
  double volume_ = 0;           ///< m^3.
  QLabel* title_;
  QLabel* details_;
  QLabel* loads_;
  QWidget* growing_;
  QWidget* body_;
  QVBoxLayout* body_layout_ = nullptr;
  QPointer<operation_form> form_;
  QPointer<QWidget> policy_row_;
  QPointer<QPushButton> apply_;
  QPointer<QPushButton> sure_;
  QPointer<QLabel> hint_;
  tall_scroll* scroll_;
  QWidget* foot_;  ///< Stays in sight while the fields above it scroll.
  QWidget* running_;
  QLabel* stage_;
  QProgressBar* fraction_;
  QPushButton* cancel_;
  QLabel* then_;  ///< What waits behind what runs.
  QPushButton* empty_;
};

}  // namespace tedit::desktop
