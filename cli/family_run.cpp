// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/family_run.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <thread>

#include "base/processors.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "cli/family_result.hpp"
#include "cli/recipe_runner.hpp"
#include "client/recipe_family.hpp"

namespace tedit::cli {

namespace {

constexpr const char* picture_size = "720x480";

/// A folder that goes with its owner.
class picture_folder {
public:
  picture_folder() = default;
  picture_folder(const picture_folder&) = delete;
  picture_folder& operator=(const picture_folder&) = delete;
  ~picture_folder() {
    std::error_code ignored;
    if (!path_.empty())
      std::filesystem::remove_all(path_, ignored);
  }
  expected<void> make() {
    std::error_code code;
    auto name = (std::filesystem::temp_directory_path(code) / "tedit-pictures-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      return fail(ec::io_error, "cannot make a folder for pictures",
                  "Set TMPDIR to a folder that can be written");
    path_ = name;
    return {};
  }
  /// Empty when none was made.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

std::string words_of(const client::recipe_step& step) {
  std::string text = client::kind_of(step);
  if (const auto* edit = std::get_if<client::edit_step>(&step))
    text += ": " + edit->request.operation + " " +
            client::words_of(edit->request.surfaces, edit->references);
  if (const auto* import = std::get_if<import_step>(&step))
    text += ": " + import->mesh.filename().string();
  if (const auto* loads = std::get_if<client::load_case_step>(&step))
    text += ": " + loads->loads.name;
  return text;
}

/// All steps of a recipe, none of which was begun.
std::vector<family_step> steps_of(const recipe& what, const std::optional<import_step>& mesh) {
  std::vector<family_step> steps;
  if (mesh)
    steps.push_back({0, words_of(*mesh)});
  for (const auto& step : what.steps)
    steps.push_back({steps.size() + (mesh ? 0 : 1), words_of(step)});
  return steps;
}

void take_figures(const solve_outcome& outcome, family_row& row) {
  const auto& worst = *std::ranges::max_element(outcome.cases, {}, &solve_report::max_von_mises_pa);
  row.mass_kg = worst.mass_kg;
  row.max_von_mises_pa = worst.max_von_mises_pa;
  row.error_estimate = worst.relative_error_estimate;
  if (worst.max_von_mises_singularity)
    row.singularity = *worst.max_von_mises_singularity == fem::singularity::clamp_rim
                        ? "at a clamp's rim"
                        : "at a re-entrant edge";
  row.max_displacement_m = worst.max_displacement_m;
  row.min_safety_factor = worst.min_safety_factor;
  row.preview = worst.preview;
  if (const auto& envelope = outcome.envelope) {
    row.max_displacement_m = envelope->max_displacement.value;
    row.preview = envelope->preview;
    if (envelope->min_safety_factor)
      row.min_safety_factor = envelope->min_safety_factor->value;
  }
}

/// Carries out rows, each on a document of its own.
class family_runner {
public:
  family_runner(const family_options& options, const client::recipe_family& family,
                client::connect_options how, const session& s, std::filesystem::path pictures)
      : options_(options),
        family_(family),
        how_(std::move(how)),
        session_(s),
        pictures_(std::move(pictures)) {
    session_.quiet = true;  // Many at once: what each has to tell is in the report.
    session_.json = false;
  }

