// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/highlight.hpp"

#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace tedit::desktop {

highlight::highlight(double tint, double width) : width_(width) {
  tint_mapper_->ScalarVisibilityOff();
  // Between the faces, which are farther back, and the edges.
  tint_mapper_->SetResolveCoincidentTopologyToPolygonOffset();
  tint_mapper_->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.5, 0.5);
  tint_actor_->SetMapper(tint_mapper_);
  tint_actor_->GetProperty()->SetOpacity(tint);
  tint_actor_->GetProperty()->LightingOff();  // The face below has its light already.
  // Drawn after the faces, it needs no sorting of what can be seen through, which costs two passes
  // more.
  tint_actor_->ForceOpaqueOn();
  line_mapper_->ScalarVisibilityOff();
  // Half of a wide line lies over faces beside it: they must not cut it off.
  line_mapper_->SetRelativeCoincidentTopologyLineOffsetParameters(-1, -8);
  line_actor_->SetMapper(line_mapper_);
  line_actor_->GetProperty()->LightingOff();
  for (auto* actor : {tint_actor_.Get(), line_actor_.Get()})
    actor->PickableOff();
  set_pixel_ratio(1);
  hide();
}

highlight::~highlight() = default;

void highlight::add_to(vtkRenderer& renderer) {
  renderer.AddActor(tint_actor_);
  renderer.AddActor(line_actor_);
}

void highlight::set_colour(const rgb& c) {
  for (auto* actor : {tint_actor_.Get(), line_actor_.Get()})
    actor->GetProperty()->SetColor(c[0], c[1], c[2]);
}

void highlight::show(const part_geometry& part, const std::vector<surface_id>& surfaces) {
  if (surfaces.empty())
    return hide();
  tint_mapper_->SetInputData(extract(part, surfaces));
  line_mapper_->SetInputData(outline(part, surfaces));
  for (auto* actor : {tint_actor_.Get(), line_actor_.Get()})
    actor->VisibilityOn();
}

void highlight::hide() {
  for (auto* actor : {tint_actor_.Get(), line_actor_.Get()})
    actor->VisibilityOff();
}

void highlight::set_pixel_ratio(double ratio) {
  line_actor_->GetProperty()->SetLineWidth(static_cast<float>(width_ * ratio));
}

void highlight::clip(vtkPlane* plane) {
  for (auto* mapper : {tint_mapper_.Get(), line_mapper_.Get()}) {
    mapper->RemoveAllClippingPlanes();
    if (plane)
      mapper->AddClippingPlane(plane);
  }
}

}  // namespace tedit::desktop
