// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/field_panel.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>

namespace tedit::desktop {
namespace {

class FieldPanel : public testing::Test {
protected:
  FieldPanel() {
    part_.open("part");
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
    panel_.take_range(shown);  // As the view tells it.
    QCoreApplication::processEvents();
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

}  // namespace
}  // namespace tedit::desktop
