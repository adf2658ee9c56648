// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>

#include <gmock/gmock.h>

#include "ops/pocket/pocket.hpp"
#include "ops/shapes/outlines/outline_file.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"

namespace tedit::ops {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// "0 LINE 10 1" as groups, a line each.
std::string groups(const std::string& text) {
  std::string result = text;
  for (auto& c : result)
    if (c == ' ')
      c = '\n';
  return result + "\n";
}

struct parts_of_drawing {
  std::string entities;
  std::string blocks = {};
  std::string layers = {};
  int unit = 4;  ///< mm
};

attachment drawing(const parts_of_drawing& of) {
  return {"plate.dxf",
          groups("0 SECTION 2 HEADER 9 $INSUNITS 70 " + std::to_string(of.unit) + " 0 ENDSEC") +
            groups("0 SECTION 2 TABLES " + of.layers + "0 ENDSEC") +
            groups("0 SECTION 2 BLOCKS " + of.blocks + "0 ENDSEC") +
            groups("0 SECTION 2 ENTITIES " + of.entities + "0 ENDSEC 0 EOF")};
}

std::string square(double side, const std::string& layer = "0") {
  const auto s = std::to_string(side);
  return "0 LWPOLYLINE 8 " + layer + " 70 1 10 0 20 0 10 " + s + " 20 0 10 " + s + " 20 " + s +
         " 10 0 20 " + s + " ";
}

double area_of(const outline& o) {
  double twice = 0;
  for (std::size_t i = 0; i < o.points.size(); ++i)
    twice += turn_of({0, 0}, o.points[i], o.points[(i + 1) % o.points.size()]);
  return std::abs(twice) / 2;
}

attachment kept(const std::string& name) {
  std::ifstream in(std::string(TEDIT_TEST_DATA "/drawings/") + name, std::ios::binary);
  return {name, std::string(std::istreambuf_iterator<char>(in), {})};
}

/// Of the regular polygon with 24 corners on the circle: how circles are drawn where edges may be
/// longer.
double circle_area(double radius) {
  return 12 * radius * radius * std::sin(std::numbers::pi / 12);
}

expected<profile> outlines(const parts_of_drawing& of, double edge = 1) {
  const auto file = outline_file::read(drawing(of), 1);
  if (!file)
    return fail(file.error());
  return file->outlines(file->longer_side(0), edge);
}

std::string refusal(const parts_of_drawing& of) {
  const auto made = outlines(of);
  return made ? "accepted" : render(made.error());
}

TEST(Dxf, ASquareWithARoundHoleIsAsLargeAsItIsDrawn) {
  const auto made = outlines({square(20) + "0 CIRCLE 8 0 10 10 20 10 40 4 "});

  ASSERT_TRUE(made) << render(made.error());
  ASSERT_THAT(made->outlines, SizeIs(2));
  EXPECT_NEAR(area_of(made->outlines[0]), 0.02 * 0.02, 1e-15);
  EXPECT_NEAR(area_of(made->outlines[1]), circle_area(0.004), 1e-15);
  EXPECT_THAT(made->sides, ElementsAre("side 1", "side 2"));
  for (const auto& p : made->outlines[1].points)
    EXPECT_NEAR(std::hypot(p[0], p[1]), 0.004, 1e-15);  // The middle of all is the origin.
}

TEST(Dxf, EdgesOfCurvesAreAsShortAsTheyAreWanted) {
  const double edge = 0.0005;
  const auto made = outlines({"0 CIRCLE 10 0 20 0 40 4 "}, edge);

  ASSERT_TRUE(made) << render(made.error());
  const auto n = std::ceil(2 * std::numbers::pi * 0.004 / edge);
  EXPECT_THAT(made->outlines[0].points, SizeIs(static_cast<std::size_t>(n)));
  EXPECT_THAT(made->sides, ElementsAre("side"));
}

/// From (0, 0) to (8, 0) and back, each with a bulge.
TEST(Dxf, ABulgeOfOneIsAHalfCircle) {
  const auto half = outlines({"0 LWPOLYLINE 70 1 10 0 20 0 42 1 10 8 20 0 "});
  const auto whole = outlines({"0 LWPOLYLINE 70 1 10 0 20 0 42 1 10 8 20 0 42 1 "});
  const auto quarter =
    outlines({"0 LWPOLYLINE 70 1 10 0 20 0 10 4 20 0 42 0.41421356237309503 10 0 20 4 "});

  ASSERT_TRUE(half && whole && quarter);
  EXPECT_NEAR(area_of(half->outlines[0]), circle_area(0.004) / 2, 1e-15);
  EXPECT_NEAR(area_of(whole->outlines[0]), circle_area(0.004), 1e-15);
  EXPECT_NEAR(area_of(quarter->outlines[0]), circle_area(0.004) / 4, 1e-15);
}

TEST(Dxf, APolylineOfVerticesIsTheSame) {
  const std::string old =
    "0 POLYLINE 66 1 70 1 0 VERTEX 10 0 20 0 42 1 0 VERTEX 10 99 20 99 70 16 "
    "0 VERTEX 10 8 20 0 0 SEQEND ";
  const auto made = outlines({old});

  ASSERT_TRUE(made) << render(made.error());
  EXPECT_NEAR(area_of(made->outlines[0]), circle_area(0.004) / 2, 1e-15);
}

TEST(Dxf, UnitsAreThoseOfTheDrawing) {
  const std::pair<int, double> longest[] = {{1, 0.0508}, {2, 0.6096}, {4, 0.002}, {5, 0.02},
                                            {6, 2},      {13, 2e-6},  {14, 0.2}};
  for (const auto& [unit, side] : longest) {
    const auto file = outline_file::read(drawing({square(2), {}, {}, unit}), 1);
    ASSERT_TRUE(file) << unit << ": " << render(file.error());
    EXPECT_NEAR(file->longer_side(9), side, 1e-12) << unit;
    EXPECT_THAT(file->notices(), IsEmpty());
  }
  const auto none = outline_file::read(drawing({square(2), {}, {}, 0}), 25.4);
  ASSERT_TRUE(none) << render(none.error());
  EXPECT_NEAR(none->longer_side(9), 0.0508, 1e-12);
  EXPECT_THAT(none->notices(), ElementsAre(HasSubstr("taken for millimetres")));
  EXPECT_THAT(refusal({square(2), {}, {}, 20}), HasSubstr("$INSUNITS 20"));
  EXPECT_THAT(refusal({square(2), {}, {}, 7}), AllOf(HasSubstr("2000 m long"), HasSubstr("scale")));
}

/// A triangle with its right angle at (2, 1), inserted at (10, 0), mirrored and twice as wide.
TEST(Dxf, ABlockIsScaledMirroredTurnedAndRepeated) {
  const std::string block =
    "0 BLOCK 2 Part 10 2 20 1 0 LWPOLYLINE 8 0 70 1 10 2 20 1 10 5 20 1 10 2 20 3 0 ENDBLK ";
  const auto mirrored = outlines({"0 INSERT 2 PART 10 10 20 0 41 -2 ", block});
  ASSERT_TRUE(mirrored) << render(mirrored.error());
  // From (10, 0) to (4, 0) and (10, 2), the middle of its box at (7, 1).
  EXPECT_THAT(mirrored->outlines[0].points,
              ElementsAre(point2{0.003, -0.001}, point2{-0.003, -0.001}, point2{0.003, 0.001}));

  const auto row = outlines({"0 INSERT 2 PART 70 3 71 2 44 10 45 10 50 90 ", block});
  ASSERT_TRUE(row) << render(row.error());
  EXPECT_THAT(row->outlines, SizeIs(6));
  EXPECT_NEAR(area_of(row->outlines[5]), 3e-6, 1e-15);
  // Turned by 90 degrees the columns go up: 22 by 10 and 3 are the sides of all.
  EXPECT_NEAR(
    outline_file::read(drawing({"0 INSERT 2 PART 70 3 71 2 44 10 45 10 50 90 ", block}), 1)
      ->longer_side(0),
    0.023, 1e-12);
}

TEST(Dxf, SeenFromBelowItIsMirrored) {
  const auto made = outlines({square(2) + "0 CIRCLE 10 -8 20 1 40 1 230 -1 "});

  ASSERT_TRUE(made) << render(made.error());
  double right = 0;
  for (const auto& p : made->outlines[1].points)
    right = std::max(right, p[0]);
  EXPECT_NEAR(right, 0.0045, 1e-12);  // From 0 to 9 mm; without the mirror from -9.
  EXPECT_THAT(refusal({"0 CIRCLE 10 0 20 0 40 1 210 1 230 1 "}), HasSubstr("does not lie in"));
}

/// One that is a circle, one that is turned by 90 degrees and cut in half.
TEST(Dxf, AnEllipseHasItsAxes) {
  const auto whole = outlines({"0 ELLIPSE 10 1 20 2 11 4 21 0 40 0.5 "});
  const auto half = outlines(
    {"0 ELLIPSE 10 0 20 0 11 0 21 4 40 0.5 41 0 42 3.14159265358979 0 LINE 10 0 20 4 11 0 21 -4 "});

  ASSERT_TRUE(whole && half);
  EXPECT_NEAR(area_of(whole->outlines[0]), circle_area(0.004) / 2, 1e-15);
  EXPECT_NEAR(area_of(half->outlines[0]), circle_area(0.004) / 4, 1e-12);
}

/// The circle of The NURBS Book, 7.5: nine control points, weights 1 and the half of root two.
TEST(Dxf, ARationalSplineIsAnExactCircle) {
  std::string spline = "0 SPLINE 71 2 40 0 40 0 40 0 40 1 40 1 40 2 40 2 40 3 40 3 40 4 40 4 40 4 ";
  const int x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1};
  const int y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
  for (int i = 0; i < 9; ++i)
    spline += "10 " + std::to_string(x[i]) + " 20 " + std::to_string(y[i]) + " 41 " +
              (i % 2 == 1 ? "0.7071067811865476 " : "1 ");
  const auto made = outlines({spline}, 1e-4);