  /// Never fails: what goes wrong is the row's.
  family_row carry_out(std::size_t number) const {
    const stopwatch clock;
    family_row row;
    row.number = number + 1;
    row.name = family_.name_of(number);
    const auto& table = family_.table();
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      row.cells.emplace_back(table.columns[c], table.rows[number].cells[c]);
    try {
      if (auto done = work(number, row); !done)
        row.failure = done.error();
    } catch (const std::bad_alloc&) {
      row.failure = error{ec::out_of_memory,
                          "there is not enough memory for this",
                          "Take fewer --jobs or a coarser mesh",
                          {}};
    } catch (const std::exception& e) {
      row.failure =
        error{ec::internal, e.what(), "This is a defect of TEdit: please report it", {}};
    }
    row.status = !row.failure                         ? family_status::passed
                 : row.failure->code == ec::cancelled ? family_status::not_run
                                                      : family_status::failed;
    row.ms = clock.milliseconds();
    return row;
  }

private:
  expected<void> work(std::size_t number, family_row& row) const {
    auto recipe = family_.recipe_of(number);
    if (!recipe)
      return fail(recipe.error());
    if (!options_.device.empty())
      recipe->device = options_.device;
    const auto mesh = mesh_for(*recipe, options_.mesh, options_.length_unit);
    if (!mesh)
      return fail(mesh.error());
    row.steps = steps_of(*recipe, *mesh);
    if (session_.cancel.cancelled())
      return fail(ec::cancelled, "interrupted");
    const auto failures = std::make_shared<failed_solves>();
    client::events handlers;
    handlers.on_solve_status = [failures](const client::solve_status& status) {
      if (status.phase == client::solve_phase::failed)
        failures->add(status.version_id);
    };
    const auto connected = client::client::connect(how_, handlers);
    if (!connected)
      return fail(connected.error());
    auto quiet = session_;
    recipe_runner runner(*recipe, quiet, **connected, failures, options_.out);
    auto done = runner.run(*mesh);
    take_steps(runner, row);
    row.files = runner.files();
    if (done)
      take_part(runner, **connected, row);
    else if (!runner.steps().empty() && runner.steps().back().failure)
      done = fail(*runner.steps().back().failure);
    if (!runner.document().empty())
      (void)(*connected)->delete_document(runner.document());  // It goes by itself, but later.
    return done;
  }

  static void take_steps(const recipe_runner& runner, family_row& row) {
    for (std::size_t i = 0; i < runner.steps().size() && i < row.steps.size(); ++i) {
      const auto& from = runner.steps()[i];
      auto& to = row.steps[i];
      to.ms = from.ms;
      to.passed_over = from.passed_over;
      to.status = !from.failure                         ? family_status::passed
                  : from.failure->code == ec::cancelled ? family_status::not_run
                                                        : family_status::failed;
    }
  }

  void take_part(recipe_runner& runner, client::client& server, family_row& row) const {
    if (runner.head().version_id.empty())
      return;
    const auto number = runner.head().number;
    if (const auto same = server.compare(number, number); same)
      row.volume_m3 = same->what.after.volume_m3;
    const auto* outcome = runner.outcome();
    if (outcome)
      take_figures(*outcome, row);
    if (pictures_.empty())
      return;
    if (!outcome) {
      row.picture_missing = "the recipe does not solve the last version";
      return;
    }
    const auto png = pictures_ / (std::to_string(row.number) + ".png");
    if (const auto drawn = runner.picture(row.name, picture_size, png); drawn)
      row.picture = png;
    else
      row.picture_missing = drawn.error().message;
  }

