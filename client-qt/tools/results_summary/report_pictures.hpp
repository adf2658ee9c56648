// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include <memory>
#include <set>
#include <vector>

#include "client-qt/model/document.hpp"
#include "client-qt/model/legend.hpp"
#include "client-qt/model/report_document.hpp"
#include "client-qt/view/overlay.hpp"
#include "client-qt/view/viewport.hpp"

namespace tedit::desktop {

/// What a report shows of a part: all of it is kept as it was when the report was asked for.
struct pictured_part {
  shared_surface surface;
  std::vector<shared_field> fields;  ///< One for each load case, then their envelope.
  std::vector<fem::load_case> load_cases;
  legend by;  ///< As on the screen.
  double deform = 0;
  camera::pose from;
  bool parallel = false;
  QSize size;  ///< Pixels.
  std::set<surface_id> hidden;
  QString note;  ///< Below the legend: "final".
};

/// Draws the pictures of a report one after the other in a view of its own that nobody sees, in
/// light colours: the part with its field for each load case, then not deformed with its loads. The
/// window goes on meanwhile.
class report_pictures : public QObject {
  Q_OBJECT

public:
  explicit report_pictures(pictured_part what, QObject* parent = nullptr);
  ~report_pictures() override;

  void start();

signals:
  void progressed(int made, int all);
  void finished(const std::vector<tedit::desktop::report_picture>& pictures);

private:
  /// One picture: a field, or loads.
  struct step {
    QString caption;
    shared_field field;                 ///< Null: the bare part,
    std::vector<fem::load_case> loads;  ///< with these.
  };
  void list_steps();
  void show_step();
  void take();

  pictured_part what_;
  std::vector<step> steps_;
  std::size_t at_ = 0;
  std::vector<report_picture> made_;
  std::unique_ptr<viewport> view_;
  overlay* over_;
  QTimer poll_;
};

}  // namespace tedit::desktop
