// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

#include <functional>

class QDockWidget;

namespace tedit::desktop {

struct toolbox;
struct window_context;

/// Who has how much of the column at the right: what is selected and the field have what they need,
/// what stands below them has the rest. A form takes what it lacks from the others while it is
/// open. Docks that a person has moved stay as they are, but for forms.
class dock_room : public QObject {
  Q_OBJECT

public:
  /// Both live longer.
  dock_room(window_context& in, toolbox& tools);

  /// Gives each what it needs, now that something else stands in it; not beside a form whose
  /// surface is selected.
  void settle();
  /// To be kept with the layout.
  [[nodiscard]] bool moved_by_hand() const noexcept { return by_hand_; }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void wire();
  /// Until then the docks are not settled.
  void later(int ms, const std::function<void()>& then);
  void make_room(const std::function<int()>& form_height, QDockWidget& dock, QDockWidget& gives,
                 QDockWidget& keeps, bool to_spare_only = false);
  void make_room_for_operation();
  void make_room_for_load(bool to_spare_only = false);
  void lend(QDockWidget& from, QDockWidget& to);
  void give_room_back();
  void selection_changed();
  void settle_twice();
  void edited();
  [[nodiscard]] QDockWidget& of(const char* name) const;
  /// Loads or the receipt, whichever is in front.
  [[nodiscard]] QDockWidget& lower() const;
  [[nodiscard]] bool stand_in_their_column() const;
  void resize(const QList<QDockWidget*>& docks, QList<int> heights);
  [[nodiscard]] int tabs_below(const QDockWidget& dock) const;

  /// Heights of the docks for loads, field and selection.
  using dock_heights = QList<int>;
  [[nodiscard]] dock_heights heights() const;

  window_context& in_;
  toolbox& tools_;
  dock_heights before_form_;  ///< Of loads; empty once a person has moved the docks since.
  bool lent_ = false;         ///< Others have room of the form, until a surface is picked.
  bool dragging_ = false;     ///< A person has hold of what lies between two docks,
  bool by_hand_ = false;      ///< or has had.
};

}  // namespace tedit::desktop
