// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/file_requests.hpp"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <utility>

#include "client-qt/model/document.hpp"
#include "client-qt/model/document_name.hpp"
#include "client-qt/net/cad_import.hpp"
#include "protocol/convert.hpp"

namespace tedit::desktop {

/// As it is now.
static cad_source source_of(const imported_file& file) {
  const QFileInfo about(file.mesh);
  return {file, about.lastModified(), about.size()};
}

bool cad_source::is_changed() const {
  const auto now = source_of(file);
  return !QFileInfo::exists(file.mesh) || now.changed_at != changed_at || now.bytes != bytes;
}

file_requests::file_requests(document& part, remote& link) : part_(part), link_(link) {
  connect(&link_, &remote::connected, this, &file_requests::reopen);
  connect(&part_, &document::begun, this, [this] {
    asked_name_.clear();
    source_.reset();
  });
}

void file_requests::close() {
  ++wanted_;
  part_.begin({});
  part_.solver().forget_watch();
  emit part_.closed();
  leave();
}

/// Not where another document was opened meanwhile: that has closed the one before.
void file_requests::leave() {
  link_.run<void>(
    [order = order_, mine = ++order_->last](client::client& c, const execution&) -> expected<void> {
      const std::lock_guard lock(order->one_at_a_time);
      return mine == order->last ? c.close_document() : expected<void>();
    },
    [](const expected<void>&) {});  // Without a connection nothing is open.
}

expected<file_requests::ready> file_requests::look_up(client::client& server,
                                                      const std::string& name) {
  const auto state = server.open(name, false, false);
  if (!state)
    return fail(state.error());
  if (!state->head)
    return fail(ec::not_found, "the server has no document \"" + name + "\" any more",
                "Open the part's mesh, or look for the document where it was moved to");
  return ready{name, {}, {}, {}};
}

void file_requests::open(const QString& name) {
  switch_to(tr("Open %1").arg(title_of(name).words),
            [name = name.toStdString()](client::client& server, const execution&) {
              return look_up(server, name);
            });
}

/// Of a copy nobody has heard.
static error naming(error reason, const QString& copy, const QString& of) {
  for (auto* text : {&reason.message, &reason.where, &reason.remedy})
    *text = QString::fromStdString(*text).replace(copy, of).toStdString();
  return reason;
}

void file_requests::open_copy(const QString& copy, const QString& of) {
  const auto look = [copy, of](client::client& server, const execution&) -> expected<ready> {
    auto found = look_up(server, QFileInfo(copy).completeBaseName().toStdString());
    return found ? std::move(found) : expected<ready>(fail(naming(found.error(), copy, of)));
  };
  switch_to(tr("Open %1").arg(QFileInfo(of).fileName()), look, [copy] {
    for (const auto* part : {"", "-wal", "-shm"})
      QFile::remove(copy + part);
  });
}

void file_requests::add(const QString& path) {
  const auto give = [path, name = valid_name(QFileInfo(path).completeBaseName()).toStdString()](
                      client::client& server, const execution& run) -> expected<ready> {
    const auto added = server.add_document(path.toStdString(), name, true, run);
    if (!added)
      return fail(added.error());
    return ready{*added, {}, {}, {}};
  };
  switch_to(tr("Open %1").arg(QFileInfo(path).fileName()), give);
}

/// `prepare` works on a connection of its own. What was wanted last counts.
void file_requests::switch_to(const QString& title, remote::work<ready> prepare,
                              std::function<void()> when_refused) {
  part_.foreground().ask<ready>(
    title,
    [options = link_.options(), prepare = std::move(prepare)](
      client::client&, const execution& run) -> expected<ready> {
      const auto aside = client::client::connect(options, {});
      return aside ? prepare(**aside, run) : expected<ready>(fail(aside.error()));
    },
    [this, title, when_refused = std::move(when_refused),
     mine = ++wanted_](const expected<ready>& got) {
      if (!got && when_refused)
        when_refused();
      if (mine != wanted_)
        return;
      if (!got)
        return emit part_.failed(title, got.error());
      part_.begin(QString::fromStdString(got->name));
      source_ = got->cad;
      reopen();
      part_.warn(got->warnings);
      if (got->from)
        emit imported(*got->from);
      if (got->refused_loads)
        emit part_.failed(tr("Set the load cases"), *got->refused_loads);
    });
}

void file_requests::rename(const QString& name, std::function<void(const expected<void>&)> done) {
  asked_name_ = name;
  link_.run<void>(
    [name = name.toStdString(), before = part_.name().toStdString()](
      client::client& c, const execution&) { return c.rename_document(name, before); },
    [this, done = std::move(done), mine = part_.opening()](const expected<void>& ok) {
      if (mine == part_.opening() && (ok || ok.error().code != ec::service_unavailable))
        asked_name_.clear();
      done(ok);
    });
}

/// A document that was being renamed when its server went has one of the two names.
expected<client::document_state> file_requests::open_named(client::client& server,
                                                           const std::string& name,
                                                           const std::string& or_else,
                                                           const client::surface_model& held) {
  auto state = server.open(name, true, true, held);
  if (!state || state->head || or_else.empty())
    return state;
  return server.open(or_else, true, true, held);
}

/// Also when a lost connection is back: the server sends what has changed since.
void file_requests::reopen() {
  part_.load_catalogue();
  if (!part_.is_open())
    return;
  const QString title = tr("Open %1").arg(part_.name());
  ++order_->last;
  const auto* head = part_.head();
  part_.foreground().ask<client::document_state>(
    title,
    [name = part_.name().toStdString(), or_else = std::exchange(asked_name_, {}).toStdString(),
     held = head ? head->surface : nullptr, order = order_](client::client& c, const execution&) {
      const std::lock_guard lock(order->one_at_a_time);
      return open_named(c, name, or_else, held ? *held : client::surface_model());
    },
    [this, title, mine = part_.opening()](const expected<client::document_state>& got) {
      if (mine != part_.opening())
        return;
      if (!got)
        return emit part_.failed(title, got.error());
      part_.take(*got);
      const auto held = part_.solver().held_solve();
      part_.solver().send_watch(held);
      emit part_.opened();
      part_.take_surface();  // It may have come before this answer.
      part_.refresh_history(true);
      part_.edits().ask_again();
      if (got->head && !got->head->load_cases.empty())
        part_.solver().solve(held);
    });
}

void file_requests::import(const QString& mesh, const QStringList& load_cases,
                           const QString& unit) {
  import_from({mesh, load_cases, unit.isEmpty() ? "mm" : unit, "medium", {}});
}

void file_requests::import_cad(const imported_file& file) {
  import_from(file);
}

void file_requests::import_anew(imported_file file, const QString& unit) {
  file.unit = unit;
  import_from(file);
}

void file_requests::import_from(const imported_file& what) {
  new_part from{what, {}};
  for (const auto& file : what.load_cases) {
    auto read = protocol::load_case_from_file(file.toStdString());
    if (!read) {
      emit part_.failed(tr("Open %1").arg(file), read.error());
      return;
    }
    from.loads.push_back(std::move(*read));
  }
  switch_to(tr("Open %1").arg(QFileInfo(what.mesh).fileName()),
            [from = std::move(from)](client::client& server, const execution& run) {
              return make(server, run, from);
            });
}

/// Named after the mesh and the time, a second later for each that has been taken: a part opened
/// twice within a second must not go into the document of the first.
expected<std::string> file_requests::open_empty(client::client& server, const QString& mesh) {
  const auto now = QDateTime::currentDateTime();
  for (int later = 0;; ++later) {
    const auto name = new_document_name(mesh, now.addSecs(later)).toStdString();
    const auto state = server.open(name, false, false);
    if (!state)
      return fail(state.error());
    if (!state->head)
      return name;
  }
}

/// A CAD file comes as a document that has its model.
expected<file_requests::ready> file_requests::make_of_cad(client::client& server,
                                                          const execution& run,
                                                          const imported_file& file) {
  const auto source = source_of(file);
  const auto meshed =
    mesh_cad_file({file.mesh, file.size, file.unit, file.local_sizes_mm}, run.part(0, 0.8));
  if (!meshed)
    return fail(meshed.error());
  const auto name = new_document_name(file.mesh, QDateTime::currentDateTime()).toStdString();
  const auto added =
    server.add_document(meshed->document.toStdString(), name, true, run.part(0.8, 1));
  if (!added)
    return fail(added.error());
  if (const auto opened = server.open(*added, false, false); !opened)
    return fail(opened.error());
  // A 3MF and CAD files say their units.
  const bool asks_unit =
    is_surface_file(file.mesh) && !file.mesh.endsWith(".3mf", Qt::CaseInsensitive);
  return ready{*added,
               meshed->warnings,
               {},
               asks_unit ? std::optional(file) : std::nullopt,
               is_cad_file(file.mesh) ? std::optional(source) : std::nullopt};
}

expected<file_requests::ready> file_requests::make_of_mesh(client::client& server,
                                                           const execution& run,
                                                           const imported_file& file) {
  const auto name = open_empty(server, file.mesh);
  if (!name)
    return fail(name.error());
  auto made = server.import_file(file.mesh.toStdString(), file.unit.toStdString(), run);
  if (!made)
    return fail(made.error());
  return ready{*name, std::move(made->warnings), {}, file};
}

/// A part whose loads are refused is opened all the same.
expected<file_requests::ready> file_requests::make(client::client& server, const execution& run,
                                                   const new_part& from) {
  auto made = is_cad_file(from.file.mesh) || is_surface_file(from.file.mesh)
                ? make_of_cad(server, run, from.file)
                : make_of_mesh(server, run, from.file);
  if (!made)
    return made;
  auto& result = *made;
  for (const auto& one : from.loads)
    if (const auto ok = server.set_load_case(one); !ok && !result.refused_loads)
      result.refused_loads = ok.error();
  return made;
}

/// The head in a format of the server's, or the whole document; the CAD model is made of that.
static expected<void> write_export(client::client& server, const execution& run,
                                   const QString& path) {
  const auto format = QFileInfo(path).suffix().toLower().toStdString();
  const bool model = is_step_file(path);
  const bool whole = model || format == document_format;
  const auto bytes = server.export_file(model ? std::string(document_format) : format, {},
                                        whole ? "" : "mm", model ? run.part(0, 0.5) : run);
  if (!bytes)
    return fail(bytes.error());
  if (model)
    return write_cad_model(*bytes, path, run);
  QSaveFile file(path);
  const auto size = static_cast<qint64>(bytes->size());
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes->data(), size) != size || !file.commit())
    return fail(ec::io_error, "cannot write the file: " + file.errorString().toStdString(), {},
                path.toStdString());
  return {};
}

void file_requests::export_to(const QString& path) {
  const auto format = QFileInfo(path).suffix().toLower().toStdString();
  const QString title = tr("Export %1").arg(QFileInfo(path).fileName());
  if (const auto can = client::check_format(link_.formats(), format); !can && !is_step_file(path))
    return emit part_.failed(title, can.error());
  part_.foreground().ask<void>(
    title, [path](client::client& c, const execution& run) { return write_export(c, run, path); },
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
