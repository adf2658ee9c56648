// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/window/main_window.hpp"

#include <QApplication>
#include <QCloseEvent>
#include <QDateTime>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolBar>
#include <QToolTip>

#include <algorithm>
#include <cmath>

#include "client-qt/model/document_name.hpp"
#include "client-qt/model/field_values.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/tools/documents/welcome_page.hpp"
#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/operations/preview_box.hpp"
#include "client-qt/tools/receipt/receipt_panel.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/tools/section/section_bar.hpp"
#include "client-qt/view/overlay.hpp"
#include "client-qt/view/view_cube.hpp"
#include "client-qt/view/viewport.hpp"
#include "client-qt/widgets/banner.hpp"
#include "client-qt/widgets/command_palette.hpp"
#include "client-qt/widgets/truth_line.hpp"
#include "client/recipe.hpp"

namespace tedit::desktop {

namespace {

constexpr int most_log_lines = 5000;
constexpr int cube_margin = 12;
constexpr int widest_banner = 760;
constexpr int below_titles = 70;    // Of a comparison.
constexpr double silent_ms = 4000;  // Then a person wonders.

QWidget* scrolled(QWidget* content) {
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidget(content);
  return area;
}

}  // namespace

main_window::main_window(const QString& state_folder)
    : settings_("tedit", "tedit-qt"), local_(state_folder), part_(link_), selection_(part_) {
  setAcceptDrops(true);
  resize(1440, 900);
  pages_ = new QStackedWidget;
  welcome_ = new welcome_page;
  view_ = new viewport;
  view_->keep_fitted(true);
  overlay_ = new overlay(*view_);
  cube_ = new view_cube(*view_);
  pages_->addWidget(welcome_);
  pages_->addWidget(view_);
  setCentralWidget(pages_);
  banner_ = new banner(pages_);
  palette_ = new command_palette(commands_, this);
  view_->installEventFilter(this);
  truth_ = new truth_line(part_, link_);
  setStatusBar(truth_);
  build_docks();
  section_ = new section_bar(part_, *view_, *fields_);
  add_commands();
  build_toolbars();
  wire();
  system_dark_ = palette().color(QPalette::Window).lightness() < 128;
  apply_preferences(load_preferences(settings_));
  take_shortcuts();
  show_recent();
  if (settings_.contains("geometry"))
    restoreGeometry(settings_.value("geometry").toByteArray());
  if (settings_.contains("layout"))
    restoreState(settings_.value("layout").toByteArray());
  show_docks(false);
  show_title();
}

main_window::~main_window() = default;

// -- layout --------------------------------------------------------------------------

QDockWidget* main_window::add_dock(const QString& name, const QString& title, QWidget* content,
                                   Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(content);
  addDockWidget(area, dock);
  return dock;
}

void main_window::build_docks() {
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  context_ = new context_panel(part_, selection_);
  fields_ = new field_panel(part_);
  loads_ = new loads_panel(part_, selection_);
  receipt_ = new receipt_panel(part_);
  history_ = new history_strip(part_);
  log_ = new QPlainTextEdit;
  log_->setReadOnly(true);
  log_->setMaximumBlockCount(most_log_lines);
  log_->setAccessibleName(tr("Log"));
  auto* selected =
    add_dock("context", tr("Selection"), scrolled(context_), Qt::RightDockWidgetArea);
  auto* field = add_dock("field", tr("Field"), fields_, Qt::RightDockWidgetArea);
  auto* loads = add_dock("loads", tr("Loads and supports"), loads_, Qt::RightDockWidgetArea);
  auto* receipt = add_dock("receipt", tr("What this edit did"), receipt_, Qt::RightDockWidgetArea);
  tabifyDockWidget(loads, receipt);
  loads->raise();
  auto* history = add_dock("history", tr("History"), history_, Qt::BottomDockWidgetArea);
  auto* log = add_dock("log", tr("Log"), log_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(history, log);
  history->raise();
  resizeDocks({selected, field, loads}, {320, 240, 240}, Qt::Vertical);
  resizeDocks({selected}, {330}, Qt::Horizontal);
  resizeDocks({history}, {190}, Qt::Vertical);
}

void main_window::build_toolbars() {
  bar_ = addToolBar(tr("Main"));
  bar_->setObjectName("main_bar");
  bar_->setMovable(false);
  title_ = new QLabel;
  title_->setObjectName("title");
  title_->setContentsMargins(8, 0, 16, 0);
  bar_->addWidget(title_);
  auto* space = new QWidget;
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar_->addWidget(space);
  for (const auto* id : {"file.open", "edit.undo", "edit.redo", "view.fit", "view.hide",
                         "view.isolate", "view.section", "file.screenshot", "file.export"})
    bar_->addAction(action(id));
  auto* search = action("help.palette");
  bar_->addAction(search);
  rail_ = new QToolBar(tr("Operations"));
  rail_->setObjectName("rail");
  rail_->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  rail_->setMovable(false);
  addToolBar(Qt::LeftToolBarArea, rail_);
}

void main_window::place_overlays() {
  overlay_->setGeometry(view_->rect());
  cube_->move(view_->width() - cube_->width() - cube_margin, cube_margin);
  section_->adjustSize();
  section_->move(view_->width() - section_->width() - cube_margin,
                 view_->height() - section_->height() - cube_margin);
  const int room = pages_->width() - 2 * (cube_->width() + 2 * cube_margin);
  const int width = std::clamp(room, 320, widest_banner);
  const int height =
    banner_->hasHeightForWidth() ? banner_->heightForWidth(width) : banner_->sizeHint().height();
  const auto* page = pages_->currentWidget();
  const int top = page == view_ || page == welcome_ ? cube_margin : below_titles;
  banner_->setGeometry((pages_->width() - width) / 2, top, width, height);
  banner_->raise();
}

/// A form with its preview needs more than a list of operations: the docks below give it, as far as
/// they can. A dock never gets smaller by this.
void main_window::make_room() {
  auto* dock = findChild<QDockWidget*>("context");
  if (context_->chosen().isEmpty() || !dock || dock->isFloating())
    return;
  constexpr int title_height = 40;
  constexpr int least_below = 120;  // Of the loads and the receipt.
  auto* field = findChild<QDockWidget*>("field");
  auto* loads = findChild<QDockWidget*>("loads");
  auto* receipt = findChild<QDockWidget*>("receipt");
  auto* below = loads->isVisible() && !loads->visibleRegion().isEmpty() ? loads : receipt;
  const int all = dock->height() + field->height() + below->height();
  const int shown = std::min(field->height(), fields_->sizeHint().height() + title_height);
  const int wanted =
    std::min(context_->sizeHint().height() + title_height, all - shown - least_below);
  // All three are given: Qt would take part of the room from the field.
  if (dock->height() < wanted)
    resizeDocks({dock, field, below}, {wanted, shown, all - wanted - shown}, Qt::Vertical);
}

/// Docks and operations are about a part: beside the start page they would be empty. The help is
/// about everything and stays as it is.
void main_window::show_docks(bool on) {
  if (std::exchange(docks_shown_, on) == on)
    return;
  auto* help = findChild<QDockWidget*>("help");
  const bool helps = help->isVisible();
  if (on) {
    restoreState(layout_);
    help->setVisible(helps);
  } else {
    layout_ = saveState();
    for (auto* dock : findChildren<QDockWidget*>())
      dock->setVisible(dock == help && helps);
  }
  rail_->setVisible(on);
  // The menu of the bars would bring them back.
  setContextMenuPolicy(on ? Qt::DefaultContextMenu : Qt::NoContextMenu);
}

bool main_window::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize)
    place_overlays();
  return QMainWindow::eventFilter(watched, event);
}

