// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/numbers.hpp"

#include <vector>

#include <google/protobuf/message.h>

namespace tedit::protocol {

namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

/// One field of one message, with the way to it.
class field_check {
public:
  field_check(const Message& of, const FieldDescriptor* field, std::string name,
              const number_range& range, ec code)
      : of_(of),
        reads_(*of.GetReflection()),
        field_(field),
        name_(std::move(name)),
        range_(range),
        code_(code) {}

  expected<void> check() const;

private:
  [[nodiscard]] expected<void> check_item(int i) const;
  [[nodiscard]] std::string name_of(int i) const;

  const Message& of_;
  const google::protobuf::Reflection& reads_;
  const FieldDescriptor* field_;
  std::string name_;
  const number_range& range_;
  ec code_;
};

expected<void> check_fields(const Message& message, const std::string& name,
                            const number_range& range, ec code) {
  std::vector<const FieldDescriptor*> set;
  message.GetReflection()->ListFields(message, &set);
  for (const auto* field : set) {
    const auto its_name = name.empty() ? field->name() : name + "." + field->name();
    if (auto ok = field_check(message, field, its_name, range, code).check(); !ok)
      return ok;
  }
  return {};
}

expected<void> field_check::check() const {
  const auto type = field_->cpp_type();
  if (type != FieldDescriptor::CPPTYPE_DOUBLE && type != FieldDescriptor::CPPTYPE_FLOAT &&
      type != FieldDescriptor::CPPTYPE_MESSAGE)
    return {};
  const int items = field_->is_repeated() ? reads_.FieldSize(of_, field_) : 1;
  for (int i = 0; i < items; ++i)
    if (auto ok = check_item(i); !ok)
      return ok;
  return {};
}

/// "loads[0]", and of a map its key: "parameters[depth]".
std::string field_check::name_of(int i) const {
  if (!field_->is_repeated())
    return name_;
  const auto* key = field_->is_map() ? field_->message_type()->map_key() : nullptr;
  if (key == nullptr || key->cpp_type() != FieldDescriptor::CPPTYPE_STRING)
    return name_ + "[" + std::to_string(i) + "]";
  const auto& row = reads_.GetRepeatedMessage(of_, field_, i);
  return name_ + "[" + row.GetReflection()->GetString(row, key) + "]";
}

expected<void> field_check::check_item(int i) const {
  const bool many = field_->is_repeated();
  switch (field_->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return check_number(
        many ? reads_.GetRepeatedDouble(of_, field_, i) : reads_.GetDouble(of_, field_), range_,
        name_of(i), code_);
    case FieldDescriptor::CPPTYPE_FLOAT:
      return check_number(
        many ? reads_.GetRepeatedFloat(of_, field_, i) : reads_.GetFloat(of_, field_), range_,
        name_of(i), code_);
    default:
      return check_fields(
        many ? reads_.GetRepeatedMessage(of_, field_, i) : reads_.GetMessage(of_, field_),
        name_of(i), range_, code_);
  }
}

}  // namespace

expected<void> check_numbers(const Message& message, const number_range& range, ec code) {
  return check_fields(message, {}, range, code);
}

}  // namespace tedit::protocol
