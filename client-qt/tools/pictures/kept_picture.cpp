// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/pictures/kept_picture.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QThreadPool>

#include "client-qt/widgets/small_picture.hpp"

namespace tedit::desktop {

static constexpr QSize kept_size(264, 168);

static QString stem_of(const QString& state_folder, const QString& document) {
  return state_folder + "/pictures/" + QString::fromLatin1(document.toUtf8().toPercentEncoding());
}

/// One after the other, so that they can be waited for.
static QThreadPool& writers() {
  static QThreadPool pool;
  pool.setMaxThreadCount(1);
  return pool;
}

QString picture_file(const QString& state_folder, const QString& document) {
  return stem_of(state_folder, document) + ".png";
}

QString picture_file(const QString& state_folder, const QString& document,
                     const std::string& version_id) {
  return stem_of(state_folder, document) + "/" + QString::fromStdString(version_id) + ".png";
}

void remove_pictures(const QString& state_folder, const QString& document) {
  QFile::remove(picture_file(state_folder, document));
  QDir(stem_of(state_folder, document)).removeRecursively();
}

void move_pictures(const QString& state_folder, const QString& from, const QString& to) {
  writers().waitForDone();
  remove_pictures(state_folder, to);
  QFile::rename(picture_file(state_folder, from), picture_file(state_folder, to));
  QDir().rename(stem_of(state_folder, from), stem_of(state_folder, to));
}

void keep_picture(const QImage& frame, const QString& to) {
  writers().start([frame, to] {
    QDir().mkpath(QFileInfo(to).path());
    small_picture(frame, kept_size).save(to);
  });
}

}  // namespace tedit::desktop
