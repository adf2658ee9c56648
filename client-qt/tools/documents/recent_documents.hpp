// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QImage>
#include <QWidget>

#include <optional>
#include <utility>
#include <vector>

class QLabel;
class QListWidget;

namespace tedit::desktop {

/// A document that was open before.
struct recent_document {
  QString name;
  QDateTime used;  ///< When it was opened last; invalid: not known.
  QImage picture;  ///< Of its part; null: none was kept.
};

/// The documents that were open before, each with its picture, name and when it was used. A click
/// or Enter opens one; Delete or the menu takes it from the list, which can be undone until the
/// next one goes. The documents themselves stay where they are.
class recent_documents : public QWidget {
  Q_OBJECT

public:
  explicit recent_documents(QWidget* parent = nullptr);

  /// The latest first.
  void show_documents(std::vector<recent_document> all);
  [[nodiscard]] QStringList names() const;
  [[nodiscard]] QListWidget* list() { return list_; }

signals:
  void document_wanted(const QString& name);
  /// A person took one away, or brought it back.
  void changed(const QStringList& names);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void fill();
  void remove(int row);
  void undo();
  void show_menu(QPoint at);

  std::vector<recent_document> all_;
  std::optional<std::pair<int, recent_document>> removed_;
  QListWidget* list_;
  QWidget* undo_row_;
  QLabel* what_;
};

}  // namespace tedit::desktop
