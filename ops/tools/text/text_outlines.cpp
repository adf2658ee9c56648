// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/tools/text/text_outlines.hpp"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <memory>

namespace tedit::ops {

namespace {

using point2 = std::array<double, 2>;

struct library_end {
  void operator()(FT_LibraryRec_* library) const { FT_Done_FreeType(library); }
};
struct face_end {
  void operator()(FT_FaceRec_* face) const { FT_Done_Face(face); }
};

/// The code points of a text; nothing where it is no UTF-8.
std::optional<std::vector<char32_t>> code_points(const std::string& text) {
  std::vector<char32_t> result;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const int more = first < 0x80       ? 0
                     : first >> 5 == 6  ? 1
                     : first >> 4 == 14 ? 2
                     : first >> 3 == 30 ? 3
                                        : -1;
    if (more < 0 || i + static_cast<std::size_t>(more) >= text.size())
      return std::nullopt;
    char32_t code = more == 0 ? first : first & (0x3fu >> more);
    for (int k = 1; k <= more; ++k) {
      const auto next = static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]);
      if (next >> 6 != 2)
        return std::nullopt;
      code = code << 6 | (next & 0x3fu);
    }
    result.push_back(code);
    i += static_cast<std::size_t>(more) + 1;
  }
  return result;
}

/// Takes the contours of glyphs, in m.
class contour_taker {
public:
  contour_taker(double scale, double edge) : scale_(scale), edge_(edge) {}

  double pen = 0;  ///< Font units.
  std::vector<std::vector<point2>> contours;

  static int move(const FT_Vector* to, void* self) {
    auto& taker = *static_cast<contour_taker*>(self);
    taker.contours.push_back({taker.at(*to)});
    return 0;
  }
  static int line(const FT_Vector* to, void* self) {
    auto& taker = *static_cast<contour_taker*>(self);
    taker.contours.back().push_back(taker.at(*to));
    return 0;
  }
  static int conic(const FT_Vector* control, const FT_Vector* to, void* self) {
    auto& taker = *static_cast<contour_taker*>(self);
    taker.curve({taker.contours.back().back(), taker.at(*control), taker.at(*to)});
    return 0;
  }
  static int cubic(const FT_Vector* one, const FT_Vector* two, const FT_Vector* to, void* self) {
    auto& taker = *static_cast<contour_taker*>(self);
    taker.curve({taker.contours.back().back(), taker.at(*one), taker.at(*two), taker.at(*to)});
    return 0;
  }

private:
  [[nodiscard]] point2 at(const FT_Vector& v) const {
    return {scale_ * (pen + static_cast<double>(v.x)), scale_ * static_cast<double>(v.y)};
  }

  /// De Casteljau, in as many pieces as its control polygon is long, and at least two.
  void curve(const std::vector<point2>& control) {
    double length = 0;
    for (std::size_t i = 1; i < control.size(); ++i)
      length += std::hypot(control[i][0] - control[i - 1][0], control[i][1] - control[i - 1][1]);
    const int pieces = std::clamp(static_cast<int>(std::lround(length / edge_)), 2, 32);
    for (int k = 1; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      auto level = control;
      for (std::size_t n = level.size() - 1; n > 0; --n)
        for (std::size_t i = 0; i < n; ++i)
          for (int axis = 0; axis < 2; ++axis)
            level[i][axis] += t * (level[i + 1][axis] - level[i][axis]);
      contours.back().push_back(level[0]);
    }
  }

  double scale_;
  double edge_;
};

/// Points that repeat the one before, and the last one where it is the first, go.
void tidy(std::vector<point2>& contour, double least) {
  std::vector<point2> kept;
  const auto near = [&](const point2& a, const point2& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1]) < least;
  };
  for (const auto& p : contour)
    if (kept.empty() || !near(p, kept.back()))
      kept.push_back(p);
  while (kept.size() > 1 && near(kept.front(), kept.back()))
    kept.pop_back();
  contour = std::move(kept);
}

profile centred(std::vector<std::vector<point2>> contours) {
  point2 low{1e300, 1e300};
  point2 high{-1e300, -1e300};
  for (const auto& c : contours)
    for (const auto& p : c)
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
  profile result;
  result.sides = {"side"};
  for (auto& c : contours) {
    for (auto& p : c)
      for (int axis = 0; axis < 2; ++axis)
        p[axis] -= 0.5 * (low[axis] + high[axis]);
    const auto edges = c.size();
    result.outlines.push_back({std::move(c), std::vector<std::uint32_t>(edges, 0)});
  }
  return result;
}

}  // namespace

expected<std::filesystem::path> font_file(const std::string& kind) {
  const std::string name = kind == "bold"    ? "DejaVuSans-Bold.ttf"
                           : kind == "serif" ? "DejaVuSerif.ttf"
                           : kind == "mono"  ? "DejaVuSansMono.ttf"
                                             : "DejaVuSans.ttf";
  const std::filesystem::path file = "/usr/share/fonts/truetype/dejavu/" + name;
  std::error_code none;
  if (!std::filesystem::exists(file, none))
    return fail(ec::not_found, "the font " + file.string() + " is not there",
                "Install the package fonts-dejavu-core where operations run");
  return file;
}

expected<profile> text_outlines(const std::string& text, const std::filesystem::path& font,
                                double height, double edge) {
  const auto letters = code_points(text);
  if (!letters)
    return fail(ec::invalid_parameter, "the text is no UTF-8", "Give it in UTF-8");
  FT_Library raw_library = nullptr;
  if (FT_Init_FreeType(&raw_library) != 0)
    return fail(ec::io_error, "FreeType does not start");
  const std::unique_ptr<FT_LibraryRec_, library_end> library(raw_library);
  FT_Face raw_face = nullptr;
  if (FT_New_Face(library.get(), font.c_str(), 0, &raw_face) != 0)
    return fail(ec::io_error, "the font " + font.string() + " cannot be read");
  const std::unique_ptr<FT_FaceRec_, face_end> face(raw_face);
  // Capitals decide: an H from the line up.
  constexpr auto how = FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP;
  if (FT_Load_Char(face.get(), U'H', how) != 0 || face->glyph->metrics.height <= 0)
    return fail(ec::io_error, "the font " + font.string() + " has no outlines");
  contour_taker taker(height / static_cast<double>(face->glyph->metrics.height), edge);
  const FT_Outline_Funcs functions{
    &contour_taker::move, &contour_taker::line, &contour_taker::conic, &contour_taker::cubic, 0, 0};
  for (const auto letter : *letters) {
    const auto glyph = FT_Get_Char_Index(face.get(), letter);
    if (glyph == 0)
      return fail(ec::invalid_parameter, "the font has no letter for one of the text's",
                  "Leave out control characters and letters of other scripts");
    if (FT_Load_Glyph(face.get(), glyph, how) != 0 ||
        FT_Outline_Decompose(&face->glyph->outline, &functions, &taker) != 0)
      return fail(ec::io_error, "the font " + font.string() + " is damaged");
    taker.pen += static_cast<double>(face->glyph->metrics.horiAdvance);
  }
  for (auto& contour : taker.contours)
    tidy(contour, 1e-4 * height);
  std::erase_if(taker.contours, [](const auto& c) { return c.size() < 3; });
  if (taker.contours.empty())
    return fail(ec::invalid_parameter, "the text has nothing to emboss", "Give some letters");
  return centred(std::move(taker.contours));
}

}  // namespace tedit::ops
