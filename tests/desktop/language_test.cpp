// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/language.hpp"
#include "client-qt/model/cad_words.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>

#include "client-qt/model/legend.hpp"
#include "client-qt/model/operation_words.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/model/server_words.hpp"
#include "client-qt/tools/operations/preview_box.hpp"
#include "client-qt/widgets/banner.hpp"
#include "client/client.hpp"

namespace tedit::desktop {
namespace {

class Language : public testing::Test {
protected:
  ~Language() override {
    qDeleteAll(qApp->findChildren<QTranslator*>());
    QLocale::setDefault(before_);
  }

  const QLocale before_;
};

TEST_F(Language, EnglishIsAlwaysThereAndTakenForWhatIsNot) {
  EXPECT_EQ(languages().front(), QString("en"));
  EXPECT_EQ(speak(*qApp, "tlh"), QString("en"));
  EXPECT_EQ(field_title(shown_field::safety_factor), QString("Safety factor"));
}

TEST_F(Language, GermanIsSpokenAlsoOfOperationsThatTheServerDescribes) {
  if (!languages().contains("de"))
    GTEST_SKIP() << "built without qt6-l10n-tools";

  EXPECT_EQ(speak(*qApp, "de"), QString("de"));

  EXPECT_EQ(field_title(shown_field::safety_factor), QString("Sicherheitsfaktor"));
  EXPECT_EQ(in_users_language("Fill hole"), "Loch schließen");
  EXPECT_EQ(in_users_language("What a plugin says"), "What a plugin says");
  EXPECT_EQ(field_value(shown_field::von_mises, 3.347e6), QString("3,347 MPa"));
}

TEST_F(Language, FiguresOfAnEditAreInTheWindowsLanguageToo) {
  if (!languages().contains("de"))
    GTEST_SKIP() << "built without qt6-l10n-tools";
  speak(*qApp, "de");
  client::edit_preview made;
  made.report.figures = {{"thickness_change_mm", 0.5, "mm", "thickness taken off"},
                         {"pieces", 3, "", "pieces, of 2 bodies"},
                         {"wobble", 7, "", "wobbles of 2.5 mm"}};

  const QString shown = preview_details(made);

  EXPECT_TRUE(shown.contains("Abgetragene Dicke")) << shown.toStdString();
  EXPECT_TRUE(shown.contains("Stücke, aus 2 Körpern")) << shown.toStdString();
  EXPECT_TRUE(shown.contains("Wobbles of 2,5 mm")) << "a plugin's own: " << shown.toStdString();
}

/// What the window makes of a sentence of the server.
std::string shown_words(const std::string& english) {
  return words_of(english).toStdString();
}

TEST_F(Language, RefusalsOfTheServerAreInTheWindowsLanguage) {
  if (!languages().contains("de"))
    GTEST_SKIP() << "built without qt6-l10n-tools";
  speak(*qApp, "de");

  EXPECT_EQ(shown_words("there is nothing to undo"), "es gibt nichts rückgängig zu machen");
  EXPECT_EQ(shown_words("the wall below surface 7 is only 1.25 mm thick at its thinnest"),
            "die Wand unter Fläche 7 ist an der dünnsten Stelle nur 1,25 mm dick");
  EXPECT_EQ(shown_words("load case 'Bending': the loads and prescribed displacements add up to no "
                        "finite number"),
            "Lastfall „Bending“: die Lasten und vorgegebenen Verschiebungen ergeben keine endliche "
            "Zahl");
  EXPECT_EQ(
    shown_words("the part is not held: free are translation along x; rotation about the "
                "axis z through (1, 2, 3) mm"),
    "das Bauteil ist nicht gehalten: frei sind Verschiebung entlang x; Drehung um die Achse "
    "z durch (1, 2, 3) mm");
  EXPECT_EQ(shown_words("no tets fit between the walls there (the mesher left gaps)"),
            "zwischen die Wände dort passen keine Tetraeder (der Vernetzer hat Lücken gelassen)");
  EXPECT_EQ(shown_words("no tets fit between the walls there (tedit-mesher crashed (signal 11))"),
            "zwischen die Wände dort passen keine Tetraeder (tedit-mesher crashed (signal 11))");
  EXPECT_EQ(shown_words("material \"Steel\": Young's modulus is -5 Pa"),
            "Werkstoff „Steel“: E-Modul ist -5 Pa");
}

TEST_F(Language, NoticesAndRemediesOfTheServerAreInTheWindowsLanguage) {
  if (!languages().contains("de"))
    GTEST_SKIP() << "built without qt6-l10n-tools";
  speak(*qApp, "de");

  EXPECT_EQ(shown_words("the selection was completed by surface 3, 4 (bottom or inner part of the "
                        "hole)"),
            "die Auswahl wurde ergänzt um Fläche 3, 4 (Boden oder Inneres des Lochs)");
  EXPECT_EQ(shown_words("2 loose crumbs of 3.5 mm3 together were dropped"),
            "weggelassen: 2 × loser Krümel, zusammen 3,5 mm³");
  EXPECT_EQ(shown_words("Take 0.25 mm: the most that works here"),
            "0,25 mm nehmen: das Größte, was hier geht");
  EXPECT_EQ(shown_words("Try again. Connect again."), "Noch einmal versuchen. Neu verbinden.");
  EXPECT_EQ(shown_words("edges shorter than 3.7e-05 mm were closed up, 1 in all, the first at 0, "
                        "1e-05, 0 mm"),
            "Kanten, die kürzer als 3,7e-05 mm sind, wurden geschlossen, zusammen 1, die erste bei "
            "0, 1e-05, 0 mm");
  EXPECT_EQ(
    shown_words("solid without a name is not valid by OpenCASCADE's checks: look at its mesh"),
    "Körper ohne Namen ist nach den Prüfungen von OpenCASCADE nicht gültig: das Netz ansehen");
}

TEST_F(Language, WhyAnEditIsInTheMeshOnlyIsInTheWindowsLanguage) {
  if (!languages().contains("de"))
    GTEST_SKIP() << "built without qt6-l10n-tools";
  speak(*qApp, "de");
  client::version_info version;
  version.cad = client::cad_state{
    client::cad_status::mesh_only,
    "layer, slab by edges around: a face of it, around -4.75, -4.4, -141.3 mm, is nowhere in the "
    "mesh; plug: it has 2 solids, the model before 1",
    0};

  EXPECT_EQ(cad_words(version).toStdString(),
            "Nur im Netz: Schicht, Scheibe nach Kanten ringsum: eine Fläche des Modells bei -4,75, "
            "-4,4, -141,3 mm gibt es im Netz nicht; Stopfen: es hat 2 Volumenkörper, das Modell "
            "davor 1");
}

TEST_F(Language, WhatTheClientSaysOfAConnectionIsInTheWindowsLanguage) {
  if (!languages().contains("de"))
    GTEST_SKIP() << "built without qt6-l10n-tools";
  speak(*qApp, "de");

  EXPECT_EQ(shown_words("no server can be reached at ws://127.0.0.1:9/v1: Connection refused"),
            "unter ws://127.0.0.1:9/v1 ist kein Server zu erreichen: Verbindung abgelehnt");
  EXPECT_EQ(shown_words("the address \"http://here\" does not begin with ws:// or wss://"),
            "die Adresse „http://here“ beginnt weder mit ws:// noch mit wss://");
  EXPECT_EQ(shown_words("the server closed the connection: wrong token"),
            "der Server hat die Verbindung geschlossen: wrong token");
  EXPECT_EQ(shown_words("there is no connection to a server"),
            "es gibt keine Verbindung zu einem Server");
  EXPECT_EQ(shown_words("Wait until it is back, or connect to another one"),
            "Warten, bis sie wieder da ist, oder mit einem anderen Server verbinden");
  EXPECT_EQ(shown_words("the token is wrong"), "das Token ist falsch");
  EXPECT_EQ(shown_words("the client speaks version 1.2 of the protocol, this server version 1.3"),
            "der Client spricht Version 1.2 des Netzwerkprotokolls, dieser Server Version 1.3");
}

/// As a client makes them, not as somebody wrote them down.
TEST_F(Language, AnAddressThatIsNoneIsRefusedInTheWindowsLanguage) {
  if (!languages().contains("de"))
    GTEST_SKIP() << "built without qt6-l10n-tools";
  speak(*qApp, "de");
  for (const auto* url : {"http://here", "wss://", "ws://[::1", "ws://", "ws://a b"}) {
    client::connect_options options;
    options.url = url;
    const auto made = client::client::connect(options, {});

    ASSERT_FALSE(made) << url;
    EXPECT_TRUE(shown_words(made.error().message).starts_with("die Adresse „")) << url;
    EXPECT_EQ(shown_words(made.error().remedy),
              "Geben Sie die Adresse eines Servers an, zum Beispiel ws://127.0.0.1:7464/v1.");
  }
}

TEST_F(Language, ARefusalIsExplainedInTheWindowsLanguageWithItsPlaceAndRemedy) {
  if (!languages().contains("de"))
    GTEST_SKIP() << "built without qt6-l10n-tools";
  speak(*qApp, "de");
  const error reason{ec::under_constrained,
                     "the part is not held: free are all six rigid-body motions",
                     "Fix or support more surfaces of it", "around (15, 2, 3) mm"};

  EXPECT_EQ(explained(reason).toStdString(),
            "Das Bauteil ist nicht gehalten: frei sind alle sechs Starrkörperbewegungen.\n"
            "Wo: um (15, 2, 3) mm\n"
            "Mehr seiner Flächen einspannen oder lagern.");
  EXPECT_EQ(one_line(reason).toStdString(),
            "das Bauteil ist nicht gehalten: frei sind alle sechs Starrkörperbewegungen "
            "[um (15, 2, 3) mm]. Mehr seiner Flächen einspannen oder lagern");
}

TEST_F(Language, WhatNobodyTranslatedIsShownAsItWasSent) {
  if (!languages().contains("de"))
    GTEST_SKIP() << "built without qt6-l10n-tools";
  speak(*qApp, "de");

  EXPECT_EQ(shown_words("the widget is broken"), "the widget is broken");
  EXPECT_EQ(shown_words("my plugin found 3 wobbles"), "my plugin found 3 wobbles");
  EXPECT_EQ(shown_words("there is no load case \"%2 and %1\""),
            "den Lastfall „%2 and %1“ gibt es nicht")
    << "a name that looks like a place";
}

/// All that the server can say: each with a number at every place.
TEST_F(Language, EverySentenceOfTheServerIsFoundAgain) {
  if (!languages().contains("de"))
    GTEST_SKIP() << "built without qt6-l10n-tools";
  speak(*qApp, "de");
  constexpr const char* all[] = {
#include "client-qt/model/server_words.inc"
  };
  static const QRegularExpression place("%[0-9]");

  for (const auto* english : all) {
    const auto said = QString::fromUtf8(english).replace(place, "7");
    const auto german = QCoreApplication::translate("server", english).replace(place, "7");
    EXPECT_EQ(in_window_language(said.toStdString()).toStdString(), german.toStdString())
      << english;
  }
}

TEST_F(Language, InEnglishTheServersWordsStayAsTheyAre) {
  speak(*qApp, "en");

  EXPECT_EQ(shown_words("the wall below surface 7 is only 1.25 mm thick at its thinnest"),
            "the wall below surface 7 is only 1.25 mm thick at its thinnest");
}

}  // namespace
}  // namespace tedit::desktop
