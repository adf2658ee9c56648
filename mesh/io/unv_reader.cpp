// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/formats.hpp"
#include "mesh/io/deck_builder.hpp"
#include "mesh/io/group_names.hpp"
#include "mesh/io/line_cursor.hpp"

namespace tedit {

namespace {

enum class unv_use { tet, face, skip, refuse };

struct unv_element {
  int descriptor;
  unv_use purpose;
  const char* name;
};

// Of the descriptors of dataset 2412 those that programs write.
constexpr unv_element unv_elements[] = {
  {11, unv_use::skip, "rod"},
  {21, unv_use::skip, "beam"},
  {22, unv_use::skip, "tapered beam"},
  {23, unv_use::skip, "curved beam"},
  {24, unv_use::skip, "parabolic beam"},
  {41, unv_use::face, "triangle"},
  {42, unv_use::face, "parabolic triangle"},
  {51, unv_use::face, "triangle"},
  {61, unv_use::face, "triangle"},
  {74, unv_use::face, "triangle"},
  {72, unv_use::face, "parabolic triangle"},
  {81, unv_use::face, "triangle"},
  {82, unv_use::face, "parabolic triangle"},
  {91, unv_use::face, "triangle"},
  {92, unv_use::face, "parabolic triangle"},
  {111, unv_use::tet, "tetrahedron"},
  {112, unv_use::refuse, "wedge"},
  {113, unv_use::refuse, "parabolic wedge"},
  {115, unv_use::refuse, "brick"},
  {116, unv_use::refuse, "parabolic brick"},
  {118, unv_use::tet, "parabolic tetrahedron"},
  {44, unv_use::refuse, "quadrangle"},
  {45, unv_use::refuse, "parabolic quadrangle"},
  {94, unv_use::refuse, "quadrangle"},
  {95, unv_use::refuse, "parabolic quadrangle"},
  {136, unv_use::skip, "spring"},
  {161, unv_use::skip, "mass"},
};

/// Rods and beams have a record of orientation more than other elements.
bool is_beam(std::int64_t descriptor) {
  return descriptor == 11 || (descriptor >= 21 && descriptor <= 24);
}

/// Whole numbers of one line, by blanks; some writers let ten-character fields touch.
std::vector<std::int64_t> numbers_of(const line_cursor& in, const char* what) {
  std::vector<std::int64_t> result;
  auto text = in.line();
  while (!trimmed(text).empty()) {
    text.remove_prefix(text.find_first_not_of(" \t"));
    const auto word = text.substr(0, text.find_first_of(" \t"));
    result.push_back(in.integer(word, what));
    text.remove_prefix(word.size());
  }
  return result;
}

struct unv_triangle {
  std::int64_t physical;
  std::array<std::uint64_t, 3> nodes;
};

struct unv_group {
  std::size_t line = 0;  ///< Where it begins.
  std::string name;
  std::vector<std::pair<std::int64_t, std::uint64_t>> members;  ///< Type (7 node, 8 element), id.
};

class unv_reader {
public:
  explicit unv_reader(std::span<const char> bytes) : in_(bytes) {}

  read_mesh run() {
    while (in_.next()) {
      if (trimmed(in_.line()).empty())
        continue;
      if (trimmed(in_.line()) != "-1")
        in_.fail_here(ec::bad_input,
                      "a dataset should begin here with a line -1, but \"" + shown(in_.line()) +
                        "\" follows the one of line " + std::to_string(set_begin_),
                      "A line is lost or too much: write the file again");
      require_line("a dataset's number");
      const auto dataset = in_.integer(in_.line(), "a dataset's number");
      set_begin_ = in_.number();
      read_dataset(dataset);
    }
    make_groups();
    return out_.finish();
  }

private:
  void read_dataset(std::int64_t dataset) {
    if (dataset == 164)
      read_units();
    else if (dataset == 2411 || dataset == 781)
      read_nodes();
    else if (dataset == 2412)
      read_elements();
    else if (is_group_set(dataset))
      read_groups(dataset);
    else if (dataset == 15 || dataset == 71 || dataset == 780)
      in_.fail_here(ec::unsupported_format,
                    "dataset " + std::to_string(dataset) + " is of an older kind of UNV",
                    "Write nodes as dataset 2411 and elements as 2412");
    else
      skip_dataset(dataset);
  }

