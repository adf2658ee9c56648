// SPDX-License-Identifier: AGPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QSaveFile>
#include <QStackedWidget>

#include "client-qt/tools/help/help_panel.hpp"
#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/jobs/jobs_panel.hpp"
#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/receipt/receipt_panel.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/view/viewport.hpp"
#include "client-qt/widgets/banner.hpp"
#include "client-qt/widgets/truth_line.hpp"
#include "client-qt/window/main_window.hpp"
#include "client-qt/window/recorder.hpp"

namespace tedit::desktop {

static constexpr int help_width = 420;
static constexpr int beside_server = 3;  // After the verdict, its button and the facts.

void main_window::add_extras() {
  add_jobs();
  add_boxes();
  add_isolines();
  add_history_words();
  add_help();
}

void main_window::add_jobs() {
  auto* button = new jobs_button(part_.work(), link_);
  truth_->insertPermanentWidget(beside_server, button);
  commands_.add({"view.jobs",
                 tr("What runs"),
                 tr("View"),
                 "J",
                 [button] { button->open_panel(); },
                 {},
                 tr("Jobs with their progress, and the server's workers")});
}

void main_window::add_boxes() {
  const auto has_part = [this] { return part_.head() != nullptr; };
  const auto boxing = std::make_shared<bool>(false);
  const auto set_boxing = [this, boxing](bool on) {
    *boxing = on;
    view_->set_boxing(on);
    if (on)
      banner_->show_news(
        tr("Draw a box. To the right: what lies in it altogether; to the left: all that it "
           "touches. Shift adds, Esc ends. Ctrl+drag does it at any time."));
  };
  connect(view_, &viewport::boxed, this, [this](const std::vector<surface_id>& found, bool add) {
    auto all = found;
    if (add)
      all.insert(all.end(), selection_.surfaces().begin(), selection_.surfaces().end());
    selection_.set(all);
  });
  commands_.add({"view.box", tr("Select with a box"), tr("Edit"), "B",
                 [set_boxing, boxing] { set_boxing(!*boxing); }, has_part,
                 tr("Ctrl+drag in the view does the same")});
  commands_.add({"edit.select_visible", tr("Select all that can be seen"), tr("Edit"), "Ctrl+A",
                 [this] { view_->pick_box_at(QRectF(view_->rect()), false, false); }, has_part});
  before_cancel([set_boxing, boxing] {
    const bool was_on = *boxing;
    set_boxing(false);
    return was_on;
  });
}

void main_window::add_isolines() {
  commands_.add({"view.isolines", tr("Show or hide isolines"), tr("View"), "N",
                 [this] { fields_->set_isolines(!fields_->isolines()); },
                 [this] { return part_.head() != nullptr; },
                 tr("Lines of equal value on the surface and on a section")});
}

void main_window::add_history_words() {
  commands_.add({"history.words", tr("Name and note of a version"), tr("Edit"), "Ctrl+F2",
                 [this] {
                   findChild<QDockWidget*>("history")->raise();
                   history_->edit_words();
                 },
                 [this] { return part_.head() != nullptr; },
                 tr("Of the one that is chosen in the history")});
}

void main_window::add_help() {
  auto* help = new help_panel;
  auto* dock = add_dock("help", tr("Help"), help, Qt::LeftDockWidgetArea);
  dock->hide();
  commands_.add({"help.manual",
                 tr("Help"),
                 tr("Help"),
                 "F1",
                 [this, dock, help] {
                   const bool was_shown = dock->isVisible();
                   dock->show();
                   dock->raise();
                   if (!was_shown)
                     resizeDocks({dock}, {help_width}, Qt::Horizontal);
                   const auto [page, heading] = help_topic();
                   help->show_page(page, heading);
                   help->start_typing();
                 },
                 {},
                 tr("The manual: the page for what is being done, with a search"),
                 "info"});
}

std::pair<QString, QString> main_window::help_topic() const {
  if (!context_->chosen().isEmpty())
    return {"operations", context_->chosen()};
  const auto* focus = QApplication::focusWidget();
  const auto in = [&](const QWidget* panel) {
    return panel && focus && panel->isAncestorOf(focus);
  };
  if (in(fields_) || in(receipt_) || in(findChild<QWidget*>("probes")))
    return {"results", {}};
  return {"desktop", {}};
}

// -- recording -----------------------------------------------------------------------

/// After all that it listens to is there.
void main_window::add_recording() {
  recorder_ = new recorder(*this);
  auto* light = new QLabel;
  light->setObjectName("recording");
  light->setStyleSheet("color: #c62828; font-weight: 600; padding: 0 8px;");
  truth_->insertPermanentWidget(beside_server, light);
  light->hide();
  connect(recorder_, &recorder::changed, this, [this, light] {
    light->setVisible(recorder_->is_on());
    light->setText(QString::fromUtf8("\u25cf ") +
                   tr("recording, steps: %1").arg(recorder_->steps().size()));
  });
  commands_.add({"file.record", tr("Record steps"), tr("File"), "Ctrl+R",
                 [this] {
                   if (!recorder_->is_on()) {
                     recorder_->start();
                     return;
                   }
                   recorder_->stop();
                   ask_recording();
                 },
                 [this] { return part_.head() != nullptr; },
                 tr("Writes down what is done, for \"tedit-qt --script\"; again: ends and saves")});
}

void main_window::ask_recording() {
  auto* dialog = new QFileDialog(this, tr("Save the recorded steps"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilter(tr("Steps (*.json)"));
  dialog->setDefaultSuffix("json");
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    QSaveFile file(path);
    const QByteArray text = recorder_->text();
    if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit())
      emit part_.exported(path);
    else
      emit part_.failed(tr("Save the recorded steps"),
                        {ec::io_error, "cannot write the file", {}, path.toStdString()});
  });
  dialog->open();
}

}  // namespace tedit::desktop
