// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/documents/document_keeping.hpp"

#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMainWindow>
#include <QPointer>
#include <QStackedWidget>
#include <QUrl>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/model/document_name.hpp"
#include "client-qt/tools/connection/connection_tool.hpp"
#include "client-qt/tools/documents/name_form.hpp"

namespace tedit::desktop {

document_keeping::document_keeping(window_context& in, connection_tool& connection)
    : in_(in), connection_(connection), naming_(new name_form(&in.window)) {
  connect(naming_, &name_form::wanted, this, &document_keeping::rename);
  connect(naming_, &name_form::left, this,
          [this] { in_.pages.currentWidget()->setFocus(Qt::OtherFocusReason); });
  connect(&in_.part, &document::begun, naming_, &name_form::leave);
  add_commands();
}

void document_keeping::add_commands() {
  const QString group = command_groups::file();
  const auto add = [&](const QString& id, const QString& title, const QString& keys,
                       std::function<void()> run, const QString& help, std::function<bool()> when) {
    in_.all_commands.add({id, title, group, keys, std::move(run), std::move(when), help});
  };
  add(
    "file.save", tr("Save"), "Ctrl+S", [this] { say_safe(); },
    tr("Nothing to do: each step is kept when it is made. Says where."), in_.has_part());
  add(
    "file.save_copy", tr("Save a copy"), "Ctrl+Shift+S", [this] { ask_copy(); },
    tr("All versions and loads in one file, to mail or to put aside"), in_.has_part());
  add(
    "file.rename", tr("Rename the document"), {}, [this] { ask_name(); },
    tr("For all who have it open; its versions, probes and pictures go with it"), in_.has_part());
  add(
    "file.show_folder", tr("Show where the document is"), {}, [this] { show_folder(); },
    tr("Opens its folder"), [this] { return in_.part.head() && connection_.is_local(); });
}

QString document_keeping::file() const {
  return QDir::toNativeSeparators(in_.server.folder() + "/documents/" + in_.part.name() + ".tedit");
}

void document_keeping::say_safe() {
  const QString place =
    connection_.is_local() ? file() : tr("%1 on %2").arg(in_.part.name(), in_.link.address().url);
  in_.messages.show_news(
    tr("Everything is safe already: each step is kept when it is made. This is version %1 of %2.")
      .arg(in_.part.head()->info.number)
      .arg(place));
}

void document_keeping::ask_copy() {
  auto* dialog = new QFileDialog(&in_.window, tr("Save a copy of the document"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilter(tr("TEdit documents (*.tedit)"));
  dialog->setDefaultSuffix("tedit");
  dialog->selectFile(title_of(in_.part.name()).words + ".tedit");
  connect(dialog, &QFileDialog::fileSelected, this, &document_keeping::copy_to);
  dialog->open();
}

void document_keeping::copy_to(const QString& path) {
  in_.part.files().export_to(path);
}

/// Below the title, with what a person calls the document.
void document_keeping::ask_name() {
  const auto* title = in_.window.findChild<QLabel*>("title");
  naming_->open(title_of(in_.part.name()).words,
                title->mapTo(&in_.window, QPoint(0, title->height())));
}

void document_keeping::rename(const QString& name) {
  in_.part.files().rename(name, [this, form = QPointer(naming_)](const expected<void>& ok) {
    if (!form)
      return;
    if (ok)
      form->leave();
    else if (form->isVisible())
      form->refuse(ok.error());
    else
      emit in_.part.failed(tr("Rename the document"), ok.error());
  });
}

void document_keeping::show_folder() {
  QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(file()).path()));
}

}  // namespace tedit::desktop
