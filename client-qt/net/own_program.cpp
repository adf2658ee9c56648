// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/net/own_program.hpp"

#include <QFile>
#include <QJsonDocument>
#include <QProcess>

#include "client-qt/net/local_server.hpp"

namespace tedit::desktop {

namespace {

/// Why the program did not.
error said_by(const QJsonObject& answer, const QString& verb) {
  const auto about = answer["error"].toObject();
  const auto text = [&](const char* key) { return about[key].toString().toStdString(); };
  if (about.isEmpty())
    return {ec::service_unavailable,
            "the program tedit ended without an answer",
            "Run \"tedit " + verb.toStdString() + "\" on the command line to see why",
            {}};
  return {code_from_name(text("code")), text("message"), text("remedy"), text("where")};
}

}  // namespace

expected<QJsonObject> run_own_program(const QStringList& arguments, const execution& run) {
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
  const bool found_wrong =
    program.exitCode() == 1 && !answer.isEmpty() && !answer.contains("error");
  if (program.exitStatus() != QProcess::NormalExit || (program.exitCode() != 0 && !found_wrong))
    return fail(said_by(answer, arguments.front()));
  return answer;
}

expected<QString> keep_document(const QTemporaryDir& folder, const std::vector<char>& bytes) {
  if (!folder.isValid())
    return fail(ec::io_error, "no temporary folder can be made",
                "Set TMPDIR to a folder with room that you may write to");
  QFile copy(folder.filePath("part.tedit"));
  const auto size = static_cast<qint64>(bytes.size());
  if (!copy.open(QIODevice::WriteOnly) || copy.write(bytes.data(), size) != size || !copy.flush())
    return fail(ec::io_error, "cannot write the file: " + copy.errorString().toStdString());
  return copy.fileName();
}

}  // namespace tedit::desktop
