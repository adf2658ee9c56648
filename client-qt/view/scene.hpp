// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vtkNew.h>

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "client-qt/model/legend.hpp"
#include "client-qt/view/highlight.hpp"
#include "client-qt/view/part_geometry.hpp"
#include "mesh/print/print_checks.hpp"

class vtkActor;
class vtkLookupTable;
class vtkPlane;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace tedit::desktop {

/// Colours of the view; everything else of the window goes with them.
struct scene_colours {
  rgb low{0.80F, 0.83F, 0.87F};    ///< Lower end of the background.
  rgb high{0.98F, 0.98F, 0.985F};  ///< Upper end.
  rgb part{0.70F, 0.73F, 0.77F};
  rgb edges{0.12F, 0.13F, 0.16F};
  rgb accent{0.93F, 0.45F, 0.10F};  ///< Selection.
  rgb hover{0.99F, 0.75F, 0.35F};
};

/// A plane through the part; the normal points to what is taken away.
struct section_plane {
  vec3 at;               ///< m.
  vec3 normal{0, 0, 1};  ///< Unit.

  [[nodiscard]] bool takes_away(const vec3& p) const { return dot(p - at, normal) > 0; }
};

/// The actors that show a part: faces with a field, feature edges, what is selected and under the
/// pointer, glyphs. Only for the thread that draws.
class scene {
public:
  explicit scene(vtkRenderer* renderer);
  ~scene();
  scene(const scene&) = delete;
  scene& operator=(const scene&) = delete;

  void set_colours(const scene_colours& colours);

  /// Shows another geometry; field and selection must be given again.
  void set_part(std::shared_ptr<const part_geometry> part);
  [[nodiscard]] const std::shared_ptr<const part_geometry>& part() const { return part_; }

  /// Neutral grey.
  void show_plain();
  /// A colour for each surface.
  void show_surfaces();
  /// One value for each point of the part (not finite: grey) by the legend's colours.
  void show_values(std::span<const float> values, const legend& by);

  /// A mark for each cell of the part, in its colour; what has none in the part's.
  void show_print_marks(const std::vector<print_mark>& marks);

  void select(const std::vector<surface_id>& picked);
  void hover(std::optional<surface_id> under_pointer);
  /// Leaves out what is selected and under the pointer, for a picture that is kept.
  void show_highlights(bool on);
  /// Surfaces that are not drawn (nor picked).
  void hide(const std::set<surface_id>& hidden);
  [[nodiscard]] const std::set<surface_id>& hidden() const noexcept { return hidden_; }
  void show_mesh(bool on);
  void show_edges(bool on);

  /// Leaves out faces that are seen from behind: right where the part is closed and looked at from
  /// outside, and nearly half of a frame where a processor draws.
  void cull_backs(bool on);
  /// Draws only what lies on the side of the plane that its normal points away from; nothing: all.
  void clip(const std::optional<section_plane>& plane);
  /// The cut surface with one value for each of its points (empty: grey); null: none.
  void set_cap(vtkPolyData* cap, std::span<const float> values, const legend& by);

  /// Lines of equal value on the part; null: none.
  void set_isolines(vtkPolyData* lines);
  /// The same on the cut surface.
  void set_cap_isolines(vtkPolyData* lines);

  /// Arrows and support marks, drawn unlit by their own colours; null for none.
  void set_glyphs(vtkPolyData* loads, vtkPolyData* supports);

private:
  void suit_pixels();
  void show_selection();
  void show_hovered();
  void light_evenly(bool on);
  void show_cell_colours(vtkUnsignedCharArray* colours);
  void paint_faces();
  void fill_table(const legend& by);

  vtkRenderer* renderer_;
  scene_colours colours_;
  std::shared_ptr<const part_geometry> part_;
  std::set<surface_id> hidden_;
  std::vector<surface_id> picked_;
  std::optional<surface_id> under_pointer_;
  bool highlights_ = true;
  unsigned long begins_frame_ = 0;  ///< Our observer of the renderer.
  vtkNew<vtkPolyData> faces_;       ///< The part's, with our scalars and without what is hidden.
  vtkNew<vtkLookupTable> table_;
  vtkNew<vtkPolyDataMapper> face_mapper_;
  vtkNew<vtkActor> face_actor_;
  vtkNew<vtkPlane> plane_;
  vtkNew<vtkPolyData> cap_;
  vtkNew<vtkPolyDataMapper> cap_mapper_;
  vtkNew<vtkActor> cap_actor_;
  vtkNew<vtkPolyDataMapper> edge_mapper_;
  vtkNew<vtkActor> edge_actor_;
  vtkNew<vtkPolyDataMapper> iso_mapper_;
  vtkNew<vtkActor> iso_actor_;
  vtkNew<vtkPolyDataMapper> cap_iso_mapper_;
  vtkNew<vtkActor> cap_iso_actor_;
  highlight selected_;
  highlight hovered_;
  vtkNew<vtkPolyDataMapper> load_mapper_;
  vtkNew<vtkActor> load_actor_;
  vtkNew<vtkPolyDataMapper> support_mapper_;
  vtkNew<vtkActor> support_actor_;
};

}  // namespace tedit::desktop
