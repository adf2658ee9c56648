// SPDX-License-Identifier: AGPL-3.0-or-later
// The results and the report of a real part in the real window.
#include "tests/desktop/window_fixture.hpp"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTreeWidget>

#include "client-qt/tools/results_summary/results_summary_panel.hpp"

namespace tedit::desktop {
namespace {

class Results : public Window {
protected:
  [[nodiscard]] results_summary_tool& tool() { return window->tools().summary; }
  [[nodiscard]] const results_summary& shown_now() { return tool().panel().summary(); }
  [[nodiscard]] std::optional<result_row> row(figure kind) {
    for (const auto& section : shown_now().sections)
      for (const auto& one : section.rows)
        if (one.kind == kind)
          return one;
    return std::nullopt;
  }
  [[nodiscard]] QTreeWidget* tree() { return tool().panel().tree(); }
  /// Rows with the words of their places.
  [[nodiscard]] bool is_complete() {
    const auto stress = row(figure::stress);
    return shown_now().final && stress && !stress->where.isEmpty();
  }

  /// What the command line says of the same part.
  static QJsonObject solved_by_the_program() {
    QProcess program;
    program.start(QCoreApplication::applicationDirPath() + "/tedit",
                  {"solve", plate(), "--load-case", loads(), "--json"});
    EXPECT_TRUE(program.waitForFinished(patience_ms));
    EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
    return QJsonDocument::fromJson(program.readAllStandardOutput()).object();
  }

  /// A row says an SI value, to four digits; what the legend shows, too, in its unit.
  void expect_says(figure kind, double value, const QString& unit) {
    const auto said = row(kind);
    ASSERT_TRUE(said) << static_cast<int>(kind);
    const auto as = shown_as(unit);
    const auto wanted =
      unit == "m" ? shown_quantity{number(value * as.scale), as.name} : shown(value, unit);
    EXPECT_EQ(said->value.unit, wanted.unit);
    EXPECT_NEAR(said->value.number.toDouble(), wanted.number.toDouble(),
                5e-4 * std::abs(wanted.number.toDouble()))
      << said->title.toStdString();
  }

  [[nodiscard]] QByteArray report(const char* name) {
    const QString path = state.filePath(name);
    tool().write_report(path);
    EXPECT_TRUE(tool().writes_report());
    EXPECT_TRUE(wait([&] { return !tool().writes_report(); }));
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
};

TEST_F(Results, AreThoseOfTheSolverAndHaveTheirPlaces) {
  open_plate();
  ASSERT_TRUE(wait([&] { return is_complete(); }));

  const auto json = solved_by_the_program();
  expect_says(figure::stress, json["max_von_mises_pa"].toDouble(), "Pa");
  expect_says(figure::displacement, json["max_displacement_m"].toDouble(), "m");
  expect_says(figure::safety, json["min_safety_factor"].toDouble(), {});
  expect_says(figure::mass, json["mass_kg"].toDouble(), "kg");
  const auto force = json["reaction_n"].toArray();
  expect_says(figure::reaction_sum,
              norm({force[0].toDouble(), force[1].toDouble(), force[2].toDouble()}), "N");
  EXPECT_TRUE(row(figure::reaction_sum)->warning.isEmpty());
  EXPECT_EQ(!row(figure::stress)->warning.isEmpty(), json.contains("max_von_mises_singularity"));
}

TEST_F(Results, AKeyGoesToTheListAndEnterToThePlaceWhichIsSeenThen) {
  open_plate();
  ASSERT_TRUE(wait([&] { return is_complete(); }));
  QTest::keyClick(window.get(), Qt::Key_R);
  ASSERT_TRUE(wait([&] { return tree()->hasFocus(); }));
  for (const auto side : {camera::direction::bottom, camera::direction::top}) {
    view().framing().look_from(side);  // From one of them the place is hidden.
    tree()->setCurrentItem(tree()->topLevelItem(0)->child(0));
    QTest::keyClick(tree(), Qt::Key_Return);

    const auto stress = row(figure::stress);
    ASSERT_TRUE(stress && stress->at);
    const auto pose = view().view().get();
    EXPECT_LT(norm(pose.focus - *stress->at), 1e-3 * norm(pose.position - pose.focus));
    const auto seen = view().pick_at(view().to_widget(*stress->at));
    const double off = seen ? norm(seen->at - *stress->at) : 0;  // At a rim a ray may pass by.
    EXPECT_LT(off, 0.02 * norm(pose.position - *stress->at));
  }
}

TEST_F(Results, AnEditIsSetBesideTheVersionBeforeAndWithoutLoadsNothingStays) {
  open_plate();
  ASSERT_TRUE(wait([&] { return is_complete(); }));
  EXPECT_FALSE(row(figure::stress)->compares);
  const QString before = row(figure::mass)->value.text();

  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final() && is_complete(); }));
  const auto mass = row(figure::mass);
  ASSERT_TRUE(mass->before);
  EXPECT_EQ(mass->before->text(), before);
  EXPECT_TRUE(mass->change.startsWith('+'));