  const family_options& options_;
  const client::recipe_family& family_;
  client::connect_options how_;
  session session_;
  std::filesystem::path pictures_;
};

/// Solvers of a running server, its own and those that joined.
unsigned solvers_of(const client::server_status& status) {
  const auto solves = [](const auto& one) { return one.role == "solver"; };
  return static_cast<unsigned>(std::ranges::count_if(status.workers, solves) +
                               std::ranges::count_if(status.nodes, solves));
}

/// The rows, `jobs` at a time; each lies at its place, whoever is done first.
void carry_out_all(const family_runner& runner, const session& s, family_result& result) {
  std::atomic<std::size_t> next{0};
  std::mutex telling;
  std::size_t done = 0;
  std::size_t failed = 0;
  const auto run = make_execution(s);
  const auto work = [&] {
    for (auto row = next++; row < result.rows.size(); row = next++) {
      result.rows[row] = runner.carry_out(row);
      const std::lock_guard lock(telling);
      ++done;
      failed += result.rows[row].status == family_status::failed ? 1 : 0;
      run.report(static_cast<double>(done) / static_cast<double>(result.rows.size()),
                 std::to_string(done) + " of " + std::to_string(result.rows.size()) + " rows, " +
                   std::to_string(failed) + " failed");
    }
  };
  std::vector<std::thread> others;
  for (unsigned i = 1; i < result.jobs; ++i)
    others.emplace_back(work);
  work();
  for (auto& one : others)
    one.join();
  end_progress(s);
}

/// What is wrong with the report's file is said before hours of work, not after.
expected<void> check_report(const std::string& file) {
  if (file.empty())
    return {};
  const std::filesystem::path path(file);
  if (auto ok = check_report_name(path); !ok)
    return ok;
  std::error_code ignored;
  if (path.has_parent_path())
    std::filesystem::create_directories(path.parent_path(), ignored);
  const bool is_new = !std::filesystem::exists(path, ignored);
  const bool writable = static_cast<bool>(std::ofstream(path, std::ios::app));
  if (!writable)
    return fail(ec::io_error, "cannot write the report " + file, "Choose another folder");
  if (is_new)
    std::filesystem::remove(path, ignored);
  return {};
}

/// All that can be known before the first row begins.
expected<std::string> check_rows(const client::recipe_family& family,
                                 const family_options& options) {
  if (auto ok = family.check(); !ok)
    return fail(ok.error());
  std::string name;
  for (std::size_t row = 0; row < family.table().rows.size(); ++row) {
    const auto recipe = family.recipe_of(row);
    if (!recipe)
      return fail(recipe.error());
    const auto mesh = mesh_for(*recipe, options.mesh, options.length_unit);
    if (!mesh)
      return fail(mesh.error());
    if (auto ok = recipe_runner::check(*recipe); !ok)
      return fail(ok.error());
    name = row == 0 ? recipe->name : name;
  }
  return name;
}

expected<client::recipe_family> read_family(const family_options& options,
                                            const client::connect_options& how, unsigned& jobs) {
  const auto connected = client::client::connect(how, {});
  if (!connected)
    return fail(connected.error());
  const auto offered = (*connected)->operations();
  if (!offered)
    return fail(offered.error());
  if (options.remote && jobs == 0) {
    const auto status = (*connected)->status();
    if (!status)
      return fail(status.error());
    jobs = std::clamp(solvers_of(*status), 1U, most_family_jobs);
  }
  return client::recipe_family::read(options.recipe, options.table, *offered);
}

/// Status and words at the end. Errors: of the report's file.
int finish(family_result& result, const family_options& options, const session& s) {
  if (!options.report.empty()) {
    if (const auto written = write_report(result, options.report); !written)
      return print_error(s, written.error());
    result.report = options.report;
  }
  print_result(s, to_json(result), describe(result));
  if (s.cancel.cancelled())
    return exit_status(ec::cancelled);
  return result.count(family_status::passed) == result.rows.size() ? 0 : 1;
}

}  // namespace

int run_family(const family_options& options, const server_source& reach, session& s) {
  const stopwatch clock;
  const auto table = client::read_csv(options.table);
  if (!table)
    return print_error(s, table.error());
  if (const auto ok = check_report(options.report); !ok)
    return print_error(s, ok.error());
  const auto rows = static_cast<unsigned>(table->rows.size());
  auto jobs = options.jobs;
  if (jobs == 0 && !options.remote)
    jobs = std::clamp(processors(), 1U, most_family_jobs);
  embedded_server own;
  auto how = reach(std::clamp(jobs, 1U, rows), own);
  if (!how)
    return print_error(s, how.error());
  how->client_name = "tedit run " TEDIT_VERSION;
  const auto family = read_family(options, *how, jobs);
  if (!family)
    return print_error(s, family.error());
  const auto name = check_rows(*family, options);
  if (!name)
    return print_error(s, name.error());
  picture_folder pictures;
  if (!options.report.empty())
    if (const auto made = pictures.make(); !made)
      return print_error(s, made.error());
  family_result result;
  result.name = *name;
  result.table = options.table;
  result.server = how->url;
  result.program = "TEdit " TEDIT_VERSION;
  result.jobs = std::clamp(jobs, 1U, rows);
  result.rows.resize(rows);
  carry_out_all(family_runner(options, *family, *how, s, pictures.path()), s, result);
  result.ms = clock.milliseconds();
  return finish(result, options, s);
}

}  // namespace tedit::cli