  ASSERT_TRUE(made) << render(made.error());
  EXPECT_GE(made->outlines[0].points.size(), 63u);  // 2 pi mm in edges of at most 0.1 mm.
  for (const auto& p : made->outlines[0].points)
    EXPECT_NEAR(std::hypot(p[0], p[1]), 1e-3, 1e-12);
}

/// y = x (4 - x) over 0 to 4, a parabola, closed by a line: two thirds of its box of 4 by 4.
TEST(Dxf, ASplineIsJoinedWithALine) {
  const auto made =
    outlines({"0 SPLINE 71 2 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 2 20 8 10 4 "
              "20 0 0 LINE 10 0 20 0 11 4 21 0 "},
             5e-5);

  ASSERT_TRUE(made) << render(made.error());
  EXPECT_NEAR(area_of(made->outlines[0]), 16e-6 * 2 / 3, 2e-9);
}

TEST(Dxf, LooseEndsThatLieTogetherAreJoined) {
  const auto made = outlines({"0 LINE 10 0 20 0 11 8 21 0 0 ARC 10 4 20 0.0004 40 4 50 0 51 180 "});

  ASSERT_TRUE(made) << render(made.error());
  EXPECT_NEAR(area_of(made->outlines[0]), circle_area(0.004) / 2, 5e-9);
}

