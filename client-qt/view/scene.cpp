// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/scene.hpp"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace tedit::desktop {

namespace {

constexpr int table_steps = 256;

void set(vtkProperty* property, const rgb& c) {
  property->SetColor(c[0], c[1], c[2]);
}

constexpr double usual_dpi = 96;

void matt(vtkProperty* property) {
  property->SetAmbient(0.28);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.06);
}

/// For faces that carry values: their colour is to be compared with the legend's whichever way they
/// look, so the light only hints at the shape. A face 60 degrees away has nine tenths of it.
void even(vtkProperty* property) {
  property->SetAmbient(0.87);
  property->SetDiffuse(0.14);
  property->SetSpecular(0);
}

/// Where each value stands on the legend's scale; NaN stays NaN.
vtkSmartPointer<vtkFloatArray> places_of(std::span<const float> values, const legend& by) {
  auto places = vtkSmartPointer<vtkFloatArray>::New();
  places->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    places->SetValue(static_cast<vtkIdType>(i),
                     std::isfinite(values[i]) ? static_cast<float>(by.place(values[i])) : NAN);
  return places;
}

/// Two lights that go with the camera, from above left and below right: a single one at the camera
/// leaves what is seen at an angle dark.
void light(vtkRenderer& renderer) {
  const auto add = [&](double x, double y, double z, double strength) {
    vtkNew<vtkLight> lamp;
    lamp->SetLightTypeToCameraLight();
    lamp->SetPosition(x, y, z);
    lamp->SetFocalPoint(0, 0, 0);
    lamp->SetIntensity(strength);
    renderer.AddLight(lamp);
  };
  renderer.AutomaticLightCreationOff();
  add(-0.35, 0.9, 0.8, 0.75);
  add(0.6, -0.3, 0.9, 0.35);
}

/// Well spread hues: steps of the golden angle. Pale, so that selection and edges stand out.
std::array<unsigned char, 3> surface_colour(std::size_t place) {
  const double hue = 6 * std::fmod(0.618033988749895 * static_cast<double>(place), 1.0);
  const auto channel = [&](double shift) {
    const double t = std::abs(std::fmod(hue + shift, 6.0) - 3) - 1;
    return static_cast<unsigned char>(255 * (0.58 + 0.30 * std::clamp(t, 0.0, 1.0)));
  };
  return {channel(0), channel(4), channel(2)};
}

}  // namespace

scene::scene(vtkRenderer* renderer) : renderer_(renderer), selected_(0.2, 3), hovered_(0.1, 1.5) {
  renderer_->GradientBackgroundOn();
  light(*renderer_);
  face_mapper_->SetInputData(faces_);
  face_mapper_->SetLookupTable(table_);
  face_mapper_->SetScalarRange(0, 1);
  face_mapper_->InterpolateScalarsBeforeMappingOn();
  // Faces a little back, so that edges and highlights lie on them.
  face_mapper_->SetResolveCoincidentTopologyToPolygonOffset();
  face_mapper_->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1);
  face_actor_->SetMapper(face_mapper_);
  matt(face_actor_->GetProperty());
  edge_mapper_->ScalarVisibilityOff();
  edge_actor_->SetMapper(edge_mapper_);
  edge_actor_->GetProperty()->SetLineWidth(1.2F);
  edge_actor_->GetProperty()->LightingOff();
  for (auto [mapper, actor] : {std::pair(iso_mapper_.Get(), iso_actor_.Get()),
                               std::pair(cap_iso_mapper_.Get(), cap_iso_actor_.Get())}) {
    mapper->ScalarVisibilityOff();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetLineWidth(1.4F);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    actor->VisibilityOff();
    renderer_->AddActor(actor);
  }
  cap_mapper_->SetInputData(cap_);
  cap_mapper_->SetLookupTable(table_);
  cap_mapper_->SetScalarRange(0, 1);
  cap_mapper_->InterpolateScalarsBeforeMappingOn();
  cap_mapper_->SetResolveCoincidentTopologyToPolygonOffset();
  cap_mapper_->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1);
  cap_actor_->SetMapper(cap_mapper_);
  cap_actor_->GetProperty()->LightingOff();  // Flat: the colours can be compared with the legend.
  cap_actor_->VisibilityOff();
  renderer_->AddActor(cap_actor_);
  load_actor_->SetMapper(load_mapper_);
  support_actor_->SetMapper(support_mapper_);
  for (auto* actor :
       {face_actor_.Get(), edge_actor_.Get(), load_actor_.Get(), support_actor_.Get()})
    renderer_->AddActor(actor);
  selected_.add_to(*renderer_);
  hovered_.add_to(*renderer_);
  for (auto* actor : {load_actor_.Get(), support_actor_.Get()})
    actor->VisibilityOff();
  vtkNew<vtkCallbackCommand> begins;
  begins->SetClientData(this);
  begins->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<scene*>(self)->suit_pixels(); });
  begins_frame_ = renderer_->AddObserver(vtkCommand::StartEvent, begins);
  set_colours({});
}