  static bool is_group_set(std::int64_t dataset) {
    for (const int one : {2417, 2429, 2430, 2432, 2435, 2452, 2467, 2477})
      if (dataset == one)
        return true;
    return false;
  }

  void skip_dataset(std::int64_t dataset) {
    // 151 is the header, 2420 coordinate systems: both say nothing of the part.
    if (dataset != 151 && dataset != 2420 && dataset != 2400)
      out_.leave_out("dataset " + std::to_string(dataset), in_.number());
    while (next_record()) {
      // Up to the dataset's end.
    }
  }

  void require_line(const char* what) {
    if (!in_.next())
      in_.fail_here(ec::bad_input,
                    std::string("the file ends where ") + what + " should stand (dataset of line " +
                      std::to_string(set_begin_) + ")",
                    "It is cut off: write or copy it again");
  }

  /// The next line of the dataset; false at its end.
  bool next_record() {
    require_line("a dataset's end");
    return trimmed(in_.line()) != "-1";
  }

  void read_units() {
    require_line("the units");
    require_line("the factor of lengths");
    // Its value is how many of the file's lengths are a metre.
    const auto word = trimmed(in_.line());
    const auto factor = in_.real(word.substr(0, word.find(' ')), "the factor of lengths");
    const std::pair<double, const char*> known[] = {{1, "m"},
                                                    {1e2, "cm"},
                                                    {1e3, "mm"},
                                                    {1e6, "um"},
                                                    {1e9, "nm"},
                                                    {39.37007874015748, "in"},
                                                    {3.280839895013123, "ft"}};
    for (const auto& [each, unit] : known)
      if (std::abs(factor / each - 1) < 1e-6)
        out_.length_unit = unit;
    if (out_.length_unit.empty())
      in_.fail_here(ec::unsupported_format,
                    "the factor of lengths is " + shown(word.substr(0, word.find(' '))) +
                      ", that of no unit that is known",
                    "Write the mesh in m, cm, mm, um, nm, in or ft");
    while (next_record()) {
      // Temperatures.
    }
  }

  void read_nodes() {
    while (next_record()) {
      const auto head = numbers_of(in_, "a number of a node's first record");
      if (head.empty() || head[0] < 1)
        in_.fail_here(ec::bad_input, "a node's first record needs its number, from 1",
                      "Write the file again");
      require_line("a node's coordinates");
      out_.mesh.add_node(static_cast<std::uint64_t>(head[0]), position());
    }
  }

  vec3 position() {
    std::array<double, 3> values{};
    auto text = in_.line();
    for (auto& value : values) {
      const auto first = text.find_first_not_of(" \t");
      text.remove_prefix(std::min(first, text.size()));
      const auto word = text.substr(0, text.find_first_of(" \t"));
      value = in_.real(word, "a node's coordinate");
      text.remove_prefix(word.size());
    }
    if (!trimmed(text).empty())
      in_.fail_here(ec::bad_input, "a node has more than three coordinates",
                    "Write decimals with a point");
    return {values[0], values[1], values[2]};
  }

  void read_elements() {
    while (next_record()) {
      const auto head = numbers_of(in_, "a number of an element's first record");
      if (head.size() < 6)
        in_.fail_here(ec::bad_input,
                      "an element's first record has six numbers: its own, descriptor, property, "
                      "material, colour and how many nodes",
                      "Write the file again");
      if (head[0] < 1 || head[5] < 0 || head[5] > 1000)
        in_.fail_here(ec::bad_input,
                      "element " + std::to_string(head[0]) + " says that it has " +
                        std::to_string(head[5]) +
                        " nodes: numbers start at 1, nodes are up to 1000",
                      "Write the file again");
      if (is_beam(head[1]))
        require_line("a beam's orientation");
      add_element(head, nodes_of(static_cast<std::size_t>(head[5])));
    }
  }

  std::vector<std::uint64_t> nodes_of(std::size_t count) {
    std::vector<std::uint64_t> nodes;
    while (nodes.size() < count) {
      require_line("an element's nodes");
      for (const auto node : numbers_of(in_, "a node of an element")) {
        if (node < 1)
          in_.fail_here(ec::bad_input, "an element names node " + std::to_string(node),
                        "Write the file again");
        nodes.push_back(static_cast<std::uint64_t>(node));
      }
    }
    if (nodes.size() > count)
      in_.fail_here(ec::bad_input, "an element has more nodes than its first record says",
                    "Write the file again");
    return nodes;
  }

