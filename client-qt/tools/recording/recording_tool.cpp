// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/recording/recording_tool.hpp"

#include <QFileDialog>
#include <QLabel>
#include <QMainWindow>
#include <QSaveFile>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/recording/recorder.hpp"

namespace tedit::desktop {

recording_tool::recording_tool(window_context& in, toolbox& tools)
    : in_(in), recorder_(new recorder(in, tools, this)) {
  add_light();
  in_.all_commands.add(
    {"file.record", tr("Record steps"), command_groups::file(), "Ctrl+R",
     [this] { start_or_stop(); }, in_.has_part(),
     tr("Writes down what is done as a recipe, which the window and \"tedit run\" carry out; "
        "again: ends and saves")});
}

void recording_tool::add_light() {
  auto* light = new QLabel;
  light->setObjectName("recording");
  light->setStyleSheet("color: #c62828; font-weight: 600; padding: 0 8px;");
  in_.truth.add(light);
  light->hide();
  connect(recorder_, &recorder::changed, this, [this, light] {
    light->setVisible(recorder_->is_on());
    light->setText(QString::fromUtf8("\u25cf ") +
                   tr("recording, steps: %1").arg(recorder_->steps()));
  });
}

void recording_tool::start_or_stop() {
  if (!recorder_->is_on()) {
    recorder_->start();
    return;
  }
  recorder_->stop();
  ask_file();
}

void recording_tool::ask_file() {
  auto* dialog = new QFileDialog(&in_.window, tr("Save the recorded steps"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const auto portable =
    tr("Recipes for other meshes and sizes, surfaces by name and place (*.json)");
  dialog->setNameFilters({tr("Recipes, surfaces by number (*.json)"), portable});
  dialog->setDefaultSuffix("json");
  connect(dialog, &QFileDialog::fileSelected, this, [=, this](const QString& path) {
    QSaveFile file(path);
    const auto recipe =
      dialog->selectedNameFilter() == portable ? recorder_->portable_recipe() : recorder_->recipe();
    const auto text = QByteArray::fromStdString(client::to_json(recipe));
    if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit())
      emit in_.part.files().exported(path);
    else
      emit in_.part.failed(tr("Save the recorded steps"),
                           {ec::io_error, "cannot write the file", {}, path.toStdString()});
  });
  dialog->open();
}

}  // namespace tedit::desktop
