// SPDX-License-Identifier: AGPL-3.0-or-later
#include <sys/resource.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

#include "base/virtual_display.hpp"

#include "client-qt/model/language.hpp"
#include "client-qt/model/preferences.hpp"
#include "client-qt/model/stall_watch.hpp"
#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/operations/drag_figures.hpp"
#include "client-qt/tools/recipes/window_player.hpp"
#include "client-qt/view/viewport.hpp"
#include "client-qt/widgets/theme.hpp"
#include "client-qt/window/latencies.hpp"
#include "client-qt/window/main_window.hpp"

namespace {

using namespace tedit;
using namespace tedit::desktop;

constexpr int patience_s = 300;  ///< Of a script, for each of its steps.

struct wishes {
  QString mesh;
  QStringList load_cases;
  QString document;
  server_address server;
  QStringList recipes;  ///< To be carried out unattended.
  QString picture;
  QString state_folder;
  QString report;
  QSize size;
  bool dark = false;
  std::optional<QString> language;
};

QSize size_from(const QString& text) {
  const auto parts = text.split('x');
  return parts.size() == 2 ? QSize(parts[0].toInt(), parts[1].toInt()) : QSize();
}

wishes read_command_line(const QCoreApplication& app) {
  QCommandLineParser line;
  line.setApplicationDescription(
    "The desktop client of TEdit: change a part, see its stress at once.\n\n"
    "Without --server it runs a server of its own on this computer. With --screenshot or --script "
    "it works unattended and ends with 0 when all was done.");
  line.addHelpOption();
  line.addVersionOption();
  line.addPositionalArgument("mesh", "A mesh to open (as --open).", "[mesh]");
  line.addOption(
    {"open", "Open a mesh file with surface ids, a document (.tedit), or run a recipe (.json).",
     "mesh"});
  line.addOption({"load-case", "A load case for it (JSON); may be given more than once.", "file"});
  line.addOption({"document", "Open a document that is there.", "name"});
  line.addOption({"server", "Connect to a server instead of running one.", "ws://host:port/v1"});
  line.addOption({"token", "The server's token.", "text"});
  line.addOption({"script", "Carry out a recipe (JSON) unattended, then end.", "recipe.json"});
  line.addOption({"screenshot", "Save a picture when the field is final, then end.", "out.png"});
  line.addOption({"report",
                  "Write how responsive the window was, frame times and memory to a JSON file.",
                  "file"});
  line.addOption({"size", "Size of the window.", "WIDTHxHEIGHT"});
  line.addOption({"state", "Folder of the local server's documents.", "folder"});
  line.addOption({"dark", "Dark colours."});
  line.addOption({"language", "Language of the window: en, de.", "code"});
  line.process(app);
  wishes result;
  result.mesh = line.value("open");
  if (result.mesh.isEmpty() && !line.positionalArguments().isEmpty())
    result.mesh = line.positionalArguments().first();
  result.load_cases = line.values("load-case");
  result.document = line.value("document");
  result.server = {line.value("server"), line.value("token")};
  result.picture = line.value("screenshot");
  const bool unattended = line.isSet("script") || line.isSet("screenshot");
  if (unattended && result.mesh.endsWith(".json"))  // Else the window runs it.
    result.recipes << std::exchange(result.mesh, {});
  if (line.isSet("script"))
    result.recipes << line.value("script");
  result.state_folder = line.value("state");
  result.report = line.value("report");
  result.size = size_from(line.value("size"));
  result.dark = line.isSet("dark");
  if (line.isSet("language"))
    result.language = line.value("language");
  return result;
}

/// All recipes, then the picture.
expected<std::vector<client::recipe_step>> steps_of(const wishes& wanted) {
  std::vector<client::recipe_step> result;
  for (const auto& file : wanted.recipes) {
    const auto read = client::read_recipe(file.toStdString());
    if (!read)
      return fail(read.error());
    result.insert(result.end(), read->steps.begin(), read->steps.end());
  }
  const auto add = [&](const char* kind, const QString& value) {
    const QJsonObject step{{kind, value}};
    result.push_back(
      client::window_step{kind, QJsonDocument(step).toJson(QJsonDocument::Compact).toStdString()});
  };
  if (!wanted.picture.isEmpty()) {
    if (!wanted.load_cases.isEmpty() || !wanted.document.isEmpty())
      add("wait", "final");
    add("screenshot", wanted.picture);
  }
  return result;
}

/// Times in ms, processor time in s (of the whole program, and of the thread that all events run
/// on); memory is the largest resident size of this process.
void write_report(const QString& path, const stall_watch& watch, const latencies& waits,
                  main_window& window) {
  const auto& view = window.context().view;
  const auto stalls = watch.take();
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  rusage own{};
  getrusage(RUSAGE_THREAD, &own);
  const auto seconds = [](const rusage& of) {
    return static_cast<double>(of.ru_utime.tv_sec + of.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(of.ru_utime.tv_usec + of.ru_stime.tv_usec);
  };
  QJsonObject report{{"events", static_cast<qint64>(stalls.samples)},
                     {"wait_p50_ms", stalls.p50_ms},
                     {"wait_p99_ms", stalls.p99_ms},
                     {"wait_worst_ms", stalls.worst_ms},
                     {"last_frame_ms", view.frame_ms()},
                     {"frames", view.frames()},
                     {"cpu_s", seconds(used)},
                     {"window_thread_cpu_s", seconds(own)},
                     {"memory_mib", static_cast<double>(used.ru_maxrss) / 1024}};
  const std::pair<const char*, std::optional<double>> worst[] = {
    {"window_ms", waits.window_open},
    {"first_field_ms", waits.first_field},
    {"click_to_frame_ms", waits.click_to_frame},
    {"commit_to_frame_ms", waits.commit_to_frame},
    {"preview_to_frame_ms", waits.preview_to_frame}};
  for (const auto& [name, ms] : worst)
    if (ms)
      report[name] = *ms;
  if (const auto drags = window.tools().operations.figures().report(); !drags.isEmpty())
    report["last_drag"] = drags;
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(QJsonDocument(report).toJson()) < 0)
    std::fprintf(stderr, "tedit-qt: cannot write %s\n", qPrintable(path));
}

int complain(const error& reason) {
  std::fprintf(stderr, "tedit-qt: %s\n", render(reason).c_str());
  return exit_status(reason.code);
}

/// A script or a picture needs nobody to look: where there is no display it gets one of its own.
bool works_unattended(int argc, char** argv) {
  const auto wants = [](std::string_view word) {
    return word.starts_with("--script") || word.starts_with("--screenshot");
  };
  return std::any_of(argv, argv + argc, wants) && std::getenv("WAYLAND_DISPLAY") == nullptr &&
         std::getenv("QT_QPA_PLATFORM") == nullptr;
}

bool has_word(int argc, char** argv, std::initializer_list<std::string_view> words) {
  return std::any_of(argv + 1, argv + argc, [&](std::string_view given) {
    return std::ranges::find(words, given) != words.end();
  });
}

bool has_display(int argc, char** argv) {
  const auto is_set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != 0;
  };
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY") || is_set("QT_QPA_PLATFORM") ||
         has_word(argc, argv, {"-platform", "--platform"});
}

