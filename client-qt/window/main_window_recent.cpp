// SPDX-License-Identifier: AGPL-3.0-or-later
// The documents that were open before, with a picture of each.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QThreadPool>

#include "client-qt/tools/documents/recent_documents.hpp"
#include "client-qt/tools/documents/welcome_page.hpp"
#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/view/viewport.hpp"
#include "client-qt/window/main_window.hpp"

namespace tedit::desktop {

static constexpr int most_recent = 12;
static constexpr QSize kept_picture(264, 168);

QString main_window::picture_file(const QString& document) const {
  return local_.folder() + "/pictures/" +
         QString::fromLatin1(document.toUtf8().toPercentEncoding()) + ".png";
}

void main_window::remember(const QString& document) {
  auto recent = settings_.value("recent").toStringList();
  recent.removeAll(document);
  recent.prepend(document);
  for (const auto& old : recent.mid(most_recent))
    QFile::remove(picture_file(old));
  recent = recent.mid(0, most_recent);
  QVariantMap used = settings_.value("recent_used").toMap();
  used[document] = QDateTime::currentDateTime();
  for (const auto& name : used.keys())
    if (!recent.contains(name))
      used.remove(name);
  settings_.setValue("recent", recent);
  settings_.setValue("recent_used", used);
}

void main_window::show_recent() {
  const auto used = settings_.value("recent_used").toMap();
  std::vector<recent_document> all;
  for (const auto& name : settings_.value("recent").toStringList())
    all.push_back({name, used[name].toDateTime(), QImage(picture_file(name))});
  welcome_->set_recent(std::move(all));
}

/// The head as it is drawn, once for each version and field; written aside.
void main_window::keep_picture(const QImage& frame) {
  const QString to = picture_file(part_.name());
  QThreadPool::globalInstance()->start([frame, to] {
    const QImage fitted =
      frame.scaled(kept_picture, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    const QRect middle(QPoint((fitted.width() - kept_picture.width()) / 2,
                              (fitted.height() - kept_picture.height()) / 2),
                       kept_picture);
    QDir().mkpath(QFileInfo(to).path());
    fitted.copy(middle).save(to);
  });
}

/// Of a frame that is there: the window waits for none.
void main_window::take_pictures() {
  const auto* head = part_.head();
  if (!head || !view_->is_seen() || !view_->is_fine() || view_->current().before ||
      view_->current().surface != head->surface)
    return;
  const auto field = view_->current().field;
  const bool coloured = field && field->version_id() == head->info.version_id;
  const QString now =
    part_.name() + "/" + QString::fromStdString(head->info.version_id) + (coloured ? "/field" : "");
  const bool fresh = std::exchange(pictured_, now) != now;
  const auto due = std::exchange(thumbnail_due_, {});
  if (!fresh && due.empty())
    return;
  const QImage frame = view_->last_picture();
  if (fresh)
    keep_picture(frame);
  if (!due.empty())
    history_->set_thumbnail(due, frame, coloured);
}

}  // namespace tedit::desktop
