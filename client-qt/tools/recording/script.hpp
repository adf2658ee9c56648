// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QObject>
#include <QTimer>

#include "base/error.hpp"

namespace tedit::desktop {

struct toolbox;
struct window_context;

/// Carries out steps in a window without a person: for pictures, tests and bug reports. Each step
/// is a JSON object with one of these keys:
///
/// - "click": id; a real click on the surface where it is visible
/// - "select": [ids]; these surfaces
/// - "choose": operation; opens its form
/// - "apply": operation, "parameters": {...} in SI units; on the selection
/// - "drag": steps; turns the view by as many mouse moves, one each time the loop is idle
/// - "undo" | "redo": true, "go_to": version number
/// - "command": id; any command of the palette
/// - "field": id, "case": load case or "" for the envelope, "deform": factor, "bands": count,
///   "isolines": bool; what is drawn
/// - "view": front|...|isometric, "camera": {"position", "focus", "up", "scale", "parallel"}
/// - "section": {"at", "normal"} or null
/// - "box": [left, top, width, height] in parts of the view, "enclosed": bool
/// - "hidden": [ids]; that are not drawn
/// - "load_case": {...} as in its files, replaces the one of its name; "remove_load_case": name
/// - "probe": {"number", "surface", "at"}, "remove_probe": number, "measure": [numbers] of the two
///   probes whose distance is said
/// - "wait": "ready" | "final"; until nothing runs, until the field is converged
/// - "report": file, .pdf or .html
/// - "screenshot": file, "width", "height"; "window": true takes the whole window
///
/// Every step first waits for what runs. The first that fails ends the script, and so does anything
/// that fails in the window once it has started.
class script : public QObject {
  Q_OBJECT

public:
  script(window_context& in, toolbox& tools, QJsonArray steps, QObject* parent = nullptr);

  /// Seconds that one step may wait.
  void set_patience(int seconds) { patience_s_ = seconds; }
  /// Nothing is opened from outside: steps do not wait for a part while there is none.
  void set_alone(bool on) { alone_ = on; }
  void start();

signals:
  void finished();
  void failed(const tedit::error& reason);

private:
  void next();
  /// Whether the screen has what every view shows.
  [[nodiscard]] bool is_all_seen() const;
  [[nodiscard]] bool ready_for(const QJsonObject& step) const;
  void carry_out(const QJsonObject& step);
  [[nodiscard]] expected<void> perform(const QJsonObject& step);
  /// Steps that say how the part is looked at; false: it is none of them.
  [[nodiscard]] bool look(const QJsonObject& step);
  [[nodiscard]] expected<void> set_load_case(const QJsonObject& loads);
  [[nodiscard]] expected<void> put_probe(const QJsonObject& probe);
  [[nodiscard]] expected<void> click(qint64 surface);
  void drag_on();
  [[nodiscard]] expected<void> apply(const QJsonObject& step);
  [[nodiscard]] expected<void> take_picture(const QJsonObject& step);
  void stop(const error& reason);

  window_context& in_;
  toolbox& tools_;
  QJsonArray steps_;
  int at_ = 0;
  int drags_left_ = 0;
  int patience_s_ = 300;
  int waited_ms_ = 0;
  QTimer poll_;
  bool done_ = false;
  bool alone_ = false;
};

/// Reads the steps of a file. Errors: `io_error`, `bad_input` with the place.
[[nodiscard]] expected<QJsonArray> read_script(const QString& path);

}  // namespace tedit::desktop
