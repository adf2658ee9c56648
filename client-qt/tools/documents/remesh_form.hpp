// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDialog>

#include <map>
#include <string>

#include "client-qt/model/file_requests.hpp"

class QComboBox;
class QDoubleSpinBox;

namespace tedit::desktop {

/// Asks how fine a CAD file shall be meshed once more, and how long edges may be on surfaces that
/// are picked.
class remesh_form : public QDialog {
  Q_OBJECT

public:
  /// `names`: those of the picked surfaces by their numbers.
  remesh_form(const imported_file& from, std::map<std::string, QString> names, QWidget* parent);

  /// The file with the sizes that are asked for. Surfaces that had sizes before keep them, unless
  /// they are picked.
  [[nodiscard]] imported_file wanted() const;

private:
  void build();

  imported_file from_;
  std::map<std::string, QString> names_;
  QComboBox* fineness_;
  QDoubleSpinBox* length_;  ///< mm; 0: as elsewhere.
};

}  // namespace tedit::desktop
