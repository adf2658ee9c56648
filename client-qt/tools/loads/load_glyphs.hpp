// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>

#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "client-qt/view/viewport.hpp"
#include "fem/load_case.hpp"

class vtkPolyData;

namespace tedit::desktop {

class document;
class field_panel;

/// Marks on the part: arrows for loads; pyramids for what is fixed or displaced, balls for rollers.
struct load_glyphs {
  vtkSmartPointer<vtkPolyData> loads;     ///< Null when there are none.
  vtkSmartPointer<vtkPolyData> supports;  ///< Null when there are none.
};

/// A place on some surfaces and the outward normal there (unit).
struct surface_place {
  vec3 at;
  vec3 normal;
};

/// At most `most` places on these surfaces, spread by area and far from each other; fewer where
/// they would be closer than `spacing`, one at least when there is a facet. The same every time.
/// Displaced as drawn. Cost: O(facets).
[[nodiscard]] std::vector<surface_place> spread(const shown_part& part,
                                                const std::vector<surface_id>& surfaces,
                                                std::size_t most, double spacing);

/// The marks of some load cases, sized by the part. On any thread.
[[nodiscard]] load_glyphs make_glyphs(const shown_part& part,
                                      const std::vector<fem::load_case>& shown);

/// Keeps the marks in the view up to date: those of the load case whose field is shown, of all for
/// the envelope or before there is a field. Made aside; the newest win.
class load_glyph_layer : public QObject {
  Q_OBJECT

public:
  load_glyph_layer(document& part, field_panel& fields, viewport& view);
  ~load_glyph_layer() override;

  void show(bool on);
  /// Load cases that cannot be solved yet: they stand for the ones of their names, others are shown
  /// beside those whose field is shown.
  void set_drafts(std::vector<fem::load_case> drafts);
  [[nodiscard]] bool is_shown() const noexcept { return on_; }

private:
  void refresh();

  document& part_;
  field_panel& fields_;
  viewport& view_;
  QThreadPool makers_;
  std::vector<fem::load_case> drafts_;
  int generation_ = 0;
  bool on_ = true;
};

}  // namespace tedit::desktop
