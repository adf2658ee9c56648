// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/canvas.hpp"

#include <QOpenGLFunctions>
#include <QThread>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace tedit::desktop {

namespace {

/// Of the current context.
bool draws_by_processor(QOpenGLContext& context) {
  const auto* renderer =
    reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
  const std::string_view name = renderer ? renderer : "";
  return name.find("llvmpipe") != name.npos || name.find("softpipe") != name.npos;
}

/// OpenGL's rows begin at the bottom, and red comes first.
QImage upright(const std::vector<std::uint32_t>& pixels, int width, int height) {
  QImage result(width, height, QImage::Format_RGB32);
  for (int y = 0; y < height; ++y) {
    const auto* from = pixels.data() + static_cast<std::size_t>(height - 1 - y) * width;
    auto* row = reinterpret_cast<std::uint32_t*>(result.scanLine(y));
    for (int x = 0; x < width; ++x) {
      const std::uint32_t p = from[x];
      row[x] = 0xff000000U | (p & 0xffU) << 16U | (p & 0xff00U) | (p >> 16U & 0xffU);
    }
  }
  return result;
}

}  // namespace

canvas::canvas(QThread* place) {
  surface_.setFormat(context_.format());
  surface_.create();
  (void)context_.create();  // `draw` says so when it did not work.
  context_.moveToThread(place);
  window_->SetOwnContext(0);
  window_->AddRenderer(renderer_);
  vtkNew<vtkCallbackCommand> make_current;
  make_current->SetClientData(this);
  make_current->SetCallback(&canvas::on_make_current);
  window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, make_current);
  vtkNew<vtkCallbackCommand> is_current;
  is_current->SetClientData(this);
  is_current->SetCallback(&canvas::on_is_current);
  window_->AddObserver(vtkCommand::WindowIsCurrentEvent, is_current);
}

canvas::~canvas() {
  window_->RemoveAllObservers();
}

void canvas::on_make_current(vtkObject*, unsigned long, void* self, void*) {
  auto& mine = *static_cast<canvas*>(self);
  if (mine.begun_ && QOpenGLContext::currentContext() != &mine.context_)
    mine.context_.makeCurrent(&mine.surface_);
}

void canvas::on_is_current(vtkObject*, unsigned long, void* self, void* data) {
  const auto& mine = *static_cast<canvas*>(self);
  *static_cast<bool*>(data) = mine.begun_ && QOpenGLContext::currentContext() == &mine.context_;
}

void canvas::begin() {
  // Smooth edges cost a processor that draws by itself most of a frame.
  window_->SetMultiSamples(draws_by_processor(context_) ? 0 : 4);
  window_->SetReadyForRendering(true);
  window_->SetForceMaximumHardwareLineWidth(1);
  window_->OpenGLInitContext();
  window_->SetFrameBlitModeToNoBlit();
}

QImage canvas::draw(const QSize& pixels, int dpi) {
  if (!context_.isValid() || !context_.makeCurrent(&surface_))
    return {};
  if (!std::exchange(begun_, true))
    begin();
  window_->SetSize(std::max(1, pixels.width()), std::max(1, pixels.height()));
  window_->SetDPI(dpi);
  auto* state = window_->GetState();
  state->Reset();
  state->Push();
  state->vtkglDepthFunc(GL_LEQUAL);
  renderer_->ResetCameraClippingRange();
  window_->Render();
  auto result = read();
  state->Pop();
  return result;
}

QImage canvas::read() {
  const int* size = window_->GetSize();
  pixels_.resize(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
  auto* state = window_->GetState();
  state->PushReadFramebufferBinding();
  window_->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  state->vtkglReadBuffer(GL_COLOR_ATTACHMENT0);
  context_.functions()->glReadPixels(0, 0, size[0], size[1], GL_RGBA, GL_UNSIGNED_BYTE,
                                     pixels_.data());
  state->PopReadFramebufferBinding();
  return upright(pixels_, size[0], size[1]);
}

void canvas::finish() {
  if (begun_ && context_.makeCurrent(&surface_)) {
    window_->Finalize();
    begun_ = false;
    context_.doneCurrent();
  }
  context_.moveToThread(surface_.thread());
}

}  // namespace tedit::desktop
