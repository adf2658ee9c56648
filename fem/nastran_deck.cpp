// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/nastran_deck.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <ostream>
#include <sstream>
#include <utility>

#include "fem/held_rows.hpp"
#include "mesh/nastran_card.hpp"

namespace tedit::fem {

namespace {

/// Sets of supports, equations and loads in the case control.
constexpr std::uint64_t support_set = 1;
constexpr std::uint64_t equation_set = 2;
constexpr std::uint64_t load_set = 3;

/// Without the noise of the way to Lame's constants and back.
double without_noise(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.12g", value);
  return std::strtod(text, nullptr);
}

class nastran_writer {
public:
  nastran_writer(const problem& p, const nastran_settings& settings, std::ostream& out)
      : p_(p), settings_(settings), out_(out) {
    for (std::size_t n = 0; n < p.node_count(); ++n)
      if (auto rows = held_rows(p, n); !rows.empty())
        held_.emplace_back(n, std::move(rows));
    counts_.held_nodes = held_.size();
  }

  nastran_counts write() {
    std::ostringstream cards;
    write_materials(cards);
    write_supports(cards);
    write_loads(cards);
    write_head();
    write_mesh();
    if (settings_.sets)
      settings_.sets(out_);
    if (settings_.around_cards)
      settings_.around_cards(out_, cards.str());
    else
      out_ << cards.str();
    out_ << "ENDDATA\n";
    return counts_;
  }

private:
  void write_head() {
    auto title = settings_.title.substr(0, 60);
    std::ranges::replace_if(
      title, [](unsigned char c) { return c < 32; }, ' ');
    out_ << "$ Written by TEdit, in SI units (m, N, Pa, kg)\n";
    if (settings_.head)
      settings_.head(out_);
    out_ << "SOL 101\nCEND\nTITLE = " << title << '\n';
    if (!held_.empty())
      out_ << "SPC = " << support_set << '\n';
    if (counts_.equations > 0)
      out_ << "MPC = " << equation_set << '\n';
    if (counts_.loads > 0)
      out_ << "LOAD = " << load_set << '\n';
    out_ << "DISPLACEMENT = ALL\nSTRESS = ALL\nSPCFORCES = ALL\nBEGIN BULK\n";
  }

  static void write_grid(std::ostream& out, std::size_t number, vec3 at) {
    nastran_card(out, "GRID", true)
      .add(std::uint64_t{number})
      .blank()
      .add(at.x)
      .add(at.y)
      .add(at.z);
  }

  void write_mesh() {
    for (std::size_t n = 0; n < p_.node_count(); ++n)
      if (!std::ranges::binary_search(p_.unused, n))
        write_grid(out_, n + 1, p_.nodes[n]);
    const auto width = static_cast<std::size_t>(p_.nodes_per_element);
    for (std::size_t e = 0; e < p_.element_count(); ++e) {
      nastran_card card(out_, "CTETRA");
      card.add(std::uint64_t{e + 1}).add(property_of(e));
      for (std::size_t a = 0; a < width; ++a)
        card.add(std::uint64_t{p_.element_nodes[width * e + a]} + 1);
    }
  }

  [[nodiscard]] std::uint64_t property_of(std::size_t e) const {
    return settings_.property ? settings_.property(p_.element_tets[e])
                              : std::uint64_t{p_.element_materials[e]} + 1;
  }

  void write_materials(std::ostream& out) const {
    std::map<std::uint64_t, std::uint32_t> material_of;
    for (std::size_t e = 0; e < p_.element_count(); ++e)
      material_of.try_emplace(property_of(e), p_.element_materials[e]);
    for (const auto& [property, material] : material_of)
      nastran_card(out, "PSOLID").add(property).add(std::uint64_t{material} + 1);
    for (std::size_t m = 0; m < p_.constants.size(); ++m) {
      const auto [lambda, mu] = p_.constants[m];
      nastran_card card(out, "MAT1", true);
      card.add(std::uint64_t{m + 1})
        .add(without_noise(mu * (3 * lambda + 2 * mu) / (lambda + mu)))
        .blank()
        .add(without_noise(lambda / (2 * (lambda + mu))));
      if (p_.densities[m] > 0)
        card.add(p_.densities[m]);
    }
  }

  void write_supports(std::ostream& out) {
    auto offset = p_.node_count();
    for (const auto& [node, rows] : held_)
      for (const auto& row : rows)
        if (!row.oblique()) {
          hold(out, node + 1, row.dependent + 1, row.value);
          ++counts_.components;
        } else {
          write_equation(out, node, row, offset);
        }
  }

  static void hold(std::ostream& out, std::size_t node, int component, double value) {
    nastran_card(out, "SPC", true)
      .add(support_set)
      .add(std::uint64_t{node})
      .add(static_cast<std::uint64_t>(component))
      .add(value);
  }

  /// u[dependent] + sum of factors - value of a GRID made for it = 0.
  void write_equation(std::ostream& out, std::size_t node, const held_row& row,
                      std::size_t& offset) {
    ++counts_.equations;
    if (row.value != 0) {
      write_grid(out, ++offset, p_.nodes[node]);
      nastran_card(out, "SPC1")
        .add(support_set)
        .add(std::string("23456"))
        .add(std::uint64_t{offset});
      hold(out, offset, 1, row.value);
    }
    std::vector<std::pair<int, double>> terms{{row.dependent, 1}};
    for (int j = 0; j < 3; ++j)
      if (row.factor[static_cast<std::size_t>(j)] != 0)
        terms.emplace_back(j, row.factor[static_cast<std::size_t>(j)]);
    nastran_card card(out, "MPC", true);
    card.add(equation_set);
    std::size_t on_card = 0;
    const auto term = [&](std::size_t grid, int component, double factor) {
      // Two to eight fields: SID G C A, G C A, and a blank at both ends from the second row on.
      if (on_card > 0 && on_card % 2 == 0)
        card.blank(2);
      card.add(std::uint64_t{grid}).add(static_cast<std::uint64_t>(component)).add(factor);
      ++on_card;
    };
    for (const auto& [component, factor] : terms)
      term(node + 1, component + 1, factor);
    if (row.value != 0)
      term(offset, 1, -1);
  }

  void write_loads(std::ostream& out) {
    for (std::size_t n = 0; n < p_.node_count(); ++n) {
      const vec3 f{p_.loads[3 * n], p_.loads[3 * n + 1], p_.loads[3 * n + 2]};
      if (norm(f) == 0)
        continue;
      ++counts_.loads;
      nastran_card(out, "FORCE", true)
        .add(load_set)
        .add(std::uint64_t{n + 1})
        .blank()
        .add(1.0)
        .add(f.x)
        .add(f.y)
        .add(f.z);
    }
  }

  const problem& p_;
  const nastran_settings& settings_;
  std::ostream& out_;
  std::vector<std::pair<std::size_t, std::vector<held_row>>> held_;
  nastran_counts counts_;
};

}  // namespace

expected<nastran_counts> write_nastran_deck(const problem& p, const nastran_settings& settings,
                                            std::ostream& out) {
  // As many again for prescribed oblique directions.
  if (2 * p.node_count() > largest_nastran_number || p.element_count() > largest_nastran_number)
    return fail(ec::invalid_argument,
                "a deck of Nastran numbers at most 99 999 999 nodes and elements",
                "Take linear tets (--order 1) or a coarser mesh");
  return nastran_writer(p, settings, out).write();
}

}  // namespace tedit::fem
