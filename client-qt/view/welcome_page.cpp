// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/welcome_page.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "client-qt/model/document_name.hpp"
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

QPushButton* card(const QString& title, const QString& text) {
  auto* button = new QPushButton;
  auto* column = new QVBoxLayout(button);
  auto* first = new QLabel(title);
  first->setProperty("role", "section");
  auto* second = new QLabel(text);
  second->setProperty("role", "faint");
  second->setWordWrap(true);
  for (auto* label : {first, second}) {
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    column->addWidget(label);
  }
  button->setAccessibleName(title);
  button->setMinimumHeight(84);
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
    example one{json["title"].toString(),
                json["story"].toString(),
                part.absoluteFilePath(json["mesh"].toString()),
                {}};
    for (const auto& file : json["load_cases"].toArray())
      one.load_cases << part.absoluteFilePath(file.toString());
    result.push_back(one);
  }
  return result;
}

welcome_page::welcome_page(QWidget* parent) : QWidget(parent) {
  auto* outer = new QHBoxLayout(this);
  outer->addStretch(1);
  auto* column = new QVBoxLayout;
  outer->addLayout(column, 3);
  outer->addStretch(1);
  column->addStretch(1);
  auto* title = new QLabel(tr("Change a part, see its stress at once"));
  title->setStyleSheet("font-size: 24px; font-weight: 600;");
  column->addWidget(title);
  auto* hint =
    new QLabel(tr("Open a tetrahedral mesh with surface ids (Gmsh .msh) by dropping it "
                  "here, or start with a shipped part:"));
  hint->setProperty("role", "faint");
  hint->setWordWrap(true);
  column->addWidget(hint);
  column->addSpacing(8);
  for (const auto& one : shipped_examples()) {
    auto* button = card(one.title, one.story);
    button->setObjectName("example");
    connect(button, &QPushButton::clicked, this, [this, one] { emit example_wanted(one); });
    column->addWidget(button);
  }
  column->addSpacing(8);
  auto* row = new QHBoxLayout;
  auto* open = new QPushButton(tr("Open a mesh ..."));
  open->setProperty("role", "primary");
  connect(open, &QPushButton::clicked, this, &welcome_page::file_wanted);
  auto* connect_to = new QPushButton(tr("Connect to a server ..."));
  connect(connect_to, &QPushButton::clicked, this, &welcome_page::server_wanted);
  row->addWidget(open);
  row->addWidget(connect_to);
  row->addStretch();
  column->addLayout(row);
  column->addSpacing(12);
  recent_box_ = new QWidget;
  recent_ = new QVBoxLayout(recent_box_);
  recent_->setContentsMargins(0, 0, 0, 0);
  column->addWidget(recent_box_);
  column->addStretch(2);
  recent_box_->hide();
}

void welcome_page::set_recent(const QStringList& documents) {
  while (auto* item = recent_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  recent_box_->setVisible(!documents.isEmpty());
  auto* title = new QLabel(tr("Go on with"));
  title->setProperty("role", "section");
  recent_->addWidget(title);
  for (const auto& name : documents.mid(0, 6)) {
    const auto shown = title_of(name);
    auto* button = new QPushButton(
      shown.made.isValid()
        ? tr("%1, %2").arg(shown.words, QLocale().toString(shown.made, QLocale::ShortFormat))
        : shown.words);
    button->setToolTip(name);
    button->setProperty("role", "link");
    connect(button, &QPushButton::clicked, this, [this, name] { emit document_wanted(name); });
    recent_->addWidget(button, 0, Qt::AlignLeft);
  }
}

void welcome_page::set_theme(const theme& look) {
  setPalette(look.palette);
}

}  // namespace tedit::desktop
