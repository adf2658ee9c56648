// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

class vtkRenderer;

namespace tedit::desktop {

class canvas;
class drawing_thread;

/// A VTK renderer inside a Qt 6 widget (VTK 9.1 comes with a widget for Qt 5 only). Frames are
/// drawn on a thread of their own, read back and painted like any picture: the window never waits
/// for one, and needs no OpenGL itself (docs/decisions/0014).
class vtk_view : public QWidget {
  Q_OBJECT

public:
  explicit vtk_view(QWidget* parent = nullptr);
  ~vtk_view() override;

  /// Draws soon; many calls make one frame. Nothing is drawn while the view is hidden.
  void redraw();

  /// Draws quickly rather than finely for a moment: while the part is turned. With as few pixels as
  /// the last such frames needed to be quick, until a fifth of a second after the last call.
  void draw_quickly();
  /// Whether the last frame has all pixels of the screen.
  [[nodiscard]] bool is_fine() const;

  /// The present frame in pixels of the screen: drawn and waited for unless it is the last one.
  [[nodiscard]] QImage picture();
  /// The last frame, without waiting.
  [[nodiscard]] const QImage& last_picture() const noexcept { return image_; }

  /// How often a frame was asked for until now, and until that began which is on the screen: a
  /// change asked for by the n-th is seen once `seen` is n.
  [[nodiscard]] int asked() const noexcept { return asked_; }
  [[nodiscard]] int seen() const noexcept { return seen_; }

  /// Milliseconds that drawing the last frame took.
  [[nodiscard]] double frame_ms() const noexcept { return frame_ms_; }

  /// Frames until now.
  [[nodiscard]] int frames() const noexcept { return frames_; }

signals:
  void drawn();  ///< A new frame is on the screen.

protected:
  /// Changes what is drawn: before the next frame, in the order of the calls, on the thread that
  /// draws. `redraw` is called apart.
  void change(std::function<void(vtkRenderer&)> what);
  /// Draws the last frame once more, changed by `before`, for `then`; not on the screen. `after`
  /// undoes the change.
  void draw_aside(const std::function<void(vtkRenderer&)>& before,
                  const std::function<void(vtkRenderer&)>& after,
                  const std::function<void(const QImage&)>& then);
  /// A frame begins: the last moment for a change that shall be in it.
  virtual void about_to_draw() {}
  /// The frame that was begun last is there.
  virtual void frame_came() {}
  /// Waits for the frame that is drawn; nothing is drawn or changed after it. To be called by the
  /// destructor of a class whose changes use its members.
  void end_drawing();

  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  struct frame {
    QImage image;
    double ms = 0;
  };
  using changes = std::vector<std::function<void(vtkRenderer&)>>;
  void apply(const changes& in_order);
  void begin_soon();
  void begin();
  void collect();
  void wait();
  void suit_coarseness();
  [[nodiscard]] QSize pixels(int coarseness) const;

  std::shared_ptr<drawing_thread> thread_;
  std::unique_ptr<canvas> canvas_;
  changes changes_;
  std::mutex mutex_;
  std::optional<frame> finished_;  ///< By the thread that draws, until it is collected.
  QImage image_;
  int asked_ = 1;
  int begun_ = 0;
  int came_ = 0;  ///< Drawn; painted once `seen_` is the same.
  int seen_ = 0;
  bool scheduled_ = false;  ///< A frame begins soon.
  bool drawing_ = false;    ///< On the other thread.
  bool quick_ = false;
  int coarseness_ = 2;  ///< Of quick frames: pixels of the widget for one that is drawn, each way.
  double frame_ms_ = 0;
  int frames_ = 0;
  QTimer fine_again_;
};

}  // namespace tedit::desktop
