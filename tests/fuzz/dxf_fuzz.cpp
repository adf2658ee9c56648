// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cmath>

#include "ops/shapes/outlines/outline_file.hpp"
#include "tests/fuzz/promise.hpp"

namespace {

using namespace tedit;

void check_refused(const error& failure) {
  fuzz::require_reason(failure);
  fuzz::require(!failure.remedy.empty(), "a refusal has a remedy:", render(failure));
  fuzz::require(failure.code == ec::bad_input || failure.code == ec::unsupported_format ||
                  failure.code == ec::invalid_parameter,
                "a refusal is about the file:", render(failure));
  fuzz::require(render(failure).size() < 2000, "a refusal is short");
}

void check_outlines(const ops::profile& shape, double side) {
  std::size_t edges = 0;
  fuzz::require(!shape.outlines.empty(), "there is an outline");
  for (const auto& outline : shape.outlines) {
    fuzz::require(outline.points.size() >= 3, "an outline has corners");
    fuzz::require(outline.side.size() == outline.points.size(), "each edge is of a side");
    for (const auto s : outline.side)
      fuzz::require(s < shape.sides.size(), "a side has a name");
    for (const auto& p : outline.points)
      fuzz::require(std::isfinite(p[0]) && std::isfinite(p[1]) && std::abs(p[0]) <= side &&
                      std::abs(p[1]) <= side,
                    "a corner lies in the drawing");
    edges += outline.points.size();
  }
  fuzz::require(edges <= ops::most_drawn, "there are not too many edges");
}

}  // namespace

/// A drawing, which also says how fine its curves shall be: by how many bytes it has.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const attachment bytes{"fuzz.dxf", std::string(reinterpret_cast<const char*>(data), size)};
  if (!ops::is_drawing_file(bytes.bytes))
    return 0;
  const auto file = ops::outline_file::read(bytes, 1);
  if (!file) {
    check_refused(file.error());
    return 0;
  }
  const double side = file->longer_side(0);
  fuzz::require(side >= 1e-6 && side <= 10, "a drawing is as large as a part may be");
  for (const auto& notice : file->notices())
    fuzz::require(notice.size() < 2000, "a notice is short");
  for (const double share : {0.05, 0.001}) {
    const auto made = file->outlines(side, share * side);
    if (made)
      check_outlines(*made, side);
    else
      check_refused(made.error());
  }
  return 0;
}
