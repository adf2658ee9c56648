// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/operation_message.hpp"

#include "protocol/json.hpp"
#include "tedit/v1/operation.pb.h"
#include "tedit/v1/session.pb.h"

namespace tedit::protocol {

namespace {

v1::Parameter::Type type_to(ops::parameter_type type) {
  switch (type) {
    case ops::parameter_type::boolean:
      return v1::Parameter::BOOLEAN;
    case ops::parameter_type::integer:
      return v1::Parameter::INTEGER;
    case ops::parameter_type::real:
      return v1::Parameter::REAL;
    case ops::parameter_type::text:
      return v1::Parameter::TEXT;
    case ops::parameter_type::choice:
      return v1::Parameter::CHOICE;
  }
  return v1::Parameter::TYPE_UNSPECIFIED;
}

ops::parameter_type type_from(v1::Parameter::Type type) {
  switch (type) {
    case v1::Parameter::BOOLEAN:
      return ops::parameter_type::boolean;
    case v1::Parameter::INTEGER:
      return ops::parameter_type::integer;
    case v1::Parameter::REAL:
      return ops::parameter_type::real;
    case v1::Parameter::CHOICE:
      return ops::parameter_type::choice;
    default:
      return ops::parameter_type::text;
  }
}

ops::parameter_description from_message(const v1::Parameter& m) {
  ops::parameter_description p;
  p.id = m.id();
  p.name = m.name();
  p.help = m.help();
  p.type = type_from(m.type());
  p.unit = m.unit();
  if (m.has_min())
    p.min = m.min();
  if (m.has_max())
    p.max = m.max();
  p.choices.assign(m.choices().begin(), m.choices().end());
  p.default_value = protocol::from_message(m.default_value());
  p.instead_of = m.instead_of();
  return p;
}

ops::operation_description from_message(const v1::Operation& m) {
  ops::operation_description d;
  d.id = m.id();
  d.name = m.name();
  d.summary = m.summary();
  d.version = m.version();
  d.selection = {m.selection_help(), m.selection_minimum(), m.selection_maximum()};
  for (const auto& p : m.parameters())
    d.parameters.push_back(from_message(p));
  return d;
}

struct value_writer {
  v1::ParameterValue* out;

  void operator()(bool value) const { out->set_boolean(value); }
  void operator()(std::int64_t value) const { out->set_integer(value); }
  void operator()(double value) const { out->set_real(value); }
  void operator()(const std::string& value) const { out->set_text(value); }
};

}  // namespace

void to_message(const ops::parameter_value& value, v1::ParameterValue* out) {
  std::visit(value_writer{out}, value);
}

ops::parameter_value from_message(const v1::ParameterValue& message) {
  switch (message.kind_case()) {
    case v1::ParameterValue::kBoolean:
      return message.boolean();
    case v1::ParameterValue::kInteger:
      return std::int64_t{message.integer()};
    case v1::ParameterValue::kReal:
      return message.real();
    default:
      return message.text();
  }
}

void to_message(const ops::operation_description& description, const std::string& plugin,
                v1::Operation* out) {
  out->set_id(description.id);
  out->set_name(description.name);
  out->set_summary(description.summary);
  out->set_version(description.version);
  out->set_plugin(plugin);
  out->set_selection_help(description.selection.help);
  out->set_selection_minimum(static_cast<std::uint32_t>(description.selection.minimum));
  out->set_selection_maximum(static_cast<std::uint32_t>(description.selection.maximum));
  for (const auto& p : description.parameters) {
    auto* row = out->add_parameters();
    row->set_id(p.id);
    row->set_name(p.name);
    row->set_help(p.help);
    row->set_type(type_to(p.type));
    row->set_unit(p.unit);
    if (p.min)
      row->set_min(*p.min);
    if (p.max)
      row->set_max(*p.max);
    row->mutable_choices()->Assign(p.choices.begin(), p.choices.end());
    to_message(p.default_value, row->mutable_default_value());
    row->set_instead_of(p.instead_of);
  }
}

std::string parameters_to_json(const ops::parameters& values) {
  v1::ApplyEdit message;
  for (const auto& [name, value] : values)
    to_message(value, &(*message.mutable_parameters())[name]);
  return message_to_json(message);
}

expected<ops::parameters> parameters_from_json(const std::string& json) {
  const auto message = message_from_json<v1::ApplyEdit>(json);
  if (!message)
    return fail(message.error());
  ops::parameters values;
  for (const auto& [name, value] : message->parameters())
    values[name] = from_message(value);
  return values;
}

std::string catalogue_to_json(
  const std::vector<std::pair<ops::operation_description, std::string>>& operations,
  const std::vector<std::pair<std::string, std::string>>& refused) {
  v1::Catalogue message;
  for (const auto& [description, plugin] : operations)
    to_message(description, plugin, message.add_operations());
  for (const auto& [file, reason] : refused) {
    auto* row = message.add_refused();
    row->set_file(file);
    row->set_reason(reason);
  }
  return message_to_json(message);
}

expected<std::vector<std::pair<ops::operation_description, std::string>>> catalogue_from_json(
  const std::string& json) {
  const auto message = message_from_json<v1::Catalogue>(json);
  if (!message)
    return fail(message.error());
  std::vector<std::pair<ops::operation_description, std::string>> result;
  for (const auto& row : message->operations())
    result.emplace_back(from_message(row), row.plugin());
  return result;
}

}  // namespace tedit::protocol