/// Errors: `service_unavailable`; the view cannot live without it, and Qt ends a window that tries.
expected<void> check_opengl() {
  QOpenGLContext context;
  QOffscreenSurface surface;
  surface.create();
  if (context.create() && context.format().version() >= std::pair(3, 2) &&
      context.makeCurrent(&surface))
    return {};
  return fail(
    ec::service_unavailable,
    "there is no OpenGL 3.2 for the view (Qt platform \"" +
      QGuiApplication::platformName().toStdString() + "\")",
    "Without a display leave QT_QPA_PLATFORM unset and use --screenshot or --script; with "
    "an old driver set LIBGL_ALWAYS_SOFTWARE=1");
}

void name_program() {
  QCoreApplication::setApplicationName("tedit-qt");
  QCoreApplication::setApplicationVersion(TEDIT_VERSION);
}

/// Says what was asked for and ends the program; without a display, too.
void answer_questions(int argc, char** argv) {
  if (!has_word(argc, argv, {"--help", "-h", "--help-all", "--version", "-v"}))
    return;
  name_program();
  (void)read_command_line(QCoreApplication(argc, argv));
}

}  // namespace

int main(int argc, char** argv) {
  answer_questions(argc, argv);
  std::optional<virtual_display> own_display;
  if (works_unattended(argc, argv)) {
    auto opened = virtual_display::open();
    if (!opened)
      return complain(opened.error());
    own_display.emplace(std::move(*opened));
  } else if (!has_display(argc, argv)) {
    return complain({ec::service_unavailable,
                     "there is no display for a window",
                     "Start it in a desktop session, or let it work unattended with --screenshot "
                     "or --script",
                     {}});
  }
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setAlphaBufferSize(8);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication app(argc, argv);
  name_program();
  QApplication::setApplicationDisplayName("TEdit");
  QApplication::setDesktopFileName("org.tedit.TEdit");
  QApplication::setStyle("Fusion");
  QApplication::setWindowIcon(window_icon());
  const auto wanted = read_command_line(app);
  speak(app, wanted.language.value_or(load_preferences(QSettings("tedit", "tedit-qt")).language));
  const auto unattended = steps_of(wanted);
  if (!unattended)
    return complain(unattended.error());
  if (auto ok = check_opengl(); !ok)
    return complain(ok.error());

  std::optional<stall_watch> watch;  // It asks 200 times a second: only for who wants to know.
  if (!wanted.report.isEmpty())
    watch.emplace();
  main_window window(wanted.state_folder);
  const latencies waits(window.context(), window.tools().operations.panel().preview());
  // Before there is a window, none is frozen.
  if (watch)
    QObject::connect(&waits, &latencies::window_shown, &*watch, &stall_watch::restart);
  if (wanted.dark)
    window.context().look.set_dark(true);
  if (wanted.size.isValid())
    window.take_size(wanted.size);
  window.show();
  if (!wanted.server.url.isEmpty())
    window.tools().connection.connect_to(wanted.server);
  if (!wanted.mesh.isEmpty())
    window.tools().documents.open_file(wanted.mesh, wanted.load_cases);
  else if (!wanted.document.isEmpty())
    window.tools().documents.open_document(wanted.document);
  else if (unattended->empty() && wanted.server.url.isEmpty())
    window.tools().documents.restore();

  int status = 0;
  window_player player(window.context(), window.tools(), *unattended);
  player.set_patience(patience_s);
  player.allow_files();
  if (!wanted.mesh.isEmpty() || !wanted.document.isEmpty() || !wanted.server.url.isEmpty())
    player.await_part();
  QObject::connect(&player, &window_player::finished, &app, [&] {
    if (const int left_out = player.left_out(); left_out > 0)
      std::fprintf(stderr, "tedit-qt: left out %d exports: \"tedit run\" writes them\n", left_out);
    QApplication::quit();
  });
  QObject::connect(&player, &window_player::failed, &app, [&](const error& reason) {
    status = complain(reason);
    QApplication::quit();
  });
  if (!unattended->empty())
    player.start();
  QApplication::exec();
  if (watch)
    write_report(wanted.report, *watch, waits, window);
  return status;
}
