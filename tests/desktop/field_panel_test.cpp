// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/results/field_panel.hpp"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QtTest/QtTest>

#include <algorithm>

#include "client-qt/tools/results/deformation_row.hpp"

namespace tedit::desktop {
namespace {

class FieldPanel : public testing::Test {
protected:
  FieldPanel() {
    part_.begin("part");
    client::committed import;
    import.head.version_id = "v";
    import.head.load_cases = {"a"};
    emit link_.committed(import);
  }

  void arrive(bool interim) {
    auto field = std::make_shared<client::field_event>();
    field->report.version_id = "v";
    field->report.load_case = "a";
    field->report.interim = interim;
    emit link_.field_arrived(field);
    legend shown = panel_.wanted();
    shown.low = 1e6;
    shown.high = interim ? 2e6 : 3e6;
    panel_.take_range(shown, true);  // As the view tells it.
    QCoreApplication::processEvents();
  }

  /// Two load cases and their envelope.
  void arrive_all() {
    for (std::uint32_t left = 3; left-- > 0;) {
      auto field = std::make_shared<client::field_event>();
      field->remaining = left;
      field->report.version_id = "v";
      field->report.load_case = left == 2 ? "a" : "b";
      if (left == 0) {
        field->envelope.emplace();
        field->envelope->version_id = "v";
      }
      emit link_.field_arrived(field);
    }
  }

