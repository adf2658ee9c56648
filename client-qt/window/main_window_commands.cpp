// SPDX-License-Identifier: AGPL-3.0-or-later
#include <QAction>
#include <QFileDialog>
#include <QInputDialog>
#include <QToolBar>

#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/tools/section/section_bar.hpp"
#include "client-qt/view/overlay.hpp"
#include "client-qt/view/viewport.hpp"
#include "client-qt/widgets/banner.hpp"
#include "client-qt/widgets/command_palette.hpp"
#include "client-qt/window/main_window.hpp"

namespace tedit::desktop {

/// The action of a command: for menus, tool buttons and its shortcut.
QAction* main_window::action(const QString& id) {
  if (const auto found = actions_.find(id); found != actions_.end())
    return *found;
  const auto* what = commands_.find(id);
  auto* made = new QAction(this);
  made->setObjectName(id);
  if (what) {
    made->setText(what->title);
    made->setToolTip(what->shortcut.isEmpty() ? what->title
                                              : what->title + "  (" + what->shortcut + ")");
    made->setShortcut(QKeySequence(settings_.value("shortcut/" + id, what->shortcut).toString()));
    if (!what->icon.isEmpty())
      made->setIcon(icon(what->icon, theme_.ink));
  }
  connect(made, &QAction::triggered, this, [this, id] { commands_.trigger(id); });
  actions_.insert(id, made);
  addAction(made);
  return made;
}

void main_window::refresh_actions() {
  for (auto at = actions_.begin(); at != actions_.end(); ++at)
    if (const auto* what = commands_.find(at.key()))
      at.value()->setEnabled(commands_.is_enabled(*what));
}

void main_window::add_commands() {
  const auto has_part = [this] { return part_.head() != nullptr; };
  const auto idle = [this] { return part_.head() && !part_.current_activity(); };
  const QString file = tr("File");
  const QString edit = tr("Edit");
  commands_.add({"file.open",
                 tr("Open"),
                 file,
                 "Ctrl+O",
                 [this] { ask_file(); },
                 {},
                 tr("A mesh with its load cases, a document, or a recipe, which is run"),
                 "file_open"});
  commands_.add({"file.connect", tr("Connect to a server"), file, {}, [this] { ask_server(); }});
  commands_.add(
    {"file.close", tr("Close the part"), file, "Ctrl+W", [this] { part_.close(); }, has_part});
  commands_.add({"file.export", tr("Export"), file, "Ctrl+E", [this] { ask_export(); }, has_part,
                 tr("Writes the mesh (.msh), its boundary (.stl) or its fields (.vtu)"), "export"});
  commands_.add({"file.screenshot", tr("Save a picture"), file, "Ctrl+P",
                 [this] { ask_screenshot(); }, has_part, tr("The view with its legend as a PNG"),
                 "camera"});
  commands_.add({"file.quit", tr("Quit"), file, "Ctrl+Q", [this] { close(); }});
  commands_.add({"edit.undo",
                 tr("Undo"),
                 edit,
                 "Ctrl+Z",
                 [this] { part_.undo(); },
                 [this, idle] { return idle() && part_.can_undo(); },
                 {},
                 "undo"});
  commands_.add({"edit.redo",
                 tr("Redo"),
                 edit,
                 "Ctrl+Y",
                 [this] { part_.redo(); },
                 [this, idle] { return idle() && part_.can_redo(); },
                 {},
                 "redo"});
  commands_.add({"edit.apply", tr("Apply the operation"), edit, "Ctrl+Return",
                 [this] { context_->apply(); }, idle});
  commands_.add({"edit.cancel",
                 tr("Cancel what runs"),
                 edit,
                 "Esc",
                 [this] {
                   if (part_.current_activity())
                     part_.cancel();
                   else if (!context_->chosen().isEmpty())
                     context_->choose({});
                   else if (!selection_.surfaces().empty())
                     selection_.clear();
                   else
                     part_.cancel_solve();
                 },
                 {},
                 {},
                 "cancel"});
  commands_.add({"edit.solve", tr("Solve again"), edit, "F5", [this] { part_.solve(); }, has_part});
  commands_.add({"edit.cancel_solve",
                 tr("Stop the solver"),
                 edit,
                 {},
                 [this] { part_.cancel_solve(); },
                 has_part});
  add_view_commands();
  add_tools();
  commands_.add({"help.palette",
                 tr("Search everything"),
                 tr("Help"),
                 "Ctrl+K",
                 [this] { palette_->open(); },
                 {},
                 tr("All commands and operations"),
                 "search"});
  add_recording();
  for (const auto& what : commands_.all())
    (void)action(what.id);
  refresh_actions();
}

void main_window::set_hidden(std::set<surface_id> surfaces) {
  hidden_ = std::move(surfaces);
  view_->hide(hidden_);
  refresh_actions();
  emit hidden_changed();
}

void main_window::add_view_commands() {
  const auto has_part = [this] { return part_.head() != nullptr; };
  const auto picked = [this] { return !selection_.surfaces().empty(); };
  const QString view = tr("View");
  commands_.add({"view.fit", tr("Fit"), view, "F", [this] { view_->fit(selection_.surfaces()); },
                 has_part, tr("The selection, or the whole part"), "fit"});
  const std::pair<const char*, camera::direction> sides[] = {
    {QT_TR_NOOP("Front"), camera::direction::front},
    {QT_TR_NOOP("Back"), camera::direction::back},
    {QT_TR_NOOP("Left"), camera::direction::left},
    {QT_TR_NOOP("Right"), camera::direction::right},
    {QT_TR_NOOP("Top"), camera::direction::top},
    {QT_TR_NOOP("Bottom"), camera::direction::bottom},
    {QT_TR_NOOP("Isometric"), camera::direction::isometric}};
  int key = 1;
  for (const auto& [name, from] : sides)
    commands_.add({QString("view.%1").arg(QString(name).toLower()),
                   tr("View from: %1").arg(tr(name)), view, QString::number(key++),
                   [this, from = from] { view_->look_from(from); }, has_part});
  commands_.add({"view.section", tr("Section plane"), view, "S",
                 [this] { section_->set_on(!section_->is_on()); }, has_part,
                 tr("Cuts the part and shows the field inside"), "section"});
  commands_.add({"view.section_at", tr("Section parallel to the last click"), view, "Shift+S",
                 [this] {
                   if (last_click_)
                     section_->set_plane(last_click_->at, last_click_->normal);
                 },
                 [this] { return part_.head() && last_click_; }});
  commands_.add({"view.hide",
                 tr("Hide the selection"),
                 view,
                 "H",
                 [this] {
                   auto all = hidden_;
                   all.insert(selection_.surfaces().begin(), selection_.surfaces().end());
                   set_hidden(std::move(all));
                   selection_.clear();
                 },
                 picked,
                 {},
                 "hide"});
  commands_.add({"view.isolate",
                 tr("Isolate the selection"),
                 view,
                 "I",
                 [this] {
                   std::set<surface_id> others;
                   if (const auto* head = part_.head(); head && head->surface)
                     for (const auto& [id, row] : head->surface->surfaces())
                       if (!selection_.contains(id))
                         others.insert(id);
                   set_hidden(std::move(others));
                 },
                 picked,
                 {},
                 "isolate"});
  commands_.add({"view.show_all", tr("Show everything"), view, "Shift+H",
                 [this] { set_hidden({}); }, [this] { return !hidden_.empty(); }});
  commands_.add({"view.parallel", tr("Parallel or perspective"), view, "O",
                 [this] {
                   view_->view().set_parallel(!view_->view().is_parallel());
                   view_->redraw();
                 },
                 has_part});
  commands_.add({"view.mesh", tr("Show or hide the mesh"), view, "M",
                 [this, on = false]() mutable { view_->show_mesh(on = !on); }, has_part});
  commands_.add({"view.edges", tr("Show or hide the edges"), view, "E",
                 [this, on = true]() mutable { view_->show_edges(on = !on); }, has_part});
  commands_.add({"view.extremes", tr("Mark smallest and largest value"), view, "X",
                 [this] { overlay_->show_extremes(!overlay_->shows_extremes()); }, has_part});
  commands_.add(
    {"view.dark", tr("Dark or light"), view, "Ctrl+Shift+D", [this] { set_dark(!theme_.dark); }});
  for (const auto& group : field_groups())
    for (const auto field : group)
      commands_.add({"view.field_" + field_id(field),
                     tr("Show: %1").arg(field_title(field)),
                     view,
                     {},
                     [this, field] { fields_->set_field(field); },
                     has_part,
                     field_help(field)});
}

/// From the catalogue: operations of plugins that this program never saw are there as well.
void main_window::add_operation_commands() {
  const QString group = tr("Operation");
  for (const auto& what : commands_.all())
    if (what.group == group)
      if (auto* old = actions_.take(what.id))
        old->deleteLater();
  commands_.remove_group(group);
  rail_->clear();
  for (const auto& one : part_.operations().operations) {
    const auto id = QString::fromStdString(one.about.id);
    commands_.add({"op." + id,
                   QString::fromStdString(one.about.name),
                   group,
                   {},
                   [this, id] { context_->choose(id); },
                   [this] { return part_.head() != nullptr; },
                   QString::fromStdString(one.about.summary),
                   operation_icon(id)});
    auto* button = action("op." + id);
    button->setToolTip(QString::fromStdString(one.about.summary));
    rail_->addAction(button);
  }
  refresh_actions();
}

// -- questions -----------------------------------------------------------------------

void main_window::ask_file() {
  auto* dialog =
    new QFileDialog(this, tr("Open a mesh and its load cases, a document or a recipe"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  dialog->setNameFilters(
    {tr("Meshes, load cases, recipes, documents (*.msh *.json *.tedit)"), tr("All files (*)")});
  connect(dialog, &QFileDialog::filesSelected, this, &main_window::open_files);
  dialog->open();
}

void main_window::ask_server() {
  auto* dialog = new QInputDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Connect to a server"));
  dialog->setLabelText(
    tr("Address and token, as \"tedit serve\" prints them: ws://HOST:PORT/v1 TOKEN"));
  connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& text) {
    const auto parts = text.split(' ', Qt::SkipEmptyParts);
    if (parts.size() == 2)
      connect_to({parts[0], parts[1]});
  });
  dialog->open();
}

void main_window::ask_export() {
  auto* dialog = new QFileDialog(this, tr("Export"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilters(
    {tr("Mesh (*.msh)"), tr("Fields for ParaView (*.vtu)"), tr("Boundary (*.stl)")});
  dialog->setDefaultSuffix("msh");
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
    dialog->setDefaultSuffix(filter.section("*.", 1).chopped(1));
  });
  connect(dialog, &QFileDialog::fileSelected, &part_, &document::export_file);
  dialog->open();
}

void main_window::ask_screenshot() {
  auto* dialog = new QFileDialog(this, tr("Save a picture"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilter(tr("Pictures (*.png)"));
  dialog->setDefaultSuffix("png");
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    if (picture().save(path))
      emit part_.exported(path);
    else
      emit part_.failed(tr("Save a picture"),
                        {ec::io_error, "cannot write the picture", {}, path.toStdString()});
  });
  dialog->open();
}

}  // namespace tedit::desktop
