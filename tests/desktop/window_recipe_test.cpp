// SPDX-License-Identifier: AGPL-3.0-or-later
// Recipes that are dropped onto the window.
#include "tests/desktop/window_fixture.hpp"

#include <QDropEvent>
#include <QFile>
#include <QMimeData>

#include "client-qt/tools/history/history_strip.hpp"

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

  open_plate(false);
  drop({own});
  ASSERT_TRUE(wait([&] { return said().contains("no surface 4711"); }));
  EXPECT_TRUE(said().contains("step 2 of 3 (edit)")) << said().toStdString();
  EXPECT_TRUE(said().contains("the recipe was made for")) << said().toStdString();
  EXPECT_FALSE(window->tools().recipes.is_running());
  EXPECT_EQ(version(), 1U);  // What was done before stays.
  EXPECT_TRUE(part().work().all().empty());

  drop({recipe(R"({"edit": {"operaton": "fill_hole"}})")});
  EXPECT_TRUE(said().contains("tep 1 (edit)")) << said().toStdString();
  drop({loads()});
  EXPECT_TRUE(said().contains("no recipe")) << said().toStdString();
}

}  // namespace
}  // namespace tedit::desktop
