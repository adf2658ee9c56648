// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vtkNew.h>

#include <vector>

#include "client-qt/model/legend.hpp"
#include "client-qt/view/part_geometry.hpp"

class vtkActor;
class vtkPlane;
class vtkPolyDataMapper;
class vtkRenderer;

namespace tedit::desktop {

/// Surfaces that are picked out: a line around them and a tint so faint that the field under it can
/// still be read. Only for the thread that draws.
class highlight {
public:
  /// `tint`: its share of the colour of a face, in [0,1]; `width`: of the line, pixels of a screen
  /// with a device pixel ratio of 1.
  highlight(double tint, double width);
  ~highlight();
  highlight(const highlight&) = delete;
  highlight& operator=(const highlight&) = delete;

  /// After the faces: it is drawn over them in the order of the actors.
  void add_to(vtkRenderer& renderer);
  void set_colour(const rgb& c);
  /// None: nothing is seen of it.
  void show(const part_geometry& part, const std::vector<surface_id>& surfaces);
  void hide();
  /// Pixels of a frame for one of the screen's usual size.
  void set_pixel_ratio(double ratio);
  /// Null: all of it.
  void clip(vtkPlane* plane);

private:
  double width_;
  vtkNew<vtkPolyDataMapper> tint_mapper_;
  vtkNew<vtkActor> tint_actor_;
  vtkNew<vtkPolyDataMapper> line_mapper_;
  vtkNew<vtkActor> line_actor_;
};

}  // namespace tedit::desktop
