// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <vtkNew.h>

#include <cstdint>
#include <vector>

class vtkGenericOpenGLRenderWindow;
class vtkObject;
class vtkRenderer;

namespace tedit::desktop {

/// A VTK renderer that draws into memory, in an OpenGL context that belongs to no window. Made and
/// ended on the thread of the widgets; all else is for the thread that draws.
class canvas {
public:
  /// `place`: the thread that will draw.
  explicit canvas(QThread* place);
  ~canvas();
  canvas(const canvas&) = delete;
  canvas& operator=(const canvas&) = delete;

  [[nodiscard]] vtkRenderer& renderer() { return *renderer_; }

  /// Draws a picture of some pixels, `dpi` of them an inch; empty when OpenGL is lost.
  [[nodiscard]] QImage draw(const QSize& pixels, int dpi);

  /// Gives back what it holds of OpenGL; nothing is drawn after it.
  void finish();

private:
  void begin();
  [[nodiscard]] QImage read();
  static void on_make_current(vtkObject* caller, unsigned long event, void* self, void* data);
  static void on_is_current(vtkObject* caller, unsigned long event, void* self, void* data);

  QOpenGLContext context_;
  QOffscreenSurface surface_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  std::vector<std::uint32_t> pixels_;
  bool begun_ = false;
};

}  // namespace tedit::desktop
