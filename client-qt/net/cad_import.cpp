// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/net/cad_import.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

#include "client-qt/net/local_server.hpp"

namespace tedit::desktop {

namespace {

struct cad_import_phrases {
  Q_DECLARE_TR_FUNCTIONS(cad_import)
};

const QStringList& suffixes() {
  static const QStringList all{"step", "stp", "iges", "igs", "brep"};
  return all;
}

/// What the program printed, or why it did not.
error said_by(const QJsonObject& answer) {
  const auto about = answer["error"].toObject();
  const auto text = [&](const char* key) { return about[key].toString().toStdString(); };
  if (about.isEmpty())
    return {ec::service_unavailable,
            "\"tedit import\" ended without an answer",
            "Run it on the command line to see why",
            {}};
  return {code_from_name(text("code")), text("message"), text("remedy"), text("where")};
}

}  // namespace

bool is_cad_file(const QString& path) {
  return suffixes().contains(QFileInfo(path).suffix().toLower());
}

QString cad_patterns() {
  return "*." + suffixes().join(" *.");
}

expected<meshed_part> mesh_cad_file(const QString& file, const QString& size,
                                    const execution& run) {
  run.report(0.05, cad_import_phrases::tr("meshing the CAD file").toStdString());
  meshed_part part{std::make_unique<QTemporaryDir>(), {}, {}};
  if (!part.folder->isValid())
    return fail(ec::io_error, "no temporary folder can be made",
                "Set TMPDIR to a folder with room that you may write to");
  part.mesh = part.folder->filePath(QFileInfo(file).completeBaseName() + ".msh");
  QProcess program;
  program.setStandardErrorFile(QProcess::nullDevice());
  program.start(local_server::program(),
                {"import", file, "--size", size, "--json", "--quiet", "-o", part.mesh},
                QIODevice::ReadOnly);
  if (!program.waitForStarted())
    return fail(ec::service_unavailable,
                "the program tedit does not start: " + program.errorString().toStdString(),
                "Install it beside this one");
  constexpr int look_every_ms = 100;
  while (!program.waitForFinished(look_every_ms))
    if (run.cancel.cancelled()) {
      program.terminate();  // It takes its own programs and files along.
      if (!program.waitForFinished(3000))
        program.kill();
      program.waitForFinished();
      return fail(ec::cancelled, "the import was cancelled");
    }
  const auto answer = QJsonDocument::fromJson(program.readAllStandardOutput()).object();
  if (program.exitStatus() != QProcess::NormalExit || program.exitCode() != 0)
    return fail(said_by(answer));
  for (const auto& warning : answer["warnings"].toArray())
    part.warnings.push_back(warning.toString().toStdString());
  return part;
}

}  // namespace tedit::desktop