  remote link_;
  document part_{link_};
  field_panel panel_{part_};
};

TEST_F(FieldPanel, LocksToTheFirstConvergedFieldWhenThatIsWanted) {
  panel_.set_look(colour_map::cividis, true, false);

  arrive(true);
  EXPECT_EQ(panel_.wanted().mode, range_mode::automatic);
  arrive(false);

  EXPECT_EQ(panel_.wanted().mode, range_mode::locked);
  EXPECT_EQ(panel_.wanted().high, 3e6);
  EXPECT_EQ(panel_.wanted().map, colour_map::cividis);
}

TEST_F(FieldPanel, StaysAutomaticOtherwise) {
  panel_.set_look(colour_map::viridis, false, true);

  arrive(false);

  EXPECT_EQ(panel_.wanted().mode, range_mode::automatic);
  EXPECT_TRUE(panel_.wanted().logarithmic);
}

TEST_F(FieldPanel, WhatHasASignIsReadByOtherColoursAndEachKindKeepsItsOwn) {
  panel_.set_look(colour_map::cividis, false, false);
  panel_.set_field(field_named("principal_1"));
  EXPECT_EQ(panel_.wanted().map, colour_map::coolwarm);
  panel_.set_field(shown_field::safety_factor);
  EXPECT_EQ(panel_.wanted().map, colour_map::safety);
  panel_.set_field(field_named("max_shear"));
  EXPECT_EQ(panel_.wanted().map, colour_map::cividis);

  panel_.findChild<QComboBox*>("colours")->setCurrentIndex(static_cast<int>(colour_map::grey));
  panel_.set_field(field_named("stress_xy"));
  EXPECT_EQ(panel_.wanted().map, colour_map::coolwarm);
  panel_.set_field(shown_field::von_mises);
  EXPECT_EQ(panel_.wanted().map, colour_map::grey);
}

TEST_F(FieldPanel, TheEnvelopeIsLeftForAFieldThatItHasNotAndThatFieldForTheEnvelope) {
  arrive_all();
  ASSERT_TRUE(panel_.field() && panel_.field()->envelope);

  panel_.set_field(field_named("principal_1"));
  ASSERT_FALSE(panel_.field()->envelope);
  EXPECT_EQ(panel_.shown_case(), "a");

  panel_.set_case("");
  EXPECT_TRUE(panel_.field()->envelope);
  EXPECT_EQ(panel_.wanted().field, shown_field::von_mises);
}

TEST_F(FieldPanel, NamesNoRangeOfWhatHasNotArrived) {
  auto* low = panel_.findChildren<QLineEdit*>().front();
  auto* missing = panel_.findChild<QLabel*>("field_missing");
  arrive(false);
  EXPECT_EQ(low->text(), "1");  // MPa.
  panel_.set_field(field_named("principal_1"));

  legend nothing = panel_.wanted();
  nothing.fit({});
  panel_.take_range(nothing, false);
  EXPECT_TRUE(low->text().isEmpty()) << low->text().toStdString();
  EXPECT_EQ(low->placeholderText(), "loading");
  EXPECT_TRUE(missing->text().startsWith("Loading")) << missing->text().toStdString();

  panel_.set_field(shown_field::von_mises);
  panel_.take_range(panel_.wanted(), true);
  EXPECT_FALSE(low->text().isEmpty());
  EXPECT_TRUE(low->placeholderText().isEmpty());
  EXPECT_TRUE(missing->text().isEmpty());
}

TEST_F(FieldPanel, WhatDoesNothingIsOffAndSaysWhy) {
  arrive_all();
  panel_.set_case("a");
  const std::vector<const char*> all{"range_mode", "colours", "bands", "isolines", "logarithmic"};
  const auto off = [&] {
    std::vector<std::string> result;
    for (const auto* name : all)
      if (const auto* one = panel_.findChild<QWidget*>(name); !one->isEnabled()) {
        EXPECT_FALSE(one->toolTip().isEmpty()) << name;
        result.emplace_back(name);
      }
    return result;
  };
  const auto hint = panel_.findChild<QWidget*>("bands")->toolTip();
  EXPECT_TRUE(off().empty());

  for (const auto plain : {shown_field::surfaces, shown_field::none}) {
    panel_.set_field(plain);
    EXPECT_EQ(off(), std::vector<std::string>(all.begin(), all.end()));
  }
  panel_.set_field(shown_field::safety_factor);
  EXPECT_EQ(off(), (std::vector<std::string>{"range_mode", "bands", "logarithmic"}));
  panel_.set_field(field_named("principal_1"));
  EXPECT_EQ(off(), std::vector<std::string>{"logarithmic"});
  panel_.set_field(shown_field::von_mises);
  EXPECT_TRUE(off().empty());
  EXPECT_EQ(panel_.findChild<QWidget*>("bands")->toolTip(), hint);
}

TEST_F(FieldPanel, SafetyStepsHaveNoRangeOfTheirOwn) {
  arrive(false);
  auto* low = panel_.findChildren<QLineEdit*>().front();
  panel_.set_field(shown_field::safety_factor);
  legend shown = panel_.wanted();
  shown.low = 20.5;
  shown.high = 41;
  panel_.take_range(shown, true);  // As the view tells it.
  EXPECT_TRUE(low->text().isEmpty()) << low->text().toStdString();

  panel_.findChild<QComboBox*>("colours")->setCurrentIndex(static_cast<int>(colour_map::viridis));
  shown.map = colour_map::viridis;
  panel_.take_range(shown, true);
  EXPECT_EQ(low->text(), "20.5");
}

TEST_F(FieldPanel, SafetyStepsAreForTheSafetyFactorAndADeformationForALoadCase) {
  arrive_all();
  const auto* colours = panel_.findChild<QComboBox*>("colours");
  const auto offers_steps = [&] {
    constexpr auto row = static_cast<int>(colour_map::safety);
    return colours->model()->index(row, 0).flags().testFlag(Qt::ItemIsEnabled);
  };
  EXPECT_FALSE(offers_steps());
  panel_.set_field(shown_field::safety_factor);
  EXPECT_TRUE(offers_steps());

  ASSERT_TRUE(panel_.field()->envelope);
  EXPECT_FALSE(panel_.deformation().isEnabled());
  EXPECT_FALSE(panel_.deformation().toolTip().isEmpty());
  panel_.set_case("a");
  EXPECT_TRUE(panel_.deformation().isEnabled());
}

TEST_F(FieldPanel, SaysWhyThereIsNoSafetyFactor) {
  arrive(false);
  panel_.set_field(shown_field::safety_factor);

  auto* missing = panel_.findChild<QLabel*>("field_missing");
  EXPECT_TRUE(missing->text().contains("yield strength")) << missing->text().toStdString();
  panel_.set_field(shown_field::von_mises);
  EXPECT_TRUE(missing->text().isEmpty());
}

TEST(Deformation, IsReadableWhereTheLargestIsATwentiethOfThePart) {
  EXPECT_DOUBLE_EQ(readable_deformation(1e-3, 0.1), 5);      // .05 * .1 / .001
  EXPECT_DOUBLE_EQ(readable_deformation(1.01e-3, 0.1), 2);   // 4.95
  EXPECT_DOUBLE_EQ(readable_deformation(2e-6, 0.16), 2000);  // 4000
  EXPECT_DOUBLE_EQ(readable_deformation(0.2, 0.1), 1);       // Is seen as it is.
  EXPECT_DOUBLE_EQ(readable_deformation(0, 0.1), 0);
  EXPECT_DOUBLE_EQ(readable_deformation(1e-320, 0.1), 0);  // The factor has no number.
}

TEST(Deformation, AnAutomaticFactorFollowsWhatIsShownUntilOneIsTyped) {
  deformation_row row;
  row.take(1e-3, 0.1);
  EXPECT_EQ(row.factor(), 0) << "nobody asked for it";
  row.findChild<QToolButton*>("deform_automatic")->setChecked(true);
  EXPECT_EQ(row.factor(), 5);
  row.take(1e-4, 0.1);
  EXPECT_EQ(row.factor(), 50);

  row.set_factor(7);
  EXPECT_FALSE(row.is_automatic());
  row.take(1e-3, 0.1);
  EXPECT_EQ(row.factor(), 7);
}

TEST(Deformation, SwingsBetweenThePartWithoutLoadAndTheFactor) {
  deformation_row row;
  row.take(1e-3, 0.1);
  row.set_swinging(true);  // Of a part that is not deformed: as far as it is readable.
  EXPECT_EQ(row.factor(), 5);
  double low = 1e9;
  double high = -1;
  const auto look = [&] {
    low = std::min(low, row.shown_factor());
    high = std::max(high, row.shown_factor());
  };
  QObject::connect(&row, &deformation_row::swung, look);
  ASSERT_TRUE(QTest::qWaitFor([&] { return low < 0.1 && high > 4.9; }, 60'000));
  EXPECT_EQ(row.factor(), 5);

  row.set_swinging(false);
  EXPECT_EQ(row.shown_factor(), 5);
}

}  // namespace
}  // namespace tedit::desktop
