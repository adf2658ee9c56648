// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>

#include <memory>

#include "client-qt/context/window_context.hpp"
#include "client-qt/model/handle_drag.hpp"
#include "client-qt/model/snap_places.hpp"
#include "client-qt/view/grips.hpp"
#include "client-qt/view/handle_layer.hpp"

namespace tedit::desktop {

class context_panel;

/// What the form that is open is dragged by in the view, and its tool as a ghost. The form's fields
/// are the only truth: a drag writes into them, and what is drawn is read from them.
class operation_handles : public QObject, public grips {
  Q_OBJECT

public:
  operation_handles(window_context& in, context_panel& panel);
  ~operation_handles() override;

  /// Back to the values before the drag; false if there is none.
  bool cancel();
  /// A click on the part while the form has a place: that place, on that wall. `free`: nothing
  /// takes hold of it. While a field of the form picks, what is there is for that field. False if
  /// the form has neither.
  bool take_place(const picked_point& at, bool free);
  /// As the camera is now; empty while no form is open.
  [[nodiscard]] std::vector<laid_handle> laid() const;
  [[nodiscard]] bool is_dragging() const noexcept { return drag_.has_value(); }
  /// Whether the tool is drawn because its preview is not there yet.
  [[nodiscard]] bool shows_ghost() const;
  /// What the place took hold of last; empty: of nothing.
  [[nodiscard]] const QString& snapped_to() const noexcept { return snapped_to_; }
  [[nodiscard]] handle_layer& layer() { return *layer_; }

  bool hover(QPointF at) override;
  bool take(QPointF at) override;
  void drag(QPointF to, Qt::KeyboardModifiers modifiers) override;
  void drop() override;
  void leave() override;

signals:
  /// The pointer moved a handle: its new place is about to be drawn.
  void dragged();
  void dropped();

private:
  struct values_before {
    ops::parameter_value value;
    std::vector<surface_id> picked;
  };

  void follow();
  void find_snap_places();
  void end_drag();
  void mark(const handle* what);
  void move_place(QPointF to, bool free);
  void put_place(const std::optional<picked_point>& hit, QPointF pointer, bool free);
  [[nodiscard]] vec3 on_head(const picked_point& hit) const;
  [[nodiscard]] bool sees(const snap_place& place) const;
  [[nodiscard]] drawn_handles drawn(const lens& by) const;
  [[nodiscard]] QString words(const laid_handle& one) const;

  window_context& in_;
  context_panel& panel_;
  handle_layer* layer_;
  QString operation_;
  handle_plan plan_;
  ops::parameters values_;
  std::optional<handle_pose> pose_;
  std::shared_ptr<const std::vector<snap_place>> places_;
  std::string places_of_;  ///< The version that they were looked for on.
  std::optional<handle_drag> drag_;
  values_before before_;
  const handle* marked_ = nullptr;
  Qt::CursorShape cursor_ = Qt::ArrowCursor;  ///< Before a handle was pointed at.
  std::optional<vec3> snapped_;
  QString snapped_to_;
  QThreadPool finders_;
};

}  // namespace tedit::desktop
