// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/net/cad_import.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>

#include "client-qt/net/own_program.hpp"

namespace tedit::desktop {

namespace {

struct cad_import_phrases {
  Q_DECLARE_TR_FUNCTIONS(cad_import)
};

const QStringList& suffixes() {
  static const QStringList all{"step", "stp", "iges", "igs", "brep"};
  return all;
}

const QStringList& surface_suffixes() {
  static const QStringList all{"stl", "obj", "ply", "3mf"};
  return all;
}

}  // namespace

bool is_cad_file(const QString& path) {
  return suffixes().contains(QFileInfo(path).suffix().toLower());
}

bool is_surface_file(const QString& path) {
  return surface_suffixes().contains(QFileInfo(path).suffix().toLower());
}

QString cad_patterns() {
  return "*." + (suffixes() + surface_suffixes()).join(" *.");
}

bool is_step_file(const QString& path) {
  const auto suffix = QFileInfo(path).suffix().toLower();
  return suffix == "step" || suffix == "stp";
}

expected<meshed_part> mesh_cad_file(const QString& file, const QString& size, const QString& unit,
                                    const execution& run) {
  run.report(0.05, (is_surface_file(file) ? cad_import_phrases::tr("meshing the surface")
                                          : cad_import_phrases::tr("meshing the CAD file"))
                     .toStdString());
  meshed_part part{std::make_unique<QTemporaryDir>(), {}, {}};
  if (!part.folder->isValid())
    return fail(ec::io_error, "no temporary folder can be made",
                "Set TMPDIR to a folder with room that you may write to");
  part.document = part.folder->filePath("part.tedit");
  QStringList arguments{"import", file, "--size", size, "-o", part.document};
  if (is_surface_file(file))
    arguments << "--unit" << unit;
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
