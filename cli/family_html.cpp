// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <fstream>

#include "base/attachment.hpp"
#include "base/child_process.hpp"
#include "base/text.hpp"
#include "cli/command.hpp"
#include "cli/family_result.hpp"

namespace tedit::cli {

namespace {

std::filesystem::path pdf_program() {
  return executable_folder() / "tedit-pdf";
}

constexpr const char* style = R"(
body { font-family: sans-serif; color: #20262f; background: #ffffff; margin: 24px; font-size: 14px; }
h1 { font-size: 26px; margin-bottom: 4px; } h2 { font-size: 19px; margin-top: 28px; }
table { border-collapse: collapse; } th { text-align: left; background: #eef1f5; }
th, td { padding: 5px 9px; border-bottom: 1px solid #d5dae1; vertical-align: top; }
td.n, th.n { text-align: right; white-space: nowrap; }
.faint { color: #5c6673; } .bad { color: #a01818; font-weight: bold; } .warning { color: #9a4a00; }
img { width: 240px; display: block; } details ol { margin: 4px 0; padding-left: 22px; }
@media print { tr { break-inside: avoid; } }
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : to_utf8(text))
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

std::string number_cell(const std::optional<double>& value, double scale, int digits) {
  return "<td class=\"n\">" + (value ? pretty(scale * *value, digits) : std::string("&ndash;")) +
         "</td>";
}

std::string cells_html(const family_row& row) {
  std::string html;
  for (const auto& [column, cell] : row.cells)
    html += (html.empty() ? "" : "<br>") + ("<span class=\"faint\">" + escaped(column)) +
            "</span> " + escaped(cell);
  return "<td>" + html + "</td>";
}

/// On paper nothing opens: there only rows that failed have their steps.
enum class page { screen, paper };

std::string steps_html(const family_row& row, page on) {
  std::string html = std::string(on == page::paper ? "" : "<details><summary>steps</summary>") +
                     "<ol start=\"" +
                     std::to_string(row.steps.empty() ? 1 : row.steps.front().number) + "\">";
  for (const auto& step : row.steps) {
    const bool failed = step.status == family_status::failed;
    const bool reached = step.status != family_status::not_run;
    html += "<li>" + escaped(step.what) + ": " +
            (failed             ? "<span class=\"bad\">failed</span>"
             : !reached         ? "<span class=\"faint\">not reached</span>"
             : step.passed_over ? "<span class=\"faint\">passed over</span>"
                                : "passed") +
            (reached ? " <span class=\"faint\">" + pretty(1e-3 * step.ms, 2) + " s</span>" : "") +
            "</li>";
  }
  return html + (on == page::paper ? "</ol>" : "</ol></details>");
}

/// The PNG inside the page, or why there is none.
std::string picture_html(const family_row& row, page on) {
  std::ifstream in(row.picture, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (row.picture.empty() || bytes.empty())
    return "<td class=\"faint\">" + escaped(row.picture_missing) + "</td>";
  return "<td><img width=\"" + std::string(on == page::paper ? "190" : "240") +
         "\" loading=\"lazy\" alt=\"" + escaped(row.name) + "\" src=\"data:image/png;base64," +
         to_base64(bytes) + "\"></td>";
}

std::string safety_html(const family_row& row) {
  if (row.min_safety_factor && *row.min_safety_factor < 1)
    return "<td class=\"n bad\">" + pretty(*row.min_safety_factor, 3) + "<br>yields</td>";
  return number_cell(row.min_safety_factor, 1, 3);
}

std::string stress_html(const family_row& row) {
  if (row.singularity.empty())
    return number_cell(row.max_von_mises_pa, 1e-6, 4);
  return "<td class=\"n\">" + pretty(1e-6 * *row.max_von_mises_pa, 4) +
         "<br><span class=\"warning\">" + row.singularity + "</span></td>";
}

std::string head_html(const family_result& result) {
  const auto line = [](const std::string& what, const std::string& value) {
    return "<tr><td class=\"faint\">" + what + "</td><td>" + value + "</td></tr>\n";
  };
  const auto count = [&](family_status status) { return std::to_string(result.count(status)); };
  const auto title = escaped(result.name.empty() ? "A family of parts" : result.name);
  std::string html =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title +
    "</title><style>" + style + "</style></head>\n<body>\n<h1>" + title + "</h1>\n<table>\n" +
    line("Table", escaped(result.table)) + line("Parts", std::to_string(result.rows.size())) +
    line("Passed", count(family_status::passed)) + line("Failed", count(family_status::failed));
  if (result.count(family_status::not_run) > 0)
    html += line("Not carried out", count(family_status::not_run));
  const auto weakest = std::ranges::min_element(
    result.rows, {}, [](const family_row& row) { return row.min_safety_factor.value_or(1e300); });
  if (weakest->min_safety_factor)
    html += line("Safety factor below 1", std::to_string(result.yielding())) +
            line("Smallest safety factor",
                 pretty(*weakest->min_safety_factor, 3) + " (" + escaped(weakest->name) + ")");
  return html +
         line("Time",
              pretty(1e-3 * result.ms, 3) + " s, " + std::to_string(result.jobs) + " at a time") +
         line("Made by", escaped(result.program)) + "</table>\n";
}

std::string failed_html(const family_row& row, page on) {
  const auto* step = row.failed_step();
  std::string html = "<tr><td class=\"n\">" + std::to_string(row.number) + "</td><td>" +
                     escaped(row.name) + "</td>" + cells_html(row) + "<td>" +
                     (step ? std::to_string(step->number) + " " + escaped(step->what) : "") +
                     steps_html(row, on) + "</td><td>";
  if (row.failure)
    html += escaped(row.failure->message) + "<br><span class=\"faint\">" +
            escaped(row.failure->remedy) + "</span>";
  return html + "</td></tr>\n";
}

std::string passed_html(const family_row& row, page on) {
  const bool is_solved = row.max_von_mises_pa.has_value();
  return "<tr><td class=\"n\">" + std::to_string(row.number) + "</td><td>" + escaped(row.name) +
         "</td>" + cells_html(row) + number_cell(row.mass_kg, 1, 4) +
         number_cell(row.volume_m3, 1e6, 6) + number_cell(row.max_displacement_m, 1e3, 4) +
         stress_html(row) + safety_html(row) + "<td class=\"n\">" +
         (is_solved ? pretty(100 * row.error_estimate, 2) + " %" : std::string("&ndash;")) +
         (row.preview ? "<br><span class=\"warning\">preview</span>" : "") + "</td>" +
         picture_html(row, on) + (on == page::paper ? "" : "<td>" + steps_html(row, on) + "</td>") +
         "</tr>\n";
}

/// The rows of one status below their heading; nothing when there are none. On paper a row of parts
/// that passed stays whole: as many of them as a page holds are a table of their own.
void write_rows(std::ostream& out, const family_result& result, family_status status,
                const std::string& heading, const std::string& columns,
                std::string (*html)(const family_row& row, page on), page on) {
  constexpr std::size_t rows_of_a_page = 4;
  const bool paged = on == page::paper && status == family_status::passed;
  std::size_t written = 0;
  for (const auto& row : result.rows) {
    if (row.status != status)
      continue;
    if (written == 0 || (paged && written % rows_of_a_page == 0))
      out << (written > 0 ? "</table>\n" : "")
          << (paged ? "<h2 style=\"page-break-before: always\">" : "<h2>") << heading
          << "</h2>\n<table><tr><th class=\"n\">Row</th><th>Name</th><th>Values</th>" << columns
          << "</tr>\n";
    out << html(row, on);
    ++written;
  }
  if (written > 0)
    out << "</table>\n";
}

expected<void> write_html(const family_result& result, const std::filesystem::path& file, page on) {
  std::ofstream out(file, std::ios::binary);
  out << head_html(result);
  const std::string reasons = "<th>Step</th><th>Reason</th>";
  write_rows(out, result, family_status::failed, "Parts that failed", reasons, failed_html, on);
  write_rows(out, result, family_status::not_run, "Parts that were not carried out", reasons,
             failed_html, on);
  write_rows(out, result, family_status::passed, "Parts that passed",
             "<th class=\"n\">Mass<br>kg</th><th class=\"n\">Volume<br>cm&sup3;</th>"
             "<th class=\"n\">Largest<br>displacement<br>mm</th>"
             "<th class=\"n\">Largest<br>von Mises<br>MPa</th>"
             "<th class=\"n\">Safety<br>factor</th><th class=\"n\">Error<br>estimate</th>"
             "<th>Picture</th>" +
               std::string(on == page::paper ? "" : "<th></th>"),
             passed_html, on);
  out
    << "<p class=\"faint\">Each picture has a legend of its own, unless the recipe's export fixes "
       "\"range_mpa\". A safety factor is the yield strength over the largest von Mises stress. "
       "The error is estimated in the energy norm.</p>\n</body></html>\n";
  out.close();
  if (!out)
    return fail(ec::io_error, "cannot write the report " + file.string(),
                "Choose another folder, or make room");
  return {};
}

bool is_pdf(const std::filesystem::path& file) {
  return file.extension() == ".pdf";
}

/// A browser would print the page; this needs none, and no display.
expected<void> write_pdf(const family_result& result, const std::filesystem::path& file) {
  const auto html = std::filesystem::path(file.string() + ".html");
  if (auto written = write_html(result, html, page::paper); !written)
    return written;
  const auto done = run_child({pdf_program().string(), html.string(), file.string()}, {},
                              {std::chrono::minutes(10), 0}, {});
  std::error_code ignored;
  std::filesystem::remove(html, ignored);
  if (!done)
    return fail(done.error().code,
                "the report " + file.string() + " could not be made: " + done.error().message,
                "Call it .html; a browser prints it as PDF");
  return {};
}

}  // namespace

expected<void> check_report_name(const std::filesystem::path& file) {
  const auto suffix = file.extension();
  if (suffix != ".html" && suffix != ".htm" && !is_pdf(file))
    return fail(ec::usage,
                "a report is an HTML or PDF file, and " + file.string() + " is none by its name",
                "Call it .html or .pdf");
  if (is_pdf(file) && !std::filesystem::exists(pdf_program()))
    return fail(ec::service_unavailable,
                "the program " + pdf_program().string() +
                  ", which makes PDF files, is not there: "
                  "this build has no Qt",
                "Call the report .html; a browser prints it as PDF");
  return {};
}

expected<void> write_report(const family_result& result, const std::filesystem::path& file) {
  return is_pdf(file) ? write_pdf(result, file) : write_html(result, file, page::screen);
}

}  // namespace tedit::cli
