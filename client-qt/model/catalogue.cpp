// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/catalogue.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>

#include "client-qt/model/operation_words.hpp"

namespace tedit::desktop {

namespace {

std::string text(const QJsonValue& value) {
  return value.toString().toStdString();
}

ops::parameter_type type_from(const QString& name) {
  using type = ops::parameter_type;
  constexpr std::array<std::pair<const char*, type>, 5> names{{{"BOOLEAN", type::boolean},
                                                               {"INTEGER", type::integer},
                                                               {"REAL", type::real},
                                                               {"TEXT", type::text},
                                                               {"CHOICE", type::choice}}};
  for (const auto& [known, meaning] : names)
    if (name == known)
      return meaning;
  return type::text;  // A kind that a newer server knows: it parses what is typed.
}

ops::parameter_value value_from(const QJsonObject& value, ops::parameter_type type) {
  switch (type) {
    case ops::parameter_type::boolean:
      return value["boolean"].toBool();
    case ops::parameter_type::integer:  // 64-bit numbers are texts in canonical JSON.
      return static_cast<std::int64_t>(value["integer"].toVariant().toLongLong());
    case ops::parameter_type::real:
      return value["real"].toDouble();
    default:
      return text(value["text"]);
  }
}

ops::parameter_description parameter_from(const QJsonObject& row) {
  ops::parameter_description result;
  result.id = text(row["id"]);
  result.name = in_users_language(text(row["name"]));
  result.help = in_users_language(text(row["help"]));
  result.type = type_from(row["type"].toString());
  result.unit = text(row["unit"]);
  if (row.contains("min"))
    result.min = row["min"].toDouble();
  if (row.contains("max"))
    result.max = row["max"].toDouble();
  for (const auto& choice : row["choices"].toArray())
    result.choices.push_back(text(choice));
  result.instead_of = text(row["instead_of"]);
  result.default_value = value_from(row["default_value"].toObject(), result.type);
  return result;
}

offered_operation operation_from(const QJsonObject& row) {
  offered_operation result;
  auto& about = result.about;
  about.id = text(row["id"]);
  about.name = in_users_language(text(row["name"]));
  about.summary = in_users_language(text(row["summary"]));
  about.version = text(row["version"]);
  about.selection.help = in_users_language(text(row["selection_help"]));
  about.selection.minimum = static_cast<std::size_t>(row["selection_minimum"].toDouble());
  about.selection.maximum = static_cast<std::size_t>(row["selection_maximum"].toDouble());
  for (const auto& parameter : row["parameters"].toArray())
    about.parameters.push_back(parameter_from(parameter.toObject()));
  result.plugin = row["plugin"].toString();
  return result;
}

}  // namespace

const offered_operation* catalogue::find(const QString& id) const {
  const auto found = std::ranges::find_if(
    operations, [wanted = id.toStdString()](const auto& o) { return o.about.id == wanted; });
  return found == operations.end() ? nullptr : &*found;
}

expected<catalogue> catalogue_from_json(const std::string& json) {
  QJsonParseError fault;
  const auto document = QJsonDocument::fromJson(QByteArray::fromStdString(json), &fault);
  if (fault.error != QJsonParseError::NoError)
    return fail(ec::protocol_error, "the server's list of operations cannot be read: " +
                                      fault.errorString().toStdString());
  catalogue result;
  const auto all = document.object();
  for (const auto& row : all["operations"].toArray())
    result.operations.push_back(operation_from(row.toObject()));
  for (const auto& row : all["refused"].toArray())
    result.refused.push_back(
      {row.toObject()["file"].toString(), row.toObject()["reason"].toString()});
  return result;
}

}  // namespace tedit::desktop
