// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/outlines/closed_loops.hpp"
#include "ops/shapes/outlines/svg_outlines.hpp"

namespace tedit::ops {

/// A file of outlines, an SVG picture or a DXF drawing: told by its content, whatever it is called.
/// A picture is as large as it is asked for, a drawing as it is drawn.
class outline_file {
public:
  /// `scale`: how many times as large a drawing is than it says. Errors: `invalid_parameter` for a
  /// drawing that is none between 1 um and 10 m; those of `read_dxf` and `join_outlines`.
  [[nodiscard]] static expected<outline_file> read(attachment file, double scale);

  [[nodiscard]] bool is_drawing() const { return drawing_.has_value(); }

  /// m: of a drawing its own, of a picture `wanted`.
  [[nodiscard]] double longer_side(double wanted) const;

  /// Around the origin, the longer side `size` m long. Of a drawing curves are in edges of about
  /// `edge` m, at least 24 for a circle, their corners on the curves; each outline is a side of its
  /// own ("side" where there is one, else "side 1", ...), and outlines in outlines are holes
  /// (even-odd). Of a picture as `svg_outlines`. Errors: those of that; `bad_input` with the place
  /// in the drawing's unit where outlines cross or touch, for more than 20,000 edges.
  [[nodiscard]] expected<profile> outlines(double size, double edge) const;

  [[nodiscard]] std::vector<std::string> notices() const;

private:
  attachment file_;
  std::optional<dxf_drawing> drawing_;
  joined_outlines joined_;
  double scale_ = 1;  ///< m per unit of the drawing.
};

/// Errors: `invalid_parameter` where an edge of a drawing is too short for the mesh there.
[[nodiscard]] expected<void> check_drawn_edges(const outline_file& file, const profile& shape,
                                               const placement& where);

/// The edit with more notices.
[[nodiscard]] expected<edit_result> with_notices(expected<edit_result> made,
                                                 const std::vector<std::string>& notices);

/// Of the parameters "file" and "scale". Errors: `invalid_parameter` where no file is given, those
/// of `outline_file::read`.
[[nodiscard]] expected<outline_file> outline_file_of(const parameters& values);

/// The parameters "file" and "scale" for such a file.
[[nodiscard]] std::vector<parameter_description> outline_file_parameters(const std::string& help);

/// `profile_parameters` with the profile "file" and those parameters.
[[nodiscard]] std::vector<parameter_description> profiles_with_file();

}  // namespace tedit::ops
