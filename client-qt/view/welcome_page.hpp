// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include "client-qt/view/theme.hpp"

class QVBoxLayout;

namespace tedit::desktop {

/// A shipped part with its load case.
struct example {
  QString title;
  QString story;  ///< One sentence: what to try with it.
  QString mesh;
  QStringList load_cases;
};

/// The examples that came with the program; none when their folder is not there.
[[nodiscard]] std::vector<example> shipped_examples();

/// What is seen before a part is open: examples, recent documents, open, connect.
class welcome_page : public QWidget {
  Q_OBJECT

public:
  explicit welcome_page(QWidget* parent = nullptr);

  /// Names of documents on this computer, the latest first.
  void set_recent(const QStringList& documents);
  void set_theme(const theme& look);

signals:
  void example_wanted(const tedit::desktop::example& which);
  void document_wanted(const QString& name);
  void file_wanted();
  void server_wanted();

private:
  QVBoxLayout* recent_;
  QWidget* recent_box_;
};

}  // namespace tedit::desktop
