// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/error.hpp"
#include "base/execution.hpp"

namespace CLI {
class App;
}

namespace tedit {
struct file_format;
}

namespace tedit::cli {

/// What all commands share. `main` fills it from the options that stand before or behind the
/// command's name.
struct session {
  bool json = false;    ///< One JSON object on stdout, nothing else.
  bool quiet = false;   ///< No progress on stderr.
  cancel_token cancel;  ///< Set by SIGINT and SIGTERM.
};

/// What a command does once the arguments are parsed; returns the exit status.
using action = std::function<int(session&)>;

/// Each adds one command to the program; parsing it sets `chosen`.
void add_info(CLI::App& app, action& chosen);
void add_ops(CLI::App& app, action& chosen);
void add_select(CLI::App& app, action& chosen);
void add_plugin(CLI::App& app, action& chosen);
void add_import(CLI::App& app, action& chosen);
void add_edit(CLI::App& app, action& chosen);
void add_adapt(CLI::App& app, action& chosen);
void add_formats(CLI::App& app, action& chosen);
void add_convert(CLI::App& app, action& chosen);
void add_check_print(CLI::App& app, action& chosen);
void add_compare(CLI::App& app, action& chosen);
void add_solve(CLI::App& app, action& chosen);
void add_export(CLI::App& app, action& chosen);
void add_run(CLI::App& app, action& chosen);
void add_serve(CLI::App& app, action& chosen);
void add_status(CLI::App& app, action& chosen);
void add_worker(CLI::App& app, action& chosen);
void add_render(CLI::App& app, action& chosen);
void add_certify(CLI::App& app, action& chosen);
void add_verify(CLI::App& app, action& chosen);
void add_doc(CLI::App& app, action& chosen);
void add_doctor(CLI::App& app, action& chosen);
void add_certs(CLI::App& app, action& chosen);
void add_users(CLI::App& app, action& chosen);
void add_config(CLI::App& app, action& chosen);

/// The format of a file to write, by its suffix. Errors: `usage`, naming those that there are.
[[nodiscard]] expected<const file_format*> output_format(const std::string& file);

// -- output ------------------------------------------------------------------------

/// Prints `result` as the command's JSON object, or `text` for people.
void print_result(const session& s, const nlohmann::ordered_json& result, const std::string& text);

/// Reports a failure: JSON on stdout when asked for, and a sentence on stderr. Returns the status.
int print_error(const session& s, const error& e);

/// An execution whose progress goes to stderr (rewritten in place on a terminal, else silent) and
/// whose cancel is the session's.
[[nodiscard]] execution make_execution(const session& s);

/// Ends a progress line, so that what follows starts on a line of its own.
void end_progress(const session& s);

/// A sentence on stderr, unless `quiet`.
void notice(const session& s, const std::string& text);

/// A number for people: at most `digits` significant digits.
[[nodiscard]] std::string pretty(double value, int digits = 4);

/// Columns padded to their widest cell; the first row is the header. The first column is a label,
/// as are those in `labels`; the others are figures and end at one place.
[[nodiscard]] std::string format_table(const std::vector<std::vector<std::string>>& rows,
                                       const std::set<std::size_t>& labels = {});

}  // namespace tedit::cli
