// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDialog>

#include <vector>

namespace tedit::desktop {

/// A library that the program is built with.
struct used_library {
  QString name;
  QString version;  ///< That runs or was built with; may be empty.
  QString licence;
  QString purpose;
};

[[nodiscard]] std::vector<used_library> used_libraries();

/// Version, licence, and the libraries with theirs.
class about_dialog : public QDialog {
  Q_OBJECT

public:
  explicit about_dialog(QWidget* parent = nullptr);
};

}  // namespace tedit::desktop
