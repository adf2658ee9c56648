// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/file_requests.hpp"

#include <QFileInfo>
#include <QSaveFile>

#include "client-qt/model/document.hpp"
#include "client-qt/model/document_name.hpp"
#include "protocol/convert.hpp"

namespace tedit::desktop {

file_requests::file_requests(document& part, remote& link) : part_(part), link_(link) {
  connect(&link_, &remote::connected, this, &file_requests::reopen);
}

void file_requests::close() {
  part_.begin({});
  part_.solver().forget_watch();
  emit part_.closed();
}

void file_requests::open(const QString& name) {
  part_.begin(name);
  reopen();
}

/// Also when a lost connection is back: the server sends the whole surface again.
void file_requests::reopen() {
  part_.load_catalogue();
  if (!part_.is_open())
    return;
  const QString title = tr("Open %1").arg(part_.name());
  part_.foreground().ask<client::document_state>(
    title,
    [name = part_.name().toStdString()](client::client& c, const execution&) {
      return c.open(name, true, true);
    },
    [this, title, mine = part_.opening()](const expected<client::document_state>& got) {
      if (mine != part_.opening())
        return;
      if (!got)
        return emit part_.failed(title, got.error());
      part_.take(*got);
      part_.solver().send_watch();
      emit part_.opened();
      part_.take_surface();  // It may have come before this answer.
      part_.refresh_history(true);
      part_.edits().ask_again();
      if (got->head && !got->head->load_cases.empty())
        part_.solver().solve();
    });
}

void file_requests::import(const QString& mesh, const QStringList& load_cases,
                           const QString& unit) {
  std::vector<fem::load_case> loads;
  for (const auto& file : load_cases) {
    auto read = protocol::load_case_from_file(file.toStdString());
    if (!read) {
      emit part_.failed(tr("Open %1").arg(file), read.error());
      return;
    }
    loads.push_back(std::move(*read));
  }
  part_.begin(new_document_name(mesh, QDateTime::currentDateTime()));
  part_.load_catalogue();
  ask_import(mesh, unit, std::move(loads));
}

void file_requests::ask_import(const QString& mesh, const QString& unit,
                               std::vector<fem::load_case> loads) {
  const QString title = tr("Open %1").arg(QFileInfo(mesh).fileName());
  part_.foreground().ask<client::committed>(
    title,
    [mesh = mesh.toStdString(), unit = unit.toStdString(), name = part_.name().toStdString()](
      client::client& c, const execution& run) -> expected<client::committed> {
      if (auto state = c.open(name, true, true); !state)
        return fail(std::move(state.error()));
      return c.import_file(mesh, unit, run);
    },
    [this, title, loads = std::move(loads),
     mine = part_.opening()](const expected<client::committed>& got) {
      if (mine != part_.opening())
        return;
      if (!got)
        return emit part_.failed(title, got.error());
      emit part_.opened();
      part_.take(*got);
      part_.solver().send_watch();
      part_.loads().send(loads);
    });
}

void file_requests::export_to(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  const auto format = suffix == "stl"   ? client::file_format::stl
                      : suffix == "vtu" ? client::file_format::vtu
                                        : client::file_format::msh;
  const QString title = tr("Export %1").arg(QFileInfo(path).fileName());
  part_.foreground().ask<void>(
    title,
    [path, format](client::client& c, const execution& run) -> expected<void> {
      const auto bytes = c.export_file(format, {}, "mm", run);
      if (!bytes)
        return fail(bytes.error());
      QSaveFile file(path);
      const auto size = static_cast<qint64>(bytes->size());
      if (!file.open(QIODevice::WriteOnly) || file.write(bytes->data(), size) != size ||
          !file.commit())
        return fail(ec::io_error, "cannot write the file: " + file.errorString().toStdString(), {},
                    path.toStdString());
      return {};
    },
    [this, title, path, mine = part_.opening()](const expected<void>& ok) {
      if (mine != part_.opening())
        return;
      if (ok)
        emit exported(path);
      else
        emit part_.failed(title, ok.error());
    });
}

}  // namespace tedit::desktop
