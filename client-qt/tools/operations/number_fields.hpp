// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include <string>

#include "ops/sdk/operation.hpp"

class QLineEdit;
class QPlainTextEdit;
class QToolButton;

/// Fields for what is several numbers: as people type them, in the unit that is shown, and as the
/// host reads them, in SI. What cannot be read goes on as it is: the host says what is wrong.
namespace tedit::desktop {

/// Three numbers between semicolons, commas with blanks, blanks, or commas: "10; 20 mm; 1/4 in".
[[nodiscard]] std::string read_vector(const QString& typed, const QString& si_unit);
/// Any number of them; between commas alone where there are at least two of these.
[[nodiscard]] std::string read_list(const QString& typed, const QString& si_unit);
/// The host's numbers, in the unit that is shown and as the locale writes them: "10; 20; 6.35".
[[nodiscard]] QString numbers_shown(const std::string& host, const QString& si_unit);

/// A field that may also be picked in the view: "surface:12", "edge:3,7".
class picked_field : public QWidget {
  Q_OBJECT

public:
  using QWidget::QWidget;

  [[nodiscard]] virtual std::string value() const = 0;
  virtual void set_value(const std::string& host) = 0;
  /// Whether the next click on the part is meant for it.
  [[nodiscard]] bool picks() const;
  void stop_picking();

signals:
  void changed();
  /// The next click is meant for it from now on.
  void pick_wanted();

protected:
  [[nodiscard]] QToolButton* make_pick(const QString& help);

private:
  QToolButton* pick_ = nullptr;
};

/// A point and a direction, a field each: of an axis, or of a plane, whose direction is its normal.
class axis_field : public picked_field {
  Q_OBJECT

public:
  axis_field(ops::parameter_type type, QString si_unit, QWidget* parent = nullptr);

  [[nodiscard]] std::string value() const override;
  void set_value(const std::string& host) override;

private:
  QString si_unit_;
  QLineEdit* point_;
  QLineEdit* direction_;
};

/// Points, one in a line.
class polyline_field : public picked_field {
  Q_OBJECT

public:
  explicit polyline_field(QString si_unit, QWidget* parent = nullptr);

  [[nodiscard]] std::string value() const override;
  void set_value(const std::string& host) override;

private:
  QString si_unit_;
  QPlainTextEdit* points_;
};

}  // namespace tedit::desktop
