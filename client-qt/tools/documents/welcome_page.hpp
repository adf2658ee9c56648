// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include "client-qt/model/document.hpp"
#include "client-qt/widgets/theme.hpp"

class QLabel;
class QProgressBar;
class QPushButton;

namespace tedit::desktop {

class recent_documents;
struct recent_document;

/// A shipped part with its load case.
struct example {
  QString title;
  QString story;  ///< One sentence: what to try with it.
  QString mesh;
  QStringList load_cases;
  QString picture;  ///< A file.
};

/// The examples that came with the program; none when their folder is not there.
[[nodiscard]] std::vector<example> shipped_examples();

/// What is seen before a part is open: examples, recent documents, open, connect.
class welcome_page : public QWidget {
  Q_OBJECT

public:
  explicit welcome_page(QWidget* parent = nullptr);

  /// Names of documents on this computer, the latest first.
  void set_recent(std::vector<recent_document> documents);
  void set_theme(const theme& look);
  /// What is being opened; nothing: none.
  void show_activity(const std::optional<activity>& now);

signals:
  void example_wanted(const tedit::desktop::example& which);
  void document_wanted(const QString& name);
  void file_wanted();
  void server_wanted();
  void tour_wanted();
  void cancel_wanted();  ///< Of what is being opened.
  /// Documents were taken from the list, or brought back.
  void recent_changed(const QStringList& names);

private:
  [[nodiscard]] QWidget* make_activity();

  QWidget* running_;
  QLabel* stage_;
  QProgressBar* fraction_;
  QPushButton* cancel_;
  recent_documents* recent_;
};

}  // namespace tedit::desktop