TEST(Dxf, AnOpenOutlineIsToldWithItsEnds) {
  const auto open =
    "0 LINE 10 0 20 0 11 8 21 0 0 LINE 10 8 20 0 11 8 21 5 "
    "0 LINE 10 8.5 20 5 11 0 21 0 ";
  EXPECT_THAT(refusal({open}), AllOf(HasSubstr("(8, 5) mm"), HasSubstr("(8.5, 5) mm"),
                                     HasSubstr("0.5 apart"), HasSubstr("layer")));
  const auto fork = square(5) +
                    "0 LINE 10 0 20 9 11 8 21 9 0 LINE 10 0 20 9 11 4 21 12 "
                    "0 LINE 10 8 20 9 11 4 21 12 0 LINE 10 4 20 12 11 4 21 20 ";
  EXPECT_THAT(refusal({fork}), AllOf(HasSubstr("3 lines"), HasSubstr("(4, 12) mm")));
}

TEST(Dxf, OutlinesThatCrossAreToldWithThePlace) {
  const auto bow = "0 LWPOLYLINE 70 1 10 0 20 0 10 10 20 10 10 10 20 0 10 0 20 10 ";
  EXPECT_THAT(refusal({bow}), AllOf(HasSubstr("cross"), HasSubstr("(5, 5) mm")));
  EXPECT_THAT(refusal({square(10) + "0 LWPOLYLINE 70 1 10 5 20 5 10 15 20 5 10 15 20 7 "}),
              AllOf(HasSubstr("cross"), HasSubstr("(10, 5) mm")));
  EXPECT_THAT(refusal({"0 LWPOLYLINE 70 1 10 0 20 0 10 9 20 0 10 5 20 0 10 5 20 5 "}),
              HasSubstr("cross"));
}

