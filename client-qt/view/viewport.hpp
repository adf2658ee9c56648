// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QThreadPool>

#include <optional>

#include "client-qt/model/version_store.hpp"
#include "client-qt/view/camera.hpp"
#include "client-qt/view/grips.hpp"
#include "client-qt/view/part_framing.hpp"
#include "client-qt/view/preview_layer.hpp"
#include "client-qt/view/scene.hpp"
#include "client-qt/view/shown_values.hpp"
#include "client-qt/view/vtk_view.hpp"

class QRubberBand;

namespace tedit::desktop {

/// What the viewport shows: all that is needed to make its geometry and colours.
struct shown_part {
  std::shared_ptr<const client::surface_model> surface;
  std::shared_ptr<const client::field_event> field;  ///< May be null, or of another version.
  double deform = 0;                                 ///< Factor on the displacement.
  /// Of a part that is only looked at: the surface that it would replace. Else null.
  std::shared_ptr<const client::surface_model> before;
};

/// The part with its field under the mouse: left drag turns, middle or Shift drag moves, the wheel
/// zooms to the pointer, Ctrl drag draws a box. Geometry is made on other threads; the newest wins.
class viewport : public vtk_view {
  Q_OBJECT

public:
  explicit viewport(QWidget* parent = nullptr);
  ~viewport() override;

  /// Shows a part; the same surface again only changes colours. `shown` follows.
  void show_part(const shown_part& what);
  /// How values become colours; its range is taken from the values when it is automatic.
  void set_legend(const legend& by);
  [[nodiscard]] const shown_part& current() const noexcept { return shown_; }
  /// What is drawn; null before the first.
  [[nodiscard]] const std::shared_ptr<const part_geometry>& geometry() const { return part_; }
  /// By which legend, and with which values.
  [[nodiscard]] const painted_values& painted() const noexcept { return painted_values_; }
  /// Whether no geometry or line is being made any more; its frame may still be drawn.
  [[nodiscard]] bool is_settled() const noexcept { return !building_ && !contouring_; }
  /// Whether the last frame shows the present geometry,
  [[nodiscard]] bool is_shape_seen() const noexcept { return !building_ && seen() >= shaped_; }
  /// and its values, too.
  [[nodiscard]] bool is_seen() const noexcept { return is_shape_seen() && seen() >= painted_; }

  void set_colours(const scene_colours& colours);
  /// Instead of a field what hinders printing: only on the version that was checked. Null: nothing.
  void show_print_marks(shared_print_check marks);
  [[nodiscard]] bool shows_print_marks() const;
  void select(const std::vector<surface_id>& picked);
  /// Shows that these are the place of a fault; none: nothing.
  void mark(const std::vector<surface_id>& faulty);
  /// The last frame without what is selected, under the pointer or marked; tells `then` at once
  /// when there is nothing of it, else once it is drawn anew, which the window does not wait for.
  void plain_picture(const std::function<void(const QImage&)>& then);
  void hide(const std::set<surface_id>& hidden);
  void show_mesh(bool on);
  void show_edges(bool on);
  /// Lines of equal value on the part and the cut surface, at the legend's levels.
  void show_isolines(bool on);
  /// A left drag draws a box, also without Ctrl.
  void set_boxing(bool on);
  /// Finds the surfaces in a box of the widget; `boxed` tells them.
  void pick_box_at(const QRectF& where, bool enclosed, bool add);
  /// What is dragged instead of the part where the pointer is over it; null: nothing.
  void set_grips(grips* over_the_part) noexcept { grips_ = over_the_part; }
  void set_glyphs(vtkPolyData* loads, vtkPolyData* supports);
  /// Takes away one side of a plane; the cap comes by `show_cap`.
  void set_section(const std::optional<section_plane>& plane);
  [[nodiscard]] const std::optional<section_plane>& section() const noexcept { return section_; }
  void show_cap(std::shared_ptr<const client::section> cap);

  [[nodiscard]] camera& view() { return camera_; }
  /// What of it the camera shows.
  [[nodiscard]] part_framing& framing() { return framing_; }

