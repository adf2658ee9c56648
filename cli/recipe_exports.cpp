// SPDX-License-Identifier: AGPL-3.0-or-later
// The steps of a recipe that write files.
#include <algorithm>
#include <fstream>

#include "base/child_process.hpp"
#include "base/named_error.hpp"
#include "cli/export_step.hpp"
#include "cli/recipe_runner.hpp"
#include "cli/reports.hpp"
#include "mesh/formats.hpp"

namespace tedit::cli {

namespace {

/// The report with the largest stress.
const solve_report& worst_of(const solve_outcome& outcome) {
  return *std::ranges::max_element(outcome.cases, {}, &solve_report::max_von_mises_pa);
}

/// What a picture's numbers are worth, and where its colours end before the field does. Of several
/// load cases it shows the envelope.
std::string caption_of(const solve_outcome& outcome, const export_step& s) {
  const auto& shown = worst_of(outcome);
  const bool preview = outcome.envelope ? outcome.envelope->preview : shown.preview;
  std::string place = shown.element_order < 2 ? " (element)" : " (node)";
  if (shown.max_von_mises_singularity)
    place += *shown.max_von_mises_singularity == fem::singularity::clamp_rim
               ? " at a clamp's rim"
               : " at a re-entrant edge";
  if (outcome.envelope)
    place += ", worst of " + std::to_string(outcome.cases.size()) + " load cases";
  const bool beyond = s.range_mpa && 1e-6 * shown.max_von_mises_pa > s.range_mpa->second;
  const auto clipped = beyond ? ",  colours end at " + pretty(s.range_mpa->second) + " MPa" : "";
  return std::string(shown.element_order < 2 ? "Preview: linear tets understate bending.  "
                     : preview               ? "Preview: stopped early.  "
                                             : "Quadratic tets,  ") +
         "max von Mises " + pretty(1e-6 * shown.max_von_mises_pa, 4) + " MPa" + place + clipped +
         ",  error estimate " + pretty(100 * shown.relative_error_estimate, 2) + " %,  residual " +
         pretty(shown.true_relative_residual, 2) + ",  version " + shown.version_id.substr(0, 8);
}

}  // namespace

std::filesystem::path recipe_runner::path_of(const std::string& name) const {
  std::string text = name;
  const std::string mark = "{version}";
  if (const auto at = text.find(mark); at != std::string::npos)
    text.replace(at, mark.size(), std::to_string(head_.number));
  return out_ / text;
}

expected<void> recipe_runner::write(const std::string& format, const std::filesystem::path& path) {
  if (format == client::step_format)
    return write_step(path);
  const bool whole = format == document_format;
  const auto bytes = server_.export_file(format, whole ? std::string() : head_.version_id,
                                         whole ? "" : "mm", make_execution(session_));
  end_progress(session_);
  if (!bytes)
    return fail(bytes.error());
  std::error_code ignored;
  std::filesystem::create_directories(path.parent_path(), ignored);
  std::ofstream out(path, std::ios::binary);
  out.write(bytes->data(), static_cast<std::streamsize>(bytes->size()));
  out.close();
  if (!out)
    return fail(ec::io_error, "cannot write " + path.string(), "Choose another folder with --out");
  return {};
}

/// Edits that the server has not made on the model yet are made now.
expected<void> recipe_runner::write_step(const std::filesystem::path& path) {
  const auto copy = std::filesystem::path(path.string() + ".tedit");
  if (auto ok = write(std::string(document_format), copy); !ok)
    return ok;
  const auto done =
    export_step_file({copy.string(), path.string(), head_.number}, make_execution(session_));
  end_progress(session_);
  std::error_code ignored;
  for (const char* with : {"", "-wal", "-shm"})
    std::filesystem::remove(copy.string() + with, ignored);
  if (done)
    return {};
  auto why = named_error(done.error(), copy.string(), "the part");
  if (why.code == ec::not_found)
    why.remedy =
      "Begin the recipe with an import step of a CAD file; edits that are in the mesh only have no "
      "place in a STEP file";
  return fail(std::move(why));
}

expected<void> recipe_runner::draw(const export_step& s, const std::filesystem::path& png,
                                   const std::vector<std::string>& more) {
  const auto wanted = s.files.find("vtu");
  const bool aside = wanted == s.files.end();
  const auto vtu = aside ? std::filesystem::path(png.string() + ".vtu") : path_of(wanted->second);
  if (aside)
    if (auto ok = write("vtu", vtu); !ok)
      return ok;
  const auto& shown = solved_.at(head_.version_id).outcome;
  const auto caption = caption_of(shown, s);
  std::vector<std::string> command{(executable_folder() / "tedit-render").string(),
                                   vtu.string(),
                                   "-o",
                                   png.string(),
                                   "--title",
                                   s.title,
                                   "--caption",
                                   caption};
  if (shown.envelope) {
    command.push_back("--field");
    command.push_back("envelope_von_mises");
  }
  if (s.range_mpa) {
    command.push_back("--range");
    command.push_back(pretty(s.range_mpa->first, 9) + "," + pretty(s.range_mpa->second, 9));
  }
  command.insert(command.end(), more.begin(), more.end());
  const auto drawn = run_child(command, {}, {std::chrono::minutes(2), 0}, make_execution(session_));
  std::error_code ignored;
  if (aside)
    std::filesystem::remove(vtu, ignored);
  if (!drawn)
    return fail(drawn.error().code,
                "the picture " + png.string() + " could not be drawn: " + drawn.error().message,
                "Try \"tedit render\" by hand: it says more");
  return {};
}

expected<void> recipe_runner::picture(const std::string& title, const std::string& size,
                                      const std::filesystem::path& png) {
  export_step wanted;
  wanted.title = title;
  for (const auto& one : recipe_.steps)
    if (const auto* written = std::get_if<export_step>(&one); written && written->range_mpa)
      wanted.range_mpa = written->range_mpa;
  return draw(wanted, png, {"--size", size});
}

expected<void> recipe_runner::step(const export_step& s) {
  const auto keeps_fields = [](const auto& file) {
    const auto* format = find_format(file.first);
    return format && format->keeps.fields;
  };
  if ((!s.png.empty() || std::ranges::any_of(s.files, keeps_fields)) &&
      !solved_.contains(head_.version_id))
    return fail(ec::bad_input, "this version has no field to export", "Put a solve step first");
  for (const auto& [format, name] : s.files) {
    if (auto ok = write(format, path_of(name)); !ok)
      return ok;
    files_.push_back(path_of(name).string());
  }
  if (s.png.empty())
    return {};
  if (auto ok = draw(s, path_of(s.png)); !ok)
    return ok;
  files_.push_back(path_of(s.png).string());
  return {};
}

}  // namespace tedit::cli
