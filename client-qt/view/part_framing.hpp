// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QRect>
#include <QSize>

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "client-qt/view/camera.hpp"
#include "client-qt/view/part_geometry.hpp"

namespace tedit::desktop {

/// Brings the part, or places of it, into the view.
class part_framing : public QObject {
  Q_OBJECT

public:
  explicit part_framing(camera& eye) : eye_(eye) {}

  /// The part that is drawn; the first is made to fit.
  void set_part(std::shared_ptr<const part_geometry> part);
  /// The next part is another one: it is made to fit as the first was.
  void expect_another();
  /// The view's size in pixels.
  void set_size(const QSize& size);
  /// Puts the whole part, or some surfaces of it, into the view.
  void fit(const std::vector<surface_id>& around = {});
  /// As long as nobody turns or moves the part it is made to fit again when the view's size
  /// changes.
  void keep_fitted(bool on) { keeps_fitted_ = on; }
  [[nodiscard]] bool keeps_fitted() const noexcept { return keeps_fitted_; }
  /// Pixels at the left that something else covers: what is made to fit stays beside them, from the
  /// next time on that something is; what a person has moved stays where it is.
  void set_left_margin(int pixels);
  /// The same at the lower edge.
  void set_lower_margin(int pixels);
  /// What else covers the upper right corner: what is made to fit keeps clear of it, moved or
  /// smaller by no more than that takes.
  void set_corner(const QRect& covered);
  /// Width to height of what that leaves.
  [[nodiscard]] double free_aspect(const QSize& size) const;
  [[nodiscard]] double free_aspect() const { return free_aspect(size_); }
  void look_from(camera::direction from);
  void fly_to(const vec3& place);
  /// Whether the whole part was made to fit and nobody has turned or moved it since.
  [[nodiscard]] bool shows_whole() const { return whole_ && whole_ == eye_.get(); }

signals:
  void moved();

private:
  /// Unless somebody has turned or moved the part.
  void fit_again();
  using box = std::array<double, 6>;
  void fit_beside_corner(const box& bounds);
  [[nodiscard]] bool covers(const box& bounds) const;

  camera& eye_;
  std::shared_ptr<const part_geometry> part_;
  QSize size_;
  bool fitted_ = false;
  bool keeps_fitted_ = false;
  std::optional<camera::pose> whole_;  ///< As the last fit of the whole part left it.
  int left_margin_ = 0;
  int fitted_left_ = 0;  ///< As the last fit had it.
  int lower_margin_ = 0;
  QRect corner_;
};

}  // namespace tedit::desktop
