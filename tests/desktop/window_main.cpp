// SPDX-License-Identifier: AGPL-3.0-or-later
// Starts a display of its own where there is none, and makes every warning of Qt a failure.
#include <QApplication>
#include <QSurfaceFormat>

#include <gtest/gtest.h>

#include "base/virtual_display.hpp"

namespace {

void fail_on_warning(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type == QtDebugMsg || type == QtInfoMsg)
    return;
  ADD_FAILURE() << "Qt says: " << text.toStdString();
}

bool only_lists(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (std::string_view(argv[i]).starts_with("--gtest_list_tests"))
      return true;
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  const bool lists = only_lists(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  if (lists)
    return RUN_ALL_TESTS();
  setenv("XDG_RUNTIME_DIR", testing::TempDir().c_str(), 0);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);  // The same pictures wherever they are made.
  const auto display = tedit::virtual_display::open();
  if (!display) {
    std::fprintf(stderr, "%s\n", tedit::render(display.error()).c_str());
    return 1;
  }
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication::setStyle("Fusion");
  const QApplication app(argc, argv);
  qInstallMessageHandler(fail_on_warning);
  return RUN_ALL_TESTS();
}
