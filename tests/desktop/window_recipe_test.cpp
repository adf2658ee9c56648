// SPDX-License-Identifier: AGPL-3.0-or-later
// Recipes that are dropped onto the window.
#include "tests/desktop/window_fixture.hpp"

#include <algorithm>

#include <QDropEvent>
#include <QFile>
#include <QMimeData>

#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/recipes/window_player.hpp"

namespace tedit::desktop {
namespace {

class Recipe : public Window {
protected:
  void drop(const QStringList& files) {
    QMimeData what;
    QList<QUrl> urls;
    for (const auto& file : files)
      urls << QUrl::fromLocalFile(file);
    what.setUrls(urls);
    QDropEvent event(QPointF(200, 200), Qt::CopyAction, &what, Qt::LeftButton, Qt::NoModifier);
    static_cast<QObject&>(*window).event(&event);  // Qt delivers only those of its own drags.
  }

  [[nodiscard]] QString recipe(const QByteArray& steps) {
    const QString path = state.filePath("own.json");
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"name\": \"Own\", \"steps\": [" + steps + "]}");
    return path;
  }

  [[nodiscard]] QString said() { return window->context().messages.text(); }
};

TEST_F(Recipe, OpensItsPartAndEachEditIsAVersion) {
  drop({TEDIT_EXAMPLES "/ctc01_plate/recipe.json"});
  for (std::size_t versions = 1; versions <= 3; ++versions)  // Each solve has its time.
    ASSERT_TRUE(wait([&] { return part().versions().size() >= versions; }));
  ASSERT_TRUE(wait([&] { return said().contains("left out"); }));

  EXPECT_FALSE(window->tools().recipes.is_running());
  EXPECT_TRUE(said().contains("(3)")) << said().toStdString();
  EXPECT_EQ(part().versions().size(), 3U);
  EXPECT_EQ(window->findChild<history_strip*>()->count(), 3);
  EXPECT_EQ(version(), 1U);
  EXPECT_EQ(part().loads().all().size(), 1U);
  ASSERT_TRUE(wait([&] { return is_final(); }));
  EXPECT_TRUE(part().work().all().empty());
  EXPECT_TRUE(part().name().startsWith("ctc01_plate.coarse"));
}

TEST_F(Recipe, WithoutAnImportItIsForTheOpenPart) {
  open_plate(false);
  const auto name = part().name();
  const auto own = recipe(R"({"load_case": {"file": ")" + loads().toUtf8() + R"("}},
    {"edit": {"operation": "thicken", "surfaces": [7], "parameters": {"depth_mm": 1}}},
    {"edit": {"operation": "fill_hole", "surfaces": [1, 2]}}, {"solve": {}}, {"undo": {}})");

  drop({own});
  ASSERT_TRUE(wait([&] { return said().contains("done"); }));
  EXPECT_EQ(part().name(), name);
  EXPECT_EQ(part().versions().size(), 3U);
  EXPECT_EQ(version(), 1U);
  EXPECT_NEAR(part().head()->report->volume_change, 5e-6, 1e-9);
}

TEST_F(Recipe, WhatDoesNotFitIsSaidWithStepCauseAndRemedy) {
  const auto own = recipe(R"({"edit": {"operation": "fill_hole", "surfaces": [1, 2]}},
    {"edit": {"operation": "fill_hole", "surfaces": [4711]}}, {"undo": {}})");
  drop({own});
  ASSERT_TRUE(wait([&] { return said().contains("part is open"); }));
  EXPECT_TRUE(said().contains("Open the part first")) << said().toStdString();
  drop({loads()});
  EXPECT_TRUE(said().contains("no recipe")) << said().toStdString();

  open_plate(false);
  drop({own});
  ASSERT_TRUE(wait([&] { return said().contains("no surface 4711"); }));
  EXPECT_TRUE(said().contains("tep 2 (edit): the part has no surface")) << said().toStdString();
  EXPECT_TRUE(said().contains("the recipe was made for")) << said().toStdString();
  EXPECT_FALSE(window->tools().recipes.is_running());
  EXPECT_EQ(version(), 1U);  // What was done before stays.
  EXPECT_TRUE(part().work().all().empty());

  drop({recipe(R"({"edit": {"operaton": "fill_hole"}})")});
  EXPECT_TRUE(said().contains("tep 1 (edit)")) << said().toStdString();
  drop({loads()});  // Of the part that is open.
  EXPECT_TRUE(wait([&] { return part().loads().all().size() == 1; }));
}

// -- steps of the window ------------------------------------------------------------------

class WindowSteps : public Recipe {
protected:
  /// What stopped the steps; empty when all were carried out.
  [[nodiscard]] std::string play(const std::string& steps) {
    const auto read = client::recipe_from_json("[" + steps + "]");
    if (!read)
      return render(read.error());
    window_player player(window->context(), window->tools(), read->steps);
    player.allow_files();
    player.set_patience(60);
    std::optional<std::string> end;
    QObject::connect(&player, &window_player::finished, [&] { end = ""; });
    QObject::connect(&player, &window_player::failed, [&](const error& e) { end = render(e); });
    player.start();
    EXPECT_TRUE(wait([&] { return end.has_value(); }));
    return end.value_or("still waiting");
  }
};

TEST_F(WindowSteps, AreCarriedOutAmongThoseThatWorkOnThePart) {
  const auto picture = state.filePath("a.png").toStdString();
  EXPECT_EQ(play(R"({"import": {"mesh": ")" + plate().toStdString() + R"("}},
    {"load_case": {"file": ")" +
                 loads().toStdString() + R"("}}, {"select": [98]},
    {"apply": "erode", "parameters": {"depth": 0.001}}, {"wait": "final"},
    {"edit": {"operation": "fill_hole", "surfaces": [1, 2]}}, {"undo": true}, {"redo": {}},
    {"go_to": 1}, {"field": "displacement"}, {"bands": 12}, {"deform": 100}, {"drag": 3},
    {"section": {"at": [0, 0, 0], "normal": [0, 1, 0]}}, {"section": null}, {"view": "top"},
    {"hidden": [7]}, {"wait": "final"}, {"screenshot": ")" +
                 picture + R"(", "width": 400,
    "height": 300}, {"export": {"msh": "left_out.msh"}})"),
            "");
  EXPECT_EQ(part().versions().size(), 3U);
  EXPECT_EQ(version(), 1U);
  EXPECT_EQ(window->tools().results.panel().wanted().field, shown_field::displacement);
  EXPECT_EQ(window->tools().selecting.hidden(), (std::set<surface_id>{7}));
  EXPECT_EQ(QImage(QString::fromStdString(picture)).size(), QSize(400, 300));
}

TEST_F(WindowSteps, SurfacesAreFoundByWhatTheyAre) {
  EXPECT_EQ(play(R"({"import": {"mesh": ")" + plate().toStdString() + R"("}},
    {"edit": {"operation": "boss", "surfaces": [{"at_mm": [-235, -49, 0]}], "label": "pin",
              "parameters": {"profile": "circle", "size_mm": 30, "height_mm": 20,
                             "at_mm": "-235,-49,0"}}},
    {"edit": {"operation": "fill_hole", "surfaces": [{"at_mm": [147.5, 45, -25], "as": "hole"}]}},
    {"edit": {"operation": "erode", "parameters": {"depth_mm": 1},
              "surfaces": [{"made_by": "pin", "at_mm": [-235, -49, 20]}]}},
    {"wait": "ready"})"),
            "");
  EXPECT_EQ(version(), 3U);
  const auto end = play(R"({"edit": {"operation": "fill_hole", "surfaces": [{"name": "pin"}]}})");
  EXPECT_NE(end.find("step 1 (edit): no surface is called"), std::string::npos) << end;
}

TEST_F(WindowSteps, WhatThePartOrTheWindowHasNotIsSaidWithItsStep) {
  open_plate();
  const std::pair<const char*, const char*> cases[] = {
    {R"({"click": 4711})", "step 2 (click): surface 4711 cannot be seen"},
    {R"({"choose": "melt"})", "step 2 (choose): there is no operation \"melt\""},
    {R"({"apply": "melt"})", "step 2 (apply): the server has no operation \"melt\""},
    {R"({"apply": "erode", "parameters": {"deep": 1}})", "erode has no parameter \"deep\""},
    {R"({"apply": "erode", "parameters": {"depth": "1"}})", "\"depth\" is of another type"},
    {R"({"command": "view.nothing"})", "step 2 (command): there is no command"},
    {R"({"view": "inside"})", "step 2 (view): there is no command \"view.inside\""},
    {R"({"field": "beauty"})", "step 2 (field): there is no field \"beauty\""},
    {R"({"case": "none"})", "step 2 (case): there is no load case \"none\""},
    {R"({"bands": 999})", "step 2 (bands): there are never 999 bands"},
    {R"({"probe": {"number": 1, "surface": 4711, "at": [0, 0, 0]}})", "no surface 4711"},
    {R"({"camera": {"position": [1, 0, 0], "focus": [1, 0, 0], "up": [0, 0, 1]}})",
     "step 2 (camera): a camera must look somewhere"},
    {R"({"camera": {"position": [0, 0, 1], "focus": [0, 0, 0], "up": [0, 0, 1]}})",
     "step 2 (camera): a camera must look somewhere"},
    {R"({"section": {"at": [0, 0, 0], "normal": [0, 0, 0]}})", "must have a length"},
    {R"({"screenshot": "/nowhere/a.png"})", "cannot write the picture"},
    {R"({"redo": true})", "step 2 (redo): there is nothing to redo"},
    {R"({"go_to": 99})", "step 2 (go_to): "}};
  for (const auto& [step, words] : cases) {
    const auto end = play(std::string(R"({"wait": "ready"}, )") + step + R"(, {"wait": "ready"})");
    EXPECT_NE(end.find(words), std::string::npos) << step << ": " << end;
  }
  EXPECT_EQ(version(), 0U);
  EXPECT_TRUE(shows_head());
}

TEST_F(Recipe, ThatWasDroppedWritesNoFiles) {
  open_plate(false);
  const auto picture = state.filePath("a.png");
  drop({recipe(R"({"view": "top"}, {"screenshot": ")" + picture.toUtf8() + R"("},
    {"report": ")" +
               picture.toUtf8() + R"("})")});
  ASSERT_TRUE(wait([&] { return said().contains("left out"); }));
  EXPECT_TRUE(said().contains("(2)")) << said().toStdString();
  EXPECT_FALSE(QFile::exists(picture));
}

TEST_F(Recipe, IsEndedByItsCancelAndByAnotherPart) {
  open_plate(false);
  const auto steps = recipe(R"({"edit": {"operation": "fill_hole", "surfaces": [1, 2]}},
    {"edit": {"operation": "thicken", "surfaces": [7], "parameters": {"depth_mm": 1}}})");
  drop({steps});
  ASSERT_TRUE(wait([&] { return part().foreground().current().has_value(); }));
  const auto& rows = part().work().all();
  const auto row = std::ranges::find(rows, QString("Own"), &job::title);
  ASSERT_NE(row, rows.end());
  EXPECT_EQ(row->stage, "step 1 of 2 (edit)");
  part().work().cancel(row->id);
  EXPECT_FALSE(window->tools().recipes.is_running());
  ASSERT_TRUE(wait([&] { return part().work().all().empty(); }));

  drop({steps});
  ASSERT_TRUE(window->tools().recipes.is_running());
  part().files().close();
  EXPECT_FALSE(window->tools().recipes.is_running());
  ASSERT_TRUE(wait([&] { return part().work().all().empty(); }));
}

}  // namespace
}  // namespace tedit::desktop