  void add_element(const std::vector<std::int64_t>& head, const std::vector<std::uint64_t>& nodes) {
    const auto* kind = std::ranges::find(unv_elements, head[1], &unv_element::descriptor);
    if (kind == std::end(unv_elements) || kind->purpose == unv_use::refuse)
      in_.fail_here(ec::unsupported_format,
                    "the file holds a " +
                      std::string(kind == std::end(unv_elements) ? "solid or shell" : kind->name) +
                      " (descriptor " + std::to_string(head[1]) +
                      "); only tetrahedra (111, 118) are supported",
                    "Mesh the volume with tetrahedra");
    const auto number = static_cast<std::uint64_t>(head[0]);
    const std::size_t corners = kind->purpose == unv_use::tet ? 4 : 3;
    if (kind->purpose == unv_use::skip)
      return;
    if (nodes.size() != corners && nodes.size() != (corners == 4 ? 10 : 6))
      in_.fail_here(ec::bad_input,
                    "element " + std::to_string(number) + ", a " + kind->name + ", has " +
                      std::to_string(nodes.size()) + " nodes",
                    "Write the file again");
    const bool quadratic = nodes.size() > corners;
    if (kind->purpose == unv_use::tet) {
      add_tet(number, head[2], nodes, quadratic);
    } else {
      // Corners and middles in turn around a parabolic triangle.
      const std::size_t step = quadratic ? 2 : 1;
      const unv_triangle made{head[2], {nodes[0], nodes[step], nodes[2 * step]}};
      if (!triangles_.emplace(number, made).second)
        in_.fail_here(ec::bad_input, "element " + std::to_string(number) + " is listed twice",
                      "Number the elements anew, or remove one of the two");
    }
  }

  /// Of a parabolic tet corners and middles stand in turn around the base (1, 3, 5; 2, 4, 6), then
  /// the middles of the edges to the top (7, 8, 9), then the top.
  void add_tet(std::uint64_t number, std::int64_t property, const std::vector<std::uint64_t>& n,
               bool quadratic) {
    if (property < INT32_MIN || property > INT32_MAX)
      in_.fail_here(ec::bad_input, "property " + std::to_string(property) + " is out of range",
                    "Number the properties anew");
    const auto region = static_cast<region_id>(property);
    if (quadratic)
      out_.mesh.add_tet(number, region,
                        {n[0], n[2], n[4], n[9], n[1], n[3], n[5], n[6], n[7], n[8]});
    else
      out_.mesh.add_tet(number, region, n);
  }

  void read_groups(std::int64_t dataset) {
    const bool pairs_of_two = dataset == 2417 || dataset == 2429 || dataset == 2430 ||
                              dataset == 2432;  // Older: no third and fourth number.
    while (next_record()) {
      const auto head = numbers_of(in_, "a number of a group's first record");
      const std::size_t at = 7;
      if (head.size() <= at || head[at] < 0)
        in_.fail_here(ec::bad_input,
                      "a group's first record has eight numbers, the last says how many members",
                      "Write the file again");
      unv_group group{in_.number(), {}, {}};
      require_line("a group's name");
      group.name = std::string(trimmed(in_.line()));
      read_members(group, static_cast<std::uint64_t>(head[at]), pairs_of_two ? 2 : 4);
      groups_.push_back(std::move(group));
    }
  }

  void read_members(unv_group& group, std::uint64_t count, std::size_t width) {
    for (std::uint64_t done = 0; done < count;) {
      require_line("a group's members");
      const auto numbers = numbers_of(in_, "a number of a group's members");
      if (numbers.empty() || numbers.size() % width != 0)
        in_.fail_here(ec::bad_input,
                      "group \"" + shown(group.name) + "\" says " + std::to_string(count) +
                        " members, but its lines have " + std::to_string(done),
                      "Write the file again");
      for (std::size_t i = 0; i < numbers.size(); i += width, ++done)
        if (numbers[i + 1] > 0)
          group.members.emplace_back(numbers[i], static_cast<std::uint64_t>(numbers[i + 1]));
    }
  }

  // -- groups ------------------------------------------------------------------------------------