TEST(Dxf, WhatIsThereTwiceCountsOnce) {
  const auto file =
    outline_file::read(drawing({square(20) + square(20) +
                                "0 LINE 10 1 20 1 11 8 21 1 0 LINE 10 8 20 1 11 1 21 1 "
                                "0 ARC 10 4.5 20 1 40 3.5 50 0 51 180 "}),
                       1);

  ASSERT_TRUE(file) << render(file.error());
  EXPECT_THAT(file->notices(), ElementsAre(HasSubstr("2 lines of the drawing are there twice")));
  EXPECT_THAT(file->outlines(0.02, 1)->outlines, SizeIs(2));
}

TEST(Dxf, WhatIsNotShownIsLeftOut) {
  const std::string layers = "0 LAYER 2 Cold 70 1 62 7 0 LAYER 2 dark 70 0 62 -3 ";
  const std::string blocks =
    "0 BLOCK 2 B 0 CIRCLE 8 0 10 0 20 0 40 1 0 CIRCLE 8 seen 10 9 20 9 40 "
    "1 0 ENDBLK ";
  const auto shown = [&](const std::string& more) {
    return outlines({square(50) + more, blocks, layers})->outlines.size() - 1;
  };
  EXPECT_EQ(shown("0 LINE 8 COLD 10 1 20 1 11 2 21 2 "), 0u);
  EXPECT_EQ(shown("0 LINE 8 Dark 10 1 20 1 11 2 21 2 "), 0u);
  EXPECT_EQ(shown("0 LINE 60 1 10 1 20 1 11 2 21 2 "), 0u);
  EXPECT_EQ(shown("0 LINE 67 1 10 1 20 1 11 2 21 2 "), 0u);
  EXPECT_EQ(shown("0 INSERT 2 B 8 plain 10 5 20 5 "), 2u);
  EXPECT_EQ(shown("0 INSERT 2 B 8 cold 10 5 20 5 "), 0u);
  EXPECT_EQ(shown("0 INSERT 2 B 8 dark 10 5 20 5 "), 1u);  // What is on other layers is shown.
}

TEST(Dxf, WhatIsNoOutlineIsCounted) {
  const auto file = outline_file::read(
    drawing({square(9) + "0 TEXT 1 hello 0 HATCH 2 SOLID 0 TEXT 1 world 0 \x01\x02 "}), 1);

  ASSERT_TRUE(file) << render(file.error());
  EXPECT_THAT(file->notices(), ElementsAre("left out of the drawing: 1 HATCH, 2 TEXT, 1 others"));
  EXPECT_THAT(refusal({"0 TEXT 1 hello "}),
              AllOf(HasSubstr("no closed outline"), HasSubstr("1 TEXT")));
}

