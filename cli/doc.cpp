// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents as files: what there is, whether it is sound, copies, meshes, room given back.
#include <algorithm>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "actors/store/check.hpp"
#include "actors/store/cleaning.hpp"
#include "actors/store/document_lock.hpp"
#include "actors/store/library.hpp"
#include "actors/store/loading.hpp"
#include "base/utc.hpp"
#include "cli/command.hpp"
#include "cli/config.hpp"
#include "cli/doc_loads.hpp"
#include "mesh/io/formats.hpp"

namespace tedit::cli {

namespace {

namespace fs = std::filesystem;

using nlohmann::ordered_json;

std::string size_text(std::int64_t bytes) {
  const double value = static_cast<double>(bytes);
  return bytes < 1'000'000 ? pretty(value / 1e3, 3) + " kB" : pretty(value / 1e6, 4) + " MB";
}

ordered_json doc_json(const std::vector<error>& damage) {
  auto list = ordered_json::array();
  for (const auto& one : damage)
    list.push_back({{"what", one.message}, {"remedy", one.remedy}});
  return list;
}

/// Where locks and SQLite see the same name.
fs::path real_path(const fs::path& file) {
  std::error_code code;
  const auto path = fs::weakly_canonical(file, code);
  return code ? file : path;
}

// -- list ----------------------------------------------------------------------------------------

/// A document as a row of the list.
struct listed {
  fs::path file;
  store::file_state state;
  bool open = false;
  std::size_t versions = 0;
  std::optional<std::uint32_t> head;
  std::optional<error> fault;  ///< Why it cannot be read.
};

listed look_at(const fs::path& file) {
  listed row{file, store::state_of(file).value_or(store::file_state{}), false, 0, {}, {}};
  row.open = store::document_lock::held(real_path(file));
  const auto document = store::document_view::open(file);
  const auto rows =
    document ? (*document)->read() : expected<store::sound_rows>(fail(document.error()));
  if (!rows) {
    row.fault = rows.error();
    return row;
  }
  row.versions = rows->rows.versions.size();
  row.head = rows->rows.head;
  if (!rows->damage.empty())
    row.fault = rows->damage.front();
  return row;
}

/// Errors: `io_error`.
expected<std::vector<listed>> documents_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code))
    if (const auto& path = entry->path();
        path.extension() == ".tedit" && !path.filename().string().starts_with('.'))
      files.push_back(path);
  if (code)
    return fail(ec::io_error, "cannot list " + folder.string() + ": " + code.message(),
                "Name the folder of the documents; \"tedit doctor\" says which one a server takes");
  std::ranges::sort(files);
  std::vector<listed> rows;
  for (const auto& file : files)
    rows.push_back(look_at(file));
  return rows;
}

ordered_json doc_json(const listed& row) {
  ordered_json json{{"name", row.file.stem().string()},
                    {"file", row.file.string()},
                    {"bytes", row.state.bytes},
                    {"changed", utc_text(row.state.changed_ms / 1000)},
                    {"open", row.open},
                    {"readable", !row.fault}};
  if (row.fault)
    json["fault"] = doc_json(std::vector{*row.fault}).front();
  else
    json["versions"] = row.versions;
  if (!row.fault && row.head)
    json["head"] = *row.head;
  return json;
}

std::string doc_text(const std::vector<listed>& rows) {
  std::vector<std::vector<std::string>> table{
    {"document", "size", "versions", "current", "changed (UTC)", "state"}};
  for (const auto& row : rows)
    table.push_back(
      {row.file.stem().string(), size_text(row.state.bytes),
       row.fault ? "" : std::to_string(row.versions),
       row.head && !row.fault ? std::to_string(*row.head) : "",
       utc_text(row.state.changed_ms / 1000),
       std::string(row.fault ? "cannot be read" : "sound") + (row.open ? ", open" : "")});
  auto text = format_table(table, {4, 5});
  for (const auto& row : rows)
    if (row.fault)
      text += row.file.stem().string() + ": " + render(*row.fault) + "\n";
  return text;
}

