// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/results_summary/results_summary_tool.hpp"

#include <QDockWidget>
#include <QFileDialog>
#include <QMainWindow>
#include <QStackedWidget>
#include <QTreeWidget>

#include <algorithm>
#include <utility>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/tools/results_summary/report_file.hpp"
#include "client-qt/tools/results_summary/report_pictures.hpp"
#include "client-qt/tools/results_summary/results_summary_panel.hpp"
#include "client-qt/tools/selection/selection_tool.hpp"

namespace tedit::desktop {

namespace {

constexpr int least_picture_width = 900;  // Pixels of a report's pictures.

std::array<double, 3> key_of(const vec3& at) {
  return {at.x, at.y, at.z};
}

}  // namespace

results_summary_tool::results_summary_tool(window_context& in, field_panel& fields,
                                           selection_tool& selecting)
    : in_(in), fields_(fields), selecting_(selecting), panel_(new results_summary_panel) {
  in_.panels.add("results", tr("Results"), panel_);
  finders_.setMaxThreadCount(1);
  wire();
  add_commands();
  refresh();
}

results_summary_tool::~results_summary_tool() {
  finders_.clear();
  finders_.waitForDone();
}

void results_summary_tool::wire() {
  for (auto signal : {&document::head_changed, &document::surface_changed, &document::field_changed,
                      &document::history_changed, &document::opened, &document::closed})
    connect(&in_.part, signal, this, &results_summary_tool::refresh_soon);
  connect(&in_.part.solver(), &solve_requests::changed, this, &results_summary_tool::refresh_soon);
  connect(&in_.part.loads(), &load_requests::changed, this, &results_summary_tool::refresh_soon);
  connect(&in_.look, &appearance::changed, panel_,
          [this](const theme& look) { panel_->set_warning_ink(look.warning); });
  connect(panel_, &results_summary_panel::row_wanted, this, &results_summary_tool::go_to);
  connect(panel_, &results_summary_panel::report_wanted, this, &results_summary_tool::ask_report);
}

void results_summary_tool::add_commands() {
  in_.all_commands.add({"view.results", tr("Results"), command_groups::view(), "R",
                        [this] {
                          in_.panels.of("results").show();
                          in_.panels.raise("results");
                          panel_->tree()->setFocus();
                        },
                        in_.has_part(),
                        tr("How strong the part is: largest stress, safety, reactions")});
  in_.all_commands.add({"results.copy",
                        tr("Copy the results as a table"),
                        command_groups::edit(),
                        {},
                        [this] { panel_->copy(); },
                        [this] { return !panel_->summary().sections.empty(); }});
  in_.all_commands.add({"file.report", tr("Report"), command_groups::file(), "Ctrl+Shift+R",
                        [this] { ask_report(); }, in_.has_part(),
                        tr("Pictures, loads, figures and what to trust, as PDF or HTML")});
}

// -- rows ----------------------------------------------------------------------------

/// Several things change together.
void results_summary_tool::refresh_soon() {
  if (std::exchange(refreshing_, true))
    return;
  QMetaObject::invokeMethod(
    this,
    [this] {
      refreshing_ = false;
      refresh();
    },
    Qt::QueuedConnection);
}

void results_summary_tool::refresh() {
  auto summary = summarise(summary_input_of(in_.part));
  look_for(points_of(summary));
  name_places(summary, [this](const vec3& at) { return words_at(at); });
  if (summary != panel_->summary())
    panel_->show_summary(summary);
}

/// Once they are found rows are shown again.
void results_summary_tool::look_for(const std::vector<vec3>& points) {
  const auto* head = in_.part.head();
  const auto surface = head ? head->surface : nullptr;
  const std::string version = surface ? surface->version_id() : std::string();
  if (std::exchange(placed_, version) != version)
    places_.clear();
  std::vector<vec3> unknown;
  for (const auto& at : points)
    if (surface && places_.try_emplace(key_of(at)).second)
      unknown.push_back(at);
  if (unknown.empty())
    return;
  find_aside(surface, unknown, [this, version, unknown](const std::vector<found_place>& found) {
    if (placed_ != version)
      return;
    for (std::size_t i = 0; i < unknown.size(); ++i)
      places_[key_of(unknown[i])] = found[i];
    refresh();
  });
}

/// On another thread: a part may have millions of facets.
void results_summary_tool::find_aside(const shared_surface& on, const std::vector<vec3>& points,
                                      std::function<void(const std::vector<found_place>&)> then) {
  finders_.start([this, on, points, then = std::move(then)] {
    QMetaObject::invokeMethod(
      this, [found = find_places(*on, points), then] { then(found); }, Qt::QueuedConnection);
  });
}

const found_place* results_summary_tool::place_of(const vec3& at) const {
  const auto found = places_.find(key_of(at));
  return found == places_.end() || !found->second ? nullptr : &*found->second;
}

QString results_summary_tool::words_at(const vec3& at) const {
  const auto* place = place_of(at);
  return place ? words(*place, [this](surface_id id) { return in_.part.surface_name(id); })
               : QString();
}

// -- the way to a place --------------------------------------------------------------

void results_summary_tool::go_to(const result_row& row, const QString& load_case) {
  in_.pages.setCurrentWidget(&in_.view);
  if (!load_case.isEmpty())
    fields_.set_case(load_case);
  if (row.at)
    fly_to(*row.at);
  else if (!row.surfaces.empty())
    selecting_.highlight(QList<qint64>(row.surfaces.begin(), row.surfaces.end()));
}

/// Seen from where one looks now, or from outside where the part hides the place.
void results_summary_tool::fly_to(const vec3& at) {
  const auto* place = place_of(at);
  in_.view.show_place(drawn_at(at), place ? place->outward : vec3{});
}

/// Where the place is in the deformed picture; of a place that is no vertex of the surface, where
/// it is in the part.
vec3 results_summary_tool::drawn_at(const vec3& at) const {
  const auto& now = in_.view.current();
  const auto& field = now.field;
  if (now.deform == 0 || !field || !now.surface || field->version_id() != now.surface->version_id())
    return at;
  const auto& moved = field->values.of("displacement_m");
  if (moved.empty())
    return at;
  for (std::size_t i = 0; i < field->vertices.size(); ++i)
    if (const auto* vertex = now.surface->positions().find(field->vertices[i]);
        vertex && *vertex == at) {
      const float* u = &moved[3 * i];
      return at + now.deform * vec3{u[0], u[1], u[2]};
    }
  return at;
}

// -- the report ----------------------------------------------------------------------

void results_summary_tool::ask_report() {
  auto* dialog = new QFileDialog(&in_.window, tr("Save the report"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilters({tr("PDF (*.pdf)"), tr("Web page (*.html)")});
  dialog->setDefaultSuffix("pdf");
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
    dialog->setDefaultSuffix(filter.section("*.", 1).chopped(1));
  });
  connect(dialog, &QFileDialog::fileSelected, this, &results_summary_tool::write_report);
  dialog->open();
}

/// First the words of all places, then the pictures, then the file.
void results_summary_tool::write_report(const QString& path) {
  if (report_) {
    emit in_.part.failed(
      tr("Report"), {ec::conflict, "another report is being written",
                     "Wait for it: \"What runs\" (J) shows how far it is", path.toStdString()});
    return;
  }
  report_ = pending_report();
  report_->path = path;
  report_->facts = facts_of(in_.part, QDateTime::currentDateTime());
  report_->job = in_.part.work().begin(tr("Report"), {});
  auto what = pictured();
  const auto surface = what.surface;
  report_->pictures = std::make_unique<report_pictures>(std::move(what));
  const auto points = points_of(report_->facts);
  if (!surface || points.empty())
    return take_pictures();
  find_aside(surface, points, [this, points](const std::vector<found_place>& found) {
    auto& facts = report_->facts;
    std::map<point, QString> known;
    for (std::size_t i = 0; i < points.size(); ++i)
      known[key_of(points[i])] = words(found[i], facts.surface_name);
    facts.place_words = [known](const vec3& at) {
      const auto place = known.find(key_of(at));
      return place == known.end() ? QString() : place->second;
    };
    name_places(facts.figures, facts.place_words);
    take_pictures();
  });
}

pictured_part results_summary_tool::pictured() const {
  pictured_part what;
  if (const auto* head = in_.part.head()) {
    what.surface = head->surface;
    if (report_->facts.outcome)
      what.fields = head->fields;
    what.load_cases = report_->facts.load_cases;
  }
  what.by = fields_.wanted();
  what.deform = fields_.deform();
  what.from = in_.view.view().get();
  what.parallel = in_.view.view().is_parallel();
  what.hidden = selecting_.hidden();
  what.note = in_.truth.verdict();
  const QSize screen = in_.view.size();
  const int width = std::max(least_picture_width, screen.width());
  what.size = {width, std::max(1, width * screen.height() / std::max(1, screen.width()))};
  return what;
}

void results_summary_tool::take_pictures() {
  connect(report_->pictures.get(), &report_pictures::progressed, this, [this](int made, int all) {
    in_.part.work().progress(report_->job, static_cast<double>(made) / all,
                             tr("picture %1 of %2").arg(made).arg(all));
  });
  connect(report_->pictures.get(), &report_pictures::finished, this,
          &results_summary_tool::finish_report, Qt::QueuedConnection);
  report_->pictures->start();
}

void results_summary_tool::finish_report(const std::vector<report_picture>& pictures) {
  report_->facts.pictures = pictures;
  const auto written = write_report_file(report_->facts, report_->path);
  const QString path = report_->path;
  in_.part.work().end(report_->job);
  report_.reset();
  if (written)
    emit in_.part.files().exported(path);
  else
    emit in_.part.failed(tr("Report"), written.error());
}

}  // namespace tedit::desktop
