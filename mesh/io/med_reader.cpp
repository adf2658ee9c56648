// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/text.hpp"
#include "base/units.hpp"
#include "mesh/formats.hpp"
#include "mesh/io/file_mesh.hpp"
#include "mesh/io/group_names.hpp"
#include "mesh/io/line_cursor.hpp"
#include "mesh/io/med_content.hpp"
#include "mesh/io/med_regions.hpp"

namespace tedit {

namespace {

/// How many groups an element may be in, on average: a hostile file has thousands of groups for
/// each.
constexpr std::size_t most_groups_each = 64;

/// Notices of tedit-med that are told, and how long one may be.
constexpr std::size_t most_med_notices = 20;
constexpr std::size_t longest_med_notice = 600;

[[noreturn]] void refuse_med(std::string message, std::string remedy, std::string place = {}) {
  throw file_failure{{ec::bad_input, std::move(message), std::move(remedy), std::move(place)}};
}

class med_reader {
public:
  explicit med_reader(med_content content) : content_(std::move(content)) {
    for (const auto& one : content_.families)
      family_of_.emplace(one.number, &one);
  }

  read_mesh run() {
    add_nodes();
    add_tets();
    add_surfaces();
    add_node_sets();
    auto out = mesh_.finish();
    take_unit(out);
    for (std::size_t i = 0; i < std::min(content_.notices.size(), most_med_notices); ++i)
      out.notices.push_back(
        std::string(cut_text(to_utf8(content_.notices[i]), longest_med_notice)));
    return out;
  }

private:
  void add_nodes() {
    const auto& x = content_.coordinates;
    for (std::size_t i = 0; i < x.size(); i += 3) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (!std::isfinite(x[i + axis]))
          refuse_med("a coordinate of node " + std::to_string(i / 3 + 1) + " is " +
                       (std::isnan(x[i + axis]) ? "no number (nan)" : "infinite"),
                     "Write the file again", "node " + std::to_string(i / 3 + 1));
      mesh_.add_node(i / 3 + 1, {x[i], x[i + 1], x[i + 2]});
    }
  }

  [[nodiscard]] std::uint64_t node_of(std::int32_t number, const char* what,
                                      std::size_t place) const {
    if (number < 1 || static_cast<std::size_t>(number) > mesh_.positions.size()) {
      const auto named = what + (" " + std::to_string(place + 1));
      refuse_med(named + " names node " + std::to_string(number) + ", which does not exist",
                 "Write the file with all of its nodes", named);
    }
    return static_cast<std::uint64_t>(number);
  }

  [[nodiscard]] const med_content::family* family_at(std::int32_t number) const {
    const auto found = family_of_.find(number);
    return number == 0 || found == family_of_.end() ? nullptr : found->second;
  }

  /// TETRA10 are numbered behind TETRA4. MED looks at a tet from the other side than we do: the
  /// second and third corner change places, and with them the middles of the edges that they end.
  void add_tets() {
    std::map<std::int32_t, std::size_t> sizes;
    for (const auto* kind : {&content_.tets, &content_.tets10})
      for (const auto family : kind->families)
        ++sizes[family];
    med_regions regions([this](std::int32_t number) { return family_at(number); }, sizes);
    mesh_.region_names = regions.names();
    if (const auto& lost = regions.notice(); !lost.empty())
      content_.notices.push_back(lost);
    add_tets(content_.tets, std::array<std::size_t, 4>{0, 2, 1, 3}, regions);
    add_tets(content_.tets10, std::array<std::size_t, 10>{0, 2, 1, 3, 6, 5, 4, 7, 9, 8}, regions);
  }

  template <std::size_t N>
  void add_tets(const med_content::elements& from, const std::array<std::size_t, N>& order,
                const med_regions& regions) {
    std::vector<std::uint64_t> nodes(N);
    for (std::size_t t = 0; t < from.families.size(); ++t) {
      const auto number = mesh_.tets.size();
      for (std::size_t i = 0; i < N; ++i)
        nodes[i] = node_of(from.nodes[N * t + order[i]], "tet", number);
      mesh_.add_tet(number + 1, regions.of(from.families[t]), nodes);
    }
  }

