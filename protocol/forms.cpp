// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/forms.hpp"

#include "protocol/json.hpp"
#include "protocol/load_case_message.hpp"
#include "protocol/operation_message.hpp"
#include "protocol/report.hpp"
#include "protocol/selection_message.hpp"
#include "tedit/v1/operation.pb.h"
#include "tedit/v1/session.pb.h"

namespace tedit::protocol {

void to_message(const std::vector<fem::load_case>& load_cases, v1::LoadCasesChanged* out) {
  to_messages(load_cases, out->mutable_load_cases());
}

expected<std::vector<fem::load_case>> from_message(const v1::LoadCasesChanged& message) {
  return from_messages(message.load_cases());
}

namespace {

using load_case_list = std::vector<fem::load_case>;
using feature_list = std::vector<found_feature>;

template <class T>
struct message_of;
template <>
struct message_of<edit_request> {
  using type = v1::ApplyEdit;
};
template <>
struct message_of<edit_report> {
  using type = v1::EditReport;
};
template <>
struct message_of<solve_outcome> {
  using type = v1::Solved;
};
template <>
struct message_of<load_case_list> {
  using type = v1::LoadCasesChanged;
};
template <>
struct message_of<selection_query> {
  using type = v1::SelectSurfaces;
};
template <>
struct message_of<feature_list> {
  using type = v1::SurfacesSelected;
};
template <>
struct message_of<operation_catalogue> {
  using type = v1::Catalogue;
};

template <class T>
typename message_of<T>::type message_from(const T& value) {
  typename message_of<T>::type message;
  to_message(value, &message);
  return message;
}

}  // namespace

template <class T>
std::string to_bytes(const T& value) {
  return message_from(value).SerializeAsString();
}

template <class T>
expected<T> from_bytes(std::string_view bytes) {
  typename message_of<T>::type message;
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
    return fail(ec::protocol_error, "these bytes are no " + message.GetTypeName());
  return from_message(message);
}

template <class T>
std::string to_json(const T& value) {
  return message_to_json(message_from(value));
}

template <class T>
expected<T> from_json(std::string_view json) {
  const auto message = message_from_json<typename message_of<T>::type>(json);
  if (!message)
    return fail(message.error());
  return from_message(*message);
}

#define TEDIT_FORMS(T)                                  \
  template std::string to_bytes<T>(const T&);           \
  template expected<T> from_bytes<T>(std::string_view); \
  template std::string to_json<T>(const T&);            \
  template expected<T> from_json<T>(std::string_view);

TEDIT_FORMS(edit_request)
TEDIT_FORMS(edit_report)
TEDIT_FORMS(solve_outcome)
TEDIT_FORMS(load_case_list)
TEDIT_FORMS(selection_query)
TEDIT_FORMS(feature_list)
TEDIT_FORMS(operation_catalogue)
#undef TEDIT_FORMS

}  // namespace tedit::protocol
