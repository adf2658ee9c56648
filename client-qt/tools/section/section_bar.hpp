// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>

#include <optional>

#include "client-qt/model/document.hpp"
#include "client-qt/view/scene.hpp"

class QComboBox;
class QLabel;
class QSlider;

namespace tedit::desktop {

class field_panel;
class viewport;

/// A section plane: along an axis or parallel to a picked plane, moved by a slider. The view cuts
/// at once; the cap with its field comes from the server, which alone holds the inside.
class section_bar : public QFrame {
  Q_OBJECT

public:
  section_bar(document& part, viewport& view, const field_panel& fields);

  void set_on(bool on);
  [[nodiscard]] bool is_on() const noexcept { return on_; }
  /// The plane through a point of the part; `normal` points to what is taken away.
  void set_plane(const vec3& at, const vec3& normal);
  /// Where the slider stands, in [0,1] from one end of the part to the other.
  void set_place(double place);

  /// The plane of the form; nothing without a part.
  [[nodiscard]] std::optional<section_plane> plane() const;

signals:
  void moved();  ///< Or was put on or off.

private:
  void face_viewer();
  void read_form();
  void ask();
  [[nodiscard]] std::array<double, 2> reach(const vec3& normal) const;

  document& part_;
  viewport& view_;
  const field_panel& fields_;
  QComboBox* axis_;
  QSlider* place_;
  QLabel* shown_;
  vec3 own_normal_{0, 0, 1};
  bool flipped_ = false;
  bool on_ = false;
  bool asking_ = false;
  bool again_ = false;  ///< The plane moved while the server was asked.
};

}  // namespace tedit::desktop
