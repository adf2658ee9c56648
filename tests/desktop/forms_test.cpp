// SPDX-License-Identifier: AGPL-3.0-or-later
// How forms take the wheel, the keyboard, numbers and too little room.
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <QtTest/QtTest>

#include <fstream>

#include "client-qt/model/part_volume.hpp"
#include "client-qt/tools/documents/welcome_page.hpp"
#include "client-qt/tools/operations/operation_form.hpp"
#include "client-qt/widgets/tall_scroll.hpp"
#include "client-qt/widgets/wheel_guard.hpp"
#include "tests/support/scratch.hpp"

namespace tedit::desktop {
namespace {

/// A long form that scrolls, in a program whose wheel is guarded.
class GuardedForm : public testing::Test {
protected:
  GuardedForm() {
    auto* content = new QWidget;
    auto* column = new QFormLayout(content);
    choice_->addItems({"a", "b", "c"});
    column->addRow("Number", number_);
    column->addRow("Choice", choice_);
    for (int i = 0; i < 40; ++i)
      column->addRow("Row", new QLineEdit);
    area_ = std::make_unique<tall_scroll>(content);
    area_->resize(300, 200);
    qApp->installEventFilter(&guard_);
    number_->setValue(5);
    choice_->setCurrentIndex(1);
  }
  void SetUp() override {
    area_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(area_.get()));
    QApplication::setActiveWindow(area_.get());
    ASSERT_GT(area_->verticalScrollBar()->maximum(), 0);
  }
  ~GuardedForm() override { qApp->removeEventFilter(&guard_); }

  static void turn_wheel_over(QWidget& field) {
    const QPointF at(field.rect().center());
    QWheelEvent event(at, field.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&field, &event);
  }

  [[nodiscard]] int scrolled() const { return area_->verticalScrollBar()->value(); }

