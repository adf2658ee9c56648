// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/documents/server_library.hpp"

#include <QMainWindow>

#include <memory>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/connection/connection_tool.hpp"
#include "client-qt/tools/documents/documents_dialog.hpp"

namespace tedit::desktop {

server_library::server_library(window_context& in, connection_tool& connection)
    : in_(in), connection_(connection) {
  in_.all_commands.add({"file.documents",
                        tr("Documents on the server"),
                        command_groups::file(),
                        "Ctrl+Shift+O",
                        [this] { show(); },
                        {},
                        tr("Which there are, to be opened, copied, renamed or deleted")});
  connect(&in_.part, &document::renamed, this, &server_library::refresh);
}

void server_library::show() {
  if (!dialog_) {
    dialog_ = new documents_dialog(&in_.window);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_, &documents_dialog::list_wanted, this, &server_library::refresh);
    connect(dialog_, &documents_dialog::copy_wanted, this, &server_library::copy);
    connect(dialog_, &documents_dialog::rename_wanted, this, &server_library::rename);
    connect(dialog_, &documents_dialog::delete_wanted, this, &server_library::remove);
    connect(dialog_, &documents_dialog::open_wanted, this, [this](const QString& name) {
      dialog_->close();
      emit document_wanted(name);
    });
  }
  dialog_->show();
  dialog_->raise();
  connection_.when_connected([this] { refresh(); });
}

void server_library::refresh() {
  if (!dialog_)
    return;
  in_.link.run<std::vector<client::document_info>>(
    [](client::client& c, const execution&) { return c.list_documents(); },
    [this](expected<std::vector<client::document_info>> all) {
      if (!dialog_)
        return;
      if (all)
        dialog_->show_documents(std::move(*all), in_.part.name());
      else
        dialog_->refuse(all.error());
    });
}

/// Where the dialog was closed meanwhile, the window says it.
void server_library::finish(const expected<void>& done, const QString& words) {
  if (!dialog_ && done)
    in_.messages.show_news(words);
  else if (!dialog_)
    emit in_.part.failed(tr("Documents on the server"), done.error());
  else if (done)
    dialog_->settle(words);
  else
    dialog_->refuse(done.error());
  refresh();
}

/// Among what runs, as a large document takes a while: there it can be cancelled.
void server_library::copy(const QString& name, const QString& to) {
  auto& work = in_.part.work();
  const auto asked = std::make_shared<ticket>();
  const int job = work.begin(tr("Copy of %1").arg(name), [asked] { asked->cancel(); });
  *asked = in_.link.run<void>(
    [from = name.toStdString(), to = to.toStdString()](client::client& c, const execution& run) {
      return c.copy_document(from, to, run);
    },
    [this, &work, job, name, to](const expected<void>& done) {
      work.end(job);
      finish(done, tr("%1 is a copy of %2 now.").arg(to, name));
    });
}

/// Who has it open, this window too, is told by the server.
void server_library::rename(const QString& name, const QString& to) {
  in_.link.run<void>(
    [name = name.toStdString(), to = to.toStdString()](client::client& c, const execution&) {
      return c.rename_on_server(name, to);
    },
    [this, name, to](const expected<void>& done) {
      finish(done, tr("%1 is called %2 now.").arg(name, to));
    });
}

/// The part that is shown goes with its document.
void server_library::remove(const QString& name) {
  in_.link.run<void>([name = name.toStdString()](
                       client::client& c, const execution&) { return c.delete_document(name); },
                     [this, name](const expected<void>& done) {
                       if (done) {
                         if (in_.part.name() == name)
                           in_.part.files().close();
                         emit gone(name);
                       }
                       finish(done, tr("%1 is deleted.").arg(name));
                     });
}

}  // namespace tedit::desktop
