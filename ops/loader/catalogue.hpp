// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ops/loader/plugin_file.hpp"

namespace tedit::ops {

/// Why a plugin file is not in use.
struct refused_plugin {
  std::filesystem::path file;
  std::string reason;
  unsigned crashes = 0;  ///< How often it broke the process that tried it: it is in quarantine.
  std::string remedy;    ///< How to have such a one tried again.
};

/// How a folder's plugins are loaded.
enum class load_care {
  direct,  ///< At once: they came with the program.
  probe,   ///< Each is loaded in a child process first; see `probe_plugin`. For confined processes.
  /// Only in child processes: one describes it (`describe_plugin`), and each that calls `apply`
  /// loads it then (`run_operation_in_child`).
  describe,
};

/// Which plugins a program uses.
enum class plugin_source {
  all,
  built_in,  ///< Safe mode: only those that came with the program.
};

/// A plugin's file, found and, where others made it, tried out.
struct found_plugin {
  std::filesystem::path file;
  std::optional<refused_plugin> refusal;  ///< It must not be loaded.
  /// What a child process found in it: it is loaded when one of them is called.
  std::optional<std::vector<described_operation>> described;
};

/// The operations that are there. Plugin libraries stay loaded until the program ends: code of
/// theirs may still be on some thread's stack.
class catalogue {
public:
  struct entry {
    operation_description description;
    std::shared_ptr<const operation> code;
    std::filesystem::path file;
    std::string plugin;  ///< Name and version.
  };

  explicit catalogue(const sdk_offer& offer = {}) : offer_(offer) {}

  /// Loads one plugin. Errors: `plugin_refused` naming the file and what is wrong with it.
  [[nodiscard]] expected<void> load_file(const std::filesystem::path& file);

  /// Takes in what was found; a refusal is noted and the rest goes on.
  void load(const std::vector<found_plugin>& found);

  /// Both for every .so in a folder, by name. A folder that is not there holds none.
  void load_directory(const std::filesystem::path& folder, load_care care = load_care::direct);

  [[nodiscard]] const std::vector<entry>& entries() const { return entries_; }
  [[nodiscard]] const std::vector<refused_plugin>& refused() const { return refused_; }

  /// Errors: `operation_not_found` naming the nearest id.
  [[nodiscard]] expected<const entry*> find(const std::string& id) const;

private:
  expected<void> refuse(const std::filesystem::path& file, const std::string& reason);
  expected<void> add(const std::filesystem::path& file, std::vector<callable_operation> made);

  sdk_offer offer_;
  std::vector<entry> entries_;
  std::vector<refused_plugin> refused_;
};

/// The plugins of the installation, lib/tedit/plugins beside the executable's folder, then those of
/// others: the folders in $TEDIT_PLUGIN_PATH (colon-separated) and $XDG_DATA_HOME/tedit/plugins
/// (without the variable ~/.local/share/tedit/plugins). `others`: how what others made is looked
/// at; a confined process cannot look.
[[nodiscard]] std::vector<found_plugin> find_plugins(plugin_source which = plugin_source::all,
                                                     load_care others = load_care::probe);

/// All of them, for a process that is not confined: what came with the program is loaded, what
/// others made is described by child processes. Cost: some ms for each of the others.
[[nodiscard]] catalogue load_default_catalogue(plugin_source which = plugin_source::all);

/// As much of them as who asks for this operation alone needs: the one plugin, where it came with
/// the program (those ask for no others and are named as their operation), else all. Cost: 1 ms
/// instead of some 18.
[[nodiscard]] catalogue load_catalogue_for(const std::string& id);

// -- loading what may be broken ------------------------------------------------------------------

/// Loads a plugin in a child process (tedit-probe, beside the executable or in $TEDIT_LIBEXEC) and
/// says why it must not be loaded here: what the child found, or how it crashed or hung. Empty when
/// it may. That a content loads, crashes or hangs is kept in `probe_cache`, other refusals depend
/// on what is installed and are found anew. Cost: some ms; then a hash of the file.
[[nodiscard]] std::string probe_plugin(const std::filesystem::path& file);

/// The same, and what its operations are. Its process is started each time, unless the content is
/// known to crash or hang. Cost: some ms.
[[nodiscard]] plugin_report describe_plugin(const std::filesystem::path& file);

/// Where the verdict on a file's content is kept: $XDG_CACHE_HOME/tedit/probes/HASH (~/.cache
/// without the variable); empty when there is no such place or the file cannot be read.
[[nodiscard]] std::filesystem::path probe_cache(const std::filesystem::path& file);

/// What is kept there: "ok", why it must not be loaded, or nothing.
[[nodiscard]] std::string kept_verdict(const std::filesystem::path& cache);

/// The dynamic loader's message as a sentence for people: which library or function is missing.
[[nodiscard]] std::string readable_dl_error(const char* message);

/// Checks types, ranges and names and fills in defaults. Text values are parsed by the parameter's
/// type; a length may be given in millimetres with the suffix _mm ("depth_mm"), a place by what the
/// part has there (`find_pick`), where there is a mesh. Errors: `invalid_parameter` naming the
/// parameter, its range, or the nearest name; those of `find_pick`.
[[nodiscard]] expected<parameters> complete_parameters(const operation_description& description,
                                                       const parameters& values,
                                                       const mesh_version* mesh = nullptr);

/// What `operation.hpp` promises of a selection: as many different surfaces as described, each in
/// the version's table. Errors: `empty_selection`, `invalid_argument`, `surface_not_found`.
[[nodiscard]] expected<void> check_selection(const operation_description& description,
                                             const mesh_version& mesh, const selection& picked);

/// What hosts give an edit as `context::search_s`, s: a person waits so long for a refusal.
inline constexpr double refusal_search_s = 3;

/// Finds and applies an operation: validation first, then `apply`; an exception from the plugin is
/// an error that names it, and so is an edit without a candidate. An empty `ctx.log` is filled.
[[nodiscard]] expected<edit_result> run_operation(const catalogue& plugins, const std::string& id,
                                                  const version_ptr& mesh, const selection& picked,
                                                  const parameters& given, context& ctx);

/// What `context::apply_other` is for an operation that these plugins' host applies, `depth` deep
/// in others; both must outlive it.
[[nodiscard]] std::function<expected<edit_result>(const std::string&, const version_ptr&,
                                                  const selection&, const parameters&)>
others_of(const catalogue& plugins, const context& ctx, int depth = 0);

/// `operation_not_found`, with the nearest of the ids that there are.
[[nodiscard]] error unknown_operation(const std::string& id, const std::vector<std::string>& known);

/// The candidate nearest to a misspelt name by edit distance; empty when there is none.
[[nodiscard]] std::string nearest_name(const std::string& name,
                                       const std::vector<std::string>& candidates);

}  // namespace tedit::ops