  // -- surfaces ----------------------------------------------------------------------------------

  /// The groups of families, each with the places of what is in it. What we wrote is one group for
  /// each surface, or several where its name is long.
  struct group_members {
    std::optional<group_name> own = {};
    std::vector<std::size_t> places = {};
  };

  /// A family without groups counts as one of its own name: so Gmsh writes what has no physical
  /// group.
  [[nodiscard]] static std::vector<std::string> groups_of(const med_content::family& family) {
    std::vector<std::string> groups;
    for (const auto& group : family.groups)
      if (std::ranges::find(groups, group) == groups.end())
        groups.push_back(group);
    return groups.empty() ? std::vector{family.name} : groups;
  }

  std::map<std::string, group_members> groups_over(const std::vector<std::int32_t>& families,
                                                   const char* what) {
    std::map<std::int32_t, std::vector<std::size_t>> by_family;
    for (std::size_t i = 0; i < families.size(); ++i)
      if (families[i] != 0)
        by_family[families[i]].push_back(i);
    std::map<std::string, group_members> result;
    std::size_t left = most_groups_each * families.size();
    for (const auto& [number, places] : by_family) {
      const auto* family = family_at(number);
      for (const auto& group : family ? groups_of(*family) : std::vector<std::string>{}) {
        if (places.size() > left)
          refuse_med(std::string("the groups hold each ") + what + " more than " +
                       std::to_string(most_groups_each) + " times on average",
                     "Write the file with fewer groups");
        left -= places.size();
        auto& members = result[group];
        members.own = own_group(group, "surface");
        members.places.insert(members.places.end(), places.begin(), places.end());
      }
    }
    return result;
  }

  void add_surfaces() {
    const auto groups = groups_over(content_.triangles.families, "face");
    std::map<std::int64_t, std::map<std::size_t, std::string>> pieces;  // Of long names.
    std::set<std::int64_t> begun;
    for (const auto& [name, group] : groups)
      if (group.own) {
        pieces[group.own->id][group.own->part] = group.own->name;
        if (group.own->part == 1)
          begun.insert(group.own->id);
      }
    for (const auto& [name, group] : groups) {
      file_mesh::face_set set{name, {}, {}};
      if (group.own && begun.contains(group.own->id)) {
        if (group.own->part != 1)
          continue;
        set.id = group.own->id;
        set.name.clear();
        for (const auto& [part, text] : pieces[group.own->id])
          set.name += text;
      }
      for (const auto place : group.places)
        set.faces.push_back(face_at(place));
      mesh_.face_sets.push_back(std::move(set));
    }
  }

  [[nodiscard]] std::array<std::uint64_t, 3> face_at(std::size_t place) const {
    std::array<std::uint64_t, 3> face{};
    for (std::size_t i = 0; i < 3; ++i)
      face[i] = node_of(content_.triangles.nodes[3 * place + i], "triangle", place);
    return face;
  }

  void add_node_sets() {
    for (const auto& [name, group] : groups_over(content_.node_families, "node")) {
      file_mesh::node_set set{name, {}};
      for (const auto place : group.places)
        set.nodes.push_back(place + 1);
      mesh_.node_sets.push_back(std::move(set));
    }
  }

  void take_unit(read_mesh& out) const {
    const auto unit = std::string(trimmed(content_.unit));
    if (metres_per_unit(unit))
      out.length_unit = unit;
    else if (!unit.empty())
      out.notices.push_back("the file says that its lengths are in \"" + shown(unit) +
                            "\", which is no unit that is known");
  }

  med_content content_;
  file_mesh mesh_;
  std::map<std::int32_t, const med_content::family*> family_of_;
};

}  // namespace

expected<read_mesh> mesh_from(med_content content) {
  return guarded_read([&] { return med_reader(std::move(content)).run(); });
}

bool formats::med::recognises(std::span<const char> bytes) {
  return is_hdf5(bytes);
}

expected<read_mesh> formats::med::read(std::span<const char> bytes) {
  const auto answer = ask_med(bytes);
  if (!answer)
    return fail(answer.error());
  auto content = content_from(*answer);
  if (!content)
    return fail(content.error());
  return mesh_from(std::move(*content));
}

}  // namespace tedit
