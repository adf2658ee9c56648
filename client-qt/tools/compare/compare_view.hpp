// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include <map>
#include <optional>
#include <set>

#include "client-qt/model/compare.hpp"
#include "client-qt/view/viewport.hpp"
#include "client-qt/widgets/theme.hpp"

class QLabel;
class QListWidget;
class QPushButton;

namespace tedit::desktop {

class legend_strip;
class overlay;

/// What two versions are compared by.
struct comparison {
  std::uint32_t before = 0;  ///< Numbers of the versions.
  std::uint32_t after = 0;
  legend by;              ///< Quantity and colours; its range when it is not automatic.
  std::string load_case;  ///< Empty: the envelope, or the only one.
  double deform = 0;
  camera::pose from;   ///< Where both are looked at from,
  double aspect = 1;   ///< in a view of this width to height.
  bool whole = false;  ///< All of the part was made to fit there: so are both here.
};

/// Two versions side by side with linked cameras and one legend below, or their difference on the
/// later one's surface. They begin as near as the part was looked at, and no farther away than what
/// shows all of both.
class compare_view : public QWidget {
  Q_OBJECT

public:
  explicit compare_view(document& part, QWidget* parent = nullptr);

  void open(const comparison& what);
  void show_difference(bool on);
  [[nodiscard]] bool shows_difference() const noexcept { return difference_; }
  void set_theme(const theme& look);

signals:
  void closed();
  /// One of the versions was not solved here; it is, once it was the head.
  void version_wanted(quint32 number);

protected:
  void showEvent(QShowEvent* event) override;

private:
  /// A version under its title.
  struct pane {
    QWidget* box;
    QLabel* title;
    viewport* view;
    overlay* over;
  };

  [[nodiscard]] pane make_pane(const char* name);
  void link(const pane& from, const pane& to);
  void refresh();
  [[nodiscard]] bool fetch_missing();
  void fetched(std::uint32_t number, const expected<shared_surface>& got);
  void show_missing(const QString& why, bool may_go);
  void show_both(const version_record& before, const version_record& after);
  /// On the surface of the version after.
  void show_change(const shared_surface& surface, const shared_field& change);
  [[nodiscard]] shared_field server_change(const version_record& after, QString& why);
  void ask_server(const std::string& load_case);
  void take_start_pose();
  void step_back(double factor);
  void look_from(const camera::pose& pose);
  void follow_size(const QSize& before, const QSize& now);
  [[nodiscard]] camera::pose whole_pose();
  [[nodiscard]] double distance_for(const QSize& size) const;
  bool eventFilter(QObject* watched, QEvent* event) override;

  document& part_;
  theme look_;
  std::optional<comparison> what_;
  bool difference_ = false;
  bool linking_ = false;
  bool posed_ = false;
  std::optional<camera::pose> whole_;  ///< As it was last made to fit.
  shared_field change_;                ///< Kept, so that a refresh shows the same one.
  std::pair<shared_field, shared_field> change_of_;
  /// What the server says where fields are not here.
  std::optional<expected<shared_comparison>> server_says_;
  bool asked_server_ = false;
  std::map<std::uint32_t, shared_surface> fetched_;  ///< Of versions that were not at hand.
  std::set<std::uint32_t> asked_;
  QString refused_;  ///< Why one of them does not come.
  QPushButton* both_;
  QPushButton* change_button_;
  QWidget* panes_;
  legend_strip* legend_;  ///< One for both.
  pane before_;
  pane after_;
  QWidget* missing_;
  QLabel* why_;
  QPushButton* go_;
  std::uint32_t wanted_ = 0;
};

/// Lets a version of the history be dragged onto another: `then` gets the dragged one and the one
/// it was dropped on.
class version_drag : public QObject {
  Q_OBJECT

public:
  explicit version_drag(QListWidget& history);

signals:
  void dropped(quint32 dragged, quint32 onto);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QListWidget& history_;
  quint32 dragged_ = 0;
};

}  // namespace tedit::desktop
