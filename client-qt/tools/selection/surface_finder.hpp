// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "client-qt/model/selection.hpp"
#include "client-qt/model/surface_search.hpp"
#include "client-qt/widgets/finder_popup.hpp"

namespace tedit::desktop {

/// Surfaces by words and keys: Ctrl+F, "bores 8 to 12 mm" or a name, up and down show on the part
/// what a row is, Enter selects it, Esc leaves the selection as it was.
class surface_finder : public finder_popup {
  Q_OBJECT

public:
  surface_finder(document& part, selection& picked, QWidget* parent);

  void open() override;

signals:
  void found(const QList<qint64>& surfaces);  ///< Enter.

protected:
  void search(const QString& letters) override;
  void walk(int row) override;
  void take(int row) override;
  void give_up() override;

private:
  void list_names(const QString& name);
  void ask(feature_kind kind, const surface_search& wanted);
  void list_bores(std::vector<found_feature> found);
  void list_equal();
  void list_grown(const std::vector<found_feature>& found);
  /// A row, what it selects, and what stands at its right end.
  void add(const QString& title, std::vector<surface_id> surfaces, const QString& size = {});
  void say(const QString& words);

  document& part_;
  selection& picked_;
  std::vector<surface_id> before_;  ///< What was selected when it opened.
  std::optional<found_feature> feature_before_;
  std::vector<std::vector<surface_id>> rows_;
  int question_ = 0;  ///< Answers to earlier letters are not for us.
};

}  // namespace tedit::desktop