  wheel_guard guard_;
  QSpinBox* number_ = new QSpinBox;
  QComboBox* choice_ = new QComboBox;
  std::unique_ptr<tall_scroll> area_;
};

TEST_F(GuardedForm, TheWheelOverAFieldThatWasNotClickedScrollsTheForm) {
  number_->setFocus(Qt::TabFocusReason);  // As the first field of a form that opens.

  turn_wheel_over(*number_);
  EXPECT_EQ(number_->value(), 5);
  EXPECT_GT(scrolled(), 0);

  const int before = scrolled();
  turn_wheel_over(*choice_);
  EXPECT_EQ(choice_->currentIndex(), 1);
  EXPECT_GT(scrolled(), before);
}

TEST_F(GuardedForm, AFieldThatWasClickedTakesTheWheelUntilItLosesTheFocus) {
  QTest::mouseClick(number_->findChild<QLineEdit*>(), Qt::LeftButton);
  ASSERT_TRUE(number_->hasFocus());
  turn_wheel_over(*number_);
  EXPECT_EQ(number_->value(), 4);

  choice_->setFocus(Qt::TabFocusReason);
  number_->setFocus(Qt::TabFocusReason);
  turn_wheel_over(*number_);
  EXPECT_EQ(number_->value(), 4);
}

TEST(TallScroll, FieldsBelowLongWordsKeepTheirHeight) {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  auto* words = new QLabel(QString("These words need several lines. ").repeated(12));
  words->setWordWrap(true);
  column->addWidget(words);
  std::vector<QDoubleSpinBox*> fields;
  for (int i = 0; i < 4; ++i) {
    fields.push_back(new QDoubleSpinBox);
    column->addWidget(fields.back());
  }
  tall_scroll area(content);
  area.resize(220, 90);
  area.show();
  QApplication::processEvents();

  for (const auto* one : fields)
    EXPECT_GE(one->height(), one->minimumSizeHint().height());
  EXPECT_GE(words->height(), words->heightForWidth(words->width()));
}

ops::operation_description one_length() {
  ops::operation_description about;
  about.id = "thicken";
  about.parameters = {
    {"depth", "Depth", "", ops::parameter_type::real, "m", 0.0, 100.0, {}, 0.001}};
  return about;
}

TEST(OperationForm, ALengthMayHaveAnyUnit) {
  operation_form form(one_length());
  auto* field = form.findChild<QDoubleSpinBox*>("depth");
  for (const auto& [typed, metres] : {std::pair{"1/4 in", 0.00635},
                                      {"2 cm", 0.02},
                                      {"0,5 m", 0.5},
                                      {"1e-3", 1e-6},
                                      {"7", 0.007}}) {
    field->selectAll();
    QTest::keyClicks(field, typed);
    const bool has_unit = QString(typed).contains(' ');
    EXPECT_EQ(field->text(), has_unit ? QString(typed) : QString("%1 mm").arg(typed));
    field->interpretText();
    EXPECT_DOUBLE_EQ(std::get<double>(form.values().at("depth")), metres) << typed;
  }
  field->selectAll();
  QTest::keyClicks(field, "5 kN");  // Is no length: the value before it stays.
  field->interpretText();
  EXPECT_DOUBLE_EQ(std::get<double>(form.values().at("depth")), 0.005);
}

TEST(OperationForm, APointAndACommaAreBothDecimal) {
  const QLocale before;
  for (const auto language : {QLocale::German, QLocale::English}) {
    QLocale::setDefault(QLocale(language));
    operation_form form(one_length());
    auto* field = form.findChild<QDoubleSpinBox*>("depth");
    for (const auto* typed : {"3.5", "3,5"}) {
      field->clear();
      QTest::keyClicks(field, typed);
      field->interpretText();
      EXPECT_DOUBLE_EQ(std::get<double>(form.values().at("depth")), 0.0035)
        << typed << " in " << QLocale::languageToString(language).toStdString();
    }
    form.set_values({{"depth", 12.3456}});
    EXPECT_DOUBLE_EQ(std::get<double>(form.values().at("depth")), 12.3456);
    EXPECT_EQ(field->text(), language == QLocale::German ? "12345,6 mm" : "12345.6 mm");
  }
  QLocale::setDefault(before);
}

TEST(OperationForm, APointIsThreeLengthsHoweverTheyAreParted) {
  ops::operation_description about;
  about.id = "placed";
  about.parameters = {
    {"at", "Place", "", ops::parameter_type::point, "m", {}, {}, {}, std::string()}};
  operation_form form(about);
  auto* field = form.findChild<QLineEdit*>("at");
  ASSERT_NE(field, nullptr);
  EXPECT_FALSE(field->placeholderText().isEmpty());
  for (const auto* typed : {"10; -2,5; 30", "10 -2.5 30", "10, -2.5, 30", "10,-2.5,30",
                            "1 cm; -2.5 mm; 3 cm", " 10 ;-2.5;30 "}) {
    field->setText(typed);
    const auto at = ops::vector_of(form.values(), "at");
    ASSERT_TRUE(at.has_value()) << typed;
    EXPECT_NEAR(norm(*at - vec3{0.01, -0.0025, 0.03}), 0, 1e-12) << typed;
  }
  // What is none goes on as it is: the host says what is wrong.
  field->setText("10; 20");
  EXPECT_EQ(std::get<std::string>(form.values().at("at")), "10; 20");
  form.set_values({{"at", std::string("0.01, -0.0025, 0.03")}});
  EXPECT_EQ(field->text(), QLocale().decimalPoint() == "," ? "10; -2,5; 30" : "10; -2.5; 30");
  form.reset();
  EXPECT_TRUE(field->text().isEmpty());
}

TEST(OperationForm, AVectorIsTypedAndNoClickGivesIt) {
  ops::operation_description about;
  about.id = "moved";
  about.parameters = {
    {"by", "By", "", ops::parameter_type::vector, "m", {}, {}, {}, std::string("0, 0, 0")}};
  operation_form form(about);
  auto* field = form.findChild<QLineEdit*>("by");
  ASSERT_NE(field, nullptr);

  field->setText("10; 0; -5");

  EXPECT_LT(norm(*ops::vector_of(form.values(), "by") - vec3{0.01, 0, -0.005}), 1e-12);
  EXPECT_FALSE(form.has_place());
}

ops::operation_description with_several(ops::parameter_type type, const char* unit) {
  ops::operation_description about;
  about.id = "several";
  about.parameters = {{"x", "X", "", type, unit, {}, {}, {}, std::string()}};
  return about;
}

TEST(OperationForm, AnAxisIsAPointAndADirectionInFieldsOfTheirOwn) {
  for (const auto type : {ops::parameter_type::axis, ops::parameter_type::plane}) {
    operation_form form(with_several(type, "m"));
    const auto fields = form.findChild<QWidget*>("x")->findChildren<QLineEdit*>();
    ASSERT_EQ(fields.size(), 2);
    const auto value = [&] { return std::get<std::string>(form.values().at("x")); };
    EXPECT_EQ(value(), "");

    fields[0]->setText("10; 1 cm; 1/4 in");
    fields[1]->setText("0 0 2");

    EXPECT_EQ(value(), "0.01, 0.01, 0.00635; 0, 0, 2");
    form.set_values({{"x", std::string("0.001, 0, -0.5; 1, 0, 0.5")}});
    const bool comma = QLocale().decimalPoint() == ",";
    EXPECT_EQ(fields[0]->text(), "1; 0; -500");
    EXPECT_EQ(fields[1]->text(), comma ? "1; 0; 0,5" : "1; 0; 0.5");
    EXPECT_EQ(value(), "0.001, 0, -0.5; 1, 0, 0.5");
  }
}

TEST(OperationForm, WhatIsPickedGoesIntoTheFieldWhoseButtonIsDown) {
  auto about = with_several(ops::parameter_type::axis, "m");
  about.parameters.push_back(
    {"path", "Path", "", ops::parameter_type::polyline, "m", {}, {}, {}, std::string()});
  operation_form form(about);
  auto* axis = form.findChild<QWidget*>("x")->findChild<QToolButton*>();
  auto* path = form.findChild<QWidget*>("path")->findChild<QToolButton*>();
  EXPECT_FALSE(form.picks());

  axis->click();
  EXPECT_TRUE(form.picks());
  path->click();
  EXPECT_FALSE(axis->isChecked()) << "one at a time";
  form.take_pick("edge:3,7");

  EXPECT_FALSE(form.picks());
  EXPECT_EQ(std::get<std::string>(form.values().at("path")), "edge:3,7");
  EXPECT_EQ(std::get<std::string>(form.values().at("x")), "");
  axis->click();
  form.take_pick("surface:12");
  EXPECT_EQ(std::get<std::string>(form.values().at("x")), "surface:12");
  form.take_pick("surface:13");  // Meant for none.
  EXPECT_EQ(std::get<std::string>(form.values().at("x")), "surface:12");
}

TEST(OperationForm, APolylineIsALineForEachPoint) {
  operation_form form(with_several(ops::parameter_type::polyline, "m"));
  auto* field = form.findChild<QWidget*>("x")->findChild<QPlainTextEdit*>();
  ASSERT_NE(field, nullptr);

  field->setPlainText("0; 0; 0\n\n10 0 0\n1 cm, 20, 0\n");

  EXPECT_EQ(std::get<std::string>(form.values().at("x")), "0, 0, 0; 0.01, 0, 0; 0.01, 0.02, 0");
  form.set_values({{"x", std::string("0, 0, 0; 0.25, 1, 2")}});
  EXPECT_EQ(field->toPlainText(), "0; 0; 0\n250; 1000; 2000");
}

TEST(OperationForm, AListIsNumbersInTheUnitThatIsShown) {
  operation_form form(with_several(ops::parameter_type::list, "m"));
  auto* field = form.findChild<QLineEdit*>("x");
  ASSERT_NE(field, nullptr);
  for (const auto* typed : {"10; 1 cm; 2.5", "10, 10, 2.5", "10 10 2,5"}) {
    field->setText(typed);
    EXPECT_EQ(std::get<std::string>(form.values().at("x")), "0.01, 0.01, 0.0025") << typed;
  }
  field->setText("7");
  EXPECT_EQ(std::get<std::string>(form.values().at("x")), "0.007");
  operation_form angles(with_several(ops::parameter_type::list, "rad"));
  angles.findChild<QLineEdit*>("x")->setText("180; 90");
  const auto numbers = ops::numbers_of(angles.values(), "x");
  ASSERT_EQ(numbers.size(), 2u);
  EXPECT_NEAR(numbers[0], 3.14159265358979, 1e-12);
}

TEST(OperationForm, AFileIsItsContentUntilAnotherPathIsTyped) {
  const test::scratch_folder folder;
  const auto path = (folder.path() / "knob.stl").string();
  std::ofstream(path) << "foobar";
  ops::operation_description about;
  about.id = "combined";
  about.parameters = {
    {"file", "File", "", ops::parameter_type::file, "", {}, {}, {}, std::string()}};
  operation_form form(about);
  auto* field = form.findChild<QWidget*>("file")->findChild<QLineEdit*>();
  ASSERT_NE(field, nullptr);
  const auto value = [&] { return std::get<std::string>(form.values().at("file")); };

  EXPECT_EQ(value(), "");
  field->setText(QString::fromStdString(path));
  EXPECT_EQ(value(), "data:knob.stl;base64,Zm9vYmFy");
  // What a recipe or the last edit gave is shown by its name, and is what it was.
  form.set_values({{"file", std::string("data:logo.stl;base64,Zm9v")}});
  EXPECT_EQ(field->text(), "logo.stl");
  EXPECT_EQ(value(), "data:logo.stl;base64,Zm9v");
  // A path to nothing goes on as it is: the host says that it is no file.
  field->clear();
  QTest::keyClicks(field, "nowhere");
  EXPECT_EQ(value(), "nowhere");
}

TEST(OperationForm, TheDialogForAFileShowsThoseThatFitFirst) {
  ops::operation_description about;
  about.id = "pocket";
  about.parameters = {{"file",
                       "File",
                       "",
                       ops::parameter_type::file,
                       "",
                       {},
                       {},
                       {"svg", "dxf", "x);;All (*"},
                       std::string()}};
  operation_form form(about);
  form.findChild<QWidget*>("file")->findChild<QToolButton*>()->click();

  auto* dialog = form.findChild<QFileDialog*>();
  ASSERT_NE(dialog, nullptr);
  const auto filters = dialog->nameFilters();
  ASSERT_EQ(filters.size(), 2);
  EXPECT_EQ(filters[0], "SVG, DXF (*.svg *.SVG *.dxf *.DXF)");
  EXPECT_TRUE(filters[1].endsWith("(*)"));
  dialog->close();
}

TEST(OperationForm, TheFirstFieldHasTheFocusOfTheForm) {
  operation_form form(one_length());

  EXPECT_EQ(form.focusProxy(), form.findChild<QWidget*>("depth"));
}

TEST(PartVolume, IsThatOfACubeWhereverItStands) {
  client::surface_update update;
  update.version_id = "v";
  update.surfaces = {{1, "cube", 12, 24.0}};
  for (std::uint32_t i = 0; i < 8; ++i) {
    update.vertices.push_back(i);
    for (int axis = 0; axis < 3; ++axis)
      update.positions.push_back(1000 + ((i >> axis & 1U) != 0 ? 2.0 : 0.0));
  }
  for (const std::uint32_t v : {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5})
    update.facet_vertices.push_back(v);
  for (std::uint32_t f = 0; f < 12; ++f) {
    update.facets.push_back(f);
    update.facet_surfaces.push_back(1);
  }
  client::surface_model surface;
  ASSERT_TRUE(surface.apply(update));

  EXPECT_NEAR(enclosed_volume(surface), 8, 1e-9);
}

TEST(StartPage, ACardIsChosenByEnterAsByAClick) {
  welcome_page page;
  page.show();
  QApplication::setActiveWindow(&page);
  auto* card = page.findChild<QPushButton*>("example");
  ASSERT_NE(card, nullptr);
  int chosen = 0;
  QObject::connect(&page, &welcome_page::example_wanted, &page, [&] { ++chosen; });

  QTest::keyClick(card, Qt::Key_Return);
  QTest::keyClick(card, Qt::Key_Enter);
  QTest::keyClick(card, Qt::Key_A);

  EXPECT_EQ(chosen, 2);
}

TEST(StartPage, ExamplesAreToldInTheLanguageOfTheWindow) {
  const QLocale before;
  std::map<QLocale::Language, QStringList> titles;
  for (const auto language : {QLocale::English, QLocale::German}) {
    QLocale::setDefault(QLocale(language));
    for (const auto& one : shipped_examples())
      titles[language] << one.title + one.story;
  }
  QLocale::setDefault(before);

  ASSERT_EQ(titles[QLocale::German].size(), 3);
  for (int i = 0; i < 3; ++i)
    EXPECT_NE(titles[QLocale::German][i], titles[QLocale::English][i]);
  EXPECT_TRUE(titles[QLocale::German].join("").contains("Bohrung"));
}

}  // namespace
}  // namespace tedit::desktop
