// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include <functional>
#include <map>

#include "client-qt/model/catalogue.hpp"

class QFormLayout;

namespace tedit::desktop {

/// The parameters of one operation as a form, made from its description alone: types, units
/// (shown in mm, MPa, degrees), ranges, choices, defaults and help. Plugins that this program has
/// never seen get theirs the same way.
class operation_form : public QWidget {
  Q_OBJECT

public:
  explicit operation_form(const ops::operation_description& about, QWidget* parent = nullptr);

  /// What is typed, in SI units.
  [[nodiscard]] ops::parameters values() const;
  /// Takes values over; those of unknown parameters are passed over.
  void set_values(const ops::parameters& values);
  void reset();
  /// Whether a click on the part can give a parameter its place.
  [[nodiscard]] bool has_place() const;
  /// The first such parameter becomes this, m, to the micrometre; an axis or a plane that stands
  /// instead of it is left out.
  void set_place(const vec3& at);
  /// Whether the next click on the part is meant for a field whose button is down.
  [[nodiscard]] bool picks() const;
  /// That field becomes this place of the part, "surface:12" or "edge:3,7", and its button is up;
  /// what an axis or a plane stands instead of is left out.
  void take_pick(const std::string& place);

signals:
  void changed();
  /// Enter in one of its fields.
  void accepted();

protected:
  /// F1 on a parameter shows its help, Enter accepts.
  bool event(QEvent* event) override;

private:
  struct entry {
    std::function<ops::parameter_value()> get;
    std::function<void(const ops::parameter_value&)> set;
  };

  [[nodiscard]] QWidget* make_field(const ops::parameter_description& parameter);
  [[nodiscard]] QWidget* make_boolean(const ops::parameter_description& parameter);
  [[nodiscard]] QWidget* make_integer(const ops::parameter_description& parameter);
  [[nodiscard]] QWidget* make_real(const ops::parameter_description& parameter);
  [[nodiscard]] QWidget* make_choice(const ops::parameter_description& parameter);
  [[nodiscard]] QWidget* make_text(const ops::parameter_description& parameter);
  [[nodiscard]] QWidget* make_file(const ops::parameter_description& parameter);
  [[nodiscard]] QWidget* make_picked(const ops::parameter_description& parameter);
  [[nodiscard]] QWidget* make_list(const ops::parameter_description& parameter);
  [[nodiscard]] QWidget* make_vector(const ops::parameter_description& parameter);

  ops::operation_description about_;
  std::map<std::string, entry> fields_;
};

}  // namespace tedit::desktop
