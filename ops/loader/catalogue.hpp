// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Why a plugin file is not in use.
struct refused_plugin {
  std::filesystem::path file;
  std::string reason;
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

  /// Loads one plugin. Errors: `plugin_refused` naming the file and what is wrong with it.
  [[nodiscard]] expected<void> load_file(const std::filesystem::path& file);

  /// Loads every .so in a folder, by name; a refusal is noted and the rest goes on. A folder that
  /// is not there holds none.
  void load_directory(const std::filesystem::path& folder);

  [[nodiscard]] const std::vector<entry>& entries() const { return entries_; }
  [[nodiscard]] const std::vector<refused_plugin>& refused() const { return refused_; }

  /// Errors: `operation_not_found` naming the nearest id.
  [[nodiscard]] expected<const entry*> find(const std::string& id) const;

private:
  std::vector<entry> entries_;
  std::vector<refused_plugin> refused_;
};

/// The plugins of the installation and of the user: folders in $TEDIT_PLUGIN_PATH
/// (colon-separated), lib/tedit/plugins beside the executable's folder, and
/// $XDG_DATA_HOME/tedit/plugins.
[[nodiscard]] catalogue load_default_catalogue();

/// Checks types, ranges and names and fills in defaults. Text values are parsed by the parameter's
/// type; a length may be given in millimetres with the suffix _mm ("depth_mm"). Errors:
/// `invalid_parameter` naming the parameter, its range, or the nearest name.
[[nodiscard]] expected<parameters> complete_parameters(const operation_description& description,
                                                       const parameters& values);

/// Finds and applies an operation: validation first, then `apply`; an exception from the plugin is
/// an error that names it.
[[nodiscard]] expected<edit_result> run_operation(const catalogue& plugins, const std::string& id,
                                                  const mesh_version& mesh, const selection& picked,
                                                  const parameters& given, context& ctx);

/// The candidate nearest to a misspelt name by edit distance; empty when there is none.
[[nodiscard]] std::string nearest_name(const std::string& name,
                                       const std::vector<std::string>& candidates);

}  // namespace tedit::ops