void main_window::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  place_overlays();
}

void main_window::set_dark(bool on) {
  theme_ = make_theme(on);
  settings_.setValue("look", on ? "dark" : "light");
  qApp->setPalette(theme_.palette);
  qApp->setStyleSheet(theme_.style_sheet);
  view_->set_colours(theme_.scene);
  overlay_->set_ink(theme_.ink);
  cube_->set_colours(theme_.cube, theme_.ink);
  banner_->set_theme(theme_);
  truth_->set_theme(theme_);
  welcome_->set_theme(theme_);
  emit theme_changed(theme_);
  for (auto at = actions_.begin(); at != actions_.end(); ++at)
    if (const auto* what = commands_.find(at.key()); what && !what->icon.isEmpty())
      at.value()->setIcon(icon(what->icon, theme_.ink));
}

void main_window::highlight(const QList<qint64>& surfaces) {
  const std::vector<surface_id> ids(surfaces.begin(), surfaces.end());
  selection_.set(ids);
  view_->fit(ids);
}

// -- opening -------------------------------------------------------------------------

void main_window::when_connected(std::function<void()> then) {
  if (link_.current() == remote::state::connected) {
    then();
    return;
  }
  once_connected_ = std::move(then);
  if (link_.current() == remote::state::offline)
    local_.start();
}

/// Meshes are opened with the load cases that came beside them.
void main_window::open_files(const QStringList& files) {
  QString mesh;
  QString recipe;
  QStringList loads;
  for (const auto& file : files) {
    if (!file.endsWith(".json"))
      mesh = mesh.isEmpty() ? file : mesh;
    else if (client::is_recipe(file.toStdString()))
      recipe = file;
    else
      loads << file;
  }
  if (!recipe.isEmpty())
    run_recipe(recipe);
  else if (!mesh.isEmpty())
    open_file(mesh, loads);
  else if (!loads.isEmpty())
    emit part_.failed(
      tr("Open %1").arg(loads.first()),
      {ec::bad_input,
       "this is no recipe: it has no \"steps\"",
       "Give a load case together with its mesh; docs/recipes.md says what a recipe is",
       {}});
}

