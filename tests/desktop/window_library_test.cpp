// SPDX-License-Identifier: AGPL-3.0-or-later
// The documents of the server, looked after in a window.
#include "tests/desktop/window_fixture.hpp"

#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QTreeWidget>

#include <algorithm>

#include "client-qt/tools/documents/documents_dialog.hpp"
#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/pictures/kept_picture.hpp"

namespace tedit::desktop {
namespace {

class ServerLibrary : public Window {
protected:
  [[nodiscard]] documents_dialog* dialog() { return window->findChild<documents_dialog*>(); }
  [[nodiscard]] QStringList names() {
    QStringList result;
    for (int i = 0; dialog() && i < dialog()->list()->topLevelItemCount(); ++i)
      result << dialog()->list()->topLevelItem(i)->text(0);
    result.sort();
    return result;
  }
  void choose(const QString& name) {
    const auto found = dialog()->list()->findItems(name, Qt::MatchExactly);
    ASSERT_EQ(found.size(), 1) << name.toStdString();
    dialog()->list()->setCurrentItem(found.front());
  }
  void type(const QString& name) {
    auto* edit = window->findChild<QLineEdit*>("documents_name");
    edit->selectAll();
    QTest::keyClicks(edit, name);
    QTest::keyClick(edit, Qt::Key_Return);
  }
  [[nodiscard]] bool has_file(const QString& name) {
    return QFile::exists(state.path() + "/documents/" + name + ".tedit");
  }
};

TEST_F(ServerLibrary, ADocumentIsCopiedRenamedOpenedAndDeleted) {
  open_plate(false);
  const auto first = part().name();
  ASSERT_TRUE(window->context().all_commands.trigger("file.documents"));
  ASSERT_TRUE(wait([&] { return names() == QStringList{first}; }));

  choose(first);
  press("documents_copy");
  type("copy of it");
  const auto runs = [&](const QString& title) {
    return std::ranges::any_of(part().work().all(),
                               [&](const job& one) { return one.title == title && one.cancel; });
  };
  EXPECT_TRUE(runs("Copy of " + first)) << "it can be cancelled";
  ASSERT_TRUE(wait([&] { return names().contains("copy-of-it"); }));
  EXPECT_FALSE(runs("Copy of " + first));
  EXPECT_TRUE(has_file("copy-of-it"));
  choose("copy-of-it");
  press("documents_rename");
  type("clamp");
  ASSERT_TRUE(wait([&] { return names().contains("clamp"); }));
  EXPECT_FALSE(has_file("copy-of-it"));
  choose(first);
  press("documents_rename");
  type("plate");
  ASSERT_TRUE(wait([&] { return names() == QStringList({"clamp", "plate"}); }));
  EXPECT_EQ(part().name(), "plate") << "the open one follows";

  choose("clamp");
  press("documents_open");
  ASSERT_TRUE(wait([&] { return part().name() == "clamp" && shows_head(); }));
  ASSERT_TRUE(window->context().all_commands.trigger("file.documents"));
  ASSERT_TRUE(wait([&] { return names() == QStringList({"clamp", "plate"}); }));
  choose("plate");
  press("documents_delete");
  press("documents_yes");
  ASSERT_TRUE(wait([&] { return names() == QStringList{"clamp"}; }));
  EXPECT_FALSE(has_file("plate"));
  EXPECT_EQ(part().name(), "clamp");
  EXPECT_TRUE(part().head());
}

TEST_F(ServerLibrary, ThePartGoesWithItsDocumentAndSoDoesWhatWasKeptOfIt) {
  open_plate(false);
  const auto name = part().name();
  ASSERT_TRUE(wait([&] { return QFile::exists(picture_file(state.path(), name)); }));
  ASSERT_TRUE(window->context().all_commands.trigger("file.documents"));
  ASSERT_TRUE(wait([&] { return names() == QStringList{name}; }));
  choose(name);
  press("documents_delete");
  press("documents_yes");

  ASSERT_TRUE(wait([&] { return !part().is_open() && names().isEmpty(); }));
  EXPECT_FALSE(has_file(name));
  EXPECT_TRUE(window->tools().documents.shows_start_page());
  EXPECT_EQ(window->context().settings.value("recent").toStringList(), QStringList{});
  EXPECT_FALSE(window->context().settings.contains("unfinished"));
  EXPECT_EQ(window->findChild<QListWidget*>("recent")->count(), 0);
  EXPECT_FALSE(QFile::exists(picture_file(state.path(), name)));
}

TEST_F(ServerLibrary, WhatAnotherHasOpenStaysAndTheWindowSaysWhy) {
  open_plate(false);
  const auto name = part().name();
  const auto other = client::client::connect(window->context().link.options(), {});
  ASSERT_TRUE(other.has_value());
  ASSERT_TRUE((*other)->open(name.toStdString(), false, false).has_value());
  ASSERT_TRUE(window->context().all_commands.trigger("file.documents"));
  ASSERT_TRUE(wait([&] { return names() == QStringList{name}; }));
  choose(name);
  press("documents_delete");
  press("documents_yes");

  const auto* words = window->findChild<QLabel*>("documents_words");
  ASSERT_TRUE(wait([&] { return words->text().contains("is open in other clients (1: "); }));
  EXPECT_TRUE(words->text().contains("closed there"));
  EXPECT_TRUE(has_file(name));
  EXPECT_TRUE(part().head());
}

TEST_F(ServerLibrary, WhoElseHasThePartOpenAndWhoMadeAVersionIsSaid) {
  open_plate(false);
  const auto* others = window->findChild<QLabel*>("others");
  EXPECT_TRUE(others->isHidden());
  auto line = window->context().link.options();
  line.client_name = "anna";
  auto other = client::client::connect(line, {});
  ASSERT_TRUE(other.has_value());
  ASSERT_TRUE((*other)->open(part().name().toStdString(), false, false).has_value());
  ASSERT_TRUE(wait([&] { return others->text() == "also here: anna"; }));
  EXPECT_FALSE(others->isHidden());
  EXPECT_TRUE(others->toolTip().startsWith("anna is here since today, "));

  ASSERT_TRUE((*other)->edit("fill_hole", {1, 2}, {}, {}).has_value());
  ASSERT_TRUE(wait([&] { return part().head()->info.number == 1 && shows_head(); }));
  EXPECT_EQ(part().head()->info.made_by, "anna");
  const auto* strip = window->findChild<history_strip*>();
  ASSERT_TRUE(wait([&] {
    return strip->count() == 2 && strip->item(1)->toolTip().contains("made by anna, today");
  }));
  other->reset();
  ASSERT_TRUE(wait([&] { return others->isHidden(); }));
}

TEST_F(ServerLibrary, APartThatIsClosedIsNotInUseAndAnotherMayDeleteIt) {
  open_plate(false);
  const auto name = part().name().toStdString();
  const auto other = client::client::connect(window->context().link.options(), {});
  ASSERT_TRUE(other.has_value());
  const auto in_use = [&] {
    const auto all = (*other)->list_documents();
    return !all || all->size() != 1 || all->front().name != name || all->front().clients > 0;
  };
  EXPECT_TRUE(in_use());
  ASSERT_TRUE(window->context().all_commands.trigger("file.close"));

  ASSERT_TRUE(wait([&] { return !in_use(); }));
  EXPECT_EQ(window->context().messages.text(), "");
  EXPECT_TRUE(wait([&] { return (*other)->delete_document(name).has_value(); }));
  EXPECT_FALSE(has_file(part().name()));
  EXPECT_EQ((*other)->status()->documents, 0U);
}

TEST_F(ServerLibrary, APartThatIsOpenedAgainAtOnceIsInUse) {
  open_plate(false);
  const auto name = part().name();
  for (std::uint32_t i = 1; i < 6; ++i) {
    ASSERT_TRUE(window->context().all_commands.trigger("file.close"));
    part().files().open(name);
    ASSERT_TRUE(wait([&] { return part().is_open() && shows_head(); }));
    part().edits().apply({"thicken", {7}, {}});
    ASSERT_TRUE(wait([&] { return version() == i && shows_head(); }));
    EXPECT_EQ(window->context().messages.text(), "");
  }
}

}  // namespace
}  // namespace tedit::desktop
