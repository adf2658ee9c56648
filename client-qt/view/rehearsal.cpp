// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/rehearsal.hpp"

#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include "client-qt/view/camera.hpp"
#include "client-qt/view/vtk_view.hpp"

namespace tedit::desktop {

namespace {

constexpr int pause_ms = 15;
constexpr int last_frame = 7;

/// A tetrahedron with two surfaces.
std::shared_ptr<const part_geometry> tiny_part() {
  client::surface_update all;
  all.version_id = "rehearsal";
  all.vertices = {0, 1, 2, 3};
  all.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  all.facets = {0, 1, 2, 3};
  all.facet_vertices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  all.facet_surfaces = {1, 1, 1, 2};
  client::surface_model model;
  [[maybe_unused]] const auto ok = model.apply(all);  // Its data are above.
  return build_part(model, {}, {}, 0);
}

vtkSmartPointer<vtkPolyData> tiny_cap() {
  client::section cut;
  cut.positions = {0, 0, 0.3, 0.7, 0, 0.3, 0, 0.7, 0.3};
  cut.triangles = {0, 1, 2};
  return make_cap(cut, 0);
}

}  // namespace

rehearsal::rehearsal(vtk_view& view, QObject* parent) : QObject(parent), view_(view) {
  pause_.setInterval(pause_ms);
  connect(&pause_, &QTimer::timeout, this, &rehearsal::next);
}

rehearsal::~rehearsal() {
  end();
}

void rehearsal::start() {
  if (std::exchange(begun_, true))
    return;
  scene_ = std::make_unique<scene>(renderer_);
  pause_.start();
}

void rehearsal::next() {
  const int frame = frame_++;
  set_up(frame);
  auto* shown = frame == 0 ? nullptr : renderer_.Get();
  if (frame > last_frame || !view_.draw_unseen(shown, frame == last_frame))
    end();
}

void rehearsal::end() {
  pause_.stop();
  if (!scene_)
    return;
  view_.forget(renderer_);
  scene_.reset();
}

/// Each adds to what the one before shows; the first has nothing but the background, the last is
/// drawn quickly.
void rehearsal::set_up(int frame) {
  if (frame == 2) {
    scene_->set_part(tiny_part());
    scene_->cull_backs(true);
    camera(renderer_).fit(scene_->part()->bounds);
  } else if (frame == 3) {
    scene_->show_values(std::vector<float>(scene_->part()->vertices.size(), 0.5F), {});
  } else if (frame == 4) {
    scene_->select({2});
    scene_->hover(1);
  } else if (frame == 5) {
    scene_->cull_backs(false);
    scene_->clip(section_plane{{0, 0, 0.3}, {0, 0, 1}});
  } else if (frame == 6) {
    scene_->set_cap(tiny_cap(), std::vector<float>(3, 0.5F), {});
  }
}

}  // namespace tedit::desktop
