// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/conformance/conformance.hpp"

#include <stdlib.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "ops/conformance/kit.hpp"
#include "ops/loader/confinement.hpp"
#include "ops/services/host_services.hpp"

namespace tedit::ops {

namespace {

using namespace kit;

/// A folder of its own for one check, removed with all that lies in it.
class scratch_folder {
public:
  scratch_folder() {
    auto pattern = (std::filesystem::temp_directory_path() / "tedit-conformance-XXXXXX").string();
    if (mkdtemp(pattern.data()))
      path_ = pattern;
  }
  scratch_folder(const scratch_folder&) = delete;
  scratch_folder& operator=(const scratch_folder&) = delete;
  ~scratch_folder() {
    std::error_code code;
    if (!path_.empty())
      std::filesystem::remove_all(path_, code);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

constexpr auto last_mark = "unloading";
constexpr std::string_view finds_cases = "every_surface_alone";
constexpr std::string_view tag_pass = "pass ";
constexpr std::string_view tag_fail = "fail ";
constexpr std::string_view tag_remedy = "remedy ";
constexpr std::string_view tag_skip = "skip ";

/// The child's side of a check.
void run_check(const check& c, const plan& p, const child_reporter& reporter) {
  plugin_trial b(p, reporter);
  try {
    const auto seen = c.run(b);
    reporter.say(std::string(tag_pass) + seen);
  } catch (const failure& f) {
    reporter.say(std::string(tag_fail) + f.seen);
    reporter.say(std::string(tag_remedy) + f.remedy);
  } catch (const not_applicable& n) {
    reporter.say(std::string(tag_skip) + n.why);
  } catch (const std::exception& e) {
    reporter.say(std::string(tag_fail) + "it threw: " + e.what());
    reporter.say(std::string(tag_remedy) + "Report errors as expected<T>; throw nothing");
  }
  reporter.mark(last_mark);
}

conformance_row row_of(const check& c) {
  return {c.name, c.rule, verdict::not_run, {}, {}, {}};
}

void judge_death(const child_outcome& child, conformance_row& row) {
  row.outcome = verdict::fail;
  row.seen = "it " + child.death + " while " + (child.doing.empty() ? "starting" : child.doing);
  if (!child.last_stderr.empty())
    row.seen += "; its last words: " + child.last_stderr.back();
  row.remedy = child.death.starts_with("did not end")
                 ? "Bound every loop and ask ctx.run.cancel.cancelled() in it"
                 : "Run the same edit under a debugger: docs/plugins.md says how";
}

/// The parent's side: what the child said, or how it died.
conformance_row perform(const check& c, const plan& p, std::vector<std::string>& other_lines) {
  auto row = row_of(c);
  const scratch_folder folder;
  sandbox_limits limits{p.settings->limit, p.settings->memory_bytes, p.settings->cancel, {}, {}};
  if (sandbox::is_wanted()) {
    auto reach = reach_of_plugins({p.settings->file});
    reach.own_folder = folder.path();
    limits.confine = [reach] { return confine_to(reach); };
    limits.programs = programs_of_operations();
  }
  auto child = run_forked([&](const child_reporter& reporter) { run_check(c, p, reporter); },
                          folder.path(), limits);
  for (const auto& line : child.lines) {
    if (line.starts_with(tag_pass))
      row.outcome = verdict::pass, row.seen = line.substr(tag_pass.size());
    else if (line.starts_with(tag_fail))
      row.outcome = verdict::fail, row.seen = line.substr(tag_fail.size());
    else if (line.starts_with(tag_skip))
      row.seen = line.substr(tag_skip.size());
    else if (line.starts_with(tag_remedy))
      row.remedy = line.substr(tag_remedy.size());
    else
      other_lines.push_back(line);
  }
  row.log = child.last_stderr;
  if (child.death.empty() && child.doing != last_mark)
    child.death = "ended the process";  // By exit(): the check never came to its end.
  if (!child.death.empty())
    judge_death(child, row);
  return row;
}

/// The survey's lines "SAMPLE ID ID ...": the first of each sample, and the part's own selection.
std::vector<working_case> cases_from(const std::vector<std::string>& lines, const plan& p) {
  std::vector<working_case> result;
  for (const auto& line : lines) {
    std::istringstream in(line);
    working_case c;
    in >> c.sample;
    for (surface_id id = 0; in >> id;)
      c.surfaces.push_back(id);
    if (c.sample < p.samples.size() &&
        std::ranges::find(result, c.sample, &working_case::sample) == result.end())
      result.push_back(std::move(c));
  }
  return result;
}

/// The survey's lines "refused" and "refused WHAT IT LACKS remedy: REMEDY".
void note_refusals(std::vector<std::string>& lines, plan& p) {
  p.refusals = 0;
  p.unexplained.clear();
  std::erase_if(lines, [&](const std::string& line) {
    if (!line.starts_with(refused))
      return false;
    ++p.refusals;
    const auto mark = line.find(remedy_mark);
    if (mark != std::string::npos)
      p.unexplained.push_back({line.substr(refused.size() + 1, mark - refused.size() - 1),
                               line.substr(mark + remedy_mark.size())});
    return true;
  });
}

/// Rules and what was seen, from the lines with this mark; nothing unless all was looked at.
std::optional<std::vector<broken_rule>> rules_from(const std::vector<std::string>& lines,
                                                   std::string_view mark) {
  std::vector<broken_rule> result;
  for (const auto& line : lines) {
    const auto split = line.find('\t');
    if (line.starts_with(mark) && split != std::string::npos)
      result.push_back({line.substr(mark.size(), split - mark.size()), line.substr(split + 1)});
  }
  if (std::ranges::find(lines, looked_at) == lines.end())
    return std::nullopt;
  return result;
}

/// What a check has found out for those that come after it.
void note_findings(const check& c, const conformance_row& row,
                   const std::vector<std::string>& lines, plan& p) {
  const std::string_view name = c.name;
  if (p.settings->repeat > 1)
    return;  // Who repeats checks wants their edits made.
  if (name == "result_complete")
    p.broken = rules_from(lines, breaks);
  else if (name == "quiet")
    p.left_behind = rules_from(lines, leaves);
  else if (name == "deterministic" && row.outcome == verdict::pass)
    for (const auto& line : lines)
      if (line.starts_with(version_is))
        p.versions.push_back(line.substr(version_is.size()));
}

/// All checks in the order in which they run.
std::vector<check> all_checks() {
  std::vector<check> result;
  for (const auto* list :
       {&file_checks(), &description_checks(), &survey_checks(), &result_checks(),
        &running_checks(), &selection_checks(), &parameter_checks(), &residue_checks()})
    result.insert(result.end(), list->begin(), list->end());
  return result;
}

/// Checks about results that others meet, too, and need not tell again.
bool breaks_results(const check& c) {
  return std::ranges::find(result_checks(), std::string_view(c.name), &check::name) !=
         result_checks().end();
}

/// One run of the kit.
class conformance_run {
public:
  conformance_run(const conformance_settings& settings,
                  const std::function<void(const conformance_row&)>& done, std::uint32_t operation)
      : done_(done) {
    plan_.operation = operation;
    plan_.settings = &settings;
    plan_.samples = kit_samples();
    if (settings.part)
      plan_.samples.push_back({"the given part", settings.part});
  }

  conformance_report run() {
    for (const auto& c : all_checks())
      if ((plan_.operation == 0 || c.needs != need::nothing) && is_wanted(c) &&
          !plan_.settings->cancel.cancelled())  // The file is the same for all operations.
        take(c);
    return std::move(report_);
  }

  /// As the file says.
  [[nodiscard]] std::uint32_t operations() const { return operations_; }

private:
  [[nodiscard]] bool is_asked_for(const check& c) const {
    const auto& names = plan_.settings->checks;
    return names.empty() || std::ranges::find(names, c.name) != names.end();
  }

  [[nodiscard]] bool is_wanted(const check& c) const {
    return is_asked_for(c) || c.needs == need::nothing || std::string_view(c.name) == finds_cases;
  }

  conformance_row perform_repeatedly(const check& c, std::vector<std::string>& lines) const {
    auto row = perform(c, plan_, lines);
    const auto times = is_asked_for(c) ? plan_.settings->repeat : 1;
    for (unsigned i = 1; i < times && row.outcome == verdict::pass; ++i) {
      lines.clear();
      row = perform(c, plan_, lines);
      if (row.outcome == verdict::fail)
        row.seen =
          "run " + std::to_string(i + 1) + " of " + std::to_string(times) + ": " + row.seen;
    }
    return row;
  }

  void take(const check& c) {
    if (const auto why = obstacle(c); !why.empty()) {
      auto row = row_of(c);
      row.seen = why;
      report_.blocked = true;
      return add(std::move(row));
    }
    std::vector<std::string> lines;
    auto row = perform_repeatedly(c, lines);
    if (c.needs == need::nothing && !lines.empty())
      operations_ = static_cast<std::uint32_t>(std::stoul(lines[0].substr(lines[0].find(' '))));
    else if (std::string_view(c.name) == finds_cases) {
      note_refusals(lines, plan_);
      plan_.cases = cases_from(lines, plan_);
    }
    note_findings(c, row, lines, plan_);
    note_obstacles(c, row);
    if (std::string_view(c.name) == "descriptor" && row.outcome == verdict::pass)
      report_.plugin = row.seen.substr(0, row.seen.find(','));
    add(std::move(row));
  }

  /// What later checks need not run into again.
  void note_obstacles(const check& c, const conformance_row& row) {
    const std::string_view name = c.name;
    if (row.outcome != verdict::fail)
      return;
    const bool survey = name == finds_cases && plan_.cases.empty();
    if (c.needs == need::nothing || name == "defaults" || survey)
      obstacle_ = c.name;
    plan_.faulty = plan_.faulty || breaks_results(c);
    deterministic_ = deterministic_ && name != "deterministic";
  }

  /// Why a check makes no sense any more; empty when it does.
  [[nodiscard]] std::string obstacle(const check& c) const {
    if (!obstacle_.empty())
      return "not run: see " + obstacle_;
    if (c.needs >= need::working_case && plan_.cases.empty())
      return "not run: no selection works, see accepts_something";
    if (c.needs == need::deterministic && !deterministic_)
      return "not run: results differ from call to call, see deterministic";
    return {};
  }

  void add(conformance_row row) {
    row.operation = plan_.operation;
    if (done_)
      done_(row);
    report_.rows.push_back(std::move(row));
  }

  const std::function<void(const conformance_row&)>& done_;
  plan plan_;
  conformance_report report_;
  std::string obstacle_;
  bool deterministic_ = true;
  std::uint32_t operations_ = 1;
};

}  // namespace

bool conformance_report::ok() const {
  return !blocked && std::ranges::none_of(rows, [](const conformance_row& row) {
    return row.outcome == verdict::fail;
  });
}

conformance_report test_plugin(const conformance_settings& settings,
                               const std::function<void(const conformance_row&)>& done) {
  (void)built_in_operations();  // The checks have them from here.
  conformance_run first(settings, done, 0);
  auto report = first.run();
  for (std::uint32_t i = 1; i < first.operations(); ++i) {
    auto next = conformance_run(settings, done, i).run();
    report.blocked = report.blocked || next.blocked;
    std::ranges::move(next.rows, std::back_inserter(report.rows));
  }
  return report;
}

std::vector<conformance_row> conformance_checks() {
  std::vector<conformance_row> result;
  for (const auto& c : all_checks())
    result.push_back(row_of(c));
  return result;
}

}  // namespace tedit::ops
