// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/operations/operation_form.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSpinBox>
#include <QWhatsThis>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "client-qt/model/operation_words.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/model/typed_quantity.hpp"
#include "client-qt/tools/operations/file_field.hpp"
#include "client-qt/tools/operations/number_fields.hpp"

namespace tedit::desktop {

namespace {

struct operation_form_phrases {
  Q_DECLARE_TR_FUNCTIONS(operation_form)
};

/// A spin box for numbers of any size: as many decimals as the value needs. A point and a comma are
/// both taken for the decimal point, and any unit of the quantity: "1/4 in".
class number_box : public QDoubleSpinBox {
public:
  explicit number_box(QString si_unit) : si_unit_(std::move(si_unit)) {
    const auto unit = shown_as(si_unit_).name;
    if (!unit.isEmpty())
      setSuffix(" " + unit);
  }

  [[nodiscard]] QString textFromValue(double value) const override {
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    return plain.toString(value, 'g', 8);
  }

  [[nodiscard]] double valueFromText(const QString& typed) const override {
    return shown(typed).value_or(value());
  }

  /// What is no number yet may become one; what is out of range is put right when it is left.
  /// Behind a unit that is typed the field's own does not stand.
  [[nodiscard]] QValidator::State validate(QString& typed, int&) const override {
    static const QRegularExpression unit(QString::fromUtf8(R"([\p{L}µ°%"](?<![eE]))"));
    if (!suffix().isEmpty() && typed.endsWith(suffix()) &&
        typed.chopped(suffix().size()).contains(unit))
      typed.chop(suffix().size());
    const auto number = shown(typed);
    if (number)
      return *number >= minimum() && *number <= maximum() ? QValidator::Acceptable
                                                          : QValidator::Intermediate;
    static const QRegularExpression possible(
      QString::fromUtf8(R"(^[-+−\d\s.,/eE]*[\p{L}µ°%"²³·/\d\s]*$)"));
    return possible.match(typed).hasMatch() ? QValidator::Intermediate : QValidator::Invalid;
  }

private:
  /// In the unit that is shown.
  [[nodiscard]] std::optional<double> shown(QString typed) const {
    // Behind a typed unit the own one may still stand.
    if (!suffix().isEmpty() && typed.endsWith(suffix()))
      typed.chop(suffix().size());
    const auto si = read_quantity(typed, si_unit_);
    return si ? std::optional(*si * shown_as(si_unit_).scale) : std::nullopt;
  }

  QString si_unit_;
};

QString text(const std::string& words) {
  return QString::fromStdString(words);
}

/// Name, help, range and default of a parameter.
QString what_it_is(const ops::parameter_description& parameter) {
  QString result = "<b>" + text(parameter.name).toHtmlEscaped() + "</b><br>" +
                   text(parameter.help).toHtmlEscaped();
  const bool counts = parameter.type == ops::parameter_type::polyline;
  const QString unit = counts ? QString() : text(parameter.unit);
  if (parameter.min && parameter.max)
    result += "<br>" + operation_form_phrases::tr("From %1 to %2")
                         .arg(quantity(*parameter.min, unit), quantity(*parameter.max, unit));
  else if (parameter.min)
    result +=
      "<br>" + operation_form_phrases::tr("At least %1").arg(quantity(*parameter.min, unit));
  else if (parameter.max)
    result += "<br>" + operation_form_phrases::tr("At most %1").arg(quantity(*parameter.max, unit));
  if (const auto* value = std::get_if<double>(&parameter.default_value))
    result += "<br>" + operation_form_phrases::tr("Usually %1").arg(quantity(*value, unit));
  return result;
}

/// Stands instead of a place and a direction: of the two ways to say it the last one counts.
bool is_whole_place(const ops::parameter_description& parameter) {
  return parameter.type == ops::parameter_type::axis ||
         parameter.type == ops::parameter_type::plane;
}

bool is_part_of_place(const ops::parameter_description& parameter) {
  return (parameter.type == ops::parameter_type::point ||
          parameter.type == ops::parameter_type::direction) &&
         parameter.default_value == ops::parameter_value(std::string());
}

QString vector_hint(ops::parameter_type type, const QString& unit) {
  if (type == ops::parameter_type::point)
    return operation_form_phrases::tr("click the part, or x; y; z in %1").arg(unit);
  if (type == ops::parameter_type::vector)
    return operation_form_phrases::tr("x; y; z in %1").arg(unit);
  return operation_form_phrases::tr("x; y; z, or empty: by the wall");
}

}  // namespace

operation_form::operation_form(const ops::operation_description& about, QWidget* parent)
    : QWidget(parent), about_(about) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  for (const auto& parameter : about_.parameters) {
    auto* widget = make_field(parameter);
    widget->setObjectName(text(parameter.id));
    widget->setToolTip(text(parameter.help));
    widget->setWhatsThis(what_it_is(parameter));
    widget->setAccessibleName(text(parameter.name));
    widget->setAccessibleDescription(text(parameter.help));
    if (parameter.type == ops::parameter_type::boolean) {
      form->addRow(widget);
    } else {
      auto* label = new QLabel(text(parameter.name));
      label->setToolTip(text(parameter.help));
      label->setBuddy(widget);
      form->addRow(label, widget);
    }
  }
  if (!about_.parameters.empty())
    setFocusProxy(findChild<QWidget*>(text(about_.parameters.front().id)));
  reset();
}

