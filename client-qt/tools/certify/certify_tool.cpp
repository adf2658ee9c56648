// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/certify/certify_tool.hpp"

#include <QDate>
#include <QDir>
#include <QFileDialog>
#include <QMainWindow>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/certify/certificate_dialog.hpp"
#include "mesh/formats.hpp"

namespace tedit::desktop {

/// "block, version 3", a number behind it where that is taken.
static QString new_folder(const QString& parent, const QString& name) {
  QString folder = QDir(parent).filePath(name);
  for (int number = 2; QFile::exists(folder); ++number)
    folder = QDir(parent).filePath(name + QString(" (%1)").arg(number));
  return folder;
}

certify_tool::certify_tool(window_context& in) : in_(in) {
  in_.all_commands.add(
    {"file.certify",
     tr("Check with CalculiX"),
     command_groups::file(),
     {},
     [this] { ask_folder(); },
     [&part = in_.part] { return part.head() && !part.head()->load_cases.empty(); },
     tr("CalculiX solves this version's load cases, too; decks, results and how "
        "far both agree go into a folder"),
     "tick",
     tr("It needs a part with a load case")});
}

void certify_tool::ask_folder() {
  auto* dialog = new QFileDialog(&in_.window, tr("Where shall decks and results be kept?"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  connect(dialog, &QFileDialog::fileSelected, this, &certify_tool::certify_into);
  dialog->open();
}

void certify_tool::certify_into(const QString& parent) {
  const auto* head = in_.part.head();
  if (!head)
    return;
  const QString title = tr("Check with CalculiX");
  const auto folder =
    new_folder(parent, tr("%1, version %2").arg(in_.part.name()).arg(head->info.number));
  in_.part.foreground().ask<certificate>(
    title,
    [folder](client::client& c, const execution& run) -> expected<certificate> {
      const auto bytes = c.export_file(std::string(document_format), {}, "", run.part(0, 0.1));
      return bytes ? certify(*bytes, folder, run) : expected<certificate>(fail(bytes.error()));
    },
    [this, title, mine = in_.part.opening()](const expected<certificate>& made) {
      if (mine != in_.part.opening())
        return;
      if (made)
        take(*made);
      else
        emit in_.part.failed(title, made.error());
    });
}

void certify_tool::take(const certificate& made) {
  note(made);
  (new certificate_dialog(made, &in_.window))->show();
}

/// The version's note gets a line, instead of what was noted of CalculiX before.
void certify_tool::note(const certificate& made) {
  const auto* head = in_.part.head();
  if (!head || head->info.number != made.version)
    return;
  QStringList lines;
  for (const auto& line : QString::fromStdString(head->info.note).split('\n', Qt::SkipEmptyParts))
    if (!line.contains("CalculiX"))
      lines << line;
  lines << tr("%1: %2").arg(QDate::currentDate().toString(Qt::ISODate), verdict_of(made));
  in_.part.edits().annotate(made.version, QString::fromStdString(head->info.name),
                            lines.join('\n'));
}

}  // namespace tedit::desktop