int run_list(const std::string& given, session& s) {
  fs::path folder = given;
  if (given.empty()) {
    const auto usual =
      load_config({}).and_then([](const server_config& all) { return documents_folder(all); });
    if (!usual)
      return print_error(s, usual.error());
    folder = *usual;
  }
  const auto rows = documents_in(folder);
  if (!rows)
    return print_error(s, rows.error());
  ordered_json json{{"folder", folder.string()}, {"documents", ordered_json::array()}};
  for (const auto& row : *rows)
    json["documents"].push_back(doc_json(row));
  print_result(s, json,
               rows->empty() ? "no documents in " + folder.string() + "\n" : doc_text(*rows));
  return 0;
}

// -- check ---------------------------------------------------------------------------------------

constexpr int status_of_damage = 65;

/// What a person can do with a damaged document.
std::string way_out(const std::string& file, const actors::document_check& found) {
  if (found.whole.empty())
    return "No version can be read whole: restore the document from a backup";
  std::string numbers;
  for (const auto number : found.whole)
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(number);
  return "Restore the document from a backup. Whole are the meshes of these versions: " + numbers +
         ". \"tedit doc export " + file + " OUT.msh --version " +
         std::to_string(found.whole.back()) + "\" saves the last of them";
}

ordered_json doc_json(const std::string& file, const actors::document_check& found) {
  ordered_json json{{"file", file},
                    {"sound", found.sound()},
                    {"format", found.format},
                    {"versions", found.versions},
                    {"whole_versions", found.whole},
                    {"pages", found.pages},
                    {"unneeded_pages", found.unneeded_pages},
                    {"log_lines", found.log_lines},
                    {"damage", doc_json(found.damage)}};
  if (found.head)
    json["head"] = *found.head;
  if (!found.sound())
    json["remedy"] = way_out(file, found);
  return json;
}

std::string doc_text(const std::string& file, const actors::document_check& found) {
  const auto contents = std::to_string(found.versions) + " versions, " +
                        std::to_string(found.pages) + " pages, " + std::to_string(found.log_lines) +
                        " lines of the log";
  if (found.sound())
    return file + " is sound: " + contents + "\n";
  auto text = file + " is damaged: " + contents + "\n";
  for (const auto& one : found.damage)
    text += "  " + one.message + "\n";
  return text + way_out(file, found) + "\n";
}

int run_check(const std::string& file, session& s) {
  const auto found = store::document_view::open(file).and_then(
    [](const auto& document) { return actors::check_document(*document); });
  if (!found) {
    const int status = print_error(s, found.error());
    return found.error().code == ec::storage_error ? status_of_damage : status;
  }
  print_result(s, doc_json(file, *found), doc_text(file, *found));
  return found->sound() ? 0 : status_of_damage;
}

// -- copy and export -----------------------------------------------------------------------------

struct output_options {
  std::string document;
  std::string output;
  std::optional<std::uint32_t> version;
  std::string length_unit = "mm";
};

int run_copy(const output_options& options, session& s) {
  const fs::path output = options.output;
  if (output.extension() != ".tedit" || output.stem().empty())
    return print_error(s, {ec::usage,
                           options.output + " does not end in .tedit",
                           "A server finds a document by this ending: give such a name",
                           {}});
  const auto versions = actors::copy_sound_file({options.document, output, s.cancel});
  if (!versions)
    return print_error(s, versions.error());
  const auto bytes = store::state_of(output).value_or(store::file_state{}).bytes;
  print_result(
    s, {{"file", options.output}, {"bytes", bytes}, {"versions", *versions}},
    options.output + ": " + std::to_string(*versions) + " versions, " + size_text(bytes) + "\n");
  return 0;
}

/// The damage of other parts is told, and does not keep a version from being saved.
void tell_damage(const store::document_view& document, session& s) {
  const auto rows = document.read();
  for (const auto& one : rows ? rows->damage : std::vector<error>{})
    notice(s, "note: " + one.message);
}