scene::~scene() {
  renderer_->RemoveObserver(begins_frame_);
}

/// A frame may have more or fewer pixels than the widget: on a fine screen, or while it is quick.
void scene::suit_pixels() {
  const double ratio = renderer_->GetRenderWindow()->GetDPI() / usual_dpi;
  for (auto* one : {&selected_, &hovered_})
    one->set_pixel_ratio(ratio);
}

void scene::set_colours(const scene_colours& colours) {
  colours_ = colours;
  renderer_->SetBackground(colours.low[0], colours.low[1], colours.low[2]);
  renderer_->SetBackground2(colours.high[0], colours.high[1], colours.high[2]);
  set(face_actor_->GetProperty(), colours.part);
  set(cap_actor_->GetProperty(), colours.part);
  set(edge_actor_->GetProperty(), colours.edges);
  for (auto* lines : {iso_actor_.Get(), cap_iso_actor_.Get()})
    set(lines->GetProperty(), colours.edges);
  selected_.set_colour(colours.accent);
  hovered_.set_colour(colours.hover);
  for (auto* marks : {load_actor_.Get(), support_actor_.Get()}) {
    marks->GetProperty()->SetAmbient(0.55);  // They are read by their colour, also in the shade.
    marks->GetProperty()->SetDiffuse(0.5);
  }
  load_actor_->GetProperty()->SetColor(0.86, 0.14, 0.44);
  support_actor_->GetProperty()->SetColor(0.05, 0.45, 0.65);
  face_actor_->GetProperty()->SetEdgeColor(colours.edges[0], colours.edges[1], colours.edges[2]);
}

void scene::set_part(std::shared_ptr<const part_geometry> part) {
  part_ = std::move(part);
  edge_mapper_->SetInputData(part_->edges);
  picked_.clear();
  under_pointer_.reset();
  show_highlights(highlights_);
  iso_actor_->VisibilityOff();
  paint_faces();
  show_plain();
}

/// The part's own mesh is shared among threads and never changed: ours has its points and cells.
void scene::paint_faces() {
  if (hidden_.empty()) {
    faces_->ShallowCopy(part_->faces);
    return;
  }
  std::vector<surface_id> left;
  for (const auto& [id, range] : part_->cells)
    if (!hidden_.contains(id))
      left.push_back(id);
  faces_->ShallowCopy(extract(*part_, left));
}

void scene::show_plain() {
  light_evenly(false);
  face_mapper_->ScalarVisibilityOff();
}

void scene::light_evenly(bool on) {
  on ? even(face_actor_->GetProperty()) : matt(face_actor_->GetProperty());
}

void scene::show_surfaces() {
  if (!part_)
    return;
  light_evenly(false);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  std::size_t place = 0;
  for (const auto& [id, range] : part_->cells) {
    const auto c = surface_colour(place++);
    for (auto i = range.first; !hidden_.contains(id) && i < range.second; ++i)
      colours->InsertNextTypedTuple(c.data());
  }
  show_cell_colours(colours);
}

void scene::show_print_marks(const std::vector<print_mark>& marks) {
  if (!part_ || marks.size() != part_->cell_surface.size())
    return;
  light_evenly(false);
  auto palette = print_mark_colours;
  for (std::size_t c = 0; c < 3; ++c)
    palette[0][c] = static_cast<std::uint8_t>(std::lround(255 * colours_.part[c]));
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (const auto& [id, range] : part_->cells)
    for (auto i = range.first; !hidden_.contains(id) && i < range.second; ++i)
      colours->InsertNextTypedTuple(
        palette[static_cast<std::size_t>(marks[static_cast<std::size_t>(i)])].data());
  show_cell_colours(colours);
}

