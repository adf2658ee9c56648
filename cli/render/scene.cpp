// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/render/scene.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDoubleArray.h>
#include <vtkFeatureEdges.h>
#include <vtkLookupTable.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnstructuredGrid.h>
#include <vtkWarpVector.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string_view>

#include "base/colour_map.hpp"

namespace tedit::picture {

namespace {

// What has no value: darker than the middle of the colours and without a tint.
constexpr double no_value = 0.45;

// As compare/compare_fields.hpp calls the arrays of a difference, and its mark for what is outside.
constexpr std::string_view difference_ending = "_difference";
constexpr const char* mark_name = "difference_mark";
constexpr double outside_mark = 2;

// Of the picture's height: where the texts stand, and by what its pixels are divided for their
// size.
constexpr double title_at = 0.935;
constexpr int title_share = 32;
constexpr double caption_at = 0.03;
constexpr int caption_share = 52;

void fill_colours(vtkLookupTable* table, bool diverging) {
  const auto& colours = diverging ? cool_to_warm : viridis;
  constexpr int steps = 256;
  table->SetNumberOfTableValues(steps);
  for (int i = 0; i < steps; ++i) {
    const auto c = colour_at(colours, static_cast<double>(i) / (steps - 1));
    table->SetTableValue(i, c[0], c[1], c[2], 1);
  }
  table->SetNanColor(no_value, no_value, no_value, 1);
}

/// The mark of a difference's points, whose field is called "NAME_difference", of several load
/// cases "NAME_difference (CASE)". Null: the field is no difference.
vtkDataArray* mark_of(vtkPolyData* surface, const std::string& field) {
  const auto at = field.find(difference_ending);
  if (at == std::string::npos)
    return nullptr;
  const auto of_case = field.substr(at + difference_ending.size());
  return surface->GetPointData()->GetArray((mark_name + of_case).c_str());
}

bool is_diverging(vtkPolyData* surface, const picture_options& options) {
  return options.diverging || mark_of(surface, options.field) != nullptr;
}

/// From the smallest value to the largest one, as far on both sides of zero when the colours
/// diverge.
std::array<double, 2> range_of(vtkDataArray* values, bool diverging) {
  std::array<double, 2> range{1e300, -1e300};
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    if (const double value = values->GetComponent(i, 0); std::isfinite(value))
      range = {std::min(range[0], value), std::max(range[1], value)};
  if (range[0] > range[1])
    range = {0, 0};
  if (diverging) {
    const double most = std::max(std::abs(range[0]), std::abs(range[1]));
    range = {-most, most};
  }
  return range;
}

/// The field as one number per point in the legend's unit, under the name "shown".
expected<void> add_shown(vtkPolyData* surface, const picture_options& options) {
  auto* field = surface->GetPointData()->GetArray(options.field.c_str());
  if (!field) {
    std::string known;
    for (int i = 0; i < surface->GetPointData()->GetNumberOfArrays(); ++i)
      known += (known.empty() ? "" : ", ") + std::string(surface->GetPointData()->GetArrayName(i));
    return fail(ec::bad_input, "the file has no point field \"" + options.field + "\"",
                "It has " + (known.empty() ? "none" : known), options.input);
  }
  vtkNew<vtkDoubleArray> shown;
  shown->SetName("shown");
  shown->SetNumberOfTuples(field->GetNumberOfTuples());
  auto* mark = mark_of(surface, options.field);
  for (vtkIdType i = 0; i < field->GetNumberOfTuples(); ++i) {
    double sum = 0;
    for (int c = 0; c < field->GetNumberOfComponents(); ++c)
      sum += field->GetComponent(i, c) * field->GetComponent(i, c);
    const double value =
      field->GetNumberOfComponents() == 1 ? field->GetComponent(i, 0) : std::sqrt(sum);
    const bool known = !mark || mark->GetComponent(i, 0) != outside_mark;
    shown->SetValue(i, known ? options.scale * value : std::nan(""));
  }
  surface->GetPointData()->SetScalars(shown);
  return {};
}

/// Where the part is drawn, as shares of the picture: heading, small print and legend lie outside.
struct part_area {
  double left = 0;
  double bottom = 0;
  double right = 0.905;
  double top = 1;
};

part_area area_of(const picture_options& options) {
  part_area area;
  const auto lines = [](const std::string& text) {
    return static_cast<double>(std::ranges::count(text, '\n') + 1);
  };
  if (!options.title.empty())
    area.top = title_at - 0.01;
  if (!options.caption.empty())
    area.bottom = caption_at + 1.4 * lines(options.caption) / caption_share + 0.01;
  return area;
}

/// By how much the part would have to shrink to lie within the renderer's area as the camera looks
/// now; below 1 it may grow.
double overhang(vtkRenderer* renderer, vtkPolyData* part, double aspect) {
  const auto* to_picture =
    renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect, -1, 1)->GetData();
  double most = 0;
  for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i) {
    std::array<double, 4> p{0, 0, 0, 1};
    part->GetPoint(i, p.data());
    const auto row = [&](int r) {
      return to_picture[4 * r] * p[0] + to_picture[4 * r + 1] * p[1] +
             to_picture[4 * r + 2] * p[2] + to_picture[4 * r + 3];
    };
    most = std::max({most, std::abs(row(0) / row(3)), std::abs(row(1) / row(3))});
  }
  return most;
}

