// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/text_fields.hpp"

#include <vector>

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include "base/text.hpp"

namespace tedit::protocol {

namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

std::vector<const FieldDescriptor*> set_fields(const Message& message) {
  std::vector<const FieldDescriptor*> fields;
  message.GetReflection()->ListFields(message, &fields);
  return fields;
}

/// The path to the first text for which `is_it` is true, from the message's own fields; empty when
/// there is none.
template <class Predicate>
std::string find_text(const Message& message, const Predicate& is_it) {
  const auto* reflection = message.GetReflection();
  std::string scratch;
  for (const auto* field : set_fields(message)) {
    const int count = field->is_repeated() ? reflection->FieldSize(message, field) : 1;
    const bool text = field->type() == FieldDescriptor::TYPE_STRING;
    const bool inner = field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    for (int i = 0; (text || inner) && i < count; ++i) {
      if (text) {
        const auto& value = field->is_repeated()
                              ? reflection->GetRepeatedStringReference(message, field, i, &scratch)
                              : reflection->GetStringReference(message, field, &scratch);
        if (is_it(value))
          return field->name();
        continue;
      }
      const auto& next = field->is_repeated() ? reflection->GetRepeatedMessage(message, field, i)
                                              : reflection->GetMessage(message, field);
      if (const auto found = find_text(next, is_it); !found.empty())
        return field->name() + "." + found;
    }
  }
  return {};
}

}  // namespace

bool has_valid_text(const Message& message) {
  return find_text(message, [](const std::string& text) { return !is_utf8(text); }).empty();
}

std::string find_long_text(const Message& message, std::size_t bytes) {
  return find_text(message, [=](const std::string& text) { return text.size() > bytes; });
}

void make_text_valid(Message& message) {
  const auto* reflection = message.GetReflection();
  for (const auto* field : set_fields(message)) {
    const int count = field->is_repeated() ? reflection->FieldSize(message, field) : 1;
    for (int i = 0; i < count; ++i) {
      if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE)
        make_text_valid(field->is_repeated()
                          ? *reflection->MutableRepeatedMessage(&message, field, i)
                          : *reflection->MutableMessage(&message, field));
      else if (field->type() == FieldDescriptor::TYPE_STRING && field->is_repeated())
        reflection->SetRepeatedString(&message, field, i,
                                      to_utf8(reflection->GetRepeatedString(message, field, i)));
      else if (field->type() == FieldDescriptor::TYPE_STRING)
        reflection->SetString(&message, field, to_utf8(reflection->GetString(message, field)));
    }
  }
}

}  // namespace tedit::protocol
