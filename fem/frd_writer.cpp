// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/frd_writer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace tedit::fem {

namespace {

/// As the format's twelve characters hold it: no sign of zero, no exponent of three digits.
double in_twelve(double value) {
  return std::abs(value) < 1e-99 ? 0 : value;
}

/// One row of a block of results.
void put_row(std::ostream& out, std::size_t node, const double* values, std::size_t count) {
  char text[160];
  int size = std::snprintf(text, sizeof(text), " -1%10zu", node);
  for (std::size_t i = 0; i < count; ++i)
    size += std::snprintf(text + size, sizeof(text) - static_cast<std::size_t>(size), "%12.5E",
                          in_twelve(values[i]));
  out << text << '\n';
}

void put_nodes(const problem& p, std::ostream& out) {
  char head[112];
  std::snprintf(head, sizeof(head),
                "    2C                  %12zu                                     1",
                p.node_count() - p.unused.size());
  out << head << '\n';
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    if (std::ranges::binary_search(p.unused, n))
      continue;
    const double at[] = {p.nodes[n].x, p.nodes[n].y, p.nodes[n].z};
    put_row(out, n + 1, at, 3);
  }
  out << " -3\n";
}

void put_elements(const problem& p, std::ostream& out) {
  char head[112];
  std::snprintf(head, sizeof(head),
                "    3C                  %12zu                                     1",
                p.element_count());
  out << head << '\n';
  const auto width = static_cast<std::size_t>(p.nodes_per_element);
  char text[96];
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    std::snprintf(text, sizeof(text), " -1%10zu%5d%5d%5zu\n", e + 1, p.element_order == 2 ? 6 : 3,
                  0, static_cast<std::size_t>(p.element_materials[e]) + 1);
    out << text << " -2";
    for (std::size_t a = 0; a < width; ++a) {
      std::snprintf(text, sizeof(text), "%10u", p.element_nodes[width * e + a] + 1);
      out << text;
    }
    out << '\n';
  }
  out << " -3\n";
}

struct frd_component {
  const char* name;
  int kind;  ///< 2: of a vector, 4: of a symmetric tensor.
  int first;
  int second;
  int exists = 0;
};

void begin_block(const problem& p, const char* name, const std::vector<frd_component>& components,
                 std::size_t step, std::ostream& out) {
  char text[160];
  std::snprintf(text, sizeof(text), "    1PSTEP%26zu%12d%12d\n", step, 1, 1);
  out << text;
  std::snprintf(text, sizeof(text),
                "  100CL%5zu%12.9f%12zu                     0%5zu           1\n", 100 + step,
                static_cast<double>(step), p.node_count() - p.unused.size(), step);
  out << text;
  std::snprintf(text, sizeof(text), " -4  %-8s%5zu%5d\n", name, components.size(), 1);
  out << text;
  for (const auto& one : components) {
    std::snprintf(text, sizeof(text), " -5  %-8s%5d%5d%5d%5d", one.name, 1, one.kind, one.first,
                  one.second);
    out << text;
    if (one.exists != 0)
      out << "    1ALL";
    out << '\n';
  }
}

void put_displacement(const problem& p, const solution& result, std::size_t step,
                      std::ostream& out) {
  begin_block(p, "DISP", {{"D1", 2, 1, 0}, {"D2", 2, 2, 0}, {"D3", 2, 3, 0}, {"ALL", 2, 0, 0, 1}},
              step, out);
  for (std::size_t n = 0; n < p.node_count(); ++n)
    if (!std::ranges::binary_search(p.unused, n))
      put_row(out, n + 1, &result.displacement[3 * n], 3);
  out << " -3\n";
}

/// Its components stand in the order of the format already.
std::array<double, 6> stress_at(const problem& p, const solution& result, std::size_t node) {
  std::array<double, 6> s{};
  const auto add = [&](std::size_t corner, double weight) {
    for (std::size_t i = 0; i < 6; ++i)
      s[i] += weight * result.nodal_stress[6 * corner + i];
  };
  if (node < p.corner_count) {
    add(node, 1);
  } else {
    const auto& ends = p.edge_ends[node - p.corner_count];
    add(ends[0], 0.5);
    add(ends[1], 0.5);
  }
  return s;
}

void put_stress(const problem& p, const solution& result, std::size_t step, std::ostream& out) {
  begin_block(p, "STRESS",
              {{"SXX", 4, 1, 1},
               {"SYY", 4, 2, 2},
               {"SZZ", 4, 3, 3},
               {"SXY", 4, 1, 2},
               {"SYZ", 4, 2, 3},
               {"SZX", 4, 3, 1}},
              step, out);
  for (std::size_t n = 0; n < p.node_count(); ++n)
    if (!std::ranges::binary_search(p.unused, n))
      put_row(out, n + 1, stress_at(p, result, n).data(), 6);
  out << " -3\n";
}

}  // namespace

void write_frd(const problem& p, const std::vector<const solution*>& cases,
               const std::vector<std::string>& names, std::ostream& out) {
  out << "    1C\n    1UUSER                                                              \n"
      << "    1UPGM               TEdit\n";
  for (std::size_t c = 0; c < names.size(); ++c) {
    auto name = names[c].substr(0, 48);
    std::ranges::replace_if(
      name, [](unsigned char ch) { return ch < 32; }, ' ');
    out << "    1U"
        << "STEP" << c + 1 << "              " << name << '\n';
  }
  put_nodes(p, out);
  put_elements(p, out);
  for (std::size_t c = 0; c < cases.size(); ++c) {
    put_displacement(p, *cases[c], c + 1, out);
    put_stress(p, *cases[c], c + 1, out);
  }
  out << " 9999\n";
}

}  // namespace tedit::fem
