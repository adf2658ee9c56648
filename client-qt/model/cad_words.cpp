// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/cad_words.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <iterator>

#include "client-qt/model/quantities.hpp"
#include "client-qt/model/server_words.hpp"

namespace tedit::desktop {

namespace {

struct cad_phrases {
  Q_DECLARE_TR_FUNCTIONS(cad)
};

using client::cad_status;

/// Ways of making an edit on the model whose name is one word: too little for a template.
constexpr const char* short_ways[] = {
  QT_TRANSLATE_NOOP("cad", "layer"), QT_TRANSLATE_NOOP("cad", "slab"),
  QT_TRANSLATE_NOOP("cad", "plug"), QT_TRANSLATE_NOOP("cad", "fillet"),
  QT_TRANSLATE_NOOP("cad", "tool")};

/// "layer, slab".
QString names_of_ways(const QString& names) {
  QStringList result;
  for (const auto& name : names.split(", "))
    result << (std::ranges::find(short_ways, name) != std::end(short_ways)
                 ? cad_phrases::tr(name.toUtf8())
                 : words_of(name.toStdString()));
  return result.join(", ");
}

/// Of several ways some have their own: "layer, slab: it has 2 solids; plug: ...".
QString reason_words(const std::string& reason) {
  const auto text = QString::fromStdString(reason);
  QStringList faults;
  for (const auto& one : text.split("; ")) {
    const auto colon = one.indexOf(": ");
    const bool is_sentence = colon < 0 || in_window_language(one.toStdString()) != one;
    faults << (is_sentence ? words_of(one.toStdString())
                           : names_of_ways(one.left(colon)) + ": " +
                               words_of(one.mid(colon + 2).toStdString()));
  }
  return faults.join("; ");
}

}  // namespace

QString cad_words(const client::version_info& version) {
  if (!version.cad)
    return {};
  switch (version.cad->status) {
    case cad_status::pending:
      return cad_phrases::tr("Being made on the CAD model");
    case cad_status::same:
      return version.operation == "import"
               ? cad_phrases::tr("The part as the CAD model has it")
               : cad_phrases::tr("On the CAD model, new vertices within %1")
                   .arg(quantity(version.cad->deviation_m, "m"));
    case cad_status::mesh_only:
      return cad_phrases::tr("In the mesh only: %1").arg(reason_words(version.cad->reason));
    case cad_status::failed:
      return cad_phrases::tr("Not tried on the CAD model: %1")
        .arg(reason_words(version.cad->reason));
    default:
      return {};
  }
}

QString cad_mark_words(const client::cad_state& state) {
  switch (state.status) {
    case cad_status::pending:
      return cad_phrases::tr("CAD ...", "on a small picture: being made on the model");
    case cad_status::same:
      return cad_phrases::tr("CAD", "on a small picture: the model has it");
    case cad_status::mesh_only:
      return cad_phrases::tr("mesh only", "on a small picture: the CAD model has it not");
    case cad_status::failed:
      return cad_phrases::tr("CAD ?", "on a small picture: not tried on the model");
    default:
      return {};
  }
}

/// Of several after each other the first one is told; it is what a person can take back.
QString cad_news(const client::version_info& version,
                 const std::optional<client::cad_state>& before) {
  const auto status = version.cad ? version.cad->status : cad_status::unspecified;
  if ((status != cad_status::mesh_only && status != cad_status::failed) ||
      (before && before->status == status))
    return {};
  return cad_phrases::tr("Version %1. %2").arg(version.number).arg(cad_words(version));
}

}  // namespace tedit::desktop