int run_doc_export(const output_options& options, session& s) {
  const auto format = output_format(options.output);
  if (!format)
    return print_error(s, format.error());
  const auto document = store::document_view::open(options.document);
  if (!document)
    return print_error(s, document.error());
  tell_damage(**document, s);
  const auto mesh = actors::read_version(**document, options.version);
  if (!mesh)
    return print_error(s, mesh.error());
  const auto written =
    write_as((*format)->name, options.output, **mesh, {.length_unit = options.length_unit});
  if (!written)
    return print_error(s, written.error());
  print_result(s,
               {{"file", options.output},
                {"format", (*format)->name},
                {"version_id", to_hex((*mesh)->id())},
                {"tets", (*mesh)->tet_count()}},
               options.output + ": " + std::to_string((*mesh)->tet_count()) + " tets of version " +
                 to_hex((*mesh)->id()) + "\n");
  return 0;
}

// -- gc ------------------------------------------------------------------------------------------

struct gc_options {
  std::string document;
  actors::cleaning wanted;
  bool dry_run = false;
};

/// What a cleaning did, or would do.
struct cleaned {
  actors::cleaning_plan plan;
  std::int64_t pages = 0;
  std::int64_t bytes_before = 0;
  std::int64_t bytes_after = 0;
};

/// A plan for rows that are a tree. Errors: `storage_error` when they are not.
expected<actors::cleaning_plan> plan_for(const store::contents& rows,
                                         const actors::cleaning& wanted) {
  return actors::check_tree(rows).and_then([&] { return actors::plan_cleaning(rows, wanted); });
}

/// Beside a server, too: nothing is written.
expected<cleaned> look_ahead(const gc_options& options) {
  const auto document = store::document_view::open(options.document);
  if (!document)
    return fail(document.error());
  const auto rows = (*document)->read();
  if (!rows)
    return fail(rows.error());
  if (!rows->damage.empty())
    return fail(rows->damage.front());
  auto plan = plan_for(rows->rows, options.wanted);
  if (!plan)
    return fail(plan.error());
  const auto bytes = store::state_of(options.document).value_or(store::file_state{}).bytes;
  return cleaned{std::move(*plan), 0, bytes, bytes};
}

expected<cleaned> clean(const gc_options& options) {
  cleaned result;
  // One that is not there would be a new one.
  const auto before = store::state_of(options.document);
  if (!before)
    return fail(before.error());
  result.bytes_before = before->bytes;
  {
    const auto document = store::document::open(options.document);
    if (!document)
      return fail(document.error());
    const auto rows = (*document)->read();
    if (!rows)
      return fail(rows.error());
    auto plan = plan_for(*rows, options.wanted);
    if (!plan)
      return fail(plan.error());
    result.plan = std::move(*plan);
    const auto done = (*document)->remove(result.plan.what);
    if (!done)
      return fail(done.error());
    result.pages = *done;
  }
  const auto after = store::state_of(options.document);
  if (!after)
    return fail(after.error());
  result.bytes_after = after->bytes;
  return result;
}

ordered_json doc_json(const gc_options& options, const cleaned& done) {
  auto versions = ordered_json::array();
  for (std::size_t number = 0; number < done.plan.what.numbers.size(); ++number)
    if (const auto& now = done.plan.what.numbers[number])
      versions.push_back({{"before", number}, {"after", *now}});
  ordered_json json{{"file", options.document},
                    {"dry_run", options.dry_run},
                    {"dropped_versions", done.plan.dropped},
                    {"versions", std::move(versions)},
                    {"bytes_before", done.bytes_before}};
  if (!options.dry_run) {
    json["removed_pages"] = done.pages;
    json["bytes_after"] = done.bytes_after;
  }
  return json;
}

std::string doc_text(const gc_options& options, const cleaned& done) {
  std::string text = options.document + ": ";
  const auto& dropped = done.plan.dropped;
  text += dropped.empty() ? "no version" : dropped.size() == 1 ? "version" : "versions";
  for (std::size_t i = 0; i < dropped.size(); ++i)
    text += (i == 0 ? " " : ", ") + std::to_string(dropped[i]);
  if (options.dry_run)
    return text + " would go\n";
  text += " and " + std::to_string(done.pages) + " pages removed, " + size_text(done.bytes_before) +
          " before, " + size_text(done.bytes_after) + " now\n";
  for (std::size_t number = 0; number < done.plan.what.numbers.size(); ++number)
    if (const auto& now = done.plan.what.numbers[number]; now && *now != number)
      text +=
        "  version " + std::to_string(number) + " is version " + std::to_string(*now) + " now\n";
  return text;
}

