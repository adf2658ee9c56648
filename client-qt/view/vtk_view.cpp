// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/vtk_view.hpp"

#include <QElapsedTimer>
#include <QPainter>

#include <algorithm>
#include <utility>

#include "client-qt/view/canvas.hpp"
#include "client-qt/view/drawing_thread.hpp"

namespace tedit::desktop {

namespace {

constexpr int fine_after_ms = 200;
// A quick frame that takes longer gets fewer pixels; more where it would not, even if its time were
// all for pixels.
constexpr double slow_ms = 50;
constexpr int coarsest = 4;
constexpr std::size_t most_changes = 64;  // Of a hidden view, which draws no frames.

}  // namespace

vtk_view::vtk_view(QWidget* parent)
    : QWidget(parent),
      thread_(drawing_thread::shared()),
      canvas_(std::make_unique<canvas>(thread_->place())) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  fine_again_.setSingleShot(true);
  connect(&fine_again_, &QTimer::timeout, this, [this] {
    quick_ = false;
    redraw();
  });
}

vtk_view::~vtk_view() {
  end_drawing();
}

void vtk_view::end_drawing() {
  if (!canvas_)
    return;
  thread_->run([this] { canvas_->finish(); });
  canvas_.reset();
}

bool vtk_view::is_fine() const {
  return image_.size() == pixels(1);
}

QSize vtk_view::pixels(int coarseness) const {
  const double ratio = devicePixelRatioF() / coarseness;
  return {std::max(1, qRound(width() * ratio)), std::max(1, qRound(height() * ratio))};
}

void vtk_view::change(std::function<void(vtkRenderer&)> what) {
  changes_.push_back(std::move(what));
  if (changes_.size() < most_changes || !canvas_)
    return;
  thread_->post([this, changes = std::exchange(changes_, {})] { apply(changes); });
}

void vtk_view::apply(const changes& in_order) {
  for (const auto& one : in_order)
    one(canvas_->renderer());
}

void vtk_view::redraw() {
  ++asked_;
  begin_soon();
}

void vtk_view::begin_soon() {
  if (drawing_ || !isVisible() || std::exchange(scheduled_, true))
    return;
  QMetaObject::invokeMethod(
    this,
    [this] {
      scheduled_ = false;
      begin();
    },
    Qt::QueuedConnection);
}

void vtk_view::begin() {
  if (!canvas_ || drawing_ || begun_ == asked_)
    return;
  begun_ = asked_;
  drawing_ = true;
  about_to_draw();
  const auto size = pixels(quick_ ? coarseness_ : 1);
  const int dpi = qRound(96.0 * size.width() / std::max(1, width()));
  thread_->post([this, changes = std::exchange(changes_, {}), size, dpi] {
    QElapsedTimer clock;
    clock.start();
    apply(changes);
    auto image = canvas_->draw(size, dpi);
    {
      const std::lock_guard lock(mutex_);
      finished_ = frame{std::move(image), static_cast<double>(clock.nsecsElapsed()) * 1e-6};
    }
    QMetaObject::invokeMethod(this, &vtk_view::collect, Qt::QueuedConnection);
  });
}

/// Of two calls for one frame, after a wait, the second finds nothing.
void vtk_view::collect() {
  std::optional<frame> came;
  {
    const std::lock_guard lock(mutex_);
    came = std::exchange(finished_, {});
  }
  if (!came)
    return;
  drawing_ = false;
  came_ = begun_;
  image_ = std::move(came->image);
  frame_ms_ = came->ms;
  ++frames_;
  suit_coarseness();
  frame_came();
  update();
  if (isVisible())
    begin();
}

void vtk_view::wait() {
  if (!drawing_)
    return;
  thread_->run([] {});
  collect();
}

void vtk_view::draw_aside(const std::function<void(vtkRenderer&)>& before,
                          const std::function<void(vtkRenderer&)>& after,
                          const std::function<void(const QImage&)>& then) {
  if (!canvas_)
    return;
  const int dpi = qRound(96.0 * image_.width() / std::max(1, width()));
  thread_->post([=, this, size = image_.size()] {
    before(canvas_->renderer());
    const auto image = canvas_->draw(size, dpi);
    after(canvas_->renderer());
    QMetaObject::invokeMethod(
      this, [image, then] { then(image); }, Qt::QueuedConnection);
  });
}

QImage vtk_view::picture() {
  wait();
  const bool quick = std::exchange(quick_, false);  // A picture has all pixels, also while turned.
  begin();
  wait();
  quick_ = quick;
  auto result = image_;
  result.setDevicePixelRatio(devicePixelRatioF());
  return result;
}

void vtk_view::draw_quickly() {
  quick_ = true;
  fine_again_.start(fine_after_ms);
}

void vtk_view::suit_coarseness() {
  if (!quick_)
    return;
  const double more = static_cast<double>(coarseness_) / std::max(1, coarseness_ - 1);
  if (frame_ms_ > slow_ms)
    coarseness_ = std::min(coarseness_ + 1, coarsest);
  else if (frame_ms_ * more * more < slow_ms)
    coarseness_ = std::max(coarseness_ - 1, 1);
}

void vtk_view::resizeEvent(QResizeEvent*) {
  redraw();
}

/// The last frame, also where the next one is not there yet or has other pixels.
void vtk_view::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (image_.isNull())
    painter.fillRect(rect(), palette().window());
  painter.setRenderHint(QPainter::SmoothPixmapTransform, !is_fine());
  painter.drawImage(rect(), image_);
  painter.end();
  const bool other_screen = !image_.isNull() && !is_fine() && !quick_;
  if (std::exchange(seen_, came_) != came_)
    emit drawn();
  if (other_screen && begun_ == asked_ && !drawing_)
    redraw();
  else if (begun_ != asked_)
    begin_soon();
}

}  // namespace tedit::desktop
