// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QTimer>

#include "base/error.hpp"
#include "client-qt/widgets/theme.hpp"

class QLabel;
class QPushButton;

namespace tedit::desktop {

/// A message over the view that blocks nothing: what happened, why, and what to do. Errors stay
/// until they are closed; news goes by itself. What lasts (a lost connection) stands above both.
class banner : public QFrame {
  Q_OBJECT

public:
  explicit banner(QWidget* parent = nullptr);

  void set_theme(const theme& look);
  /// What was tried and why it failed; surfaces that the error names can be shown.
  void show_error(const QString& what, const error& reason);
  /// A line more to the error that is shown; news where there is none.
  void add_to_error(const QString& text);
  void show_news(const QString& text);
  /// What a person should know before going on; stays longer than news.
  void show_warning(const QString& text);
  /// Stays until `clear_standing`, also beside an error: a connection that is lost.
  void show_standing(const QString& text);
  void clear_standing();
  /// What was said of a part that is closed now; what stands stays.
  void clear_message();
  /// All that it says, also what is elided for want of room; empty while it is hidden.
  [[nodiscard]] QString text() const;

signals:
  void changed();  ///< It needs more or less room.
  void place_wanted(const QList<qint64>& surfaces);

protected:
  bool event(QEvent* event) override;

private:
  void paint_bar();
  void fit_words();
  void show_for(int ms, const QString& text, const QColor& bar);
  void present(const QString& title, const QString& body, const QColor& bar);
  [[nodiscard]] bool has_message() const;
  void drop_message();

  QLabel* standing_;
  QLabel* title_;
  QLabel* body_;
  QString title_words_;  ///< As they are, whatever there is room for.
  QString body_words_;
  QPushButton* place_;
  QList<qint64> surfaces_;
  QColor bar_;
  QTimer away_;
  theme look_;
  bool stands_ = false;
};

/// Cause, place and remedy in lines.
[[nodiscard]] QString explained(const error& reason);

/// The words with each one elided in its middle that no line of this many pixels takes: a label
/// cannot break it, and would lose the lines that follow.
[[nodiscard]] QString fitted(const QString& words, const QFontMetrics& by, int width);

/// The surfaces that a sentence names: "surface 12", "surfaces 15, 91".
[[nodiscard]] QList<qint64> surfaces_in(const QString& text);

}  // namespace tedit::desktop
