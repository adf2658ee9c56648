// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client-qt/context/window_context.hpp"
#include "client-qt/model/place_words.hpp"
#include "client-qt/model/report_document.hpp"
#include "client-qt/tools/results_summary/report_pictures.hpp"

namespace tedit::desktop {

class field_panel;
class results_summary_panel;
class selection_tool;

/// How strong the part is: its figures, the way to their places, and the report about them.
class results_summary_tool : public QObject {
  Q_OBJECT

public:
  results_summary_tool(window_context& in, field_panel& fields, selection_tool& selecting);
  ~results_summary_tool() override;

  [[nodiscard]] results_summary_panel& panel() { return *panel_; }
  /// Writes a report of the head as it is now, by the suffix of `path`; pictures take a moment. The
  /// document's `exported` or `failed` follows. One at a time: another call is refused meanwhile.
  void write_report(const QString& path);
  [[nodiscard]] bool writes_report() const noexcept { return report_.has_value(); }

private:
  using point = std::array<double, 3>;

  void wire();
  void add_commands();
  void refresh_soon();
  void refresh();
  void look_for(const std::vector<vec3>& points);
  void find_aside(const shared_surface& on, const std::vector<vec3>& points,
                  std::function<void(const std::vector<found_place>&)> then);
  [[nodiscard]] const found_place* place_of(const vec3& at) const;
  [[nodiscard]] QString words_at(const vec3& at) const;
  void go_to(const result_row& row, const QString& load_case);
  void fly_to(const vec3& at);
  [[nodiscard]] vec3 drawn_at(const vec3& at) const;
  void ask_report();
  [[nodiscard]] pictured_part pictured() const;
  void take_pictures();
  void finish_report(const std::vector<report_picture>& pictures);

  /// A report that is being made: of the part as it was when it was asked for.
  struct pending_report {
    QString path;
    report_facts facts;
    int job = 0;
    std::unique_ptr<report_pictures> pictures;
  };

  window_context& in_;
  field_panel& fields_;
  selection_tool& selecting_;
  results_summary_panel* panel_;
  std::optional<pending_report> report_;
  QThreadPool finders_;
  /// Of points of the surface of version `placed_`; empty while they are sought.
  std::map<point, std::optional<found_place>> places_;
  std::string placed_;
  bool refreshing_ = false;
};

}  // namespace tedit::desktop