TEST(Dxf, WhatIsBrokenIsToldWithItsLine) {
  const auto said = [](attachment file) {
    const auto read = outline_file::read(std::move(file), 1);
    return read ? "accepted" : render(read.error());
  };
  EXPECT_THAT(said({"a.dxf", "AutoCAD Binary DXF\r\n\x1a"}), HasSubstr("binary DXF"));
  EXPECT_THAT(said({"a.dxf", "AC1015 and more"}), HasSubstr("DWG"));
  EXPECT_THAT(said({"a.dxf", "0\nSECTION\nx\n"}), AllOf(HasSubstr("\"x\""), HasSubstr("line 3")));
  auto cut = drawing({square(20)});
  cut.bytes.resize(cut.bytes.size() - 5);
  EXPECT_THAT(said(cut), HasSubstr("ends early"));
  EXPECT_THAT(refusal({"0 LINE 10 1,5 "}), AllOf(HasSubstr("\"1,5\""), HasSubstr("line ")));
  EXPECT_THAT(refusal({"0 LINE 10 nan "}), HasSubstr("no number"));
  EXPECT_THAT(refusal({"0 LINE 10 1e99 "}), HasSubstr("no number"));
  EXPECT_THAT(refusal({"0 CIRCLE 40 -1 "}), HasSubstr("no radius"));
  EXPECT_THAT(refusal({"0 SPLINE 71 3 40 0 10 1 20 1 "}), HasSubstr("1 knots for 1 control"));
  EXPECT_THAT(refusal({"0 SPLINE 71 3 11 1 21 1 "}), HasSubstr("no control points"));
  EXPECT_THAT(refusal({"0 SPLINE 71 1 40 0 40 0 40 0 40 0 10 1 20 1 10 2 20 1 "}),
              HasSubstr("knots in no order"));
  EXPECT_THAT(refusal({"0 POLYLINE 70 64 0 SEQEND "}), HasSubstr("is a surface"));
  EXPECT_THAT(refusal({"0 INSERT 2 nowhere "}), HasSubstr("does not have"));
}

/// Each of some hundred bytes that stand for very much.
TEST(Dxf, WhatAsksForMuchIsRefusedSoon) {
  std::string nested;
  for (int i = 0; i < 12; ++i)
    nested += "0 BLOCK 2 B" + std::to_string(i) + " 0 INSERT 70 99 71 99 44 1 45 1 2 B" +
              std::to_string(i + 1) + " 0 ENDBLK ";
  EXPECT_THAT(refusal({"0 INSERT 2 B0 ", nested + "0 BLOCK 2 B12 0 ENDBLK "}),
              HasSubstr("more than 20,000"));
  EXPECT_THAT(refusal({"0 INSERT 2 A ", "0 BLOCK 2 A 0 INSERT 2 A 0 ENDBLK "}),
              HasSubstr("without end"));
  std::string far;
  for (int i = 0; i < 12; ++i)
    far += "0 BLOCK 2 F" + std::to_string(i) + " 0 INSERT 41 9e8 42 9e8 2 F" +
           std::to_string(i + 1) + " 0 ENDBLK ";
  EXPECT_THAT(refusal({"0 INSERT 2 F0 ", far + "0 BLOCK 2 F12 0 CIRCLE 40 9e8 0 ENDBLK "}),
              HasSubstr("further than any part"));
  const auto fine = outlines({square(1000) + "0 CIRCLE 10 500 20 500 40 400 "}, 1e-9);
  ASSERT_FALSE(fine);
  EXPECT_THAT(fine.error().message, HasSubstr("too many curves"));
}

