// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDialog>

#include <vector>

#include "client-qt/model/preferences.hpp"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace tedit::desktop {

/// What a person sets once for all parts, found by a few letters. It blocks nothing; every change
/// holds at once.
class settings_dialog : public QDialog {
  Q_OBJECT

public:
  explicit settings_dialog(const preferences& now, QWidget* parent = nullptr);

  [[nodiscard]] preferences values() const;

signals:
  void changed(const tedit::desktop::preferences& wanted);

private:
  /// A line of the form and the words by which it is found.
  struct entry {
    QWidget* label;
    QWidget* field;
    QString words;
  };

  [[nodiscard]] QFormLayout* section(const QString& title);
  void add(QFormLayout* form, const QString& title, QWidget* field, const QString& help);
  void build_language(QFormLayout* form, const preferences& now);
  void build_solver(const preferences& now);
  void build_legend(const preferences& now);
  void search(const QString& letters);

  std::vector<entry> entries_;
  std::vector<QWidget*> sections_;
  QWidget* content_;
  QLabel* nothing_;
  QComboBox* look_;
  QComboBox* turning_;
  QComboBox* language_;
  QComboBox* device_;
  QComboBox* order_;
  QDoubleSpinBox* tolerance_;
  QComboBox* map_;
  QComboBox* range_;
  QCheckBox* logarithmic_;
  QComboBox* log_;
};

}  // namespace tedit::desktop