/// As near as a usual part may be, and so far that a tall one does not run over the texts.
void fit(vtkRenderer* renderer, vtkPolyData* part, const picture_options& options,
         const part_area& area) {
  constexpr double margin = 1.03;
  constexpr double usual_zoom = 1.35;
  auto* camera = renderer->GetActiveCamera();
  const double height = area.top - area.bottom;
  const double aspect =
    (area.right - area.left) * options.width / (height * static_cast<double>(options.height));
  const double half = camera->GetViewAngle() * std::numbers::pi / 360;
  const double all = std::atan(margin * overhang(renderer, part, aspect) * std::tan(half));
  const double usual = std::atan(height * std::tan(half / usual_zoom));
  camera->SetViewAngle(std::max(all, usual) * 360 / std::numbers::pi);
}

void aim(vtkRenderer* renderer, vtkPolyData* part, const picture_options& options,
         const part_area& area) {
  const auto& view = options.view;
  auto* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  const double sign = view.starts_with('-') ? -1 : 1;
  if (view.ends_with('x'))
    camera->SetPosition(sign, 0, 0);
  else if (view.ends_with('y'))
    camera->SetPosition(0, sign, 0);
  else if (view.ends_with('z')) {
    camera->SetPosition(0, 0, sign);
    camera->SetViewUp(0, 1, 0);
  } else
    camera->SetPosition(-0.55, -1, 0.75);
  renderer->ResetCamera();
  fit(renderer, part, options, area);
  if (options.focus) {
    std::array<double, 3> middle{};
    std::array<double, 3> eye{};
    camera->GetFocalPoint(middle.data());
    camera->GetPosition(eye.data());
    for (std::size_t i = 0; i < 3; ++i)
      eye[i] += (*options.focus)[i] - middle[i];
    camera->SetFocalPoint(options.focus->data());
    camera->SetPosition(eye.data());
  }
  camera->Zoom(options.zoom);
  renderer->ResetCameraClippingRange();
}

void style(vtkTextProperty* text, int size, bool bold) {
  text->SetFontFamilyToArial();
  text->SetFontSize(size);
  text->SetBold(bold);
  text->SetItalic(false);
  text->SetShadow(false);
  text->SetColor(0.13, 0.16, 0.20);
}

void add_text(vtkRenderer* renderer, const std::string& words, double x, double y, int size,
              bool bold) {
  if (words.empty())
    return;
  vtkNew<vtkTextActor> actor;
  actor->SetInput(words.c_str());
  style(actor->GetTextProperty(), size, bold);
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor->SetPosition(x, y);
  renderer->AddActor2D(actor);
}

void add_legend(vtkRenderer* renderer, vtkLookupTable* table, const picture_options& options) {
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(table);
  bar->SetTitle(options.unit.c_str());
  bar->SetNumberOfLabels(6);
  bar->SetLabelFormat("%.3g");
  bar->UnconstrainedFontSizeOn();
  bar->SetBarRatio(0.22);
  bar->SetVerticalTitleSeparation(options.height / 60);  // Else it touches the topmost label.
  style(bar->GetTitleTextProperty(), options.height / 42, true);
  style(bar->GetLabelTextProperty(), options.height / 50, false);
  bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->SetPosition(0.915, 0.18);
  bar->SetWidth(0.075);
  bar->SetHeight(0.62);
  renderer->AddActor2D(bar);
}

