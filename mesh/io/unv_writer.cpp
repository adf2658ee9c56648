// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <ostream>

#include "base/text.hpp"
#include "base/units.hpp"
#include "mesh/io/compaction.hpp"
#include "mesh/io/file_surfaces.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/group_names.hpp"

namespace tedit {

namespace {

/// A real number in a field of 25 characters, with the letter that Fortran takes for double.
std::string unv_real(double value) {
  char text[40];
  std::snprintf(text, sizeof(text), "%25.16E", value + 0.0);
  std::string result = text;
  std::ranges::replace(result, 'E', 'D');
  return result;
}

class unv_writer {
public:
  unv_writer(std::ostream& out, const mesh_version& mesh, const std::string& unit, double metres)
      : out_(out),
        mesh_(mesh),
        unit_(unit),
        metres_(metres),
        vertices_(vertices_of_file(mesh)),
        tets_(tets_of_file(mesh)),
        surfaces_(sides_of_surfaces(mesh)) {}

  void write() {
    write_units();
    write_nodes();
    write_elements();
    write_groups();
  }

private:
  void put(std::uint64_t number) {
    char text[24];
    std::snprintf(text, sizeof(text), "%10llu", static_cast<unsigned long long>(number));
    out_ << text;
  }

  void begin(int dataset) {
    out_ << "    -1\n" << (dataset < 1000 ? "   " : "  ") << dataset << '\n';
  }
  void end() { out_ << "    -1\n"; }

  void write_units() {
    begin(164);
    // "10" is a system of the user's own.
    std::string name = "lengths in " + unit_;
    name.resize(20, ' ');
    out_ << "        10" << name << "         2\n"
         << unv_real(1 / metres_) << unv_real(1) << unv_real(1) << '\n'
         << unv_real(273.15) << '\n';
    end();
  }

  void write_nodes() {
    begin(2411);
    for (std::size_t i = 0; i < vertices_.slots.size(); ++i) {
      const auto p = mesh_.position(vertices_.slots[i]) / metres_;
      put(i + 1);
      out_ << "         1         1        11\n"
           << unv_real(p.x) << unv_real(p.y) << unv_real(p.z) << '\n';
    }
    end();
  }

  void write_element(std::uint64_t number, int descriptor, std::int64_t property, int nodes) {
    char text[80];
    std::snprintf(text, sizeof(text), "%10llu%10d%10lld%10d%10d%10d\n",
                  static_cast<unsigned long long>(number), descriptor,
                  static_cast<long long>(property), 1, 7, nodes);
    out_ << text;
  }

  void write_elements() {
    begin(2412);
    for (std::size_t i = 0; i < tets_.slots.size(); ++i) {
      const auto t = tets_.slots[i];
      write_element(i + 1, 111, mesh_.region_of(t), 4);
      for (const auto v : mesh_.tet_at(t).v)
        put(vertices_.index[v] + 1ull);
      out_ << '\n';
    }
    auto number = tets_.slots.size();
    std::int64_t place = 0;
    for (const auto& [surface, sides] : surfaces_) {
      ++place;
      for (const auto& side : sides) {
        write_element(++number, 91, has_plain_ids() ? surface : place, 3);
        for (const auto v : corners_of(mesh_, side))
          put(vertices_.index[v] + 1ull);
        out_ << '\n';
      }
    }
    end();
  }

  /// Whether ids can be properties: programs that know no groups part surfaces by these.
  [[nodiscard]] bool has_plain_ids() const {
    return surfaces_.empty() ||
           (surfaces_.begin()->first > 0 && surfaces_.rbegin()->first <= INT32_MAX);
  }

  void begin_group(std::size_t number, std::size_t members, std::string text) {
    put(number);
    out_ << "         0         0         0         0         0         0";
    put(members);
    std::ranges::replace_if(
      text, [](unsigned char c) { return c < 32; }, ' ');
    out_ << '\n' << text << '\n';
  }

  /// Elements (8) two to a line.
  void write_members(std::uint64_t first, std::size_t count, const auto& number_of) {
    for (std::size_t i = 0; i < count; ++i) {
      out_ << "         8";
      put(first + number_of(i));
      out_ << "         0         0";
      if (i % 2 == 1 || i + 1 == count)
        out_ << '\n';
    }
  }

  void write_groups() {
    begin(2467);
    std::size_t group = 0;
    std::uint64_t first = tets_.slots.size() + 1;
    for (const auto& [surface, sides] : surfaces_) {
      const auto* row = mesh_.find_surface(surface);
      begin_group(++group, sides.size(), name_of_group("surface", surface, row ? row->name : ""));
      write_members(first, sides.size(), [](std::size_t i) { return i; });
      first += sides.size();
    }
    for (const auto& region : mesh_.regions()) {
      std::vector<std::size_t> members;
      for (std::size_t i = 0; i < tets_.slots.size(); ++i)
        if (mesh_.region_of(tets_.slots[i]) == region.id)
          members.push_back(i);
      begin_group(++group, members.size(), name_of_group("region", region.id, region.name));
      write_members(1, members.size(), [&](std::size_t i) { return members[i]; });
    }
    end();
  }

  std::ostream& out_;
  const mesh_version& mesh_;
  std::string unit_;
  double metres_;
  compaction vertices_;
  compaction tets_;
  std::map<surface_id, std::vector<tet_side>> surfaces_;
};

}  // namespace

expected<void> formats::unv::write(const file_target& to, const mesh_version& mesh,
                                   const file_terms& terms) {
  const auto unit = metres_per_unit(terms.length_unit);
  if (!unit)
    return fail(unit.error());
  return to.write(
    [&](std::ostream& out) { unv_writer(out, mesh, terms.length_unit, *unit).write(); });
}

}  // namespace tedit