  const auto name = part().loads().all().front().name;
  part().loads().remove(name);
  ASSERT_TRUE(wait([&] { return part().loads().all().empty() && shown_now().sections.empty(); }));
  EXPECT_TRUE(shown_now().missing.contains("no loads"));
}

TEST_F(Results, TheReportHasEveryFigureAndItsPicturesInBothForms) {
  open_plate();
  ASSERT_TRUE(wait([&] { return is_complete(); }));
  const auto pose = view().view().get();
  const auto shown_before = view().current().field;

  const QByteArray html = report("report.html");
  const QByteArray pdf = report("report.pdf");

  const QString text = QString::fromUtf8(html).replace("&nbsp;", " ");
  for (const auto& section : shown_now().sections)
    for (const auto& one : section.rows) {
      EXPECT_TRUE(text.contains(one.title.toHtmlEscaped())) << one.title.toStdString();
      EXPECT_TRUE(text.contains(one.value.text().toHtmlEscaped()))
        << one.value.text().toStdString();
      EXPECT_TRUE(text.contains(one.where.toHtmlEscaped())) << one.where.toStdString();
    }
  const QRegularExpression picture("data:image/png;base64,([A-Za-z0-9+/=]+)");
  int pictures = 0;
  for (auto found = picture.globalMatch(text); found.hasNext(); ++pictures) {
    const auto png = QByteArray::fromBase64(found.next().captured(1).toLatin1());
    const auto image = QImage::fromData(png, "PNG");
    ASSERT_FALSE(image.isNull());
    EXPECT_NE(image.pixel(image.width() / 2, image.height() / 2), image.pixel(image.width() - 1, 0))
      << "nothing is drawn in the middle";
  }
  EXPECT_EQ(pictures, 2);  // The field, and the loads.
  EXPECT_TRUE(pdf.startsWith("%PDF-"));
  EXPECT_EQ(pdf.count("/Subtype /Image"), 2);
  EXPECT_EQ(view().view().get(), pose);  // Nothing of it was seen in the window.
  EXPECT_EQ(view().current().field, shown_before);
}

TEST_F(Results, ThePdfCanBeReadAsText) {
  const QString reader = QStandardPaths::findExecutable("pdftotext");
  ASSERT_FALSE(reader.isEmpty()) << "pdftotext is not here: scripts/install_deps.sh";
  open_plate();
  ASSERT_TRUE(wait([&] { return is_complete(); }));
  ASSERT_FALSE(report("report.pdf").isEmpty());

  QProcess program;
  program.start(reader, {"-layout", state.filePath("report.pdf"), "-"});
  ASSERT_TRUE(program.waitForFinished());
  const QString text = QString::fromUtf8(program.readAllStandardOutput());
  EXPECT_TRUE(text.contains(row(figure::stress)->value.number));
  EXPECT_TRUE(text.contains("Page 1 of"));
}

}  // namespace
}  // namespace tedit::desktop