bool operation_form::event(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
    return QWidget::event(event);
  auto* field = focusWidget();
  while (field && field != this && field->whatsThis().isEmpty())
    field = field->parentWidget();
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
  if (enter && event->type() == QEvent::KeyPress && !(key->modifiers() & ~Qt::KeypadModifier)) {
    emit accepted();
    return true;
  }
  if (key->key() != Qt::Key_F1 || !field || field == this)
    return QWidget::event(event);
  event->accept();  // Else it would be the window's shortcut.
  if (event->type() == QEvent::KeyPress)
    QWhatsThis::showText(field->mapToGlobal(field->rect().bottomLeft()), field->whatsThis(), field);
  return true;
}

QWidget* operation_form::make_field(const ops::parameter_description& parameter) {
  switch (parameter.type) {
    case ops::parameter_type::boolean:
      return make_boolean(parameter);
    case ops::parameter_type::integer:
      return make_integer(parameter);
    case ops::parameter_type::real:
      return make_real(parameter);
    case ops::parameter_type::choice:
      return make_choice(parameter);
    case ops::parameter_type::point:
    case ops::parameter_type::direction:
    case ops::parameter_type::vector:
      return make_vector(parameter);
    case ops::parameter_type::file:
      return make_file(parameter);
    case ops::parameter_type::axis:
    case ops::parameter_type::plane:
    case ops::parameter_type::polyline:
      return make_picked(parameter);
    case ops::parameter_type::list:
      return make_list(parameter);
    default:
      return make_text(parameter);
  }
}

QWidget* operation_form::make_boolean(const ops::parameter_description& parameter) {
  auto* box = new QCheckBox(text(parameter.name));
  connect(box, &QCheckBox::toggled, this, &operation_form::changed);
  fields_[parameter.id] = {[box] { return ops::parameter_value(box->isChecked()); },
                           [box](const ops::parameter_value& v) {
                             if (const auto* on = std::get_if<bool>(&v))
                               box->setChecked(*on);
                           }};
  return box;
}

QWidget* operation_form::make_integer(const ops::parameter_description& parameter) {
  auto* box = new QSpinBox;
  const auto limit = [](std::optional<double> given, int otherwise) {
    return given ? static_cast<int>(std::clamp(*given, -2e9, 2e9)) : otherwise;
  };
  box->setRange(limit(parameter.min, std::numeric_limits<int>::min()),
                limit(parameter.max, std::numeric_limits<int>::max()));
  connect(box, &QSpinBox::valueChanged, this, &operation_form::changed);
  fields_[parameter.id] = {
    [box] { return ops::parameter_value(static_cast<std::int64_t>(box->value())); },
    [box](const ops::parameter_value& v) {
      if (const auto* n = std::get_if<std::int64_t>(&v))
        box->setValue(static_cast<int>(*n));
    }};
  return box;
}

QWidget* operation_form::make_real(const ops::parameter_description& parameter) {
  const auto unit = shown_as(text(parameter.unit));
  auto* box = new number_box(text(parameter.unit));
  box->setDecimals(9);
  box->setRange(parameter.min ? *parameter.min * unit.scale : -1e12,
                parameter.max ? *parameter.max * unit.scale : 1e12);
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  connect(box, &QDoubleSpinBox::valueChanged, this, &operation_form::changed);
  fields_[parameter.id] = {
    [box, scale = unit.scale] { return ops::parameter_value(box->value() / scale); },
    [box, scale = unit.scale](const ops::parameter_value& v) {
      if (const auto* x = std::get_if<double>(&v))
        box->setValue(*x * scale);
    }};
  return box;
}

QWidget* operation_form::make_choice(const ops::parameter_description& parameter) {
  auto* box = new QComboBox;
  for (const auto& choice : parameter.choices)
    box->addItem(choice_words(choice), text(choice));
  connect(box, &QComboBox::currentIndexChanged, this, &operation_form::changed);
  fields_[parameter.id] = {
    [box] { return ops::parameter_value(box->currentData().toString().toStdString()); },
    [box](const ops::parameter_value& v) {
      if (const auto* s = std::get_if<std::string>(&v))
        box->setCurrentIndex(box->findData(text(*s)));
    }};
  return box;
}

QWidget* operation_form::make_text(const ops::parameter_description& parameter) {
  auto* box = new QLineEdit;
  connect(box, &QLineEdit::textChanged, this, &operation_form::changed);
  fields_[parameter.id] = {[box] { return ops::parameter_value(box->text().toStdString()); },
                           [box](const ops::parameter_value& v) {
                             if (const auto* s = std::get_if<std::string>(&v))
                               box->setText(text(*s));
                           }};
  return box;
}

