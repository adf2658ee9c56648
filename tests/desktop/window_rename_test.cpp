// SPDX-License-Identifier: AGPL-3.0-or-later
// A document that gets another name in a window, and what is kept by its name.
#include "tests/desktop/window_fixture.hpp"

#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>

#include <csignal>

#include "client-qt/tools/documents/name_form.hpp"
#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/pictures/kept_picture.hpp"
#include "client-qt/tools/probes/probes_tool.hpp"

namespace tedit::desktop {
namespace {

class Renaming : public Window {
protected:
  [[nodiscard]] QWidget* form() { return window->findChild<name_form*>(); }
  [[nodiscard]] QString words() {
    return window->findChild<QLabel*>("document_name_words")->text();
  }
  [[nodiscard]] QString title() { return window->findChild<QLabel*>("title")->text(); }
  [[nodiscard]] QStringList recents() {
    return window->context().settings.value("recent").toStringList();
  }

  void ask_for(const QString& name) {
    ASSERT_TRUE(window->context().all_commands.trigger("file.rename"));
    ASSERT_TRUE(form()->isVisible());
    type(name);
  }
  void type(const QString& name) {
    auto* edit = window->findChild<QLineEdit*>("document_name");
    edit->selectAll();
    QTest::keyClicks(edit, name);
    QTest::keyClick(edit, Qt::Key_Return);
  }

  /// Files and settings that are kept by a document's name.
  [[nodiscard]] QStringList kept_of(const QString& name) {
    QStringList result;
    const auto picture = picture_file(state.path(), name);
    for (const auto& path :
         {state.path() + "/documents/" + name + ".tedit", picture, picture.chopped(4)})
      if (QFileInfo::exists(path))
        result << path;
    auto& settings = window->context().settings;
    if (settings.contains(pins_key(name)))
      result << "pins";
    if (settings.value("recent_used").toMap().contains(name))
      result << "used";
    if (settings.value("unfinished") == name)
      result << "unfinished";
    return result;
  }
};

TEST_F(Renaming, WhatIsKeptByTheNameFollowsIt) {
  open_plate();
  auto& pins = window->tools().probing.pins();
  const auto* surface = part().head()->surface.get();
  surface_id wall = 0;
  for (const auto& [id, row] : surface->surfaces())
    if (!wall && id > 2 && view().visible_point(id))  // The bore, 1 and 2, is filled.
      wall = id;
  ASSERT_TRUE(pins.put(3, wall, *view().visible_point(wall)));
  const auto version_id = part().head()->info.version_id;
  const auto before = part().name();
  ASSERT_TRUE(wait([&] { return QFile::exists(picture_file(state.path(), before, version_id)); }));
  ASSERT_TRUE(wait([&] { return QFile::exists(picture_file(state.path(), before)); }));
  ASSERT_EQ(kept_of(before).size(), 6) << kept_of(before).join(" ").toStdString();
  window->context().settings.setValue(pins_key("left-bracket"), QVariantList{1});  // Somebody's.

  ask_for("left-bracket");
  ASSERT_TRUE(wait([&] { return part().name() == "left-bracket" && !form()->isVisible(); }));

  EXPECT_EQ(pins.all().size(), 1U) << "nothing of what is seen goes";
  EXPECT_TRUE(title().contains("left-bracket")) << title().toStdString();
  EXPECT_TRUE(window->windowTitle().startsWith("left-bracket"));
  EXPECT_EQ(kept_of(before), QStringList{});
  EXPECT_EQ(kept_of("left-bracket").size(), 6);
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));

  part().files().close();
  EXPECT_EQ(recents(), QStringList{"left-bracket"});
  auto* list = window->findChild<QListWidget*>("recent");
  ASSERT_EQ(list->count(), 1);
  EXPECT_TRUE(list->item(0)->text().startsWith("left-bracket"));
  const auto place = list->visualItemRect(list->item(0)).center();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, place);
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  EXPECT_EQ(part().name(), "left-bracket");
  ASSERT_EQ(pins.all().size(), 1U);
  EXPECT_EQ(pins.all().front().number, 3);
  auto* strip = window->findChild<history_strip*>();
  EXPECT_TRUE(wait([&] { return strip->has_thumbnail(version_id, true); }));
  EXPECT_EQ(kept_of(before), QStringList{});
}

TEST_F(Renaming, ARefusedNameIsSaidInTheFormAndCanBeChanged) {
  open_plate(false);
  const auto before = part().name();
  QFile other(state.path() + "/documents/taken.tedit");
  ASSERT_TRUE(other.open(QIODevice::WriteOnly));

  ask_for("a/b");
  ASSERT_TRUE(wait([&] { return words().contains("cannot name a document"); }));
  EXPECT_TRUE(words().contains("64 letters")) << "the remedy: " << words().toStdString();
  type("taken");
  ASSERT_TRUE(wait([&] { return words().contains("there is a document taken"); }));
  EXPECT_TRUE(form()->isVisible());
  EXPECT_EQ(part().name(), before);
  EXPECT_EQ(window->context().messages.text(), "") << "the form says it";
  type("free  of blanks");
  EXPECT_TRUE(wait([&] { return part().name() == "free-of-blanks" && !form()->isVisible(); }));
}

TEST_F(Renaming, EscAndTheSameNameLeaveItAsItIs) {
  open_plate(false);
  const auto before = part().name();
  auto* edit = window->findChild<QLineEdit*>("document_name");

  ASSERT_TRUE(window->context().all_commands.trigger("file.rename"));
  QTest::keyClicks(edit, "other");
  QTest::keyClick(edit, Qt::Key_Escape);
  EXPECT_FALSE(form()->isVisible());
  ASSERT_TRUE(window->context().all_commands.trigger("file.rename"));
  EXPECT_TRUE(before.startsWith(edit->text())) << "what a person calls it";
  QTest::keyClick(edit, Qt::Key_Return);
  EXPECT_FALSE(form()->isVisible());
  EXPECT_EQ(part().name(), before);
}

/// Another client does it, and then the server dies: the window follows, and comes back.
TEST_F(Renaming, AnothersRenameIsFollowedAlsoOverALostServer) {
  open_plate(false);
  const auto before = part().name();
  const auto other = client::client::connect(window->context().link.options(), {});
  ASSERT_TRUE(other.has_value());
  ASSERT_TRUE((*other)->open(before.toStdString(), false, false).has_value());
  ASSERT_TRUE((*other)->rename_document("theirs").has_value());
  ASSERT_TRUE(wait([&] { return part().name() == "theirs"; }));
  EXPECT_EQ(kept_of(before), QStringList{});
  EXPECT_EQ(recents(), QStringList{"theirs"});

  int opened = 0;
  const QObject here;  // Nobody listens when this test is over.
  QObject::connect(&part(), &document::opened, &here, [&] { ++opened; });
  ::kill(static_cast<pid_t>(window->context().server.pid()), SIGKILL);
  ASSERT_TRUE(wait([&] { return opened > 0 && shows_head(); }));
  EXPECT_EQ(part().name(), "theirs");
  part().edits().apply({"fill_hole", {1, 2}, {}});
  EXPECT_TRUE(wait([&] { return version() == 1; }));
}

}  // namespace
}  // namespace tedit::desktop
