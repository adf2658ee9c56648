// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>

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

  /// Milliseconds that the last frame took on this thread.
  [[nodiscard]] double frame_ms() const noexcept { return frame_ms_; }

signals:
  void drawn();

protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;

private:
  void release();
  static void on_make_current(vtkObject* caller, unsigned long event, void* self, void* data);
  static void on_is_current(vtkObject* caller, unsigned long event, void* self, void* data);

  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  double frame_ms_ = 0;
};

}  // namespace tedit::desktop
