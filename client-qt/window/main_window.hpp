// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QHash>
#include <QMainWindow>
#include <QPointer>
#include <QSettings>

#include "client-qt/model/commands.hpp"
#include "client-qt/model/document.hpp"
#include "client-qt/model/preferences.hpp"
#include "client-qt/model/selection.hpp"
#include "client-qt/net/local_server.hpp"
#include "client-qt/view/part_geometry.hpp"
#include "client-qt/widgets/theme.hpp"

class QAction;
class QDockWidget;
class QLabel;
class QPlainTextEdit;
class QStackedWidget;
class QToolBar;

namespace tedit::desktop {

class banner;
class command_palette;
class context_panel;
class field_panel;
class history_strip;
class loads_panel;
class overlay;
class probe_panel;
class probes;
class receipt_panel;
class recipe_player;
class recorder;
class section_bar;
class truth_line;
class view_cube;
class viewport;
class welcome_page;
struct example;

/// The window: one part, one flow. It wires the models to the views and owns nothing else.
class main_window : public QMainWindow {
  Q_OBJECT

public:
  /// `state_folder`: where the local server keeps its documents; empty: the usual place.
  explicit main_window(const QString& state_folder = {});
  ~main_window() override;

  /// What a person dropped or chose: a mesh with load cases, a document, or a recipe that is run.
  void open_files(const QStringList& files);
  /// A mesh with load cases, a document file (.tedit) or a recipe.
  void open_file(const QString& mesh, const QStringList& load_cases);
  void open_document(const QString& name);
  /// Opens what was open when the program ended without being closed: after a crash.
  void restore();
  void connect_to(const server_address& address);
  void set_dark(bool on);

  [[nodiscard]] document& part() { return part_; }
  [[nodiscard]] selection& picked() { return selection_; }
  [[nodiscard]] remote& link() { return link_; }
  [[nodiscard]] local_server& server() { return local_; }
  [[nodiscard]] commands& all_commands() { return commands_; }
  [[nodiscard]] viewport& view() { return *view_; }
  [[nodiscard]] overlay& over() { return *overlay_; }
  [[nodiscard]] context_panel& context() { return *context_; }
  [[nodiscard]] field_panel& fields() { return *fields_; }
  [[nodiscard]] banner& messages() { return *banner_; }
  [[nodiscard]] section_bar& section() { return *section_; }
  [[nodiscard]] bool runs_recipe() const;
  [[nodiscard]] recorder& recording() { return *recorder_; }
  [[nodiscard]] probes& pins() { return *probes_; }
  [[nodiscard]] probe_panel& probe_list() { return *probe_list_; }
  /// Surfaces that are not drawn.
  [[nodiscard]] const std::set<surface_id>& hidden() const noexcept { return hidden_; }
  void set_hidden(std::set<surface_id> surfaces);

  /// The view with legend and marks. Width and height 0: as on the screen.
  [[nodiscard]] QImage picture(int width = 0, int height = 0);

signals:
  /// The view shows the head with all that is known of it.
  void settled();
  void theme_changed(const tedit::desktop::theme& look);
  void hidden_changed();

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  // -- main_window.cpp --
  void build_docks();
  void build_toolbars();
  QDockWidget* add_dock(const QString& name, const QString& title, QWidget* content,
                        Qt::DockWidgetArea area);
  void place_overlays();
  void make_room();
  void show_docks(bool on);
  void show_part();
  void show_title();
  void show_tooltip(const std::optional<picked_point>& at, QPoint global);
  void show_menu(const std::optional<picked_point>& at, QPoint global);
  void connection_changed();
  void when_connected(std::function<void()> then);
  void remember(const QString& document);
  void show_recent();
  void take_pictures();
  void keep_picture(const QImage& frame);
  [[nodiscard]] QString picture_file(const QString& document) const;
  void log(const QString& line, log_level level = log_level::everything);
  void step_to(std::uint32_t version);
  void highlight(const QList<qint64>& surfaces);

  // -- main_window_wiring.cpp --
  void wire();
  void wire_connection();
  void wire_document();
  void wire_messages();
  void wire_view();
  void wire_panels();

  // -- main_window_commands.cpp --
  void add_commands();
  void add_view_commands();
  void add_operation_commands();
  void refresh_actions();
  QAction* action(const QString& id);
  void ask_file();
  void ask_server();
  void ask_export();
  void ask_screenshot();

  // -- main_window_tools.cpp --
  void add_tools();
  void before_cancel(std::function<bool()> then);
  void open_document_file(const QString& path);
  void run_recipe(const QString& path);
  void add_load_commands();
  void add_compare();
  void add_settings();
  void apply_preferences(const preferences& wanted);
  void take_shortcuts();
  void add_probes();

  // -- main_window_extras.cpp --
  void add_extras();
  void add_jobs();
  void add_boxes();
  void add_isolines();
  void add_history_words();
  void add_help();
  /// The page of the manual for what is being done, and the heading to begin with.
  [[nodiscard]] std::pair<QString, QString> help_topic() const;
  void add_recording();
  void ask_recording();

  QSettings settings_;
  remote link_;
  local_server local_;
  document part_;
  selection selection_;
  commands commands_;
  theme theme_;
  QHash<QString, QAction*> actions_;
  std::function<void()> once_connected_;
  std::set<surface_id> hidden_;
  std::string thumbnail_due_;  ///< The version whose picture the next frame gives.
  QString pictured_;           ///< Document, version and field of the picture that was kept.
  std::optional<picked_point> last_click_;
  QString local_url_;         ///< Of this computer's server, once it runs.
  bool probing_ = false;      ///< A click sets a probe and picks nothing.
  bool system_dark_ = false;  ///< As it was when the program started.
  bool docks_shown_ = true;
  QByteArray layout_;  ///< Of docks and bars, while they are hidden.
  log_level log_level_ = log_level::everything;

  QStackedWidget* pages_;
  welcome_page* welcome_;
  viewport* view_;
  overlay* overlay_;
  view_cube* cube_;
  banner* banner_;
  section_bar* section_;
  command_palette* palette_;
  context_panel* context_;
  field_panel* fields_;
  loads_panel* loads_;
  receipt_panel* receipt_;
  history_strip* history_;
  truth_line* truth_;
  QPlainTextEdit* log_;
  QToolBar* rail_;
  QToolBar* bar_;
  QLabel* title_;
  probes* probes_ = nullptr;
  probe_panel* probe_list_ = nullptr;
  recorder* recorder_ = nullptr;
  QPointer<recipe_player> recipe_;  ///< The one that runs.
};

}  // namespace tedit::desktop
