// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/vtk_view.hpp"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace tedit::desktop {

namespace {

constexpr int fine_after_ms = 200;
// A quick frame that takes longer gets fewer pixels, a shorter one more. Twice as many each way
// cost four times as much at most: the two limits are further apart than that.
constexpr double slow_ms = 35;
constexpr double fast_ms = 8;
constexpr int coarsest = 4;

}  // namespace

vtk_view::vtk_view(QWidget* parent) : QOpenGLWidget(parent) {
  setTextureFormat(GL_RGB8);  // Without alpha: what lies behind the window must not shine through.
  window_->SetOwnContext(0);
  window_->AddRenderer(renderer_);
  fine_again_.setSingleShot(true);
  connect(&fine_again_, &QTimer::timeout, this, [this] {
    quick_ = false;
    set_pixels();
    update();
  });
  vtkNew<vtkCallbackCommand> make_current;
  make_current->SetClientData(this);
  make_current->SetCallback(&vtk_view::on_make_current);
  window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, make_current);
  vtkNew<vtkCallbackCommand> is_current;
  is_current->SetClientData(this);
  is_current->SetCallback(&vtk_view::on_is_current);
  window_->AddObserver(vtkCommand::WindowIsCurrentEvent, is_current);
}

vtk_view::~vtk_view() {
  if (context())  // The base class ends it when we are half gone.
    disconnect(context(), nullptr, this, nullptr);
  release();
  window_->RemoveAllObservers();
}

void vtk_view::release() {
  if (!context())
    return;
  makeCurrent();
  window_->Finalize();
  doneCurrent();
}

/// QOpenGLWidget::makeCurrent binds its own framebuffer: in the middle of VTK's frame that would
/// take VTK's away, so it is called only when another context is current.
void vtk_view::on_make_current(vtkObject*, unsigned long, void* self, void*) {
  auto* view = static_cast<vtk_view*>(self);
  if (view->context() && QOpenGLContext::currentContext() != view->context())
    view->makeCurrent();
}

void vtk_view::on_is_current(vtkObject*, unsigned long, void* self, void* data) {
  const auto* view = static_cast<vtk_view*>(self);
  *static_cast<bool*>(data) = QOpenGLContext::currentContext() == view->context();
}

void vtk_view::initializeGL() {
  // The context may be replaced when the widget moves to another window.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &vtk_view::release,
          Qt::UniqueConnection);
  // Smooth edges cost a processor that draws by itself most of a frame.
  const auto* renderer =
    reinterpret_cast<const char*>(context()->functions()->glGetString(GL_RENDERER));
  const std::string_view name = renderer ? renderer : "";
  software_ = name.find("llvmpipe") != name.npos || name.find("softpipe") != name.npos;
  window_->SetMultiSamples(software_ ? 0 : 4);
  window_->SetReadyForRendering(true);
  window_->SetForceMaximumHardwareLineWidth(1);
  window_->OpenGLInitContext();
  window_->SetFrameBlitModeToNoBlit();
}

void vtk_view::resizeGL(int, int) {
  set_pixels();
}

void vtk_view::set_pixels() {
  const double ratio = devicePixelRatioF() / (quick_ ? coarseness_ : 1);
  window_->SetSize(std::max(1, qRound(width() * ratio)), std::max(1, qRound(height() * ratio)));
  window_->SetDPI(qRound(96 * ratio));
}

void vtk_view::draw_quickly() {
  if (!software_)
    return;
  if (!std::exchange(quick_, true))
    set_pixels();
  fine_again_.start(fine_after_ms);
}

double vtk_view::pixel_ratio() const {
  return static_cast<double>(window_->GetSize()[0]) / std::max(1, width());
}

void vtk_view::paintGL() {
  if (unseen_) {
    if (!renderer_->GetDraw())
      draw();
    return;
  }
  QElapsedTimer clock;
  clock.start();
  about_to_draw();
  draw();
  frame_ms_ = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
  ++frames_;
  suit_coarseness();
  emit drawn();
}

void vtk_view::draw() {
  auto* state = window_->GetState();
  state->Reset();
  state->Push();
  state->vtkglDepthFunc(GL_LEQUAL);
  window_->Render();
  const int* size = window_->GetSize();
  const double ratio = devicePixelRatioF();
  const QSize shown(qRound(width() * ratio), qRound(height() * ratio));
  auto* gl = context()->functions();
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  state->ResetFramebufferBindings();
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  const GLenum target = GL_COLOR_ATTACHMENT0;
  state->vtkglDrawBuffers(1, const_cast<GLenum*>(&target));
  state->vtkglDisable(GL_SCISSOR_TEST);
  window_->BlitDisplayFramebuffer(0, 0, 0, size[0], size[1], 0, 0, shown.width(), shown.height(),
                                  GL_COLOR_BUFFER_BIT, quick_ ? GL_LINEAR : GL_NEAREST);
  state->Pop();
}

bool vtk_view::draw_unseen(vtkRenderer* other, bool quickly) {
  if (isVisible() || (quickly && !software_))
    return false;
  if (other && !window_->HasRenderer(other))
    window_->AddRenderer(other);
  renderer_->SetDraw(other == nullptr);
  if (other)
    other->DrawOn();
  unseen_ = true;
  quick_ = quickly;
  if (isValid())
    set_pixels();
  const bool drawn = !grabFramebuffer().isNull();
  quick_ = false;
  set_pixels();
  unseen_ = false;
  if (other)
    other->DrawOff();
  renderer_->DrawOn();
  return drawn;
}

void vtk_view::forget(vtkRenderer* other) {
  if (!window_->HasRenderer(other))
    return;
  makeCurrent();
  window_->RemoveRenderer(other);
  doneCurrent();
}

void vtk_view::suit_coarseness() {
  if (!quick_)
    return;
  const int before = coarseness_;
  if (frame_ms_ > slow_ms)
    coarseness_ = std::min(coarseness_ + 1, coarsest);
  else if (frame_ms_ < fast_ms)
    coarseness_ = std::max(coarseness_ - 1, 1);
  if (coarseness_ != before)
    set_pixels();
}

}  // namespace tedit::desktop
