// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QSettings>

#include <optional>

#include "client-qt/context/window_context.hpp"
#include "client-qt/tools/toolbox.hpp"
#include "client-qt/window/dock_room.hpp"

class QLabel;

namespace tedit::desktop {

class command_palette;
class view_cube;

/// The window: one part, one flow. It makes the view and what stands round it, hands them to the
/// tools, and lays out what these put there. What can be done is the tools' matter.
class main_window : public QMainWindow {
  Q_OBJECT

public:
  /// `state_folder`: where the local server keeps its documents; empty: the usual place.
  explicit main_window(const QString& state_folder = {});
  ~main_window() override;

  [[nodiscard]] window_context& context() { return *context_; }
  [[nodiscard]] toolbox& tools() { return *tools_; }
  /// Of the window alone, also where it was as large as the screen when it was closed last.
  void take_size(const QSize& size);

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void make_view();
  void add_commands();
  void lay_out_docks();
  void build_bar();
  void wire();
  void wire_look();
  void wire_messages();
  void place_overlays();
  void place_banner();
  void show_docks(bool on);
  void show_title();

  QSettings settings_;
  remote link_;
  local_server server_;
  document part_;
  selection picked_;
  commands commands_;
  appearance look_;
  escapes escapes_;
  docks docks_;
  command_actions actions_;
  QStackedWidget* pages_;
  viewport* view_;
  overlay* overlay_;
  view_cube* cube_;
  banner* banner_;
  log_panel* log_;
  truth_line* truth_;
  QToolBar* rail_;
  operation_rail* operations_;  ///< In it.
  command_palette* palette_;
  QLabel* title_;
  std::optional<window_context> context_;
  std::optional<toolbox> tools_;
  std::optional<dock_room> room_;
  bool docks_shown_ = true;
  QByteArray layout_;  ///< Of docks and bars, while they are hidden.
};

}  // namespace tedit::desktop
