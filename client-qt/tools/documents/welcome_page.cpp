// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/documents/welcome_page.hpp"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPixmap>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "client-qt/tools/documents/recent_documents.hpp"

namespace tedit::desktop {

namespace {

/// Beside the program as it is installed (share/tedit/examples) or built (the source's examples).
QString examples_folder() {
  const QDir program(QCoreApplication::applicationDirPath());
  for (const auto* place : {"../share/tedit/examples", "../../../examples"})
    if (program.exists(place))
      return program.absoluteFilePath(place);
  return {};
}

/// Enter does what a click does.
class card_button : public QPushButton {
protected:
  void keyPressEvent(QKeyEvent* event) override {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
      click();
    else
      QPushButton::keyPressEvent(event);
  }
};

/// In the window's language where the example has it.
QString words_of(const QJsonObject& about, const QString& what) {
  const auto translated = about[what + "_" + QLocale().name().section('_', 0, 0)].toString();
  return translated.isEmpty() ? about[what].toString() : translated;
}

constexpr QSize picture_size(132, 84);

QLabel* words(const QString& text, const char* role) {
  auto* label = new QLabel(text);
  label->setProperty("role", role);
  label->setWordWrap(true);
  return label;
}

/// What the part looks like, sharp also where the screen has several pixels for one.
QLabel* picture(const QImage& image) {
  auto* label = new QLabel;
  label->setObjectName("example_picture");
  const qreal pixels = qApp->devicePixelRatio();
  QPixmap fitted = QPixmap::fromImage(image).scaled(picture_size * pixels, Qt::KeepAspectRatio,
                                                    Qt::SmoothTransformation);
  fitted.setDevicePixelRatio(pixels);
  label->setPixmap(fitted);
  label->setFixedSize(picture_size);
  return label;
}

QPushButton* card(const example& of) {
  auto* button = new card_button;
  auto* row = new QHBoxLayout(button);
  row->setContentsMargins(6, 6, 10, 6);
  if (const QImage image(of.picture); !image.isNull())
    row->addWidget(picture(image));
  auto* column = new QVBoxLayout;
  column->addStretch();
  column->addWidget(words(of.title, "section"));
  column->addWidget(words(of.story, "faint"));
  column->addStretch();
  row->addLayout(column, 1);
  for (auto* label : button->findChildren<QLabel*>())
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
  button->setAccessibleName(of.title);
  button->setMinimumHeight(picture_size.height() + 12);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Minimum);
  return button;
}

}  // namespace

std::vector<example> shipped_examples() {
  std::vector<example> result;
  const QDir folder(examples_folder());
  if (examples_folder().isEmpty())
    return result;
  for (const auto& name : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
    const QDir part(folder.absoluteFilePath(name));
    QFile about(part.absoluteFilePath("example.json"));
    if (!about.open(QIODevice::ReadOnly))
      continue;
    const auto json = QJsonDocument::fromJson(about.readAll()).object();
    example one{words_of(json, "title"),
                words_of(json, "story"),
                part.absoluteFilePath(json["mesh"].toString()),
                {},
                part.absoluteFilePath(json["picture"].toString())};
    for (const auto& file : json["load_cases"].toArray())
      one.load_cases << part.absoluteFilePath(file.toString());
    result.push_back(one);
  }
  return result;
}

welcome_page::welcome_page(QWidget* parent) : QWidget(parent) {
  // Examples and recent documents may need more room than a small screen has.
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  all->addWidget(area);
  auto* content = new QWidget;
  area->setWidget(content);
  auto* outer = new QHBoxLayout(content);
  outer->addStretch(1);
  auto* column = new QVBoxLayout;
  outer->addLayout(column, 3);
  outer->addStretch(1);
  column->addStretch(1);
  auto* title = new QLabel(tr("Change a part, see its stress at once"));
  title->setStyleSheet("font-size: 24px; font-weight: 600;");
  column->addWidget(title);
  auto* hint =
    new QLabel(tr("Open a CAD file (STEP, IGES, BREP) or a tetrahedral mesh with surface ids (Gmsh "
                  ".msh) by dropping it here, or start with a shipped part:"));
  hint->setProperty("role", "faint");
  hint->setWordWrap(true);
  column->addWidget(hint);
  column->addSpacing(8);
  for (const auto& one : shipped_examples()) {
    auto* button = card(one);
    button->setObjectName("example");
    connect(button, &QPushButton::clicked, this, [this, one] { emit example_wanted(one); });
    column->addWidget(button);
  }
  column->addSpacing(8);
  auto* row = new QHBoxLayout;
  auto* open = new QPushButton(tr("Open ..."));
  open->setProperty("role", "primary");
  connect(open, &QPushButton::clicked, this, &welcome_page::file_wanted);
  auto* tour = new QPushButton(tr("Take the tour"));
  tour->setToolTip(tr("Two minutes on a shipped part: close a bore and see its stress"));
  connect(tour, &QPushButton::clicked, this, &welcome_page::tour_wanted);
  auto* connect_to = new QPushButton(tr("Work on another computer ..."));
  connect(connect_to, &QPushButton::clicked, this, &welcome_page::server_wanted);
  row->addWidget(open);
  row->addWidget(tour);
  row->addWidget(connect_to);
  row->addStretch();
  column->addLayout(row);
  column->addWidget(make_activity());
  column->addSpacing(12);
  recent_ = new recent_documents;
  connect(recent_, &recent_documents::document_wanted, this, &welcome_page::document_wanted);
  connect(recent_, &recent_documents::changed, this, &welcome_page::recent_changed);
  column->addWidget(recent_);
  column->addStretch(2);
  recent_->hide();
}

QWidget* welcome_page::make_activity() {
  running_ = new QWidget;
  auto* row = new QHBoxLayout(running_);
  row->setContentsMargins(0, 12, 0, 0);
  stage_ = new QLabel;
  stage_->setObjectName("welcome_stage");
  fraction_ = new QProgressBar;
  fraction_->setRange(0, 1000);
  fraction_->setTextVisible(false);
  cancel_ = new QPushButton(tr("Cancel"));
  cancel_->setObjectName("welcome_cancel");
  connect(cancel_, &QPushButton::clicked, this, &welcome_page::cancel_wanted);
  row->addWidget(stage_);
  row->addWidget(fraction_, 1);
  row->addWidget(cancel_);
  running_->hide();
  return running_;
}

void welcome_page::show_activity(const std::optional<activity>& now) {
  running_->setVisible(now.has_value());
  if (!now)
    return;
  stage_->setText(now->stage.isEmpty() ? now->title : now->title + ": " + now->stage);
  fraction_->setValue(qRound(1000 * now->fraction));
  cancel_->setEnabled(now->can_cancel);
}

void welcome_page::set_recent(std::vector<recent_document> documents) {
  recent_->show_documents(std::move(documents));
}

void welcome_page::set_theme(const theme& look) {
  setPalette(look.palette);
}

}  // namespace tedit::desktop
