// SPDX-License-Identifier: AGPL-3.0-or-later
// The report about a part as HTML, of facts that are made by hand.
#include "client-qt/model/report_document.hpp"

#include <gtest/gtest.h>

#include <QLocale>
#include <QRegularExpression>
#include <QXmlStreamReader>

namespace tedit::desktop {
namespace {

class Report : public testing::Test {
protected:
  Report() {
    QLocale::setDefault(QLocale::c());
    facts_.title = "bracket <2>";
    facts_.document = "bracket-20260101-120000";
    facts_.version = 3;
    facts_.version_id = "00ff";
    facts_.tets = 1200;
    facts_.when = QDateTime(QDate(2026, 1, 2), QTime(3, 4, 5));
    facts_.program = "TEdit 0.1.0";
    facts_.surface_name = [](surface_id id) { return QString("Wall %1").arg(id); };
    facts_.place_words = [](const vec3&) { return QString("at the foot"); };
    add_loads();
    add_figures();
    facts_.history = {{0, "Import", {}, {}, 0.5, 20e6, {}},
                      {3, "Fill hole: thicker", "as asked", 2e-6, 0.516, 13.4e6, {"Load moved."}}};
    facts_.pictures = {{"Field", "not a picture", 900, 600}};
  }
  ~Report() override { QLocale::setDefault(QLocale::c()); }

  void add_loads() {
    fem::load_case loads;
    loads.name = "up & down";
    loads.materials = {{"Steel", 210e9, 0.3, 7850, 0, {}}};
    loads.constraints = {{{1, 2}, fem::fixed{}}};
    loads.loads = {{{4}, fem::force{{0, 0, -500}}, "It acts on a much larger area."},
                   {{}, fem::gravity{{0, 0, -9.81}}}};
    facts_.load_cases = {loads};
  }

  void add_figures() {
    solve_report report;
    report.load_case = "up & down";
    report.element_order = 2;
    report.preview = false;
    report.device = "cpu";
    report.max_von_mises_pa = 13.4e6;
    report.relative_error_estimate = 0.07;
    report.true_relative_residual = 4e-7;
    report.dofs = 4321;
    report.singular_places = {{fem::singularity::reentrant_edge, {}, 13e6}};
    report.singular_places_count = 12;
    report.warnings = {"Held on 9 mm2 instead of 3."};
    facts_.outcome = solve_outcome{{report}, {}};
    version_record version;
    version.info.number = 3;
    version.outcome = facts_.outcome;
    facts_.figures =
      summarise({&version, nullptr, field_state::converged, {}, facts_.surface_name});
  }

  [[nodiscard]] QString html() const {
    return report_html(facts_, [](std::size_t i) { return QString("p%1.png").arg(i); });
  }
  /// The text that a reader sees, blanks as single ones.
  [[nodiscard]] QString text() const {
    auto seen = html();
    seen.remove(
      QRegularExpression("<style>.*</style>", QRegularExpression::DotMatchesEverythingOption));
    return seen.replace(QRegularExpression("<[^>]*>"), " ").replace("&nbsp;", " ").simplified();
  }

