// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/preview_layer.hpp"

#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace tedit::desktop {

namespace {

// Cold against the accent's warmth, and readable on both backgrounds.
constexpr rgb ghost_colour{0.25F, 0.50F, 0.85F};
constexpr rgb fault_colour{0.85F, 0.16F, 0.16F};
constexpr double ghost_opacity = 0.30;

void set(vtkActor* actor, const rgb& c) {
  actor->GetProperty()->SetColor(c[0], c[1], c[2]);
}

}  // namespace

preview_layer::piece::piece() {
  mapper->ScalarVisibilityOff();
  actor->SetMapper(mapper);
  actor->PickableOff();
  actor->VisibilityOff();
}

preview_layer::piece::~piece() = default;

void preview_layer::piece::show(vtkPolyData* data) {
  actor->SetVisibility(data != nullptr);
  if (data)
    mapper->SetInputData(data);
}

preview_layer::preview_layer(vtkRenderer* renderer) {
  for (auto* one : all_)
    renderer->AddActor(one->actor);
  for (auto* over : {&added_, &fault_}) {  // Between the faces and their edges, as a selection.
    over->mapper->SetResolveCoincidentTopologyToPolygonOffset();
    over->mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.5, 0.5);
    over->actor->GetProperty()->SetAmbient(0.28);
    over->actor->GetProperty()->SetDiffuse(0.8);
  }
  ghost_.actor->GetProperty()->SetOpacity(ghost_opacity);
  ghost_.actor->GetProperty()->SetAmbient(0.4);
  for (auto* lines : {&added_edges_, &ghost_edges_}) {
    lines->actor->GetProperty()->LightingOff();
    lines->actor->GetProperty()->SetLineWidth(1.2F);
  }
  set(ghost_.actor, ghost_colour);
  set(ghost_edges_.actor, ghost_colour);
  set(fault_.actor, fault_colour);
  set_colours({});
}

preview_layer::~preview_layer() = default;

void preview_layer::set_colours(const scene_colours& colours) {
  set(added_.actor, colours.accent);
  set(added_edges_.actor, colours.edges);
}

void preview_layer::show(const std::shared_ptr<const preview_geometry>& what) {
  const auto* added = what ? what->added.get() : nullptr;
  const auto* removed = what ? what->removed.get() : nullptr;
  added_.show(added ? added->faces.Get() : nullptr);
  added_edges_.show(added ? added->edges.Get() : nullptr);
  ghost_.show(removed ? removed->faces.Get() : nullptr);
  ghost_edges_.show(removed ? removed->edges.Get() : nullptr);
}

void preview_layer::mark(const part_geometry& part, const std::vector<surface_id>& surfaces) {
  marked_ = !surfaces.empty();
  fault_.show(surfaces.empty() ? nullptr : extract(part, surfaces).Get());
}

void preview_layer::show_marks(bool on) {
  fault_.actor->SetVisibility(on && marked_);
}

void preview_layer::clip(const std::optional<section_plane>& plane) {
  if (plane) {  // VTK keeps what the normal points to.
    plane_->SetOrigin(plane->at.x, plane->at.y, plane->at.z);
    plane_->SetNormal(-plane->normal.x, -plane->normal.y, -plane->normal.z);
  }
  for (auto* one : all_) {
    one->mapper->RemoveAllClippingPlanes();
    if (plane)
      one->mapper->AddClippingPlane(plane_);
  }
}

}  // namespace tedit::desktop
