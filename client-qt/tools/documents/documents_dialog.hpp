// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDialog>

#include <vector>

#include "client/types.hpp"

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace tedit::desktop {

/// The documents of the server, the latest first: each can be opened, copied, renamed and deleted.
/// What needs a name or a second thought is asked below the list; so is what was refused said
/// there.
class documents_dialog : public QDialog {
  Q_OBJECT

public:
  explicit documents_dialog(QWidget* parent = nullptr);

  /// `here`: the name of the one that this window has open; may be empty.
  void show_documents(std::vector<client::document_info> all, const QString& here);
  /// What was asked for is done; the list comes anew.
  void settle(const QString& words);
  void refuse(const error& why);
  [[nodiscard]] QTreeWidget* list() { return list_; }

signals:
  void list_wanted();
  void open_wanted(const QString& name);
  void copy_wanted(const QString& name, const QString& copy);
  void rename_wanted(const QString& name, const QString& to);
  void delete_wanted(const QString& name);

protected:
  void keyPressEvent(QKeyEvent* event) override;

private:
  enum class question { none, copy, rename, remove };

  [[nodiscard]] QWidget* make_buttons();
  [[nodiscard]] QWidget* make_question();
  [[nodiscard]] QPushButton* add_button(const char* name, const QString& words, QWidget* row);
  [[nodiscard]] QString chosen() const;
  void fill();
  void ask(question what);
  void answer();
  void say(const char* role, const QString& words);
  void open_chosen();
  void refresh_buttons();

  std::vector<client::document_info> all_;
  QString here_;
  question asked_ = question::none;
  QString about_;         ///< Of which document it is asked.
  bool waiting_ = false;  ///< For the server.
  QTreeWidget* list_;
  QLineEdit* letters_;
  QPushButton* open_ = nullptr;
  QPushButton* copy_ = nullptr;
  QPushButton* rename_ = nullptr;
  QPushButton* delete_ = nullptr;
  QWidget* question_row_ = nullptr;
  QLabel* question_words_ = nullptr;
  QLineEdit* name_ = nullptr;
  QPushButton* yes_ = nullptr;
  QLabel* words_;
};

}  // namespace tedit::desktop
