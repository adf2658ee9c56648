// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/materials.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "client-qt/model/load_editing.hpp"

namespace tedit::desktop {

expected<std::vector<fem::material>> materials_from_json(const QByteArray& json,
                                                         const QString& source) {
  QJsonParseError fault;
  const auto all = QJsonDocument::fromJson(json, &fault);
  if (fault.error != QJsonParseError::NoError)
    return fail(ec::bad_input,
                "the library of materials is no JSON: " + fault.errorString().toStdString(), {},
                source.toStdString() + ":" + std::to_string(fault.offset));
  std::vector<fem::material> result;
  for (const auto& value : all.object()["materials"].toArray()) {
    const auto row = value.toObject();
    fem::material one;
    one.name = row["name"].toString().toStdString();
    one.young_modulus_pa = row["young_modulus_pa"].toDouble();
    one.poisson_ratio = row["poisson_ratio"].toDouble(1);  // Missing is a fault too.
    one.density_kg_m3 = row["density_kg_m3"].toDouble();
    one.yield_strength_pa = row["yield_strength_pa"].toDouble();
    const auto wrong = faults(one);
    if (!wrong.empty())
      return fail(ec::bad_input,
                  "material \"" + one.name + "\": " + wrong[0].field.toStdString() + ": " +
                    wrong[0].words.toStdString(),
                  "Correct the entry", source.toStdString());
    result.push_back(std::move(one));
  }
  return result;
}

expected<std::vector<fem::material>> shipped_materials() {
  const QDir program(QCoreApplication::applicationDirPath());
  for (const auto* place : {"../share/tedit/materials.json", "../../../config/materials.json"}) {
    QFile file(program.absoluteFilePath(place));
    if (file.open(QIODevice::ReadOnly))
      return materials_from_json(file.readAll(), QDir::cleanPath(file.fileName()));
  }
  return fail(ec::io_error, "the library of materials is not beside the program",
              "Install share/tedit/materials.json, or type own values",
              program.absolutePath().toStdString());
}

}  // namespace tedit::desktop
