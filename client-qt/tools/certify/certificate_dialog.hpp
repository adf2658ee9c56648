// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDialog>

#include "client-qt/model/server_tables.hpp"
#include "client-qt/net/certification.hpp"

namespace tedit::desktop {

/// "CalculiX 2.20 agrees on all 3 load cases of version 5."
[[nodiscard]] QString verdict_of(const certificate& what);

/// Its load cases with their differences, a row each.
[[nodiscard]] word_table table_of(const certificate& what);

/// What CalculiX made of the part. It deletes itself when it is closed.
class certificate_dialog : public QDialog {
  Q_OBJECT

public:
  explicit certificate_dialog(const certificate& what, QWidget* parent = nullptr);

private:
  [[nodiscard]] QWidget* make_table() const;
  [[nodiscard]] QWidget* make_buttons();

  certificate what_;
};

}  // namespace tedit::desktop
