// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/net/cad_import.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>

#include "base/short_number.hpp"
#include "client-qt/net/own_program.hpp"
#include "client/part_files.hpp"

namespace tedit::desktop {

namespace {

struct cad_import_phrases {
  Q_DECLARE_TR_FUNCTIONS(cad_import)
};

}  // namespace

bool is_cad_file(const QString& path) {
  return client::is_cad_file(path.toStdString());
}

bool is_surface_file(const QString& path) {
  return client::is_surface_file(path.toStdString());
}

QString cad_patterns() {
  QStringList all;
  const auto add = [&](const auto& suffixes) {
    for (const auto& suffix : suffixes)
      all << "*." + QString::fromUtf8(suffix.data(), static_cast<qsizetype>(suffix.size()));
  };
  add(client::cad_suffixes);
  add(client::surface_suffixes);
  return all.join(" ");
}

bool is_step_file(const QString& path) {
  const auto suffix = QFileInfo(path).suffix().toLower();
  return suffix == "step" || suffix == "stp";
}

expected<meshed_part> mesh_cad_file(const cad_file& part_file, const execution& run) {
  const auto& file = part_file.path;
  run.report(0.05, (is_surface_file(file) ? cad_import_phrases::tr("meshing the surface")
                                          : cad_import_phrases::tr("meshing the CAD file"))
                     .toStdString());
  meshed_part part{std::make_unique<QTemporaryDir>(), {}, {}};
  if (!part.folder->isValid())
    return fail(ec::io_error, "no temporary folder can be made",
                "Set TMPDIR to a folder with room that you may write to");
  part.document = part.folder->filePath("part.tedit");
  QStringList arguments{"import", file, "--size", part_file.size, "-o", part.document};
  if (is_surface_file(file))
    arguments << "--unit" << part_file.unit;
  for (const auto& [surface, mm] : part_file.local_sizes_mm)
    arguments << "--local-size" << QString::fromStdString(surface + "=" + short_number(mm, 17));
  const auto answer = run_own_program(arguments, run);
  if (!answer)
    return fail(answer.error());
  for (const auto& warning : (*answer)["warnings"].toArray())
    part.warnings.push_back(warning.toString().toStdString());
  return part;
}

expected<void> write_cad_model(const std::vector<char>& document, const QString& step,
                               const execution& run) {
  run.report(0.5, cad_import_phrases::tr("editing the CAD model").toStdString());
  const QTemporaryDir folder;
  const auto copy = keep_document(folder, document);
  if (!copy)
    return fail(copy.error());
  return run_own_program({"export", *copy, "-o", step}, run).map([](const QJsonObject&) {});
}

}  // namespace tedit::desktop