  /// The surface point at a widget position, if any.
  [[nodiscard]] std::optional<picked_point> pick_at(QPointF position) const;
  /// The same of a version that may not be what is drawn, a preview being in its place: as it was
  /// last drawn at rest, else of what is drawn.
  [[nodiscard]] std::optional<picked_point> pick_at(QPointF position,
                                                    const std::string& version) const;
  /// Where a point of space is in the widget.
  [[nodiscard]] QPointF to_widget(const vec3& at) const;
  /// The same as the last frame shows it: what is painted over it must not run ahead.
  [[nodiscard]] QPointF to_frame(const vec3& at) const;
  /// A point of the surface's face that is nearest to the viewer: for tests and labels.
  [[nodiscard]] std::optional<vec3> visible_point(surface_id surface) const;
  /// Brings a place, as drawn, to the middle: seen from where one looks now, or from `outward` (a
  /// unit vector; zero: not known) where the part hides it.
  void show_place(const vec3& drawn, const vec3& outward);
  /// The shown value at a picked point, SI; nothing without a field there.
  [[nodiscard]] std::optional<double> value_at(const picked_point& at) const;

signals:
  void shown();           ///< New geometry or colours are on the screen.
  void legend_changed();  ///< Its automatic range followed the values.
  void hovered(std::optional<tedit::desktop::picked_point> at, QPoint global);
  void clicked(std::optional<tedit::desktop::picked_point> at, Qt::KeyboardModifiers modifiers);
  /// A box was drawn; `add`: to what is selected.
  void boxed(const std::vector<tedit::surface_id>& found, bool add);
  void menu_wanted(std::optional<tedit::desktop::picked_point> at, QPoint global);
  void view_changed();

protected:
  void about_to_draw() override;
  void frame_came() override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  /// Arrows turn the part, with Shift they move it; + and - zoom.
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  /// What is drawn; only for the thread that draws.
  struct stage {
    explicit stage(vtkRenderer& renderer) : part(&renderer), preview(&renderer) {}
    scene part;
    preview_layer preview;
  };
  void change_stage(std::function<void(stage&)> what);
  void build();
  void take_geometry(std::shared_ptr<const part_geometry> part,
                     const std::shared_ptr<const preview_geometry>& preview, int generation);
  void highlight();
  void paint_values();
  void paint_cap();
  void contour();
  void finish_box(QPointF to, Qt::KeyboardModifiers modifiers);
  void drag(QPointF to, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers);
  void hover_at(QPointF position, QPoint global);
  void forget_hovered();

  camera camera_;
  part_framing framing_{camera_};
  camera::projection drawn_by_;  ///< Of the frame that is drawn,
  camera::projection seen_by_;   ///< and of the last one.
  std::unique_ptr<stage> stage_;
  std::shared_ptr<const part_geometry> part_;
  std::shared_ptr<const part_geometry> at_rest_;  ///< The last that is no preview, not deformed.
  std::set<surface_id> hidden_;
  shown_part shown_;
  painted_values painted_values_;
  std::vector<surface_id> selected_;
  std::vector<surface_id> faulty_;
  std::optional<section_plane> section_;
  std::shared_ptr<const client::section> cap_;
  shared_print_check print_marks_;
  int shaped_ = 0;   ///< The frame asked for when the geometry changed,
  int painted_ = 0;  ///< and when the values did.
  QThreadPool builders_;
  int generation_ = 0;
  bool building_ = false;
  bool isolines_ = false;
  bool contouring_ = false;
  int contours_ = 0;  ///< Lines of earlier values are not for us.
  bool boxing_ = false;
  bool draws_box_ = false;  ///< The drag that is going on.
  QRubberBand* band_ = nullptr;
  std::optional<QPointF> pressed_;
  QPointF last_;
  bool dragging_ = false;
  grips* grips_ = nullptr;
  bool grip_taken_ = false;
  std::optional<surface_id> hovered_;
};

}  // namespace tedit::desktop
