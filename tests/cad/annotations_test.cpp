// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/annotations.hpp"

#include <gtest/gtest.h>

namespace tedit::cad {
namespace {

TEST(Annotations, BecomePointsUnderTheirNumbers) {
  const auto plain = without_annotations(
    "DATA;\n#1=DATUM('a;b','',#2,.F.,'C');\n#2=PRODUCT('p','p','',());\n#3 = FLATNESS_TOLERANCE "
    "('','',#4,#5);\nENDSEC;\n");

  EXPECT_EQ(plain.left_out, 2U);
  EXPECT_EQ(plain.text,
            "DATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=PRODUCT('p','p','',());\n#3 "
            "=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\n");
}

TEST(Annotations, OfSeveralTypesAreFoundByAny) {
  const auto plain = without_annotations(
    "#1=(GEOMETRIC_TOLERANCE('',#2)POSITION_TOLERANCE());\n"
    "#2=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));");

  EXPECT_EQ(plain.left_out, 1U);
  EXPECT_EQ(plain.text,
            "#1=CARTESIAN_POINT('',(0.,0.,0.));\n"
            "#2=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));");
}

TEST(Annotations, InQuotesAndCommentsAreText) {
  const std::string text =
    "/* #1=DATUM(); */#1=PRODUCT('#2=DATUM();','DATUM','',(#3));#4=NAME('it''s a DATUM');";

  const auto plain = without_annotations(text);

  EXPECT_EQ(plain.left_out, 0U);
  EXPECT_EQ(plain.text, text);
}

TEST(Annotations, ThatEndInTheMiddleAreTakenToTheEnd) {
  EXPECT_EQ(without_annotations("#1=DATUM('never closed").left_out, 1U);
  EXPECT_EQ(without_annotations("#1=").text, "#1=");
  EXPECT_EQ(without_annotations("").text, "");
}

TEST(Annotations, AreNoShapesColoursOrNames) {
  for (const auto* kept :
       {"ADVANCED_FACE", "COLOUR_RGB", "DRAUGHTING_PRE_DEFINED_COLOUR", "STYLED_ITEM", "PRODUCT",
        "MANIFOLD_SOLID_BREP", "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION",
        "UNCERTAINTY_MEASURE_WITH_UNIT", "DIMENSIONAL_EXPONENTS"})
    EXPECT_FALSE(is_annotation(kept)) << kept;
  for (const auto* gone : {"PERPENDICULARITY_TOLERANCE", "DATUM", "DATUM_FEATURE",
                           "DIMENSIONAL_SIZE", "ANNOTATION_PLANE", "PLUS_MINUS_TOLERANCE"})
    EXPECT_TRUE(is_annotation(gone)) << gone;
}

}  // namespace
}  // namespace tedit::cad