void add_surface(vtkRenderer* renderer, vtkPolyData* surface, vtkLookupTable* table, bool edges) {
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SetFeatureAngle(30);
  normals->SplittingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->SetLookupTable(table);
  mapper->SetScalarRange(table->GetRange());
  mapper->InterpolateScalarsBeforeMappingOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetDiffuse(0.75);
  actor->GetProperty()->SetSpecular(0.08);
  if (edges) {
    actor->GetProperty()->EdgeVisibilityOn();
    actor->GetProperty()->SetEdgeColor(0.2, 0.22, 0.26);
  }
  renderer->AddActor(actor);

  vtkNew<vtkFeatureEdges> sharp;
  sharp->SetInputData(surface);
  sharp->SetFeatureAngle(30);
  sharp->BoundaryEdgesOff();
  sharp->NonManifoldEdgesOff();
  sharp->ColoringOff();
  vtkNew<vtkPolyDataMapper> lines;
  lines->SetInputConnection(sharp->GetOutputPort());
  lines->ScalarVisibilityOff();
  vtkNew<vtkActor> outline;
  outline->SetMapper(lines);
  outline->GetProperty()->SetColor(0.12, 0.13, 0.16);
  outline->GetProperty()->SetLineWidth(1.2F);
  outline->GetProperty()->SetOpacity(0.55);
  renderer->AddActor(outline);
}

vtkSmartPointer<vtkPolyData> boundary_of(vtkUnstructuredGrid* grid, double deform) {
  vtkNew<vtkDataSetSurfaceFilter> filter;
  vtkNew<vtkWarpVector> warp;
  filter->SetInputData(grid);
  if (deform != 0 && grid->GetPointData()->HasArray("displacement_m")) {
    grid->GetPointData()->SetActiveVectors("displacement_m");
    warp->SetInputData(grid);
    warp->SetScaleFactor(deform);
    filter->SetInputConnection(warp->GetOutputPort());
  }
  filter->Update();
  return filter->GetOutput();
}

}  // namespace

expected<void> draw_picture(const picture_options& options) {
  if (!std::filesystem::is_regular_file(options.input))
    return fail(ec::io_error, "cannot read " + options.input + ": there is no such file");
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  if (!reader->CanReadFile(options.input.c_str()))
    return fail(ec::bad_input, options.input + " is no VTU file", "\"tedit solve -o\" writes them");
  reader->SetFileName(options.input.c_str());
  reader->Update();
  const auto surface = boundary_of(reader->GetOutput(), options.deform);
  if (surface->GetNumberOfCells() == 0)
    return fail(ec::bad_input, options.input + " holds no cells to draw");
  if (auto ok = add_shown(surface, options); !ok)
    return ok;

  vtkNew<vtkLookupTable> table;
  const bool diverging = is_diverging(surface, options);
  fill_colours(table, diverging);
  auto range = range_of(surface->GetPointData()->GetScalars(), diverging);
  if (options.range)
    range = {options.range->first, options.range->second};
  if (const double least = std::max(1e-12, std::abs(range[0]) * 1e-6); !(range[1] > range[0]))
    range = {range[0] - (diverging ? least : 0), range[1] + least};
  table->SetRange(range.data());

  vtkNew<vtkRenderer> backdrop;
  backdrop->GradientBackgroundOn();
  backdrop->SetBackground(0.98, 0.98, 0.985);
  backdrop->SetBackground2(0.80, 0.83, 0.87);
  add_legend(backdrop, table, options);
  add_text(backdrop, options.title, 0.025, title_at, options.height / title_share, true);
  add_text(backdrop, options.caption, 0.025, caption_at, options.height / caption_share, false);
  vtkNew<vtkRenderer> renderer;
  const auto area = area_of(options);
  renderer->SetViewport(area.left, area.bottom, area.right, area.top);
  renderer->SetLayer(1);
  add_surface(renderer, surface, table, options.edges);
  aim(renderer, surface, options, area);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(options.width, options.height);
  window->SetNumberOfLayers(2);
  window->AddRenderer(backdrop);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(options.output.c_str());
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
  if (writer->GetErrorCode() != 0 || !std::filesystem::exists(options.output))
    return fail(ec::io_error, "cannot write " + options.output,
                "Check the path and its permissions");
  return {};
}

}  // namespace tedit::picture