/// A row for each cell that is drawn.
void scene::show_cell_colours(vtkUnsignedCharArray* colours) {
  faces_->GetCellData()->SetScalars(colours);
  face_mapper_->SetScalarModeToUseCellData();
  face_mapper_->SetColorModeToDirectScalars();
  face_mapper_->ScalarVisibilityOn();
}

void scene::show_values(std::span<const float> values, const legend& by) {
  if (!part_ || values.size() != part_->vertices.size())
    return;
  light_evenly(true);
  fill_table(by);
  faces_->GetPointData()->SetScalars(places_of(values, by));
  face_mapper_->SetScalarModeToUsePointData();
  face_mapper_->SetColorModeToMapScalars();
  face_mapper_->ScalarVisibilityOn();
}

void scene::fill_table(const legend& by) {
  table_->SetNumberOfTableValues(table_steps);
  table_->SetRange(0, 1);
  for (int i = 0; i < table_steps; ++i) {
    const auto c = by.colour_at(static_cast<double>(i) / (table_steps - 1));
    table_->SetTableValue(i, c[0], c[1], c[2], 1);
  }
  table_->SetNanColor(colours_.part[0], colours_.part[1], colours_.part[2], 1);
}

void scene::cull_backs(bool on) {
  face_actor_->GetProperty()->SetBackfaceCulling(on);
}

void scene::clip(const std::optional<section_plane>& plane) {
  if (plane) {  // VTK keeps what the normal points to.
    plane_->SetOrigin(plane->at.x, plane->at.y, plane->at.z);
    plane_->SetNormal(-plane->normal.x, -plane->normal.y, -plane->normal.z);
  }
  for (auto* mapper : {face_mapper_.Get(), edge_mapper_.Get(), iso_mapper_.Get(),
                       load_mapper_.Get(), support_mapper_.Get()}) {
    mapper->RemoveAllClippingPlanes();
    if (plane)
      mapper->AddClippingPlane(plane_);
  }
  for (auto* one : {&selected_, &hovered_})
    one->clip(plane ? plane_.Get() : nullptr);
}

void scene::set_cap(vtkPolyData* cap, std::span<const float> values, const legend& by) {
  cap_actor_->SetVisibility(cap != nullptr);
  if (!cap)
    return;
  cap_->ShallowCopy(cap);
  const bool coloured =
    !values.empty() && static_cast<vtkIdType>(values.size()) == cap->GetNumberOfPoints();
  cap_mapper_->SetScalarVisibility(coloured);
  if (coloured) {
    fill_table(by);
    cap_->GetPointData()->SetScalars(places_of(values, by));
  }
}

void scene::select(const std::vector<surface_id>& picked) {
  picked_ = picked;
  show_selection();
}

void scene::hover(std::optional<surface_id> under_pointer) {
  under_pointer_ = under_pointer;
  show_hovered();
}

void scene::show_highlights(bool on) {
  highlights_ = on;
  show_selection();
  show_hovered();
}

void scene::show_selection() {
  if (part_ && highlights_)
    selected_.show(*part_, picked_);
  else
    selected_.hide();
}

void scene::show_hovered() {
  if (part_ && highlights_ && under_pointer_)
    hovered_.show(*part_, {*under_pointer_});
  else
    hovered_.hide();
}

void scene::hide(const std::set<surface_id>& hidden) {
  hidden_ = hidden;
  if (part_)
    paint_faces();
}

void scene::show_mesh(bool on) {
  face_actor_->GetProperty()->SetEdgeVisibility(on);
}

void scene::show_edges(bool on) {
  edge_actor_->SetVisibility(on);
}

void scene::set_isolines(vtkPolyData* lines) {
  iso_actor_->SetVisibility(lines != nullptr);
  if (lines)
    iso_mapper_->SetInputData(lines);
}

void scene::set_cap_isolines(vtkPolyData* lines) {
  cap_iso_actor_->SetVisibility(lines != nullptr);
  if (lines)
    cap_iso_mapper_->SetInputData(lines);
}

void scene::set_glyphs(vtkPolyData* loads, vtkPolyData* supports) {
  load_actor_->SetVisibility(loads != nullptr);
  support_actor_->SetVisibility(supports != nullptr);
  if (loads)
    load_mapper_->SetInputData(loads);
  if (supports)
    support_mapper_->SetInputData(supports);
}

}  // namespace tedit::desktop
