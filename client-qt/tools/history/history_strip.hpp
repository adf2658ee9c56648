// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QImage>
#include <QListWidget>

#include <map>
#include <set>

#include "client-qt/model/document.hpp"
#include "client-qt/model/version_lanes.hpp"
#include "client-qt/widgets/theme.hpp"

namespace tedit::desktop {

/// The versions of the document as a tree: edits go to the right, branches stand below. Each has a
/// small picture and what changed: operation or name, largest stress, note, below it or, once there
/// are branches, beside it. The head has a frame. Of a part that came from CAD the picture says
/// whether the CAD model has the version, too.
/// Arrow keys go from place to place, Enter goes to a version, F2 names it.
class history_strip : public QListWidget {
  Q_OBJECT

public:
  explicit history_strip(document& part, QWidget* parent = nullptr);

  void set_theme(const theme& look);

  /// A picture without a field counts while none with a field is asked for.
  [[nodiscard]] bool has_thumbnail(const std::string& version_id, bool with_field) const {
    return pictures_.contains(version_id) && (!with_field || !plain_.contains(version_id));
  }
  /// The picture of a version, by its content.
  void set_thumbnail(const std::string& version_id, const QImage& picture, bool with_field);

  /// Pictures with their fields from an earlier time, for versions that have none by now.
  void find_thumbnails(const std::map<std::string, QImage>& kept);
  /// The picture's field is not the version's any more: the next one replaces it.
  void outdate(const std::string& version_id) { plain_.insert(version_id); }

  /// Opens the fields for name and note of the chosen version.
  void edit_words();

signals:
  void version_wanted(quint32 number);
  /// With the present one.
  void comparison_wanted(quint32 number);

protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  /// Sideways where there is nothing below.
  void wheelEvent(QWheelEvent* event) override;
  void doItemsLayout() override;

private:
  void refresh();
  void keep(const std::string& version_id, const QImage& picture);
  void put_in_places();
  [[nodiscard]] QSize picture_size() const;
  [[nodiscard]] QSize cell() const;  ///< With words and the way to the next one.
  [[nodiscard]] QPixmap picture_of(const version_record& version) const;
  [[nodiscard]] QString describe(const version_record& version) const;
  [[nodiscard]] QString details(const version_record& version) const;
  [[nodiscard]] QRect frame_of(std::uint32_t number) const;

  document& part_;
  std::map<std::string, QPixmap> pictures_;
  std::set<std::string> plain_;  ///< Whose pictures have no field.
  std::map<std::uint32_t, version_place> places_;
  std::map<std::uint32_t, QListWidgetItem*> rows_;
  std::optional<std::uint32_t> head_;  ///< As it is shown.
  bool branches_ = false;
  bool placing_ = false;
  theme look_;
};

}  // namespace tedit::desktop
