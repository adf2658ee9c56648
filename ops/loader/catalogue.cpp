// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/loader/catalogue.hpp"

#include <algorithm>
#include <cstdlib>

#include "base/child_process.hpp"
#include "ops/services/notices.hpp"

namespace tedit::ops {

namespace {

/// As it is shown; nothing where the plugin may be used.
std::optional<refused_plugin> refusal_of(const std::filesystem::path& file,
                                         const std::string& fault) {
  if (fault.empty())
    return std::nullopt;
  // A fault that is kept is that of a file that crashed or hung.
  const auto kept = probe_cache(file);
  const bool crashed = !kept.empty() && kept_verdict(kept) == fault;
  return refused_plugin{file, fault, crashed ? 1U : 0U,
                        crashed ? "remove " + kept.string() + " to have it tried again" : ""};
}

found_plugin look_at(const std::filesystem::path& file, load_care care) {
  if (care == load_care::direct)
    return {file, std::nullopt, std::nullopt};
  if (care == load_care::probe)
    return {file, refusal_of(file, probe_plugin(file)), std::nullopt};
  auto said = describe_plugin(file);
  return {file, refusal_of(file, said.refusal), std::move(said.operations)};
}

std::filesystem::path built_in_folder() {
  return executable_folder() / "../lib/tedit/plugins";
}

void find_in(const std::filesystem::path& folder, load_care care,
             std::vector<found_plugin>& found) {
  std::error_code code;
  std::vector<std::filesystem::path> files;
  for (const auto& item : std::filesystem::directory_iterator(folder, code))
    if (item.path().extension() == ".so")
      files.push_back(item.path());
  std::ranges::sort(files);
  for (const auto& file : files)
    found.push_back(look_at(file, care));
}

}  // namespace

expected<void> catalogue::refuse(const std::filesystem::path& file, const std::string& reason) {
  refused_.push_back({file, reason, 0, {}});
  return fail(plugin_not_used(file, reason));
}

expected<void> catalogue::add(const std::filesystem::path& file,
                              std::vector<callable_operation> made) {
  std::vector<entry> fresh;
  for (auto& one : made) {
    const auto& id = one.about.description.id;
    const auto same = [&](const entry& e) { return e.description.id == id; };
    if (std::ranges::any_of(entries_, same) || std::ranges::any_of(fresh, same))
      return refuse(file, "the operation id " + id + " is taken already");
    fresh.push_back(
      {std::move(one.about.description), std::move(one.code), file, std::move(one.about.plugin)});
  }
  std::ranges::move(fresh, std::back_inserter(entries_));
  return {};
}

expected<void> catalogue::load_file(const std::filesystem::path& file) {
  auto made = load_plugin(file, offer_);
  return made ? add(file, std::move(*made)) : refuse(file, made.error().message);
}

void catalogue::load(const std::vector<found_plugin>& found) {
  for (const auto& one : found) {
    if (one.refusal) {
      refused_.push_back(*one.refusal);
    } else if (one.described) {
      std::vector<callable_operation> made;
      for (const auto& about : *one.described)
        made.push_back(make_deferred(about, one.file, offer_));
      (void)add(one.file, std::move(made));  // A refusal is noted in refused().
    } else {
      (void)load_file(one.file);
    }
  }
}

void catalogue::load_directory(const std::filesystem::path& folder, load_care care) {
  std::vector<found_plugin> found;
  find_in(folder, care, found);
  load(found);
}

expected<const catalogue::entry*> catalogue::find(const std::string& id) const {
  std::vector<std::string> ids;
  for (const auto& e : entries_) {
    if (e.description.id == id)
      return &e;
    ids.push_back(e.description.id);
  }
  return fail(unknown_operation(id, ids));
}

error unknown_operation(const std::string& id, const std::vector<std::string>& known) {
  const auto near = nearest_name(id, known);
  return {ec::operation_not_found,
          "there is no operation \"" + id + "\"",
          near.empty() ? "\"tedit ops\" lists those that there are"
                       : "Did you mean " + near + "? \"tedit ops\" lists all",
          {}};
}

std::vector<found_plugin> find_plugins(plugin_source which, load_care others) {
  std::vector<found_plugin> result;
  // First, so that no other plugin takes the id of a built-in one.
  find_in(built_in_folder(), load_care::direct, result);
  if (which == plugin_source::built_in)
    return result;
  if (const char* path = std::getenv("TEDIT_PLUGIN_PATH")) {
    std::string_view left = path;
    while (!left.empty()) {
      const auto end = std::min(left.find(':'), left.size());
      if (end > 0)
        find_in(left.substr(0, end), others, result);
      left.remove_prefix(std::min(end + 1, left.size()));
    }
  }
  if (const char* data = std::getenv("XDG_DATA_HOME"))
    find_in(std::filesystem::path(data) / "tedit/plugins", others, result);
  else if (const char* home = std::getenv("HOME"))
    find_in(std::filesystem::path(home) / ".local/share/tedit/plugins", others, result);
  return result;
}

catalogue load_default_catalogue(plugin_source which) {
  catalogue result;
  result.load(find_plugins(which, load_care::describe));
  return result;
}

catalogue load_catalogue_for(const std::string& id) {
  std::vector<found_plugin> found;
  find_in(built_in_folder(), load_care::direct, found);
  std::erase_if(found, [&](const auto& one) { return one.file.stem() != id; });
  catalogue result;
  result.load(found);
  return result.find(id) ? std::move(result) : load_default_catalogue();
}

expected<void> check_selection(const operation_description& description, const mesh_version& mesh,
                               const selection& picked) {
  const auto& wanted = description.selection;
  const auto surfaces = as_set(picked);
  if (surfaces.size() < wanted.minimum)
    return fail(ec::empty_selection,
                description.name + " needs at least " + std::to_string(wanted.minimum) +
                  " selected surface" + (wanted.minimum == 1 ? "" : "s"),
                wanted.help);
  if (wanted.maximum > 0 && surfaces.size() > wanted.maximum)
    return fail(ec::invalid_argument,
                description.name + " takes at most " + std::to_string(wanted.maximum) + " surface" +
                  (wanted.maximum == 1 ? "" : "s") + ", " + std::to_string(surfaces.size()) +
                  " are selected",
                wanted.help);
  for (const auto surface : surfaces)
    if (!mesh.find_surface(surface))
      return fail(ec::surface_not_found,
                  "surface " + std::to_string(surface) + " is not in this version of the mesh",
                  "\"tedit info\" lists the surfaces");
  return {};
}

namespace {

/// Operations that ask for each other.
constexpr int deepest = 8;

expected<edit_result> run_nested(const catalogue& plugins, const std::string& id,
                                 const version_ptr& mesh, const selection& picked,
                                 const parameters& given, context& ctx, int depth);

}  // namespace

std::function<expected<edit_result>(const std::string&, const version_ptr&, const selection&,
                                    const parameters&)>
others_of(const catalogue& plugins, const context& ctx, int depth) {
  return
    [&plugins, &ctx, depth](const std::string& id, const version_ptr& mesh, const selection& picked,
                            const parameters& given) -> expected<edit_result> {
      if (depth >= deepest)
        return fail(
          ec::invalid_argument,
          "operations ask for each other " + std::to_string(deepest) + " deep, the last for " + id,
          "Report this to the plugin's author: they may go round in a circle");
      if (!mesh)
        return fail(ec::invalid_argument, "the operation \"" + id + "\" was asked of no version");
      auto inner = ctx;
      return run_nested(plugins, id, mesh, picked, given, inner, depth + 1);
    };
}

expected<edit_result> run_operation(const catalogue& plugins, const std::string& id,
                                    const version_ptr& mesh, const selection& picked,
                                    const parameters& given, context& ctx) {
  auto* const host = dynamic_cast<telling_services*>(ctx.host);
  if (host)
    (void)host->take_notices();  // Of an edit that was refused.
  auto answer = run_nested(plugins, id, mesh, picked, given, ctx, 0);
  if (answer && host)
    for (auto& notice : host->take_notices())
      answer->notices.push_back(std::move(notice));
  return answer;
}

namespace {

expected<edit_result> run_nested(const catalogue& plugins, const std::string& id,
                                 const version_ptr& mesh, const selection& picked,
                                 const parameters& given, context& ctx, int depth) {
  const auto found = plugins.find(id);
  if (!found)
    return fail(found.error());
  const auto& entry = **found;
  auto values = complete_parameters(entry.description, given, mesh.get());
  if (!values)
    return fail(values.error());
  if (auto fits = check_selection(entry.description, *mesh, picked); !fits)
    return fail(std::move(fits.error()));
  if (!ctx.log)
    ctx.log = [](std::string_view) {};
  ctx.apply_other = others_of(plugins, ctx, depth);
  const auto name = "the operation \"" + id + "\" of the plugin " + entry.plugin;
  const char* const to_author =
    "The version is unchanged. \"tedit plugin test\" looks for such "
    "faults; report this to the plugin's author";
  try {
    auto answer = entry.code->apply(mesh, picked, *values, ctx);
    if (answer && !answer->candidate)
      return fail(ec::internal, name + " made an edit without a version", to_author);
    return answer;
  } catch (const std::bad_alloc&) {
    return fail(ec::out_of_memory, name + " ran out of memory",
                "The version is unchanged. Close other programs, or take a coarser mesh");
  } catch (const std::exception& e) {
    return fail(ec::internal, name + " failed: " + e.what(), to_author);
  } catch (...) {
    return fail(ec::internal, name + " threw something that is no std::exception", to_author);
  }
}

}  // namespace

}  // namespace tedit::ops
