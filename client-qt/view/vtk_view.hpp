// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>
#include <QTimer>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkCallbackCommand;
class vtkGenericOpenGLRenderWindow;
class vtkObject;
class vtkRenderer;

namespace tedit::desktop {

/// A VTK renderer inside a Qt 6 widget: VTK 9.1 comes with a widget for Qt 5 only. VTK draws into
/// its own framebuffer, which is then copied to the widget's.
class vtk_view : public QOpenGLWidget {
  Q_OBJECT

public:
  explicit vtk_view(QWidget* parent = nullptr);
  ~vtk_view() override;

  [[nodiscard]] vtkRenderer* renderer() const { return renderer_; }

  /// Draws soon; many calls make one frame.
  void redraw() { update(); }

  /// Draws quickly rather than finely for a moment: while the part is turned. Only where a
  /// processor draws by itself: with as few pixels as the last such frames needed to be quick,
  /// until a fifth of a second after the last call.
  void draw_quickly();
  [[nodiscard]] bool draws_quickly() const noexcept { return quick_; }

  /// Draws what another renderer shows in a frame that nobody sees; `quickly`: as while the part is
  /// turned; null: only gets ready to draw. False: the view is shown, or cannot draw. `forget` must
  /// follow the last one.
  bool draw_unseen(vtkRenderer* other, bool quickly);
  void forget(vtkRenderer* other);

  /// Pixels that are drawn for one of the widget.
  [[nodiscard]] double pixel_ratio() const;

  /// Milliseconds that the last frame took on this thread.
  [[nodiscard]] double frame_ms() const noexcept { return frame_ms_; }

  /// Frames until now.
  [[nodiscard]] int frames() const noexcept { return frames_; }

signals:
  void drawn();

protected:
  /// Before each frame.
  virtual void about_to_draw() {}
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;

private:
  void release();
  void draw();
  void set_pixels();
  void suit_coarseness();
  static void on_make_current(vtkObject* caller, unsigned long event, void* self, void* data);
  static void on_is_current(vtkObject* caller, unsigned long event, void* self, void* data);

  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  double frame_ms_ = 0;
  int frames_ = 0;
  bool software_ = false;
  bool quick_ = false;
  bool unseen_ = false;
  int coarseness_ = 2;  ///< Of quick frames: pixels of the widget for one that is drawn, each way.
  QTimer fine_again_;
};

}  // namespace tedit::desktop
