// SPDX-License-Identifier: AGPL-3.0-or-later
#include "verification/page.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace tedit::verification {

namespace {

/// A cell of a Markdown table; bars would end it.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const auto& text : cells)
    line += " " + cell(text) + " |";
  return line + "\n";
}

std::string verdict(bool passed) {
  return passed ? "yes" : "**NO**";
}

std::string introduction(const suite_report& report, const page_facts& facts) {
  const auto count = std::to_string(report.results.size());
  const auto failures = std::to_string(report.failures());
  return "# Verification of the finite element solver\n\n"
         "<!-- Written by `" +
         facts.command + "`: do not edit by hand. -->\n\n" + facts.program + " on the device \"" +
         report.device + "\": " + count + " figures, " + failures +
         " outside their tolerance.\n\n"
         "Repeat it with\n\n```\n" +
         facts.command +
         "\nctest --test-dir build/release -L verification\n```\n\n"
         "The command exits with 0 when all figures hold. All meshes are structured and made by "
         "formula (`verification/meshes.hpp`): cells cut into six tets, except for the real parts. "
         "Quadratic tets have straight edges, so circles are polygons in both orders. Tolerances "
         "are what a correct code must hold on that mesh; rounding and the solver's own tolerance "
         "(1e-9 or less) lie far below them.\n\n";
}

std::string what_is_verified() {
  std::string text = "## What is verified\n\n";
  for (const auto& item : describe_cases())
    text += "- **" + item.name + "** (" + item.source + "): " + item.about + "\n";
  return text + "\n";
}

std::string figures(const suite_report& report) {
  std::string text =
    "## Figures\n\n"
    "| case | order | tets | quantity | target | computed | error | tolerance | holds |\n"
    "|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& r : report.results) {
    if (r.kind == comparison::refusal && r.target == 1)
      continue;
    // Those that hold are summed up in a table of their own.
    if (r.name == side_by_side_case && r.passed)
      continue;
    const auto t = text_of(r);
    text += row({r.name, std::to_string(r.element_order), std::to_string(r.elements), r.quantity,
                 t.target, t.computed, t.error, t.tolerance, verdict(r.passed)});
  }
  return text + "\n";
}

/// One row for each input, whatever the order of the elements.
std::string refusals(const suite_report& report) {
  std::vector<std::pair<std::string, bool>> rows;
  for (const auto& r : report.results) {
    if (r.kind != comparison::refusal || r.target != 1)
      continue;
    const auto known = std::ranges::find(rows, r.quantity, &std::pair<std::string, bool>::first);
    if (known == rows.end())
      rows.emplace_back(r.quantity, r.passed);
    else
      known->second = known->second && r.passed;
  }
  if (rows.empty())
    return {};
  std::string text = "## Refused input\n\n| input | error | refused |\n|---|---|---|\n";
  for (const auto& [quantity, passed] : rows) {
    const auto colon = quantity.rfind(": ");
    text +=
      row({quantity.substr(0, colon), "`" + quantity.substr(colon + 2) + "`", verdict(passed)});
  }
  return text + "\n";
}

std::string convergence(const suite_report& report, const page_facts& facts) {
  if (report.convergence.empty())
    return {};
  std::string text =
    "## Convergence\n\n"
    "The manufactured solution on shaken cubes. Theory: the L2 error falls with h to the order "
    "plus one, the energy error with h to the order.\n\n";
  if (!facts.picture.empty())
    text += "![relative errors over the cell size](" + facts.picture + ")\n\n";
  text +=
    "| order | tets | h | L2 error | rate | energy error | rate |\n|---|---|---|---|---|---|---|\n";
  for (const auto& r : report.convergence) {
    const auto rate = [](double value) { return value == 0 ? "" : format_number("%.2f", value); };
    text += row({std::to_string(r.element_order), std::to_string(r.elements),
                 format_number("%.4g", r.size), format_number("%.3e", r.l2_error), rate(r.l2_rate),
                 format_number("%.3e", r.energy_error), rate(r.energy_rate)});
  }
  return text + "\n";
}

std::string side_by_side(const suite_report& report) {
  if (report.side_by_side.empty())
    return {};
  const auto& program = report.side_by_side.front().program;
  std::string text =
    "## Side by side with " + program +
    "\n\n"
    "The shipped parts (`tests/data/parts`, coarse meshes) with their load cases, exported by the "
    "writer behind `tedit export` and solved by " +
    program +
    " with its direct solver SPOOLES on one thread: the same nodes, elements, supports and nodal "
    "forces, another program. It prints 7 digits, so an agreement of some 1e-7 is all that can "
    "show. Displacement: the largest difference at any node over the largest displacement. "
    "Reactions: of the total, and of the worst surface, over the sum of all surfaces' magnitudes. "
    "Held to 1e-5 in displacement and 1e-6 in reactions and compliance; a figure outside stands "
    "in the table of figures. "
    "Times are whole runs on the machine that wrote this page, and no benchmark: ours is the solve "
    "to a residual of 1e-9, the other includes its files.\n\n"
    "| part | order | tets | nodes | displacement | total reaction | surface reaction | compliance "
    "| TEdit, s | CalculiX, s |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& r : report.side_by_side)
    text += row({r.part, std::to_string(r.element_order), std::to_string(r.elements),
                 std::to_string(r.nodes), format_number("%.1e", r.displacement),
                 format_number("%.1e", r.reaction), format_number("%.1e", r.surface_reaction),
                 format_number("%.1e", r.compliance), format_number("%.1f", 1e-3 * r.milliseconds),
                 format_number("%.1f", 1e-3 * r.other_milliseconds)});
  return text + "\n";
}

std::string left_out(const suite_report& report) {
  if (report.left_out.empty())
    return {};
  std::string text = "## Left out\n\n";
  for (const auto& item : report.left_out)
    text += "- " + item.what + ": " + item.why + "\n";
  return text;
}

}  // namespace

std::string markdown_page(const suite_report& report, const page_facts& facts) {
  return introduction(report, facts) + what_is_verified() + figures(report) + refusals(report) +
         convergence(report, facts) + side_by_side(report) + left_out(report);
}

}  // namespace tedit::verification
