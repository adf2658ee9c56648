// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/net/cad_import.hpp"

#include <QCoreApplication>
#include <QFile>
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

/// Why the program did not.
error said_by(const QJsonObject& answer) {
  const auto about = answer["error"].toObject();
  const auto text = [&](const char* key) { return about[key].toString().toStdString(); };
  if (about.isEmpty())
    return {ec::service_unavailable,
            "the program tedit ended without an answer",
            "Run \"tedit import\" or \"tedit export\" on the command line to see why",
            {}};
  return {code_from_name(text("code")), text("message"), text("remedy"), text("where")};
}

/// Runs this installation's `tedit` and reads what it prints.
expected<QJsonObject> run_program(const QStringList& arguments, const execution& run) {
  QProcess program;
  program.setStandardErrorFile(QProcess::nullDevice());
  program.start(local_server::program(), arguments + QStringList{"--json", "--quiet"},
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
      return fail(ec::cancelled, "the work was cancelled");
    }
  const auto answer = QJsonDocument::fromJson(program.readAllStandardOutput()).object();
  if (program.exitStatus() != QProcess::NormalExit || program.exitCode() != 0)
    return fail(said_by(answer));
  return answer;
}

tl::unexpected<error> no_temporary_folder() {
  return fail(ec::io_error, "no temporary folder can be made",
              "Set TMPDIR to a folder with room that you may write to");
}

}  // namespace

bool is_cad_file(const QString& path) {
  return suffixes().contains(QFileInfo(path).suffix().toLower());
}

QString cad_patterns() {
  return "*." + suffixes().join(" *.");
}

bool is_step_file(const QString& path) {
  const auto suffix = QFileInfo(path).suffix().toLower();
  return suffix == "step" || suffix == "stp";
}

expected<meshed_part> mesh_cad_file(const QString& file, const QString& size,
                                    const execution& run) {
  run.report(0.05, cad_import_phrases::tr("meshing the CAD file").toStdString());
  meshed_part part{std::make_unique<QTemporaryDir>(), {}, {}};
  if (!part.folder->isValid())
    return no_temporary_folder();
  part.document = part.folder->filePath("part.tedit");
  const auto answer = run_program({"import", file, "--size", size, "-o", part.document}, run);
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
  if (!folder.isValid())
    return no_temporary_folder();
  QFile copy(folder.filePath("part.tedit"));
  const auto size = static_cast<qint64>(document.size());
  if (!copy.open(QIODevice::WriteOnly) || copy.write(document.data(), size) != size ||
      !copy.flush())
    return fail(ec::io_error, "cannot write the file: " + copy.errorString().toStdString());
  copy.close();
  return run_program({"export", copy.fileName(), "-o", step}, run).map([](const QJsonObject&) {});
}

}  // namespace tedit::desktop
