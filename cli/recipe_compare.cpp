// SPDX-License-Identifier: AGPL-3.0-or-later
// The step "compare" of a recipe.
#include <fstream>

#include "base/child_process.hpp"
#include "cli/compare_report.hpp"
#include "cli/recipe_runner.hpp"
#include "cli/server_comparison.hpp"

namespace tedit::cli {

namespace {

expected<void> write_json(const nlohmann::ordered_json& what, const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  std::ofstream out(file);
  out << what.dump(1) << '\n';
  out.close();
  if (!out)
    return fail(ec::io_error, "cannot write " + file.string(), "Choose another folder with --out");
  return {};
}

expected<void> draw_difference(const std::filesystem::path& vtu, const std::filesystem::path& png,
                               const std::string& title, const execution& run) {
  const std::vector<std::string> command{
    (executable_folder() / "tedit-render").string(), vtu.string(), "-o", png.string(), "--field",
    "von_mises_pa" + std::string(difference_ending), "--title",    title};
  const auto drawn = run_child(command, {}, {std::chrono::minutes(2), 0}, run);
  if (!drawn)
    return fail(drawn.error().code,
                "the picture " + png.string() + " could not be drawn: " + drawn.error().message,
                "Try \"tedit render\" by hand: it says more");
  return {};
}

}  // namespace

expected<void> recipe_runner::step(const client::compare_step& s) {
  const bool needs_field = !s.vtu.empty() || !s.png.empty();
  if (needs_field && s.load_case.empty())
    return fail(ec::bad_input, "a file holds the difference of fields, and no load case is named",
                "Add \"load_case\", or leave vtu and png out");
  const auto made =
    compare_on_server(server_, {s.before, s.after.value_or(head_.number), s.load_case}, session_);
  end_progress(session_);
  if (!made)
    return fail(made.error());
  auto json = cli::to_json(made->what);
  json["step"] = "compare";
  json["before_number"] = made->before;
  json["after_number"] = made->after;
  details_ += describe_comparison(*made);
  if (!s.json.empty()) {
    if (auto ok = write_json(json, path_of(s.json)); !ok)
      return ok;
    files_.push_back(path_of(s.json).string());
  }
  report_.push_back(std::move(json));
  return needs_field ? write_files(s, *made) : expected<void>();
}

expected<void> recipe_runner::write_files(const client::compare_step& s,
                                          const client::comparison& made) {
  const bool aside = s.vtu.empty();
  const auto png = path_of(s.png);
  const auto vtu = aside ? std::filesystem::path(png.string() + ".vtu") : path_of(s.vtu);
  if (auto ok = write_difference(server_, made, vtu, session_); !ok)
    return ok;
  if (!aside)
    files_.push_back(vtu.string());
  if (s.png.empty())
    return {};
  auto drawn = draw_difference(vtu, png, s.title, make_execution(session_));
  std::error_code ignored;
  if (aside)
    std::filesystem::remove(vtu, ignored);
  if (drawn)
    files_.push_back(png.string());
  return drawn;
}

}  // namespace tedit::cli
