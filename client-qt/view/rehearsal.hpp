// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include <memory>

#include "client-qt/view/scene.hpp"

namespace tedit::desktop {

class vtk_view;

/// Draws a tiny part in all ways that a part is drawn in, unseen, before there is a part: plain and
/// with a field, picked, under the pointer, cut open. Shaders are compiled when something is first
/// drawn with them, 20 to 60 ms each where a processor draws: here nobody waits for it. One frame
/// at a time, with the loop's events between; ends as soon as the view is shown.
class rehearsal : public QObject {
  Q_OBJECT

public:
  /// `view` must outlive this.
  explicit rehearsal(vtk_view& view, QObject* parent = nullptr);
  ~rehearsal() override;

  /// Once; later calls do nothing.
  void start();
  /// Whether frames are left.
  [[nodiscard]] bool is_on() const noexcept { return pause_.isActive(); }

private:
  void next();
  void end();
  void set_up(int frame);

  vtk_view& view_;
  vtkNew<vtkRenderer> renderer_;
  std::unique_ptr<scene> scene_;
  QTimer pause_;
  int frame_ = 0;
  bool begun_ = false;
};

}  // namespace tedit::desktop
