// SPDX-License-Identifier: AGPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QPointer>
#include <QRegularExpression>
#include <QSplitter>
#include <QStackedWidget>
#include <QThreadPool>

#include "client-qt/tools/compare/compare_view.hpp"
#include "client-qt/tools/help/about_dialog.hpp"
#include "client-qt/tools/help/shortcuts_dialog.hpp"
#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/loads/load_glyphs.hpp"
#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/tools/probes/plot_panel.hpp"
#include "client-qt/tools/probes/probe_panel.hpp"
#include "client-qt/tools/recipes/recipe_player.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/tools/settings/settings_dialog.hpp"
#include "client-qt/view/viewport.hpp"
#include "client-qt/window/main_window.hpp"

namespace tedit::desktop {

/// What stands beside the part itself.
void main_window::add_tools() {
  connect(&local_, &local_server::ready, this,
          [this](const server_address& address) { local_url_ = address.url; });
  add_load_commands();
  add_compare();
  add_settings();
  add_probes();
  add_extras();
}

/// Esc first tries `then`; when that had nothing to end, it does what it did before.
void main_window::before_cancel(std::function<bool()> then) {
  auto cancel = *commands_.find("edit.cancel");
  cancel.run = [then = std::move(then), otherwise = cancel.run] {
    if (!then())
      otherwise();
  };
  commands_.add(std::move(cancel));
}

/// A document is served from the local server's folder: one from elsewhere is copied there, aside.
void main_window::open_document_file(const QString& path) {
  const QFileInfo file(path);
  const QDir documents(local_.folder() + "/documents");
  if (link_.current() == remote::state::connected && link_.address().url != local_url_) {
    emit part_.failed(tr("Open %1").arg(file.fileName()),
                      {ec::invalid_argument, "a document file is opened on this computer only",
                       "Start TEdit anew without --server", path.toStdString()});
    return;
  }
  if (file.absoluteDir() == documents) {
    open_document(file.completeBaseName());
    return;
  }
  QString stem = file.completeBaseName().left(40);
  stem.replace(QRegularExpression("[^A-Za-z0-9._-]"), "_");
  QString name = stem;
  for (int i = 2; documents.exists(name + ".tedit"); ++i)
    name = stem + "-" + QString::number(i);
  const QString to = documents.absoluteFilePath(name + ".tedit");
  QThreadPool::globalInstance()->start([path, to, name, window = QPointer(this)] {
    QDir().mkpath(QFileInfo(to).path());
    if (QFile::exists(path + "-wal"))  // Steps that are not in the main file yet.
      QFile::copy(path + "-wal", to + "-wal");
    const bool copied = QFile::copy(path, to);
    QMetaObject::invokeMethod(qApp, [=] {
      if (window && copied)
        window->open_document(name);
      else if (window)
        emit window->part_.failed(
          tr("Open %1").arg(path),
          {ec::io_error, "cannot copy the document to " + to.toStdString(),
           "Check that it can be read and that there is room", path.toStdString()});
    });
  });
}

bool main_window::runs_recipe() const {
  return recipe_ && recipe_->is_running();
}

/// On the open part, or on the one that it imports.
void main_window::run_recipe(const QString& path) {
  const QString what = tr("Run the recipe %1").arg(QFileInfo(path).fileName());
  if (runs_recipe()) {
    emit part_.failed(what, {ec::conflict,
                             "another recipe is running",
                             "Wait for it, or cancel it in \"What runs\" (J)",
                             {}});
    return;
  }
  auto steps = client::read_recipe(path.toStdString());
  if (!steps) {
    emit part_.failed(what, steps.error());
    return;
  }
  when_connected([=, this, read = std::move(*steps)] {
    auto* player = new recipe_player(part_, read, this);
    recipe_ = player;
    connect(player, &recipe_player::began, this, [this](const QString& step) { log(step); });
    connect(player, &recipe_player::finished, this, [this, what](int exports) {
      emit part_.notice(exports == 0 ? tr("%1: done").arg(what)
                                     : tr("%1: done. Its exports (%2) were left out: export by "
                                          "hand, or use \"tedit run\".")
                                         .arg(what)
                                         .arg(exports));
    });
    connect(player, &recipe_player::stopped, this, [this, what](const QString& step) {
      log(tr("%1: stopped at %2").arg(what, step), log_level::errors);
    });
    connect(player, &recipe_player::ended, player, &QObject::deleteLater);
    player->start();
  });
}

void main_window::add_load_commands() {
  const auto has_part = [this] { return part_.head() != nullptr; };
  auto* glyphs = new load_glyph_layer(part_, *fields_, *view_);
  glyphs->show(settings_.value("show_loads", true).toBool());
  commands_.add({"view.loads", tr("Show or hide loads and supports"), tr("View"), "L",
                 [this, glyphs] {
                   glyphs->show(!glyphs->is_shown());
                   settings_.setValue("show_loads", glyphs->is_shown());
                 },
                 has_part, tr("Arrows and support marks of the load case that is shown"), "load"});
  const QString group = tr("Loads");
  const auto add = [&](const char* id, const QString& title, const char* drawing, item_kind kind) {
    commands_.add({id,
                   title,
                   group,
                   {},
                   [this, kind] {
                     findChild<QDockWidget*>("loads")->raise();
                     loads_->add_item(kind);
                   },
                   has_part,
                   {},
                   drawing});
  };
  add("loads.add_support", tr("Add a support"), "support", item_kind::support);
  add("loads.add_load", tr("Add a load"), "load", item_kind::load);
  add("loads.add_material", tr("Add a material"), "material", item_kind::material);
  commands_.add({"loads.new_case",
                 tr("New load case"),
                 group,
                 {},
                 [this] { loads_->new_load_case(); },
                 has_part});
  commands_.add({"loads.remove",
                 tr("Remove the chosen load, support or load case"),
                 group,
                 {},
                 [this] { loads_->remove_current(); },
                 has_part,
                 tr("What is chosen in \"Loads and supports\"")});
}

/// The shown version against its parent, or one that was dragged onto another.
void main_window::add_compare() {
  auto* compare = new compare_view(part_);
  pages_->addWidget(compare);
  const auto open = [this, compare](quint32 before, quint32 after) {
    const auto field = fields_->field();
    compare->open({before, after, fields_->wanted(),
                   field && !field->envelope ? field->report.load_case : std::string(),
                   fields_->deform(), view_->view().get(), view_->free_aspect()});
    pages_->setCurrentWidget(compare);
    place_overlays();  // What has to be said stays in front.
  };
  const auto back = [this, compare] {
    if (pages_->currentWidget() == compare)
      pages_->setCurrentWidget(view_);
  };
  const auto is_open = [this, compare] { return pages_->currentWidget() == compare; };
  commands_.add({"view.compare", tr("Compare with the version before"), tr("View"), "C",
                 [this, open, back, is_open] {
                   const auto* head = part_.head();
                   if (is_open())
                     back();
                   else
                     open(*head->info.parent, head->info.number);
                 },
                 [this] { return part_.head() && part_.head()->info.parent; },
                 tr("Side by side with linked cameras, or their difference"), "compare"});
  commands_.add({"view.compare_difference",
                 tr("Comparison: difference or side by side"),
                 tr("View"),
                 {},
                 [compare] { compare->show_difference(!compare->shows_difference()); },
                 is_open});
  auto* drag = new version_drag(*history_);
  connect(drag, &version_drag::dropped, this, open);
  connect(drag, &version_drag::dropped, &part_, &document::refresh_history);
  connect(compare, &compare_view::closed, this, back);
  connect(compare, &compare_view::version_wanted, this, [this, back](quint32 version) {
    back();
    step_to(version);
  });
  connect(this, &main_window::theme_changed, compare, &compare_view::set_theme);
  before_cancel([is_open, back] {
    const bool was_open = is_open();
    back();
    return was_open;
  });
}

// -- settings and help ---------------------------------------------------------------

/// One of each kind, not modal: asked for again it comes to the front.
template <class Dialog, class Make>
static void show_one(main_window& window, Make make) {
  auto* dialog = window.findChild<Dialog*>();
  if (!dialog) {
    dialog = make();
    dialog->setAttribute(Qt::WA_DeleteOnClose);
  }
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

void main_window::apply_preferences(const preferences& wanted) {
  set_dark(wanted.look == look_wish::dark || (wanted.look == look_wish::system && system_dark_));
  save(wanted, settings_);
  fields_->set_look(wanted.map, wanted.locked, wanted.logarithmic);
  log_level_ = wanted.log;
  if (const auto solve = solve_settings_of(wanted); solve != part_.solve_settings())
    part_.set_solve_settings(solve);
}

void main_window::add_settings() {
  const QString help = tr("Help");
  commands_.add({"file.settings",
                 tr("Settings"),
                 tr("File"),
                 "Ctrl+,",
                 [this] {
                   show_one<settings_dialog>(*this, [this] {
                     auto* made = new settings_dialog(load_preferences(settings_), this);
                     connect(made, &settings_dialog::changed, this,
                             &main_window::apply_preferences);
                     return made;
                   });
                 },
                 {},
                 tr("Colours, solver, legend, log"),
                 "settings"});
  commands_.add({"help.shortcuts",
                 tr("Keyboard shortcuts"),
                 help,
                 "Ctrl+F1",
                 [this] {
                   show_one<shortcuts_dialog>(*this, [this] {
                     auto* made = new shortcuts_dialog({commands_, settings_}, this);
                     connect(made, &shortcuts_dialog::changed, this, &main_window::take_shortcuts);
                     return made;
                   });
                 },
                 {},
                 tr("All commands with their keys, to look up and to change")});
  commands_.add(
    {"help.about",
     tr("About TEdit"),
     help,
     {},
     [this] { show_one<about_dialog>(*this, [this] { return new about_dialog(this); }); },
     {},
     tr("Version, licence, libraries"),
     "info"});
}

void main_window::take_shortcuts() {
  const shortcut_table table(commands_, settings_);
  for (auto at = actions_.begin(); at != actions_.end(); ++at)
    if (const auto* what = commands_.find(at.key())) {
      const QString keys = table.keys(*what);
      at.value()->setShortcut(QKeySequence(keys));
      at.value()->setToolTip(keys.isEmpty() ? what->title : what->title + "  (" + keys + ")");
    }
}

// -- probes and plots ----------------------------------------------------------------

void main_window::add_probes() {
  auto* all = probes_ = new probes(part_, this);
  auto* marks = new probe_marks(*view_, part_, *all);
  auto* list = probe_list_ = new probe_panel(part_, *all, *fields_);
  auto* curves = new plot_panel(part_, *all, *list, *fields_, *view_);
  auto* both = new QSplitter;
  both->addWidget(list);
  both->addWidget(curves);
  auto* dock = add_dock("probes", tr("Probes and plots"), both, Qt::BottomDockWidgetArea);
  auto* history = findChild<QDockWidget*>("history");
  tabifyDockWidget(history, dock);
  history->raise();
  connect(this, &main_window::theme_changed, marks, [marks](const theme& look) {
    marks->set_accent(look.palette.color(QPalette::Highlight));
  });
  connect(view_, &viewport::clicked, this, [this, all](const std::optional<picked_point>& at) {
    if (probing_ && at)
      all->add(at->surface, at->vertices, at->weights);
  });
  const auto has_part = [this] { return part_.head() != nullptr; };
  const auto set_probing = [this, dock](bool on) {
    probing_ = on;
    view_->setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
    if (on)
      dock->raise();
  };
  commands_.add({"view.probe", tr("Probe: values at places that are clicked"), tr("View"), "P",
                 [this, set_probing] { set_probing(!probing_); }, has_part,
                 tr("Numbered pins that stay over edits; two give a distance and a line"),
                 "probe"});
  commands_.add({"view.clear_probes",
                 tr("Remove all probes"),
                 tr("View"),
                 {},
                 [all] { all->clear(); },
                 [all] { return !all->all().empty(); }});
  commands_.add({"view.plots",
                 tr("Probes and plots"),
                 tr("View"),
                 {},
                 [dock] {
                   dock->show();
                   dock->raise();
                 },
                 has_part,
                 tr("The field by area, along a line, and the quality of tets")});
  before_cancel([this, set_probing] {
    const bool ends = probing_ && pages_->currentWidget() == view_;
    if (ends)
      set_probing(false);
    return ends;
  });
}

}  // namespace tedit::desktop