  void make_groups() {
    std::map<std::uint64_t, region_id> region_of;
    std::vector<std::pair<const unv_group*, std::vector<std::uint64_t>>> volumes;
    for (const auto& group : groups_) {
      file_mesh::face_set faces{group.name, {}, {}};
      file_mesh::node_set nodes{group.name, {}};
      std::vector<std::uint64_t> tets;
      std::size_t others = 0;
      for (const auto& [type, id] : group.members)
        if (type == 7) {
          nodes.nodes.push_back(id);
        } else if (const auto triangle = triangles_.find(id); triangle != triangles_.end()) {
          faces.faces.push_back(triangle->second.nodes);
          grouped_.push_back(id);
        } else if (out_.mesh.find_tet(id)) {
          tets.push_back(id);
        } else {
          ++others;
        }
      if (others > 0)
        out_.leave_out(
          "members of group \"" + shown(group.name) + "\" that are no tets or triangles",
          group.line);
      if (!faces.faces.empty())
        add_surface(group, std::move(faces));
      if (!nodes.nodes.empty())
        out_.mesh.node_sets.push_back(std::move(nodes));
      if (!tets.empty())
        volumes.emplace_back(&group, std::move(tets));
    }
    add_ungrouped();
    name_regions(volumes);
  }

  /// What we write is called "surface 12: Bore" and "region 3: Steel".
  void add_surface(const unv_group& group, file_mesh::face_set faces) {
    if (const auto own = own_group(group.name, "surface"); own && own->part == 1) {
      faces.id = own->id;
      faces.name = own->name;
    }
    out_.mesh.face_sets.push_back(std::move(faces));
  }

  /// Triangles of no group are surfaces by their property, as Gmsh and others number them.
  void add_ungrouped() {
    for (const auto number : grouped_)
      triangles_.erase(number);
    std::map<std::int64_t, file_mesh::face_set> by_property;
    for (const auto& [number, triangle] : triangles_)
      by_property[triangle.physical].faces.push_back(triangle.nodes);
    for (auto& [property, set] : by_property) {
      set.name = "SURFACE-" + std::to_string(property);
      out_.mesh.face_sets.push_back(std::move(set));
    }
  }

  /// A group of tets names their region: where its tets have one property of their own, that is its
  /// id, else it becomes a region with a number of its own.
  void name_regions(
    const std::vector<std::pair<const unv_group*, std::vector<std::uint64_t>>>& volumes) {
    std::map<std::uint64_t, std::size_t> place;
    for (std::size_t t = 0; t < out_.mesh.tets.size(); ++t)
      place[out_.mesh.tet_numbers[t]] = t;
    std::map<region_id, std::size_t> sizes;
    for (const auto region : out_.mesh.regions)
      ++sizes[region];
    region_id next = sizes.empty() ? 0 : std::max(0, sizes.rbegin()->first);
    for (const auto& [group, tets] : volumes) {
      if (tets.size() == out_.mesh.tets.size() && sizes.size() > 1)
        continue;  // All of the part: it divides nothing.
      const auto own = own_group(group->name, "region");
      const auto first = out_.mesh.regions[place[tets.front()]];
      const bool whole =
        tets.size() == sizes[first] && std::ranges::all_of(tets, [&](std::uint64_t number) {
          return out_.mesh.regions[place[number]] == first;
        });
      const auto id = whole || next == INT32_MAX ? first : ++next;
      if (!whole)
        for (const auto number : tets)
          out_.mesh.regions[place[number]] = id;
      out_.mesh.region_names.push_back({id, own ? own->name : group->name});
    }
  }

  line_cursor in_;
  deck_builder out_;
  std::size_t set_begin_ = 0;
  std::map<std::uint64_t, unv_triangle> triangles_;
  std::vector<std::uint64_t> grouped_;
  std::vector<unv_group> groups_;
};

}  // namespace

bool formats::unv::recognises(std::span<const char> bytes) {
  line_cursor in(bytes.first(std::min<std::size_t>(bytes.size(), 4096)));
  while (in.next())
    if (!trimmed(in.line()).empty())
      return trimmed(in.line()) == "-1" && in.next() && integer_of(in.line()).has_value();
  return false;
}

expected<read_mesh> formats::unv::read(std::span<const char> bytes) {
  return guarded_read([&] { return unv_reader(bytes).run(); });
}

}  // namespace tedit