/// Bits that are turned, and files that are cut: read or refused, with a reason.
TEST(Dxf, DamagedFilesAreReadOrRefused) {
  std::mt19937 random(20);
  for (const auto* name : {"plate_r12.dxf", "plate_r2000.dxf"}) {
    const auto whole = kept(name);
    int refused = 0;
    for (int trial = 0; trial < 500; ++trial) {
      auto damaged = whole;
      for (int i = 0; i < 4; ++i)
        damaged.bytes[random() % damaged.bytes.size()] ^= static_cast<char>(1u << random() % 8);
      if (trial % 4 == 0)
        damaged.bytes.resize(random() % damaged.bytes.size());
      const auto file = outline_file::read(damaged, 1);
      const auto made =
        file ? file->outlines(file->longer_side(1), 1e-3) : expected<profile>(fail(file.error()));
      refused += made ? 0 : 1;
      EXPECT_TRUE(made || !made.error().message.empty());
      EXPECT_TRUE(made || !made.error().remedy.empty());
    }
    EXPECT_GT(refused, 125) << name;  // Those that were cut.
  }
}

class DxfPocket : public test::tool_edits {
protected:
  /// Into the top of a plate of 100 x 100 x 20 mm.
  expected<edit_result> apply(const attachment& file) {
    const parameters values{{"profile", std::string("file")},
                            {"size", 0.01},
                            {"width", 0.0},
                            {"corners", std::int64_t{6}},
                            {"along", std::string("1, 0, 0")},
                            {"file", attachment_text(file)},
                            {"scale", 1.0},
                            {"height", 0.005},
                            {"at", std::string("0.05, 0.05, 0.02")},
                            {"direction", std::string()}};
    return cut_pocket(plate_, {{6}}, values, ctx_);
  }

  version_ptr plate_ = test::box_mesh({20, 20, 4}, {0.1, 0.1, 0.02});
};

TEST_F(DxfPocket, ASquareRingTakesOffItsAreaAndEachOutlineIsAWall) {
  const auto file = drawing({square(40) + "0 CIRCLE 10 20 20 20 40 6 0 TEXT 1 x "});
  const auto cut = apply(file);

  ASSERT_TRUE(cut) << render(cut.error());
  expect_good(plate_, *cut);
  const double area = 0.04 * 0.04 - circle_area(0.006);
  EXPECT_NEAR(cut->volume_change, -0.005 * area, 1e-15);
  EXPECT_NEAR(area_of(*cut->candidate, "pocket side 2"),
              0.005 * 24 * 0.012 * std::sin(std::numbers::pi / 24), 1e-12);
  EXPECT_THAT(cut->notices, Contains("left out of the drawing: 1 TEXT"));
}

/// 40 by 25 mm, corners of 5 mm, two holes of 4 mm and a slot of 16 by 4 mm; frozen notes.
TEST_F(DxfPocket, DrawingsAsOtherProgramsWriteThem) {
  const double area = 1e-6 * (40 * 25 - 4 * 25) + circle_area(0.005) - 2 * circle_area(0.002) -
                      1e-6 * 12 * 4 - circle_area(0.002);
  for (const auto* name : {"plate_r12.dxf", "plate_r2000.dxf"}) {
    const auto cut = apply(kept(name));

    ASSERT_TRUE(cut) << name << ": " << render(cut.error());
    expect_good(plate_, *cut);
    EXPECT_NEAR(cut->volume_change, -0.005 * area, 1e-10) << name;
    EXPECT_THAT(cut->notices, Contains("left out of the drawing: 1 TEXT")) << name;
  }
}

TEST_F(DxfPocket, WhatIsTooSmallForTheMeshIsTold) {
  const auto tiny = apply(drawing({square(40) + "0 CIRCLE 10 20 20 20 40 0.05 "}));

  ASSERT_FALSE(tiny);
  EXPECT_THAT(tiny.error().message, HasSubstr("too small for the mesh"));
}

}  // namespace
}  // namespace tedit::ops