void main_window::open_file(const QString& mesh, const QStringList& load_cases) {
  log(tr("opening %1").arg(mesh));
  if (mesh.endsWith(".tedit"))
    return open_document_file(mesh);
  if (mesh.endsWith(".json"))
    return run_recipe(mesh);
  when_connected([=, this] { part_.import(mesh, load_cases); });
}

void main_window::restore() {
  const QString name = settings_.value("unfinished").toString();
  if (name.isEmpty())
    return;
  log(tr("the last session was not closed; opening %1 again").arg(name));
  open_document(name);
}

void main_window::open_document(const QString& name) {
  when_connected([=, this] { part_.open(name); });
}

void main_window::connect_to(const server_address& address) {
  part_.close();
  link_.connect_to(address);
}

void main_window::connection_changed() {
  if (link_.current() == remote::state::lost)
    banner_->show_standing(
      tr("The connection to the server is lost. It is taken up again by itself; nothing that was "
         "done is lost."));
  else if (link_.silence_ms() > silent_ms)
    banner_->show_standing(
      tr("The connection is slow: the server has not answered for %1. What was asked for goes on "
         "when it does, and can be cancelled.")
        .arg(duration(1000 * std::floor(link_.silence_ms() / 1000))));
  else if (link_.current() == remote::state::connected)
    banner_->clear_standing();
}

// -- showing -------------------------------------------------------------------------

void main_window::show_part() {
  const auto* head = part_.head();
  if (!head || !head->surface)
    return;
  part_.watch(needs(fields_->wanted().field));
  const auto& preview = context_->preview();
  truth_->set_candidate(preview.shown() != nullptr);
  const auto& refused = preview.refusal();
  view_->mark(refused ? places_of(*refused) : std::vector<surface_id>{});
  view_->set_legend(fields_->wanted());
  view_->show_isolines(fields_->isolines() && !preview.shown());
  if (const auto& shown = preview.shown())
    return view_->show_part({shown->surface, nullptr, 0, shown->before});
  view_->show_part({head->surface, fields_->field(), fields_->deform()});
}

void main_window::show_title() {
  const auto* head = part_.head();
  const QString version = head ? QString("  v%1").arg(head->info.number) : QString();
  const auto title = title_of(part_.name());
  title_->setText(part_.is_open() ? "<b>" + title.words.toHtmlEscaped() + "</b>" + version
                                  : QString("<b>TEdit</b>"));
  title_->setToolTip(part_.is_open() ? tr("Document %1").arg(part_.name()) : QString());
  setWindowTitle(part_.is_open() ? title.words + " - TEdit" : "TEdit");
}

void main_window::show_tooltip(const std::optional<picked_point>& at, QPoint global) {
  if (!at) {
    QToolTip::hideText();
    return;
  }
  QStringList lines{part_.surface_name(at->surface)};
  const auto* head = part_.head();
  if (head && head->surface) {
    const auto& rows = head->surface->surfaces();
    if (const auto row = rows.find(at->surface); row != rows.end())
      lines << tr("area %1").arg(quantity(row->second.area_m2, "m2"));
  }
  lines << part_.acting_on({at->surface});
  const auto& by = view_->current_legend();
  if (const auto value = view_->value_at(*at))
    lines << field_title(by.field) + ": " + field_value(by.field, *value);
  QToolTip::showText(global + QPoint(16, 16), lines.join("\n"), view_);
}

void main_window::show_menu(const std::optional<picked_point>& at, QPoint global) {
  if (at && !selection_.contains(at->surface))
    selection_.click(at->surface, false);
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const auto& what : commands_.all())
    if (what.group == tr("Operation"))
      menu->addAction(action(what.id));
  menu->addSeparator();
  for (const auto* id : {"view.hide", "view.isolate", "view.show_all", "view.fit"})
    menu->addAction(action(id));
  menu->popup(global);
}

void main_window::step_to(std::uint32_t version) {
  const auto* head = part_.head();
  if (head && head->info.number != version && !part_.current_activity())
    part_.go_to(version);
}

QImage main_window::picture(int width, int height) {
  return overlay_->picture(width, height);
}

void main_window::log(const QString& line, log_level level) {
  if (level > log_level_)
    return;
  log_->appendPlainText(QDateTime::currentDateTime().toString("HH:mm:ss.zzz  ") + line);
}

// -- the window ----------------------------------------------------------------------

void main_window::closeEvent(QCloseEvent* event) {
  settings_.setValue("geometry", saveGeometry());
  settings_.setValue("layout", docks_shown_ ? saveState() : layout_);
  settings_.remove("unfinished");
  event->accept();
}

void main_window::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls())
    event->acceptProposedAction();
}

void main_window::dropEvent(QDropEvent* event) {
  QStringList files;
  for (const auto& url : event->mimeData()->urls())
    files << url.toLocalFile();
  open_files(files);
}

}  // namespace tedit::desktop
