// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/pictures/pictures_tool.hpp"

#include <QApplication>
#include <QFileDialog>
#include <QMainWindow>
#include <QPointer>
#include <QThreadPool>

#include <utility>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/history/history_tool.hpp"
#include "client-qt/tools/pictures/kept_picture.hpp"

namespace tedit::desktop {

pictures_tool::pictures_tool(window_context& in, history_tool& history)
    : in_(in), history_(history) {
  in_.all_commands.add({"file.screenshot", tr("Save a picture"), command_groups::file(), "Ctrl+P",
                        [this] { ask_file(); }, in_.has_part(),
                        tr("The view with its legend as a PNG"), "camera"});
  connect(&in_.view, &viewport::shown, this, &pictures_tool::shown);
  connect(&in_.view, &viewport::drawn, this, &pictures_tool::take);
  connect(&in_.part, &document::begun, this, [this] { looked_for_.clear(); });
  connect(&in_.part, &document::history_changed, this, &pictures_tool::find_kept);
  // Once they have moved; those that were looked for meanwhile were not found.
  connect(
    &in_.part, &document::renamed, this,
    [this] {
      looked_for_.clear();
      find_kept();
    },
    Qt::QueuedConnection);
  connect(&in_.part, &document::field_changed, this, [this] {
    if (const auto* head = in_.part.head(); head && head->fields.empty()) {
      kept_.clear();  // Other loads: the next field gives another picture.
      history_.strip().outdate(head->info.version_id);
    }
  });
}

void pictures_tool::ask_file() {
  auto* dialog = new QFileDialog(&in_.window, tr("Save a picture"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilter(tr("Pictures (*.png)"));
  dialog->setDefaultSuffix("png");
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    if (in_.over.picture(0, 0).save(path))
      emit in_.part.files().exported(path);
    else
      emit in_.part.failed(tr("Save a picture"),
                           {ec::io_error, "cannot write the picture", {}, path.toStdString()});
  });
  dialog->open();
}

void pictures_tool::shown() {
  const auto* head = in_.part.head();
  const auto field = in_.view.current().field;
  const bool whole = head && in_.view.painted().extremes && field && !field->interim() &&
                     field->version_id() == head->info.version_id;
  const bool due =
    head && (whole || !field) && !history_.strip().has_thumbnail(head->info.version_id, whole);
  thumbnail_due_ = due ? head->info.version_id : "";
}

/// The head as it is drawn, once for each version and field.
void pictures_tool::take() {
  const auto* head = in_.part.head();
  const auto& view = in_.view;
  if (!head || !view.is_seen() || !view.is_fine() || view.current().before ||
      view.current().surface != head->surface)
    return;
  const auto field = view.current().field;
  const bool coloured = field && field->version_id() == head->info.version_id;
  const int opening = in_.part.opening();
  const QString now = QString::number(opening) + "/" +
                      QString::fromStdString(head->info.version_id) + (coloured ? "/field" : "");
  const bool fresh = std::exchange(kept_, now) != now;
  const auto due = std::exchange(thumbnail_due_, {});
  if (!fresh && due.empty())
    return;
  in_.view.plain_picture([=, this, asked = in_.part.name()](const QImage& frame) {
    const QString folder = in_.server.folder();
    // It may have got another name meanwhile.
    const QString name = opening == in_.part.opening() ? in_.part.name() : asked;
    if (fresh)
      keep_picture(frame, picture_file(folder, name));
    if (coloured && !due.empty())
      keep_picture(frame, picture_file(folder, name, due));
    if (!due.empty())
      history_.strip().set_thumbnail(due, frame, coloured);
  });
}

/// Of versions that were drawn when the document was open before; read aside, as there may be many.
void pictures_tool::find_kept() {
  std::map<std::string, QString> files;
  for (const auto& [number, row] : in_.part.versions())
    if (const auto& id = row.info.version_id;
        looked_for_.insert(id).second && !history_.strip().has_thumbnail(id, true))
      files[id] = picture_file(in_.server.folder(), in_.part.name(), id);
  if (files.empty())
    return;
  QThreadPool::globalInstance()->start([files, tool = QPointer(this)] {
    std::map<std::string, QImage> found;
    for (const auto& [id, file] : files)
      if (QImage kept(file); !kept.isNull())
        found.emplace(id, std::move(kept));
    if (!found.empty())
      QMetaObject::invokeMethod(qApp, [tool, found] {
        if (tool)
          tool->history_.strip().find_thumbnails(found);
      });
  });
}

}  // namespace tedit::desktop
