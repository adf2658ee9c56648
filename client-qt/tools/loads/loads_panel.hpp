// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QTreeWidget>

#include <optional>
#include <set>
#include <string>

#include "client-qt/model/document.hpp"
#include "client-qt/model/load_editing.hpp"
#include "client-qt/model/selection.hpp"
#include "client-qt/tools/loads/unfinished_forms.hpp"

class QLabel;
class QPushButton;

namespace tedit::desktop {

/// Materials, supports and loads of every load case of the head, and their editing. A load case is
/// sent as a whole after each change, once it can be solved; until then it is kept here and the
/// tree says what it lacks. After an edit of the part, items that it changed carry a mark.
class loads_panel : public QWidget {
  Q_OBJECT

public:
  loads_panel(document& part, selection& picked, QWidget* parent = nullptr);

  /// The load case that new items go to; a head without any has none.
  void new_load_case();
  /// Opens the editor on a new item for the load case that is chosen in the tree.
  void add_item(item_kind kind);
  /// Takes away what is chosen in the tree: an item, or a whole load case.
  void remove_current();
  [[nodiscard]] bool can_remove() const { return current().has_value(); }
  /// Closes the editor and forgets what was typed in it; false when it is not open.
  bool cancel();
  /// Closes it; what was typed is there again when it is opened for the same.
  void close_editor();
  [[nodiscard]] load_editor* editor() const { return editor_; }
  [[nodiscard]] QTreeWidget* tree() const { return tree_; }
  /// What the form and a few rows of the list need, pixels.
  [[nodiscard]] int wanted_height() const;
  /// Takes up load cases that could not be solved yet when the document was left; one of a name
  /// that is being changed here stays as it is.
  void take_up(const std::vector<fem::load_case>& kept);
  /// Load cases that cannot be solved yet, or are on their way.
  [[nodiscard]] const std::vector<fem::load_case>& drafts() const noexcept { return drafts_; }

signals:
  void surfaces_wanted(const QList<qint64>& surfaces);
  void drafts_changed();
  void chosen_changed();
  void form_opened();
  void form_closed();

protected:
  void changeEvent(QEvent* event) override;  ///< Icons follow the colours of the text.

private:
  /// A row of the tree: the load case, or one of its items.
  struct row_place {
    std::string load_case;
    std::optional<item_kind> kind;  ///< Empty: the load case itself.
    std::size_t at = 0;
  };

  void build_buttons();
  void wire();
  void refresh();
  void show_parts();
  void add_case(const fem::load_case& loads);
  void add_row(QTreeWidgetItem* parent, const load_item& item, const row_place& place,
               const std::vector<item_mark>& changed);
  void add_dropped(QTreeWidgetItem* parent, const std::vector<item_mark>& changed);
  void show_menu(QPoint at);
  void edit_row(const row_place& place);
  void open_editor(const QString& title, const load_item& item);
  void apply_editor();
  void duplicate(const row_place& place);
  void drop(const row_place& place);
  void remove_case(const row_place& place);
  void renamed(QTreeWidgetItem* row);
  /// Sends it when it is complete, else keeps it as a draft.
  void change(const fem::load_case& loads);
  void forget_settled_drafts();
  void carry_drafts(const client::committed& what);

  [[nodiscard]] std::optional<row_place> current() const;
  [[nodiscard]] std::vector<fem::load_case> all() const;
  [[nodiscard]] const fem::load_case* find(const std::string& name,
                                           const std::vector<fem::load_case>& in) const;

  document& part_;
  selection& picked_;
  QTreeWidget* tree_ = nullptr;
  QWidget* buttons_;
  load_editor* editor_ = nullptr;
  QLabel* hint_;
  std::vector<fem::load_case> drafts_;  ///< Not complete yet, or complete and on their way.
  std::set<std::string> known_;         ///< Load cases that the server had when it told last.
  std::optional<row_place> editing_;    ///< `at` past the end: a new item.
  unfinished_forms unfinished_;
  bool filling_ = false;
};

}  // namespace tedit::desktop
