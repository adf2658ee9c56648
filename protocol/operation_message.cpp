// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/operation_message.hpp"

#include "protocol/load_policy_message.hpp"
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
    case ops::parameter_type::point:
      return v1::Parameter::POINT;
    case ops::parameter_type::direction:
      return v1::Parameter::DIRECTION;
    case ops::parameter_type::vector:
      return v1::Parameter::VECTOR;
    case ops::parameter_type::file:
      return v1::Parameter::FILE;
    case ops::parameter_type::axis:
      return v1::Parameter::AXIS;
    case ops::parameter_type::plane:
      return v1::Parameter::PLANE;
    case ops::parameter_type::polyline:
      return v1::Parameter::POLYLINE;
    case ops::parameter_type::list:
      return v1::Parameter::LIST;
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
    case v1::Parameter::POINT:
      return ops::parameter_type::point;
    case v1::Parameter::DIRECTION:
      return ops::parameter_type::direction;
    case v1::Parameter::VECTOR:
      return ops::parameter_type::vector;
    case v1::Parameter::FILE:
      return ops::parameter_type::file;
    case v1::Parameter::AXIS:
      return ops::parameter_type::axis;
    case v1::Parameter::PLANE:
      return ops::parameter_type::plane;
    case v1::Parameter::POLYLINE:
      return ops::parameter_type::polyline;
    case v1::Parameter::LIST:
      return ops::parameter_type::list;
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
  d.icon = m.icon();
  d.guide = m.guide();
  d.rank = m.rank();
  d.best_for = m.best_for();
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

namespace {

void to_message(const ops::parameter_description& p, v1::Parameter* out) {
  out->set_id(p.id);
  out->set_name(p.name);
  out->set_help(p.help);
  out->set_type(type_to(p.type));
  out->set_unit(p.unit);
  if (p.min)
    out->set_min(*p.min);
  if (p.max)
    out->set_max(*p.max);
  out->mutable_choices()->Assign(p.choices.begin(), p.choices.end());
  protocol::to_message(p.default_value, out->mutable_default_value());
  out->set_instead_of(p.instead_of);
}

void to_message(const offered_operation& one, v1::Operation* out) {
  const auto& about = one.about;
  out->set_id(about.id);
  out->set_name(about.name);
  out->set_summary(about.summary);
  out->set_version(about.version);
  out->set_plugin(one.plugin);
  out->set_selection_help(about.selection.help);
  out->set_selection_minimum(static_cast<std::uint32_t>(about.selection.minimum));
  out->set_selection_maximum(static_cast<std::uint32_t>(about.selection.maximum));
  for (const auto& p : about.parameters)
    to_message(p, out->add_parameters());
  out->set_icon(about.icon);
  out->set_guide(about.guide);
  out->set_rank(about.rank);
  out->set_best_for(about.best_for);
}

void to_message(const refused_operation& one, v1::RefusedPlugin* out) {
  out->set_file(one.file);
  out->set_reason(one.reason);
  out->set_operation(one.operation);
  out->set_crashes(one.crashes);
  out->set_remedy(one.remedy);
}

}  // namespace

void to_message(const operation_catalogue& all, v1::Catalogue* out) {
  for (const auto& one : all.operations)
    to_message(one, out->add_operations());
  for (const auto& one : all.refused)
    to_message(one, out->add_refused());
}

operation_catalogue from_message(const v1::Catalogue& message) {
  operation_catalogue result;
  for (const auto& row : message.operations())
    result.operations.push_back({from_message(row), row.plugin()});
  for (const auto& row : message.refused())
    result.refused.push_back(
      {row.file(), row.reason(), row.operation(), row.crashes(), row.remedy()});
  return result;
}

void to_message(const edit_request& wanted, v1::ApplyEdit* out) {
  out->set_operation(wanted.operation);
  out->mutable_surfaces()->Assign(wanted.surfaces.begin(), wanted.surfaces.end());
  for (const auto& [name, value] : wanted.parameters)
    to_message(value, &(*out->mutable_parameters())[name]);
  to_message(wanted.loads, out->mutable_loads());
}

expected<edit_request> from_message(const v1::ApplyEdit& message) {
  const auto loads = from_message(message.loads());
  if (!loads)
    return fail(loads.error());
  edit_request wanted{
    message.operation(), {message.surfaces().begin(), message.surfaces().end()}, {}, *loads};
  for (const auto& [name, value] : message.parameters())
    wanted.parameters[name] = from_message(value);
  return wanted;
}

}  // namespace tedit::protocol
