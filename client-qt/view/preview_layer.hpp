// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vtkNew.h>

#include "client-qt/view/preview_geometry.hpp"
#include "client-qt/view/scene.hpp"

class vtkActor;
class vtkPolyDataMapper;

namespace tedit::desktop {

/// What lies over the part while an edit is only looked at: what it would add in the accent's
/// colour, what it would take away as a ghost, and the surfaces that it cannot be made of. Only for
/// the thread that draws.
class preview_layer {
public:
  explicit preview_layer(vtkRenderer* renderer);
  ~preview_layer();
  preview_layer(const preview_layer&) = delete;
  preview_layer& operator=(const preview_layer&) = delete;

  void set_colours(const scene_colours& colours);
  /// Null: nothing.
  void show(const std::shared_ptr<const preview_geometry>& what);
  /// These surfaces of the part in the colour of errors; none: nothing.
  void mark(const part_geometry& part, const std::vector<surface_id>& surfaces);
  /// Leaves them out for a picture that is kept.
  void show_marks(bool on);
  void clip(const std::optional<section_plane>& plane);

private:
  struct piece {
    piece();
    ~piece();
    void show(vtkPolyData* data);

    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };

  vtkNew<vtkPlane> plane_;
  bool marked_ = false;
  piece added_;
  piece added_edges_;
  piece ghost_;
  piece ghost_edges_;
  piece fault_;
  std::array<piece*, 5> all_{&added_, &added_edges_, &ghost_, &ghost_edges_, &fault_};
};

}  // namespace tedit::desktop