  report_facts facts_;
};

TEST_F(Report, SaysWhatItIsAboutAndEscapesIt) {
  EXPECT_TRUE(text().contains("bracket &lt;2&gt;"));
  EXPECT_TRUE(text().contains("bracket-20260101-120000"));
  EXPECT_TRUE(text().contains("3 (1,200 tets; 00ff)") || text().contains("3 (1200 tets; 00ff)"))
    << text().toStdString();
  EXPECT_TRUE(text().contains("TEdit 0.1.0"));
  EXPECT_TRUE(text().contains("2026"));
  EXPECT_FALSE(html().contains("<2>"));
}

TEST_F(Report, IsWellFormed) {
  auto xml = html();
  xml.remove("<!DOCTYPE html>").remove("<meta charset=\"utf-8\">").replace("<br>", "<br/>");
  xml.replace("&nbsp;", " ").replace(QRegularExpression("(<img [^>]*)>"), "\\1/>");
  QXmlStreamReader reader(xml);
  while (!reader.atEnd())
    reader.readNext();
  EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString() << " in line "
                                  << reader.lineNumber();
}

TEST_F(Report, SaysMaterialsSupportsAndLoadsInWords) {
  EXPECT_TRUE(text().contains("Steel 210 GPa 0.3 7850 kg/m³ not given"));
  EXPECT_TRUE(text().contains("Support Fixed Wall 1, Wall 2"));
  EXPECT_TRUE(text().contains("Force 500 N along −z. It acts on a much larger area. Wall 4"));
  EXPECT_TRUE(text().contains("the whole part"));
}

TEST_F(Report, HasTheHistoryWithWhatEachStepDid) {
  EXPECT_TRUE(text().contains("0 Import - 500 g 20 MPa"));
  EXPECT_TRUE(text().contains("3 Fill hole: thicker (as asked) +2000 mm³ 516 g (+3.2 %) 13.4 MPa"));
}

TEST_F(Report, SaysWhatToTrust) {
  EXPECT_TRUE(text().contains("Quadratic tets, converged"));
  EXPECT_TRUE(text().contains("energy norm: 7 %; fair"));
  EXPECT_TRUE(text().contains("4e-7"));
  EXPECT_TRUE(text().contains("sharp inner edges): 12."));
  EXPECT_TRUE(text().contains("13 MPa, sharp inner edge: at the foot"));
  EXPECT_TRUE(text().contains("Held on 9 mm² instead of 3."));
  EXPECT_TRUE(text().contains("Version 3: Load moved."));
  facts_.outcome->cases.front().element_order = 1;
  EXPECT_TRUE(text().contains("Linear tets"));
  facts_.outcome->cases.front().element_order = 2;
  facts_.outcome->cases.front().interim = true;
  EXPECT_TRUE(text().contains("but a preview"));
}

TEST_F(Report, HasItsPicturesInsideOrBesideIt) {
  EXPECT_TRUE(html().contains("<img src=\"p0.png\" width=\"555\" height=\"370\""));
  const QString alone = self_contained_html(facts_);
  EXPECT_TRUE(alone.contains("data:image/png;base64," +
                             QString::fromLatin1(QByteArray("not a picture").toBase64())));
  facts_.pictures.front().width = 0;
  EXPECT_FALSE(html().contains("<img"));
}

TEST_F(Report, OfAPartThatIsNotSolvedSaysSoAndWhatToDo) {
  facts_.outcome.reset();
  version_record version;
  facts_.figures = summarise({&version, nullptr, field_state::none, {}, facts_.surface_name});

  EXPECT_TRUE(text().contains("There are no loads yet. Add supports and loads"));
  EXPECT_FALSE(text().contains("13.4 MPa 3"));
}

TEST_F(Report, HasTheDecimalPointOfTheLocale) {
  QLocale::setDefault(QLocale("de_DE"));
  add_figures();

  EXPECT_TRUE(text().contains("13,4 MPa"));
  EXPECT_TRUE(text().contains("+3,2 %"));
  EXPECT_FALSE(text().contains("13.4 MPa"));
}

TEST(ReportFacts, OfADocumentWithoutAPartAreEmpty) {
  remote link;
  const document part(link);

  const auto facts = facts_of(part, QDateTime::currentDateTime());

  EXPECT_TRUE(facts.history.empty());
  EXPECT_FALSE(facts.outcome);
  EXPECT_TRUE(points_of(facts).empty());
}

TEST(ReportFacts, FollowTheVersionsThatLedHereAndNoBranch) {
  remote link;
  document part(link);
  part.begin("part");
  for (const auto& [number, parent] :
       std::vector<std::pair<std::uint32_t, std::optional<std::uint32_t>>>{
         {0, {}}, {1, 0}, {2, 1}, {3, 1}}) {
    client::committed made;
    made.head.number = number;
    made.head.version_id = "v" + std::to_string(number);
    made.head.parent = parent;
    made.head.operation = number == 0 ? "import" : "erode";
    made.report.emplace();
    made.report->volume_change = -1e-6 * number;
    made.report->notices = {"lost 2 mm2"};
    emit link.committed(made);
  }

  const auto facts = facts_of(part, QDateTime::currentDateTime());

  ASSERT_EQ(facts.history.size(), 3U);
  EXPECT_EQ(facts.history[0].made, QString("Import"));
  EXPECT_EQ(facts.history[1].number, 1U);
  EXPECT_EQ(facts.history[2].number, 3U);
  EXPECT_EQ(facts.history[2].volume_change_m3, std::optional(-3e-6));
  EXPECT_EQ(facts.history[2].notices, QStringList{QString::fromUtf8("lost 2 mm²")});
  EXPECT_EQ(facts.title, QString("part"));
}

}  // namespace
}  // namespace tedit::desktop