int run_gc(const gc_options& options, session& s) {
  auto done = options.dry_run ? look_ahead(options) : clean(options);
  if (!done) {
    auto why = done.error();
    if (why.code == ec::conflict)
      why.remedy =
        "Close it in every window and wait until its server has closed it (two minutes, "
        "limits.close_unused_after_s), or end that server; then try again";
    return print_error(s, why);
  }
  print_result(s, doc_json(options, *done), doc_text(options, *done));
  return 0;
}

// -- commands ------------------------------------------------------------------------------------

void add_list(CLI::App& doc, action& chosen) {
  auto folder = std::make_shared<std::string>();
  auto* command = doc.add_subcommand(
    "list", "List the documents of a folder: size, versions, whether each is open and sound");
  command->add_option("folder", *folder, "Instead of the folder of \"tedit serve\"");
  command->callback(
    [folder, &chosen] { chosen = [folder](session& s) { return run_list(*folder, s); }; });
}

void add_check(CLI::App& doc, action& chosen) {
  auto file = std::make_shared<std::string>();
  auto* command =
    doc.add_subcommand("check", "Read all of a document and say what is damaged (status 65)");
  command->add_option("file", *file, "A document (.tedit)")->required();
  command->callback(
    [file, &chosen] { chosen = [file](session& s) { return run_check(*file, s); }; });
}

void add_copy(CLI::App& doc, action& chosen) {
  auto options = std::make_shared<output_options>();
  auto* command =
    doc.add_subcommand("copy", "Write a document, with all its versions, to another file");
  command->add_option("file", options->document, "A document (.tedit)")->required();
  command->add_option("output", options->output, "The new file (.tedit); never one that is there")
    ->required();
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_copy(*options, s); }; });
}

void add_doc_export(CLI::App& doc, action& chosen) {
  auto options = std::make_shared<output_options>();
  auto* command = doc.add_subcommand("export", "Write the mesh of a version of a document");
  command->add_option("file", options->document, "A document (.tedit)")->required();
  command->add_option("output", options->output, "The new file: " + written_formats_text())
    ->required();
  command->add_option("--version", options->version, "Its number; the current one without it");
  command->add_option("--length-unit", options->length_unit, "Unit of the new file's coordinates")
    ->capture_default_str();
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_doc_export(*options, s); }; });
}

void add_gc(CLI::App& doc, action& chosen) {
  auto options = std::make_shared<gc_options>();
  auto* command = doc.add_subcommand(
    "gc", "Remove from a document what no version needs, and give its room back to the disk");
  command->add_option("file", options->document, "A document (.tedit) that nobody has open")
    ->required();
  command->add_flag("--drop-unreachable", options->wanted.unreachable,
                    "Also versions on branches that no undo or redo reaches, unless they, or one "
                    "made from them, have a name or a note");
  command
    ->add_option("--keep", options->wanted.keep,
                 "Numbers of versions that stay all the same, separated by commas")
    ->delimiter(',');
  command->add_flag("--dry-run", options->dry_run, "Only say which versions would go");
  command->footer(
    "Versions that stay keep their order and are numbered anew; the old and the new number are "
    "said.");
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_gc(*options, s); }; });
}

}  // namespace

void add_doc(CLI::App& app, action& chosen) {
  auto* command = app.add_subcommand("doc", "Look after documents as files");
  command->require_subcommand(1);
  command->fallthrough();
  add_list(*command, chosen);
  add_check(*command, chosen);
  add_copy(*command, chosen);
  add_doc_export(*command, chosen);
  add_doc_loads(*command, chosen);
  add_gc(*command, chosen);
}

}  // namespace tedit::cli
