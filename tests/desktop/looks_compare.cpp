// SPDX-License-Identifier: AGPL-3.0-or-later
// looks_compare [--keep] KEPT SEEN: whether the window's pictures in SEEN look like those that were
// looked at and kept (tests/data/looks/README.md). Part of scripts/looks.sh.
#include <QDir>
#include <QGuiApplication>
#include <QTextStream>

#include "tests/desktop/picture_difference.hpp"

namespace tedit::desktop {
namespace {

// Pictures are kept so small that words are shades: what stands where counts, not which
// milliseconds or which fonts. What moves by a button's width is seen.
constexpr int kept_width = 240;
constexpr double most_mean = 0.8;   ///< Of 255, over all channels.
constexpr double most_off = 0.005;  ///< Share of pixels of another colour.

QImage reduced(const QString& path) {
  const QImage seen(path);
  return seen.isNull() ? seen
                       : seen.scaledToWidth(kept_width, Qt::SmoothTransformation)
                           .convertToFormat(QImage::Format_RGB32);
}

/// Empty: it looks as it did.
QString fault_of(const QString& kept_path, const QImage& seen) {
  const QImage kept = QImage(kept_path).convertToFormat(QImage::Format_RGB32);
  if (kept.isNull())
    return "no picture of it is kept";
  if (kept.size() != seen.size())
    return "it has another shape";
  const auto d = compare(kept, seen);
  if (d.mean <= most_mean && d.off <= most_off)
    return {};
  return QString("mean difference %1 of 255, %2 % of the pixels off").arg(d.mean).arg(100 * d.off);
}

int check(const QDir& kept, const QDir& seen) {
  QTextStream out(stdout);
  int faults = 0;
  auto missing = kept.entryList({"*.png"});
  for (const auto& name : seen.entryList({"*.png"})) {
    missing.removeAll(name);
    const auto fault = fault_of(kept.filePath(name), reduced(seen.filePath(name)));
    if (fault.isEmpty())
      continue;
    ++faults;
    out << seen.filePath(name) << ": " << fault << "\n";
  }
  for (const auto& name : missing)
    out << kept.filePath(name) << ": the window made no such picture\n";
  return faults + static_cast<int>(missing.size());
}

int keep(const QDir& kept, const QDir& seen) {
  kept.mkpath(".");
  for (const auto& name : kept.entryList({"*.png"}))
    QFile::remove(kept.filePath(name));
  for (const auto& name : seen.entryList({"*.png"}))
    if (!reduced(seen.filePath(name)).save(kept.filePath(name)))
      return 1;
  return 0;
}

}  // namespace
}  // namespace tedit::desktop

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QGuiApplication app(argc, argv);
  auto words = QGuiApplication::arguments().mid(1);
  const bool keeps = words.removeAll("--keep") > 0;
  if (words.size() != 2 || !QDir(words[1]).exists()) {
    QTextStream(stderr) << "usage: looks_compare [--keep] KEPT SEEN\n";
    return 2;
  }
  const QDir kept(words[0]);
  const QDir seen(words[1]);
  return (keeps ? tedit::desktop::keep(kept, seen) : tedit::desktop::check(kept, seen)) > 0;
}
