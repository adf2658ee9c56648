// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/quantities.hpp"

#include <QLocale>

#include <cmath>

#include <gtest/gtest.h>

#include "client-qt/model/operation_words.hpp"

namespace tedit::desktop {
namespace {

std::string utf8(const QString& words) {
  return words.toStdString();
}

TEST(Quantities, ShowWhatEngineersThinkIn) {
  EXPECT_EQ(utf8(quantity(0.0125, "m")), "12.5 mm");
  EXPECT_EQ(utf8(quantity(187.04e6, "Pa")), "187 MPa");
  EXPECT_EQ(utf8(quantity(2e-4, "m2")), "200 mm²");
  EXPECT_EQ(utf8(quantity(500, "N")), "500 N");
  EXPECT_EQ(utf8(quantity(0.5, "")), "0.5");
  EXPECT_EQ(utf8(quantity(std::acos(-1.0) / 2, "rad")), "90°");
}

TEST(Quantities, NumbersKeepTheirSizeReadable) {
  EXPECT_EQ(utf8(number(0)), "0");
  EXPECT_EQ(utf8(number(21992.1)), "21992.1");
  EXPECT_EQ(utf8(number(1.234e-5)), "1.23e-5");
  EXPECT_EQ(utf8(number(3.2e7)), "3.2e+7");
  EXPECT_EQ(utf8(number(NAN)), "none");
  EXPECT_EQ(utf8(quantity(2.19921e-5, "m3")), "21992.1 mm³");
  EXPECT_EQ(utf8(quantity(-3.8e-3, "m3")), "-3800 cm³");
}

TEST(Quantities, AChangeIsNotTakenForTheWhole) {
  EXPECT_EQ(utf8(change_by(2.19921e-5, "m3")), "+21992.1 mm³");
  EXPECT_EQ(utf8(change_by(-3.8e-3, "m3")), "−3800 cm³");
  EXPECT_EQ(utf8(change_by(0, "m3")), "0 mm³");
}

TEST(Quantities, WhatIsSaidIsASentence) {
  EXPECT_EQ(utf8(sentence_of("the selection grew by 3 mm2")), "The selection grew by 3 mm².");
  EXPECT_EQ(utf8(sentence_of("It is done.")), "It is done.");
  EXPECT_EQ(utf8(sentence_of("")), "");
}

TEST(Quantities, NumbersOnAScaleAreRoundedByItsRange) {
  EXPECT_EQ(utf8(number_in(5.4e-8, 7.117)), "0");
  EXPECT_EQ(utf8(number_in(7.117, 7.117)), "7.12");
  EXPECT_EQ(utf8(number_in(5, 13.4)), "5");
  EXPECT_EQ(utf8(number_in(1000.003, 0.004)), "1000.003");
  EXPECT_EQ(utf8(number_in(2.5e-7, 5e-7)), "2.5e-7");
  EXPECT_EQ(utf8(number_in(-120, 240)), "-120");
}

TEST(Quantities, NumbersHaveTheDecimalPointOfTheLanguage) {
  const QLocale before;
  QLocale::setDefault(QLocale(QLocale::German));

  EXPECT_EQ(utf8(quantity(3.347e6, "Pa")), "3,347 MPa");
  EXPECT_EQ(utf8(number(21992.1)), "21992,1");
  EXPECT_EQ(utf8(number_in(7.117, 7.117)), "7,12");
  EXPECT_EQ(utf8(duration(1300)), "1,3 s");
  EXPECT_EQ(utf8(change(100, 103.2)), "+3,2 %");
  EXPECT_EQ(utf8(exact(-2500.25)), "-2500,25");
  EXPECT_EQ(utf8(words_of("Area 12.5 mm2 (-3.1 %), 0.5.")), "Area 12,5 mm² (-3,1 %), 0,5.");
  EXPECT_EQ(utf8(words_of("part-0.5.msh of 127.0.0.1:88, v0.1")),
            "part-0.5.msh of 127.0.0.1:88, v0.1");
  QLocale::setDefault(before);
}

TEST(Quantities, LengthsChooseTheirUnit) {
  EXPECT_EQ(utf8(length(2.5)), "2.5 m");
  EXPECT_EQ(utf8(length(0.0125)), "12.5 mm");
  EXPECT_EQ(utf8(length(3.5e-5)), "35 µm");
  EXPECT_EQ(utf8(length(2e-8)), "20 nm");
  EXPECT_EQ(utf8(length(0)), "0 mm");
}

TEST(Quantities, WordsOfTheServerGetTheLettersOfTheWindow) {
  EXPECT_EQ(utf8(words_of("12 mm2 (-3 %) and 0.5 mm3, 2 m2")), "12 mm² (-3 %) and 0.5 mm³, 2 m²");
  EXPECT_EQ(utf8(words_of("surface mm22 of item3, 4 mm")), "surface mm22 of item3, 4 mm");
}

TEST(Quantities, AnEditThatItsPreviewMadeTookWhatThePreviewTook) {
  edit_report report;
  report.operation_ms = 30;
  report.improve_ms = 8;
  report.check_ms = 2;
  report.total_ms = 45;
  EXPECT_FALSE(was_previewed(report));
  EXPECT_EQ(made_in_ms(report), 45);

  report.total_ms = 0.02;
  EXPECT_TRUE(was_previewed(report));
  EXPECT_EQ(made_in_ms(report), 40);
}

TEST(Quantities, Durations) {
  EXPECT_EQ(utf8(duration(3.14)), "3.1 ms");
  EXPECT_EQ(utf8(duration(87)), "87 ms");
  EXPECT_EQ(utf8(duration(1300)), "1.3 s");
  EXPECT_EQ(utf8(duration(250'000)), "4 min 10 s");
}

TEST(Quantities, Counts) {
  EXPECT_EQ(utf8(count(12)), "12");
  EXPECT_EQ(utf8(count(9999)), "9999");
  EXPECT_EQ(utf8(count(21750)), "21.8 k");
  EXPECT_EQ(utf8(count(1.02e6)), "1.02 M");
}

TEST(Quantities, Changes) {
  EXPECT_EQ(utf8(change(100, 103.2)), "+3.2 %");
  EXPECT_EQ(utf8(change(100, 75)), "−25 %");
  EXPECT_EQ(utf8(change(-100, -50)), "+50 %");
  EXPECT_EQ(utf8(change(0, 5)), "");
  EXPECT_EQ(utf8(change(100, 100.02)), "+0.02 %") << "not +0.0 %";
  EXPECT_EQ(utf8(change(100, 100.001)), "0.0 %") << "nothing has no sign";
  EXPECT_EQ(utf8(change(100, 99.96)), "−0.04 %");
}

}  // namespace
}  // namespace tedit::desktop
