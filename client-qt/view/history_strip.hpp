// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QImage>
#include <QListWidget>

#include <map>

#include "client-qt/model/document.hpp"

namespace tedit::desktop {

/// The versions of the document in the order in which they were made, each with a small picture and
/// what changed: operation, largest stress, mass, worst tet.
class history_strip : public QListWidget {
  Q_OBJECT

public:
  explicit history_strip(document& part, QWidget* parent = nullptr);

  [[nodiscard]] bool has_thumbnail(const std::string& version_id) const {
    return pictures_.contains(version_id);
  }
  /// The picture of a version, by its content.
  void set_thumbnail(const std::string& version_id, const QImage& picture);

signals:
  void version_wanted(quint32 number);

private:
  void refresh();
  [[nodiscard]] QString describe(const version_record& version) const;
  [[nodiscard]] QString details(const version_record& version) const;

  document& part_;
  std::map<std::string, QPixmap> pictures_;
};

}  // namespace tedit::desktop
