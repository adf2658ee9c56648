// SPDX-License-Identifier: AGPL-3.0-or-later
// Results and history as a person uses them: fields on demand, boxes, names, load cases, recording.
#include "tests/desktop/window_fixture.hpp"

#include <QComboBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QProcess>
#include <QTreeWidget>

#include "client-qt/model/field_values.hpp"
#include "client-qt/model/probes.hpp"
#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/tools/probes/probe_panel.hpp"
#include "client-qt/tools/recipes/window_player.hpp"
#include "client-qt/tools/recording/recorder.hpp"
#include "client-qt/tools/section/section_bar.hpp"
#include "protocol/convert.hpp"

namespace tedit::desktop {
namespace {

class Recording : public Window {
protected:
  std::optional<double> probed;  ///< The distance of two probes.

  /// As in the panel: a load case is made harder, gets another name, and one is added and removed.
  void record_loads_and_probes() {
    auto twice = part().loads().all().front();
    const std::string before = twice.name;
    std::get<fem::force>(twice.loads.front().kind).total_n.z *= 2;
    part().loads().set(twice);
    twice.name = "twice";
    ASSERT_TRUE(wait([&] { return !part().loads().is_changing(); }));
    part().loads().rename(before, twice);
    ASSERT_TRUE(wait([&] {
      const auto& now = part().loads().all();
      return !part().loads().is_changing() && is_final() && now.size() == 1 &&
             now.front().name == "twice";
    }));

    auto& pins = window->tools().probing.pins();
    int number = 0;
    for (const surface_id id : {98, 7, 3})
      ASSERT_TRUE(pins.put(++number, id, {})) << id;
    pins.remove(2);
    window->tools().probing.list().choose({1, 3});
    probed = pins.distance(pins.all()[0], pins.all()[1], *part().head());
    window->context().picked.set({98});
    ASSERT_TRUE(window->context().all_commands.trigger("view.hide"));
  }
};

TEST_F(Window, PrincipalStressesComeWhenTheyAreWantedAndFollowAnEdit) {
  open_plate();
  EXPECT_TRUE(view().current().field->values.of("stress_pa").empty());

  const auto* low = window->tools().results.panel().findChildren<QLineEdit*>().front();
  EXPECT_FALSE(low->text().isEmpty());
  window->tools().results.panel().set_field(field_named("principal_1"));
  EXPECT_TRUE(low->text().isEmpty()) << "a range of values that are not there";
  EXPECT_EQ(low->placeholderText(), "loading");
  ASSERT_TRUE(wait([&] { return view().painted().extremes.has_value(); }));
  EXPECT_FALSE(low->text().isEmpty());
  const auto& by = view().painted().by;
  EXPECT_EQ(by.map, colour_map::coolwarm);
  EXPECT_DOUBLE_EQ(by.low, -by.high);
  const auto& field = *view().current().field;
  for (std::size_t i = 0; i < field.vertices.size(); ++i)  // None is beyond the largest.
    ASSERT_GE(value_in(field, i, field_named("principal_1")),
              value_in(field, i, field_named("stress_xx")) - 1);

  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  EXPECT_FALSE(view().current().field->values.of("stress_pa").empty());
  window->tools().results.panel().set_field(shown_field::safety_factor);
  ASSERT_TRUE(wait([&] { return view().painted().extremes.has_value(); }));
  EXPECT_NEAR(view().painted().extremes->low, *part().head()->outcome->cases[0].min_safety_factor,
              0.01 * view().painted().extremes->low);
}

TEST_F(Window, TheLargestStrainComesWhenItIsWantedInMicrometresAMetre) {
  open_plate();
  EXPECT_TRUE(view().current().field->values.of("largest_strain").empty());

  window->tools().results.panel().set_field(field_named("largest_strain"));
  ASSERT_TRUE(wait([&] { return view().painted().extremes.has_value(); }));

  const auto& by = view().painted().by;
  EXPECT_EQ(by.map, colour_map::coolwarm);
  EXPECT_EQ(field_title(by.field), "Largest principal strain");
  EXPECT_EQ(shown_as(field_unit(by.field)).name, QString::fromUtf8("µm/m"));
  // Steel or aluminium under some MPa: tens of micrometres a metre.
  EXPECT_GT(view().painted().extremes->high, 1e-6);
  EXPECT_LT(view().painted().extremes->high, 1e-2);
}

TEST_F(Window, WhatChangesNoColourPaintsNothing) {
  open_plate();
  const auto values = view().painted().values.data();
  QSignalSpy painted(&view(), &viewport::legend_changed);
  legend same = view().painted().by;
  same.low = -1;  // Automatic: the values' own range holds.

  view().set_legend(same);
  EXPECT_EQ(painted.count(), 0);
  view().show_part(view().current());  // `shown` follows all the same.
  EXPECT_EQ(view().painted().values.data(), values);
  legend other = same;
  other.map = colour_map::grey;
  view().set_legend(other);
  EXPECT_EQ(painted.count(), 2);
  EXPECT_GE(view().painted().by.low, 0);
}

TEST_F(Window, IsolinesAreDrawnAndTakenAwayAgain) {
  open_plate();
  const auto bare = window->context().over.picture();

  QTest::keyClick(window.get(), Qt::Key_N);
  ASSERT_TRUE(wait([&] { return view().is_settled(); }));
  QTest::qWait(50);
  EXPECT_NE(window->context().over.picture(), bare);

  QTest::keyClick(window.get(), Qt::Key_N);
  QTest::qWait(50);
  EXPECT_EQ(window->context().over.picture(), bare);
}

TEST_F(Window, IsolinesAndBandsAreDrawnOnASection) {
  open_plate();
  std::set<surface_id> all;
  for (const auto& [id, row] : part().head()->surface->surfaces())
    all.insert(id);
  ASSERT_TRUE(window->context().all_commands.trigger("view.edges"));
  window->tools().selecting.set_hidden(all);  // Only the cut surface is left.
  const auto bare = window->context().over.picture();
  window->tools().section.bar().set_plane({0, 0, 0.001}, {0, 0, 1});
  ASSERT_TRUE(wait([&] { return window->context().link.running() == 0 && view().is_settled(); }));
  const auto smooth = window->context().over.picture();
  ASSERT_NE(smooth, bare);

  window->tools().results.panel().set_isolines(true);
  ASSERT_TRUE(wait([&] { return view().is_settled() && window->context().link.running() == 0; }));
  const auto lined = window->context().over.picture();
  EXPECT_NE(lined, smooth);
  window->tools().results.panel().set_isolines(false);
  ASSERT_TRUE(wait([&] { return view().is_settled() && window->context().link.running() == 0; }));
  EXPECT_EQ(window->context().over.picture(), smooth);
  window->tools().results.panel().set_bands(8);
  ASSERT_TRUE(wait([&] { return view().is_settled() && window->context().link.running() == 0; }));
  EXPECT_NE(window->context().over.picture(), smooth);
}

TEST_F(Window, ASectionAcrossAnAxisIsCalledSoAndKeepsItsSide) {
  open_plate(false);
  auto& bar = window->tools().section.bar();
  const auto called = [&] { return bar.findChild<QComboBox*>()->currentText(); };

  bar.set_plane({0, 0, 0}, {0, -2, 0});

  EXPECT_EQ(called(), QString("Section across y"));
  ASSERT_TRUE(view().section());
  EXPECT_EQ(view().section()->normal, (vec3{0, -1, 0}));

  bar.set_plane({0, 0, 0}, {0, 1, 1});

  EXPECT_EQ(called(), QString("Parallel to the picked surface"));
}

TEST_F(Window, ABoxToTheRightTakesWhatLiesInItAndOneToTheLeftWhatItTouches) {
  open_plate(false);
  ASSERT_TRUE(window->context().all_commands.trigger("view.top"));
  const auto place = view().visible_point(98);
  const auto draw = [&](QPoint from, QPoint to, Qt::KeyboardModifiers with) {
    QTest::mousePress(&view(), Qt::LeftButton, with, from);
    for (const QPoint at : {(from + to) / 2, to}) {  // A real drag has the button held.
      QMouseEvent move(QEvent::MouseMove, QPointF(at), view().mapToGlobal(QPointF(at)),
                       Qt::NoButton, Qt::LeftButton, with);
      QApplication::sendEvent(&view(), &move);
    }
    QTest::mouseRelease(&view(), Qt::LeftButton, with, to);
  };
  ASSERT_TRUE(place.has_value());
  const QPoint at = view().to_widget(*place).toPoint();
  const auto before = view().view().get();

  draw(at + QPoint(12, 12), at - QPoint(12, 12), Qt::ControlModifier);  // To the left.
  ASSERT_TRUE(wait([&] { return window->context().picked.contains(98); }));
  draw(at - QPoint(12, 12), at + QPoint(12, 12), Qt::ControlModifier);  // To the right.
  ASSERT_TRUE(wait([&] { return window->context().picked.surfaces().empty(); }));
  EXPECT_EQ(view().view().get().position, before.position);  // Nothing was turned.

  QTest::keyClick(window.get(), Qt::Key_A, Qt::ControlModifier);
  ASSERT_TRUE(wait([&] { return window->context().picked.surfaces().size() > 5; }));
  EXPECT_TRUE(window->context().picked.contains(98));
}

TEST_F(Window, ANameIsKeptByTheServer) {
  open_plate(false);
  part().edits().annotate(0, "as bought", "from the shelf");
  ASSERT_TRUE(wait([&] { return part().head()->info.name == "as bought"; }));

  const auto name = part().name();
  part().files().close();
  part().files().open(name);
  ASSERT_TRUE(wait([&] { return shows_head() && part().head()->info.name == "as bought"; }));
  EXPECT_EQ(part().head()->info.note, "from the shelf");
}

TEST_F(Window, AHistoryThatWasAskedForBeforeItTakesNoNameAway) {
  open_plate(false);
  auto named = part().head()->info;
  named.name = "as bought";
  part().refresh_history();
  emit window->context().link.annotated(named);  // Overtakes the answer.
  QSignalSpy answers(&part(), &document::history_changed);

  ASSERT_TRUE(wait([&] { return !answers.isEmpty(); }));
  EXPECT_EQ(part().head()->info.name, "as bought");
}

TEST_F(Window, AnEditIsTakenOnceAndItsAnswerMovesNoNewerHeadBack) {
  open_plate();
  QSignalSpy edits(&part(), &document::edited);
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  EXPECT_EQ(edits.count(), 1);

  // Somebody else's commit comes between the event of this undo and its answer.
  auto& link = window->context().link;
  bool told = false;
  const QObject here;  // Nobody listens when this test is over.
  QObject::connect(&link, &remote::committed, &here, [&](const client::committed& what) {
    if (std::exchange(told, true))
      return;
    auto other = what;
    other.head.number = 7;
    other.head.version_id = "somebody's";
    emit link.committed(other);
  });
  part().edits().undo();
  ASSERT_TRUE(wait([&] { return told && !part().foreground().current(); }));
  EXPECT_EQ(version(), 7u);
}

TEST_F(Window, ALoadCaseCanBeRemovedTheLastOneToo) {
  open_plate();
  auto second = part().loads().all().front();
  second.name = "second";
  part().loads().set(second);
  ASSERT_TRUE(wait([&] { return is_final() && part().head()->fields.size() == 3; }));

  part().loads().remove("second");
  ASSERT_TRUE(wait([&] { return is_final() && part().head()->fields.size() == 1; }));
  EXPECT_EQ(window->findChild<loads_panel*>()->tree()->topLevelItemCount(), 1);

  part().loads().remove(part().loads().all().front().name);
  ASSERT_TRUE(wait([&] { return part().loads().all().empty(); }));
  EXPECT_TRUE(part().head()->fields.empty());
  EXPECT_EQ(part().solver().progress(), field_state::none);
  EXPECT_FALSE(view().painted().extremes.has_value());
  EXPECT_TRUE(window->context().messages.text().isEmpty())
    << window->context().messages.text().toStdString();
}

TEST_F(Recording, IsPlayedWithItsEditsLoadsProbesAndWhatIsHidden) {
  open_plate();
  window->tools().recording.recording().start();
  window->context().picked.set({1, 2});
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  window->tools().results.panel().set_field(field_named("max_shear"));
  window->tools().results.panel().set_bands(8);
  ASSERT_TRUE(wait([&] { return view().painted().extremes.has_value(); }));
  record_loads_and_probes();
  const auto loads = part().loads().all();
  part().edits().apply({"erode", {98}, {{"depth", 0.5}}});  // Refused: no step.
  ASSERT_TRUE(wait([&] { return !part().foreground().current() && shows_head(); }));
  ASSERT_TRUE(window->context().all_commands.trigger("view.top"));
  window->tools().recording.recording().stop();
  const auto text = client::to_json(window->tools().recording.recording().recipe());
  const auto id = part().head()->info.version_id;
  const auto pose = view().view().get();

  window = std::make_unique<main_window>(state.path());
  window->resize(1200, 800);
  window->show();
  open_plate(false);  // The loads are in the recording.
  const auto recorded = client::recipe_from_json(text);
  ASSERT_TRUE(recorded) << render(recorded.error()) << text;
  window_player replay(window->context(), window->tools(), recorded->steps);
  bool done = false;
  QObject::connect(&replay, &window_player::finished, [&] { done = true; });
  replay.start();
  ASSERT_TRUE(wait([&] { return done && is_final(); })) << text;

  EXPECT_EQ(part().head()->info.version_id, id);
  EXPECT_EQ(window->tools().results.panel().wanted().field, field_named("max_shear"));
  EXPECT_EQ(window->tools().results.panel().wanted().bands, 8);
  const vec3 off = view().view().get().position - pose.position;
  EXPECT_LT(dot(off, off), 1e-12);
  EXPECT_EQ(part().versions().size(), 2U);
  ASSERT_EQ(loads.size(), 1U);
  ASSERT_EQ(part().loads().all().size(), 1U);
  EXPECT_EQ(protocol::load_case_to_json(part().loads().all().front()),
            protocol::load_case_to_json(loads.front()));
  EXPECT_EQ(loads.front().name, "twice");
  EXPECT_EQ(window->tools().selecting.hidden(), (std::set<surface_id>{98}));
  ASSERT_EQ(window->tools().probing.pins().all().size(), 2U);
  EXPECT_EQ(window->tools().probing.pins().all()[0].number, 1);
  EXPECT_EQ(window->tools().probing.pins().all()[1].number, 3);
  EXPECT_EQ(window->tools().probing.list().chosen(), (std::vector<int>{1, 3}));
  const auto way = window->tools().probing.pins().distance(window->tools().probing.pins().all()[0],
                                                           window->tools().probing.pins().all()[1],
                                                           *part().head());
  ASSERT_TRUE(way && probed);
  EXPECT_NEAR(*way, *probed, 1e-9);
}

/// What "tedit run" says of a recipe; empty when it failed.
QJsonObject run_on_the_command_line(const QStringList& arguments) {
  QProcess program;
  program.start(QCoreApplication::applicationDirPath() + "/tedit",
                QStringList{"run", "--json"} + arguments);
  EXPECT_TRUE(program.waitForFinished(120'000));
  const auto out = program.readAllStandardOutput();
  EXPECT_EQ(program.exitCode(), 0)
    << out.toStdString() << program.readAllStandardError().toStdString();
  return QJsonDocument::fromJson(out).object();
}

TEST_F(Recording, MakesTheSameVersionsOnTheCommandLine) {
  open_plate();
  auto& recorder = window->tools().recording.recording();
  recorder.start();
  std::vector<std::string> made;
  const auto note = [&](std::uint32_t wanted) {
    ASSERT_TRUE(wait([&] { return version() == wanted && shows_head(); }));
    made.push_back(part().head()->info.version_id);
  };
  click_surface(1);  // As a person: picked, previewed, applied by the form.
  ASSERT_TRUE(wait([&] { return window->context().picked.surfaces().size() == 2; }));
  press("offer_fill_hole");
  press("apply");
  note(1);
  part().edits().apply({"erode", {98}, {{"depth", 0.001}}, {fem::load_policy::move, true}});
  note(2);
  part().edits().undo();
  note(1);
  part().edits().redo();
  note(2);
  part().edits().go_to(0);
  note(0);
  recorder.stop();
  for (const auto& recipe : {recorder.recipe(), recorder.portable_recipe()}) {
    const QString file = state.filePath("recorded.json");
    QFile out(file);
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(QByteArray::fromStdString(client::to_json(recipe)));
    out.close();

    const auto said = run_on_the_command_line({file, "--mesh", plate()});
    std::vector<std::string> there;
    for (const auto& one : said["steps"].toArray()) {
      const auto step = one.toObject();
      if (step["step"] != "import" && step["step"] != "load_case")
        there.push_back(step["version_id"].toString().toStdString());
    }
    EXPECT_EQ(there, made);
    EXPECT_GT(said["passed_over"].toInt(), 0);
    EXPECT_EQ(recipe.name, "ctc01_plate.coarse");
    for (const auto& step : recipe.steps)
      EXPECT_FALSE(std::holds_alternative<client::apply_step>(step));
  }
}

/// No number of a surface is left: those of CAD by their names, others by a place, and what an edit
/// made by that edit.
TEST_F(Recording, SaysWhatSurfacesAreForOtherMeshes) {
  open_plate();
  auto& recorder = window->tools().recording.recording();
  recorder.start();
  part().edits().apply(
    {"boss", {98}, {{"size", 0.03}, {"height", 0.02}}, {fem::load_policy::move, true}});
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));
  const auto& surfaces = part().head()->surface->surfaces();
  const auto made = std::ranges::max_element(
    surfaces, {}, [](const auto& row) { return row.first; });  // The newest.
  part().edits().apply(
    {"thicken", {made->first}, {{"depth", 0.001}}, {fem::load_policy::move, true}});
  ASSERT_TRUE(wait([&] { return version() == 2 && shows_head(); }));
  recorder.stop();

  std::vector<client::edit_step> edits;
  for (const auto& step : recorder.portable_recipe().steps) {
    if (const auto* edit = std::get_if<client::edit_step>(&step))
      edits.push_back(*edit);
    if (const auto* loads = std::get_if<client::load_case_step>(&step)) {
      EXPECT_FALSE(loads->references.empty());
    }
    EXPECT_STRNE(client::kind_of(step), "select");
  }
  ASSERT_EQ(edits.size(), 2U);
  EXPECT_EQ(edits[0].label, "edit 1");
  ASSERT_EQ(edits[0].references.size(), 1U);
  EXPECT_TRUE(edits[0].references[0].at_mm || !edits[0].references[0].name.empty());
  EXPECT_EQ(edits[0].references[0].made_by, "");
  ASSERT_EQ(edits[1].references.size(), 1U);
  EXPECT_EQ(edits[1].references[0].made_by, "edit 1");
  EXPECT_EQ(edits[1].request.surfaces, std::vector{client::place_of_reference(0)});
}

}  // namespace
}  // namespace tedit::desktop
