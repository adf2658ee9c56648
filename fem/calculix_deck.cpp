// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/calculix_deck.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <ostream>
#include <sstream>
#include <utility>

#include "base/short_number.hpp"
#include "fem/held_rows.hpp"

namespace tedit::fem {

namespace {

// -- numbers ---------------------------------------------------------------------------

/// CalculiX cuts a number here without a word: it reads -1.00000000000000e-05 as -1.
constexpr std::size_t longest_number = 20;

std::string shortest(double value) {
  return short_number(value, longest_number);
}

/// Without the noise of the way to Lame's constants and back.
std::string rounded(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.14g", value);
  return text.data();
}

// -- the deck --------------------------------------------------------------------------

class deck_writer {
public:
  deck_writer(const problem& p, const calculix_settings& settings, std::ostream& out)
      : p_(p), settings_(settings), file_(out) {
    for (std::size_t n = 0; n < p.node_count(); ++n)
      if (auto rows = held_rows(p, n); !rows.empty())
        held_.emplace_back(n, std::move(rows));
    counts_.held_nodes = held_.size();
  }

  calculix_counts write() {
    write_header();
    write_nodes();
    write_elements();
    file_ << out_.str();
    out_.str({});
    if (settings_.sets)
      settings_.sets(file_);
    write_materials();
    write_equations();
    out_ << "*STEP\n*STATIC, SOLVER="
         << (settings_.solver == calculix_solver::spooles ? "SPOOLES" : "ITERATIVE CHOLESKY")
         << "\n1., 1.\n";
    write_boundaries();
    write_loads();
    write_output();
    if (settings_.around_cards)
      settings_.around_cards(file_, out_.str());
    else
      file_ << out_.str();
    return counts_;
  }

private:
  void write_header() {
    auto title = settings_.title;
    // A line break would end the comment.
    std::ranges::replace_if(
      title, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    out_ << "** " << title << "\n"
         << "** Written by TEdit for CalculiX 2.20: ccx -i NAME, for this file as NAME.inp\n"
         << "** Units: SI (m, N, Pa, kg).\n"
         << "** " << p_.node_count() << " nodes, " << p_.element_count() << " "
         << (p_.element_order == 2 ? "quadratic tets (C3D10, straight edges)"
                                   : "linear tets (C3D4)")
         << "\n** Results: NAME.dat has U of all nodes and RF of the held ones (set HELD), with "
            "the total.\n"
         << "** RF is the reaction plus the load on the node.\n";
  }

  void write_nodes() {
    out_ << "*NODE, NSET=NALL\n";
    for (std::size_t n = 0; n < p_.node_count(); ++n)
      write_node(n + 1, p_.nodes[n]);
    // One more node for each oblique direction that is not held at zero.
    auto next = p_.node_count();
    for (const auto& [node, rows] : held_)
      for (const auto& row : rows)
        if (row.oblique() && row.value != 0) {
          if (next == p_.node_count())
            out_ << "*NODE, NSET=OFFSETS\n";
          write_node(++next, p_.nodes[node]);
        }
    if (held_.empty())
      return;
    out_ << "*NSET, NSET=HELD\n";
    for (const auto& [node, rows] : held_)
      out_ << node + 1 << ",\n";
  }

  void write_node(std::size_t id, vec3 at) {
    out_ << id << ", " << shortest(at.x) << ", " << shortest(at.y) << ", " << shortest(at.z)
         << "\n";
  }

  void write_elements() {
    const auto width = static_cast<std::size_t>(p_.nodes_per_element);
    for (std::size_t m = 0; m < p_.constants.size(); ++m) {
      bool any = false;
      for (std::size_t e = 0; e < p_.element_count(); ++e) {
        if (p_.element_materials[e] != m)
          continue;
        if (!std::exchange(any, true))
          out_ << "*ELEMENT, TYPE=" << (p_.element_order == 2 ? "C3D10" : "C3D4")
               << ", ELSET=" << material(m) << "\n";
        out_ << e + 1;
        for (std::size_t a = 0; a < width; ++a)
          out_ << "," << p_.element_nodes[width * e + a] + 1;
        out_ << "\n";
      }
      if (any)
        materials_.push_back(m);
    }
  }

  /// The name of a material and of the set of its elements.
  static std::string material(std::size_t index) { return "MATERIAL-" + std::to_string(index + 1); }

  void write_materials() {
    for (const auto m : materials_) {
      const auto [lambda, mu] = p_.constants[m];
      out_ << "*MATERIAL, NAME=" << material(m) << "\n*ELASTIC\n"
           << rounded(mu * (3 * lambda + 2 * mu) / (lambda + mu)) << ", "
           << rounded(lambda / (2 * (lambda + mu))) << "\n";
      if (p_.densities[m] > 0)
        out_ << "*DENSITY\n" << shortest(p_.densities[m]) << "\n";
      out_ << "*SOLID SECTION, ELSET=" << material(m) << ", MATERIAL=" << material(m) << "\n";
    }
  }

  void write_equations() {
    auto offset = p_.node_count();
    for (const auto& [node, rows] : held_)
      for (const auto& row : rows) {
        if (!row.oblique())
          continue;
        const bool moved = row.value != 0;
        if (counts_.equations++ == 0)
          out_ << "*EQUATION\n";
        const auto terms = std::ranges::count_if(row.factor, [](double f) { return f != 0; });
        out_ << terms + 1 + (moved ? 1 : 0) << "\n"
             << node + 1 << "," << row.dependent + 1 << ",1.";
        for (int j = 0; j < 3; ++j)
          if (row.factor[j] != 0)
            out_ << "," << node + 1 << "," << j + 1 << "," << shortest(row.factor[j]);
        if (moved)
          out_ << "," << ++offset << ",1,-1.";
        out_ << "\n";
      }
  }

  /// All supports stand in the step: CalculiX takes values other than zero only there.
  void write_boundaries() {
    auto offset = p_.node_count();
    bool any = false;
    const auto write = [&](std::size_t id, int component, double value) {
      if (!std::exchange(any, true))
        out_ << "*BOUNDARY\n";
      out_ << id << ", " << component << ", " << component << ", " << shortest(value) << "\n";
    };
    for (const auto& [node, rows] : held_)
      for (const auto& row : rows)
        if (!row.oblique()) {
          write(node + 1, row.dependent + 1, row.value);
          ++counts_.boundaries;
        } else if (row.value != 0) {
          write(++offset, 1, row.value);
        }
  }

  void write_loads() {
    for (std::size_t i = 0; i < p_.dofs(); ++i) {
      if (p_.loads[i] == 0)
        continue;
      if (counts_.loads++ == 0)
        out_ << "*CLOAD\n";
      out_ << i / 3 + 1 << ", " << i % 3 + 1 << ", " << shortest(p_.loads[i]) << "\n";
    }
  }

  void write_output() {
    out_ << "*NODE PRINT, NSET=NALL\nU\n";
    if (!held_.empty())
      out_ << "*NODE PRINT, NSET=HELD, TOTALS=YES\nRF\n";
    if (settings_.fields)
      out_ << "*NODE FILE\nU, RF\n*EL FILE\nS\n";
    out_ << "*END STEP\n";
  }

  const problem& p_;
  const calculix_settings& settings_;
  std::ostream& file_;
  std::ostringstream out_;  ///< What is not in the file yet.
  std::vector<std::pair<std::size_t, std::vector<held_row>>> held_;
  std::vector<std::size_t> materials_;  ///< Those that have elements.
  calculix_counts counts_;
};

}  // namespace

calculix_counts write_calculix_deck(const problem& p, const calculix_settings& settings,
                                    std::ostream& out) {
  return deck_writer(p, settings, out).write();
}

}  // namespace tedit::fem