/// Three numbers, those of a point or a vector in the unit that lengths are shown in. What cannot
/// be read goes on as it is: the host says what is wrong with it.
QWidget* operation_form::make_vector(const ops::parameter_description& parameter) {
  auto* box = new QLineEdit;
  const QString unit = text(parameter.unit);
  const QString shown = shown_as(unit).name;
  box->setPlaceholderText(vector_hint(parameter.type, shown));
  connect(box, &QLineEdit::textChanged, this, &operation_form::changed);
  fields_[parameter.id] = {
    [box, unit] { return ops::parameter_value(read_vector(box->text(), unit)); },
    [box, unit](const ops::parameter_value& v) {
      if (const auto* s = std::get_if<std::string>(&v))
        box->setText(numbers_shown(*s, unit));
    }};
  return box;
}

QWidget* operation_form::make_picked(const ops::parameter_description& parameter) {
  picked_field* field = nullptr;
  if (parameter.type == ops::parameter_type::polyline)
    field = new polyline_field(text(parameter.unit));
  else
    field = new axis_field(parameter.type, text(parameter.unit));
  connect(field, &picked_field::changed, this, &operation_form::changed);
  connect(field, &picked_field::pick_wanted, this, [this, field] {
    for (auto* other : findChildren<picked_field*>())
      if (other != field)
        other->stop_picking();
  });
  fields_[parameter.id] = {[field] { return ops::parameter_value(field->value()); },
                           [field](const ops::parameter_value& v) {
                             if (const auto* s = std::get_if<std::string>(&v))
                               field->set_value(*s);
                           }};
  return field;
}

QWidget* operation_form::make_list(const ops::parameter_description& parameter) {
  auto* box = new QLineEdit;
  const QString unit = text(parameter.unit);
  const QString shown = shown_as(unit).name;
  box->setPlaceholderText(shown.isEmpty()
                            ? operation_form_phrases::tr("numbers, between semicolons")
                            : operation_form_phrases::tr("in %1, between semicolons").arg(shown));
  connect(box, &QLineEdit::textChanged, this, &operation_form::changed);
  fields_[parameter.id] = {
    [box, unit] { return ops::parameter_value(read_list(box->text(), unit)); },
    [box, unit](const ops::parameter_value& v) {
      if (const auto* s = std::get_if<std::string>(&v))
        box->setText(numbers_shown(*s, unit));
    }};
  return box;
}

QWidget* operation_form::make_file(const ops::parameter_description& parameter) {
  auto* field = new file_field(parameter.choices);
  connect(field, &file_field::changed, this, &operation_form::changed);
  fields_[parameter.id] = {[field] { return ops::parameter_value(field->content()); },
                           [field](const ops::parameter_value& v) {
                             if (const auto* s = std::get_if<std::string>(&v))
                               field->set_content(*s);
                           }};
  return field;
}

ops::parameters operation_form::values() const {
  ops::parameters result;
  for (const auto& [id, one] : fields_)
    result[id] = one.get();
  return result;
}

void operation_form::set_values(const ops::parameters& values) {
  // As the server reads a request: what a given number stands in for is 0, not its default.
  for (const auto& parameter : about_.parameters)
    if (values.contains(parameter.id) && !parameter.instead_of.empty() &&
        !values.contains(parameter.instead_of))
      if (const auto other = fields_.find(parameter.instead_of); other != fields_.end())
        other->second.set(0.0);
  for (const auto& [id, value] : values)
    if (const auto found = fields_.find(id); found != fields_.end())
      found->second.set(value);
}

bool operation_form::has_place() const {
  return std::ranges::count(about_.parameters, ops::parameter_type::point,
                            &ops::parameter_description::type) > 0;
}

void operation_form::set_place(const vec3& at) {
  const auto place = std::ranges::find(about_.parameters, ops::parameter_type::point,
                                       &ops::parameter_description::type);
  if (place == about_.parameters.end())
    return;
  for (const auto& other : about_.parameters)
    if (is_whole_place(other))
      fields_.at(other.id).set(other.default_value);
  QStringList numbers;
  for (const double x : {at.x, at.y, at.z})
    numbers.append(QString::number(1e-6 * std::round(1e6 * x), 'g', 12));
  fields_.at(place->id).set(numbers.join(", ").toStdString());
}

bool operation_form::picks() const {
  return std::ranges::any_of(findChildren<picked_field*>(), &picked_field::picks);
}

void operation_form::take_pick(const std::string& place) {
  for (const auto& parameter : about_.parameters) {
    auto* field = findChild<picked_field*>(text(parameter.id));
    if (!field || !field->picks())
      continue;
    field->stop_picking();
    for (const auto& other : about_.parameters)
      if (is_whole_place(parameter) && is_part_of_place(other))
        fields_.at(other.id).set(other.default_value);
    field->set_value(place);
  }
}

void operation_form::reset() {
  for (const auto& parameter : about_.parameters)
    fields_[parameter.id].set(parameter.default_value);
}

}  // namespace tedit::desktop
