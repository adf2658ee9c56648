// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/window/main_window.hpp"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QLabel>
#include <QLayout>
#include <QMenuBar>
#include <QMimeData>
#include <QStackedWidget>
#include <QTimer>
#include <QToolBar>

#include <algorithm>
#include <utility>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/model/document_name.hpp"
#include "client-qt/model/part_size.hpp"
#include "client-qt/model/server_words.hpp"
#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/section/section_bar.hpp"
#include "client-qt/view/view_cube.hpp"
#include "client-qt/widgets/command_palette.hpp"
#include "client-qt/widgets/undo_guard.hpp"
#include "client-qt/widgets/wheel_guard.hpp"
#include "client-qt/window/menus.hpp"

namespace tedit::desktop {

namespace {

constexpr int cube_margin = 12;
constexpr int docks_width = 330;  // Those on the right.
constexpr int widest_banner = 760;
constexpr int narrowest_banner = 320;  // A file's name.
constexpr int below_titles = 70;       // Of a comparison.

}  // namespace

main_window::main_window(const QString& state_folder)
    : settings_("tedit", "tedit-qt"),
      server_(state_folder),
      part_(link_),
      picked_(part_),
      look_(settings_),
      docks_(*this),
      actions_(commands_, settings_, look_, *this) {
  setAcceptDrops(true);
  qApp->installEventFilter(new wheel_guard(this));
  qApp->installEventFilter(new undo_guard(this));
  resize(1440, 900);
  make_view();
  wire_look();
  wire_messages();
  context_.emplace(window_context{*this, settings_, link_, server_, part_, picked_, commands_,
                                  actions_, escapes_, docks_, *operations_, *pages_, *view_,
                                  *overlay_, look_, *banner_, *log_, *truth_});
  tools_.emplace(*context_);
  add_commands();
  lay_out_docks();
  room_.emplace(*context_, *tools_);
  build_bar();
  wire();
  tools_->settings.apply_kept();
  actions_.take_shortcuts();
  tools_->documents.show_recent();
  if (settings_.contains("geometry"))
    restoreGeometry(settings_.value("geometry").toByteArray());
  if (settings_.contains("layout"))
    restoreState(settings_.value("layout").toByteArray());
  show_docks(false);
  show_title();
}

/// Hidden while all of it lives: children that lose the keyboard's focus tell it to what they show.
main_window::~main_window() {
  hide();
}

/// What stands there whatever the tools add.
void main_window::make_view() {
  view_ = new viewport;
  view_->framing().keep_fitted(true);
  view_->installEventFilter(this);
  overlay_ = new overlay(*view_);
  cube_ = new view_cube(*view_);
  pages_ = new QStackedWidget;
  pages_->addWidget(view_);
  setCentralWidget(pages_);
  banner_ = new banner(pages_);
  palette_ = new command_palette(commands_, this);
  log_ = new log_panel;
  truth_ = new truth_line(part_, link_);
  setStatusBar(truth_);
  rail_ = new QToolBar(tr("Operations"));
  rail_->setObjectName("rail");
  rail_->setMovable(false);
  operations_ = new operation_rail;
  operations_->setObjectName("operations");
  rail_->addWidget(operations_);
}

void main_window::add_commands() {
  commands_.add({"file.quit", tr("Quit"), command_groups::file(), "Ctrl+Q", [this] { close(); }});
  commands_.add({"edit.cancel",
                 tr("Cancel what runs"),
                 command_groups::edit(),
                 "Esc",
                 [this] { escapes_.run(); },
                 {},
                 {},
                 "cancel"});
  commands_.add({"help.palette",
                 tr("Search everything"),
                 command_groups::help(),
                 "Ctrl+K",
                 [this] { palette_->open(); },
                 {},
                 tr("All commands and operations"),
                 "search"});
  actions_.make_all();
  fill_menus(*menuBar(), commands_, actions_);
  // In a list Esc leaves the list: what is selected on the part is another matter.
  escapes_.add(ends::list, [this] {
    const auto* focus = QApplication::focusWidget();
    const bool in_list = qobject_cast<const QAbstractItemView*>(focus) && isAncestorOf(focus);
    if (in_list)
      pages_->currentWidget()->setFocus(Qt::OtherFocusReason);
    return in_list;
  });
}

// -- layout --------------------------------------------------------------------------

/// As they are before a person has moved them.
void main_window::lay_out_docks() {
  docks_.add("log", tr("Log"), log_);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  for (const auto* name : {"context", "field", "loads", "receipt"})
    addDockWidget(Qt::RightDockWidgetArea, &docks_.of(name));
  for (const auto* name : {"history", "results", "log", "probes", "print"})
    addDockWidget(Qt::BottomDockWidgetArea, &docks_.of(name));
  addDockWidget(Qt::LeftDockWidgetArea, &docks_.of("help"));
  docks_.of("help").hide();
  docks_.of("print").hide();
  tabifyDockWidget(&docks_.of("loads"), &docks_.of("receipt"));
  tabifyDockWidget(&docks_.of("history"), &docks_.of("results"));
  tabifyDockWidget(&docks_.of("results"), &docks_.of("log"));
  tabifyDockWidget(&docks_.of("log"), &docks_.of("probes"));
  tabifyDockWidget(&docks_.of("probes"), &docks_.of("print"));
  docks_.raise("loads");
  docks_.raise("history");
  resizeDocks({&docks_.of("context"), &docks_.of("field"), &docks_.of("loads")}, {320, 240, 240},
              Qt::Vertical);
  resizeDocks({&docks_.of("context")}, {docks_width}, Qt::Horizontal);
  resizeDocks({&docks_.of("history")}, {190}, Qt::Vertical);
}

void main_window::build_bar() {
  auto* bar = addToolBar(tr("Main"));
  bar->setObjectName("main_bar");
  bar->setMovable(false);
  title_ = new QLabel;
  title_->setObjectName("title");
  title_->setContentsMargins(8, 0, 16, 0);
  bar->addWidget(title_);
  auto* space = new QWidget;
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  for (const auto* id : {"file.open", "edit.undo", "edit.redo", "view.fit", "view.hide",
                         "view.isolate", "view.section", "file.screenshot", "file.export"})
    bar->addAction(actions_.of(id));
  bar->addAction(actions_.of("help.palette"));
  addToolBar(Qt::LeftToolBarArea, rail_);
}

void main_window::place_overlays() {
  overlay_->setGeometry(view_->rect());
  cube_->move(view_->width() - cube_->width() - cube_margin, cube_margin);
  view_->framing().set_corner(cube_->geometry());
  tools_->selecting.place_count(cube_->geometry());
  auto& section = tools_->section.bar();
  const int room = view_->width() - 2 * cube_margin;
  section.resize(std::max(section.sizeHint().width(), std::min(room, widest_banner)),
                 section.sizeHint().height());
  section.move((view_->width() - section.width()) / 2,
               view_->height() - section.height() - cube_margin);
  const int taken = section.isVisible() ? section.height() + cube_margin : 0;
  overlay_->keep_free(taken);
  view_->framing().set_lower_margin(taken);
  place_banner();
}

/// Over the view in its middle, where there is no room for that beside the cube, and below the cube
/// where there is none there either.
void main_window::place_banner() {
  const bool has_cube = pages_->currentWidget() == view_;
  const int all = pages_->width() - 2 * cube_margin;
  const int taken = has_cube ? cube_->width() + cube_margin : 0;
  const bool beside = all - taken >= narrowest_banner;
  const int width = std::min(beside ? all - taken : all, widest_banner);
  const int middle = (pages_->width() - width) / 2;
  const int left =
    beside ? std::min(middle, pages_->width() - cube_margin - taken - width) : middle;
  const int height =
    banner_->hasHeightForWidth() ? banner_->heightForWidth(width) : banner_->sizeHint().height();
  const bool has_titles = !has_cube && !tools_->documents.shows_start_page();
  const int top = has_titles ? below_titles
                  : beside   ? cube_margin
                             : 2 * cube_margin + cube_->height();
  banner_->setGeometry(left, top, width, height);
  banner_->raise();
  // Where both stand one over the other the legend gives way for as long as something is said.
  const bool over_legend = has_cube && banner_->isVisible() && left < overlay_->scale_box().right();
  overlay_->keep_free_above(over_legend ? top + height : 0);
}

/// Docks and operations are about a part: beside the start page they would be empty. The help is
/// about everything and stays as it is.
void main_window::show_docks(bool on) {
  if (std::exchange(docks_shown_, on) == on)
    return;
  auto& help = docks_.of("help");
  const bool helps = help.isVisible();
  if (on) {
    restoreState(layout_);
    if (!settings_.contains("layout"))  // Before they stood on the screen it was a wish.
      resizeDocks({&docks_.of("context")}, {docks_width}, Qt::Horizontal);
    help.setVisible(helps);
  } else {
    layout_ = saveState();
    for (auto* dock : findChildren<QDockWidget*>())
      dock->setVisible(dock == &help && helps);
  }
  rail_->setVisible(on);
  // The menu of the bars would bring them back.
  setContextMenuPolicy(on ? Qt::DefaultContextMenu : Qt::NoContextMenu);
}

/// A window that has not been shown still has the least width of all docks, hidden or not, beside
/// each other: without them it is laid out first.
void main_window::take_size(const QSize& size) {
  setWindowState(windowState() & ~(Qt::WindowMaximized | Qt::WindowFullScreen));
  layout()->activate();
  resize(size);
}

void main_window::show_title() {
  const auto* head = part_.head();
  const QString version = head ? QString("  v%1").arg(head->info.number) : QString();
  const auto title = title_of(part_.name());
  const QString size =
    head && head->surface ? "&nbsp;&nbsp; " + size_of(*head->surface).words() : QString();
  title_->setText(part_.is_open() ? "<b>" + title.words.toHtmlEscaped() + "</b>" + version + size
                                  : QString("<b>TEdit</b>"));
  title_->setToolTip(part_.is_open() ? tr("Document %1").arg(part_.name()) : QString());
  setWindowTitle(part_.is_open() ? title.words + " - TEdit" : "TEdit");
}

// -- wiring --------------------------------------------------------------------------

void main_window::wire() {
  connect(pages_, &QStackedWidget::currentChanged, this, [this] {
    show_docks(!tools_->documents.shows_start_page());
    place_overlays();  // What has to be said stays in front.
  });
  connect(banner_, &banner::changed, this, &main_window::place_overlays);
  connect(&tools_->section.bar(), &section_bar::moved, this, &main_window::place_overlays);
  connect(&tools_->selecting, &selection_tool::hidden_changed, this, &main_window::place_overlays);
  for (auto signal :
       {&document::opened, &document::closed, &document::head_changed, &document::surface_changed})
    connect(&part_, signal, this, &main_window::show_title);
  connect(&part_, &document::renamed, this, &main_window::show_title);
  connect(&part_, &document::begun, banner_, &banner::clear_message);
  connect(&part_, &document::begun, this, [this] { view_->framing().expect_another(); });
  connect(&part_.loads(), &load_requests::changed, &actions_, &command_actions::refresh);
  connect(&part_.foreground(), &foreground_work::changed, &actions_, &command_actions::refresh);
  for (auto signal : {&document::head_changed, &document::closed, &document::opened})
    connect(&part_, signal, &actions_, &command_actions::refresh);
  connect(&picked_, &selection::changed, &actions_, &command_actions::refresh);
}

void main_window::wire_look() {
  connect(&look_, &appearance::changed, this, [this](const theme& look) {
    view_->set_colours(look.scene);
    overlay_->set_ink(look.ink);
    cube_->set_colours(look.cube, look.ink);
    banner_->set_theme(look);
    truth_->set_theme(look);
  });
}

/// What has to be said goes over the view and into the log.
void main_window::wire_messages() {
  connect(&part_, &document::failed, this, [this](const QString& what, const error& reason) {
    log_->write(tr("%1: %2").arg(what, one_line(reason)), log_level::errors);
    if (reason.code != ec::cancelled)
      banner_->show_error(what, reason);
  });
  connect(&part_, &document::notice, this, [this](const QString& text) {
    log_->write(text, log_level::notices);
    banner_->show_news(text);
  });
  connect(&part_, &document::warned, this, [this](const QString& text) {
    log_->write(text, log_level::notices);
    banner_->show_warning(text);
  });
  connect(&part_.files(), &file_requests::exported, this, [this](const QString& path) {
    log_->write(tr("wrote %1").arg(path), log_level::notices);
    banner_->show_news(tr("Wrote %1").arg(path));
  });
}

// -- events --------------------------------------------------------------------------

bool main_window::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize && tools_)
    place_overlays();
  return QMainWindow::eventFilter(watched, event);
}

void main_window::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  place_overlays();
}

void main_window::closeEvent(QCloseEvent* event) {
  settings_.setValue("geometry", saveGeometry());
  settings_.setValue("layout", docks_shown_ ? saveState() : layout_);
  settings_.setValue("docks_by_hand", room_->moved_by_hand());
  tools_->documents.forget_unfinished();
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
  tools_->documents.open_files(files);
}

}  // namespace tedit::desktop
