// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "mesh/formats.hpp"
#include "mesh/io/edge_nodes.hpp"
#include "mesh/io/msh_cursor.hpp"
#include "mesh/io/msh_elements.hpp"
#include "mesh/io/node_index.hpp"
#include "mesh/io/read_mesh.hpp"

namespace tedit {

namespace {

class msh_reader {
public:
  explicit msh_reader(std::span<const char> bytes) : in_(bytes) {}

  read_mesh run() {
    require_first_section();
    read_header();
    while (read_section()) {
      // Each call reads one section.
    }
    if (node_numbers_.empty())
      in_.fail_here(ec::bad_input, "the file holds no nodes", "Write the mesh again");
    if (tets_.empty())
      in_.fail_here(ec::bad_input,
                    has_elements_ ? "the mesh has no volume elements (tets)"
                                  : "the file has no section $Elements",
                    has_elements_ ? "Mesh the volume in Gmsh (3D) and save all elements"
                                  : "It is cut off, or was saved without its mesh: write it again");
    if (quads_ > 0)
      in_.fail_here(ec::unsupported_format,
                    "the mesh holds " + std::to_string(quads_) +
                      " quadrangles; only triangles and tetrahedra are supported",
                    "Mesh surfaces with triangles");
    resolve();
    return std::move(out_);
  }

private:
  // -- frame -------------------------------------------------------------------------

  void require_first_section() {
    const auto head = in_.text().substr(0, 4096);
    const auto first = head.find_first_not_of(" \t\r\n");
    if (first == head.npos || head[first] != '$')
      in_.fail_here(
        ec::unsupported_format,
        "the file is of no format that is read: it does not begin with $MeshFormat, nor "
        "as a VTU, Abaqus, Nastran or UNV file does",
        "Choose a .msh (2.2 or 4.1), .vtu, .inp, .bdf or .unv file");
  }

  void read_header() {
    const auto name = in_.token();
    if (name != "$MeshFormat")
      in_.fail_here(ec::bad_input,
                    "the file starts with " + plain(name) + " instead of $MeshFormat",
                    "Save the mesh as MSH 4.1 or 2.2");
    in_.section = "$MeshFormat";
    const auto version = std::string(in_.token());
    if (version.empty())
      in_.fail_truncated();
    if (version != "2.2" && version != "2" && version != "4.1")
      in_.fail_here(ec::unsupported_format, "MSH version " + plain(version) + " is not supported",
                    "Save the mesh as MSH 4.1 or 2.2");
    four_ = version == "4.1";
    const auto type = in_.integer("file type");
    const auto data_size = in_.integer("data size");
    if (type != 0 && type != 1)
      in_.fail_here(ec::bad_input, "the file type must be 0 (ASCII) or 1 (binary)");
    if (type == 1 && data_size != 8)
      in_.fail_here(ec::unsupported_format,
                    "binary files need 8-byte numbers, this one says " + std::to_string(data_size),
                    "Write it on a 64-bit machine, or as text");
    in_.skip_line_end();
    if (type == 1)
      read_byte_order();
    expect_end("$MeshFormat");
  }

  void read_byte_order() {
    in_.binary = true;
    const auto one = in_.raw_int();
    if (one == 0x01000000)
      in_.swapped = true;
    else if (one != 1)
      in_.fail_here(ec::bad_input, "the byte-order marker is neither 1 nor a swapped 1",
                    "The file is no binary MSH file, or it is damaged");
  }

  void expect_end(const std::string& name) {
    const auto word = in_.token();
    if (word.empty())
      in_.fail_truncated();
    if (word != "$End" + name.substr(1))
      in_.fail_here(ec::bad_input, "section " + name + " should end here, but \"" + plain(word) +
                                     "\" follows: its counts and its content disagree");
  }

  bool read_section() {
    const auto name = std::string(in_.token());
    if (name.empty())
      return false;
    if (name.front() != '$' || name.starts_with("$End"))
      in_.fail_here(ec::bad_input, "a section name was expected here, not \"" + plain(name) + "\"");
    in_.section = plain(name);
    if (name == "$PhysicalNames") {
      read_physical_names();
    } else if (name == "$Entities" && four_) {
      in_.skip_line_end();
      read_entities();
    } else if (name == "$Nodes") {
      in_.skip_line_end();
      four_ ? read_nodes_41() : read_nodes_22();
    } else if (name == "$Elements") {
      has_elements_ = true;
      in_.skip_line_end();
      four_ ? read_elements_41() : read_elements_22();
    } else {
      skip_section(name);
      return true;
    }
    expect_end(name);
    return true;
  }

  void skip_section(const std::string& name) {
    const auto end = "$End" + name.substr(1);
    const auto found = in_.text().find("\n" + end, in_.offset());
    if (found == std::string_view::npos)
      in_.fail_here(ec::bad_input, "section " + plain(name) + " is not closed",
                    "The file is cut off or damaged: write it again");
    in_.seek(found + 1 + end.size());
  }

  // -- names and entities --------------------------------------------------------------

  void read_physical_names() {
    // Text in binary files, too.
    const bool binary = std::exchange(in_.binary, false);
    const auto count = in_.size("the number of physical names");
    in_.check_count(count, 5, "physical names");
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto dimension = in_.integer("dimension");
      const auto tag = in_.integer("physical tag");
      const auto line = in_.rest_of_line();
      const auto first = line.find('"');
      const auto last = line.rfind('"');
      if (first == line.npos || last == first)
        in_.fail_here(ec::bad_input, "a physical name must stand in double quotes");
      names_[{dimension, tag}] = std::string(line.substr(first + 1, last - first - 1));
    }
    in_.binary = binary;
  }

  void read_entities() {
    std::array<std::uint64_t, 4> counts{};
    for (auto& count : counts)
      count = in_.size("number of entities");
    for (int dimension = 0; dimension < 4; ++dimension) {
      in_.check_count(counts[dimension], in_.binary ? 36 : 8, "entities");
      for (std::uint64_t i = 0; i < counts[dimension]; ++i)
        read_entity(dimension);
    }
  }

  void read_entity(int dimension) {
    const auto tag = in_.integer("entity tag");
    for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i)
      (void)in_.real("a bounding box coordinate of entity " + std::to_string(tag));
    const auto physical = in_.size("number of physical tags");
    in_.check_count(physical, in_.binary ? 4 : 2, "physical tags");
    for (std::uint64_t i = 0; i < physical; ++i) {
      const auto group = in_.integer("physical tag");
      if (group < INT32_MIN || group > INT32_MAX)
        in_.fail_here(ec::bad_input, "physical tag " + std::to_string(group) + " is out of range");
      if (const auto name = names_.find({dimension, std::abs(group)}); name != names_.end())
        entity_names_[{dimension, tag}] = name->second;
    }
    if (dimension == 0)
      return;
    const auto bounding = in_.size("number of bounding entities");
    in_.check_count(bounding, in_.binary ? 4 : 2, "bounding entities");
    for (std::uint64_t i = 0; i < bounding; ++i)
      (void)in_.integer("bounding entity");
  }

  // -- nodes ---------------------------------------------------------------------------

  void add_node(std::uint64_t number, vec3 position) {
    node_numbers_.push_back(number);
    out_.mesh.positions.push_back(position);
  }

  vec3 read_position(std::uint64_t number) {
    vec3 p;
    // The text of a message is only worth making for ASCII tokens, which are parsed one by one.
    const auto what = in_.binary ? std::string("a coordinate of a node")
                                 : "a coordinate of node " + std::to_string(number);
    p.x = in_.real(what);
    p.y = in_.real(what);
    p.z = in_.real(what);
    return p;
  }

  void read_nodes_22() {
    const bool binary = std::exchange(in_.binary, false);
    const auto count = in_.size("the number of nodes");
    if (binary)
      in_.skip_line_end();
    in_.binary = binary;
    in_.check_count(count, binary ? 28 : 8, "nodes");
    reserve_nodes(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto number = in_.integer("node number");
      if (number <= 0)
        in_.fail_here(ec::bad_input,
                      "node numbers start at 1, this one is " + std::to_string(number));
      add_node(static_cast<std::uint64_t>(number),
               read_position(static_cast<std::uint64_t>(number)));
    }
  }

  void reserve_nodes(std::uint64_t more) {
    node_numbers_.reserve(node_numbers_.size() + more);
    out_.mesh.positions.reserve(node_numbers_.size() + more);
  }

  void read_nodes_41() {
    const auto blocks = in_.size("number of node blocks");
    const auto total = in_.size("the number of nodes");
    (void)in_.size("smallest node number");
    (void)in_.size("largest node number");
    in_.check_count(blocks, in_.binary ? 20 : 8, "node blocks");
    in_.check_count(total, in_.binary ? 32 : 8, "nodes");
    reserve_nodes(total);
    for (std::uint64_t b = 0; b < blocks; ++b)
      read_node_block();
    if (node_numbers_.size() != total)
      in_.fail_here(ec::bad_input, "the file says " + std::to_string(total) + " nodes but lists " +
                                     std::to_string(node_numbers_.size()));
  }

  void read_node_block() {
    const auto dimension = in_.integer("entity dimension");
    (void)in_.integer("entity tag");
    const auto parametric = in_.integer("parametric flag");
    const auto count = in_.size("number of nodes in a block");
    if (dimension < 0 || dimension > 3 || parametric < 0 || parametric > 1)
      in_.fail_here(ec::bad_input, "a node block's dimension or parametric flag is out of range");
    in_.check_count(count, in_.binary ? 32 : 8, "nodes in a block");
    const auto first = node_numbers_.size();
    for (std::uint64_t i = 0; i < count; ++i)
      node_numbers_.push_back(in_.size("node number"));
    for (std::uint64_t i = 0; i < count; ++i) {
      out_.mesh.positions.push_back(read_position(node_numbers_[first + i]));
      for (int u = 0; u < (parametric ? dimension : 0); ++u)
        (void)in_.real("a parametric coordinate");
    }
  }

  // -- elements --------------------------------------------------------------------------

  using element_nodes = std::array<std::uint64_t, 16>;  ///< Corners, edge nodes of a cubic tet.

  const element_kind& kind_of(std::int64_t type) {
    for (const auto& kind : element_kinds)
      if (kind.type == type) {
        if (kind.purpose == element_use::refuse)
          in_.fail_here(ec::unsupported_format,
                        std::string("the mesh holds a ") + kind.name + " (element type " +
                          std::to_string(type) + "); only tetrahedra are supported",
                        "Mesh the volume with tetrahedra");
        return kind;
      }
    in_.fail_here(ec::unsupported_format, "unknown element type " + std::to_string(type),
                  "Mesh the volume with tetrahedra");
  }

  void add_element(const element_kind& kind, std::uint64_t number, std::int64_t entity, bool tagged,
                   const element_nodes& nodes) {
    if (entity < INT32_MIN || entity > INT32_MAX)
      in_.fail_here(ec::bad_input, "entity tag " + std::to_string(entity) + " is out of range");
    if (kind.purpose == element_use::triangle) {
      triangles_.push_back({{nodes[0], nodes[1], nodes[2]}, entity, tagged});
    } else if (kind.purpose == element_use::tet) {
      if (kind.nodes > 4)
        edge_nodes_.add(tets_.size(), kind.nodes > 10 ? 2 : 1, &nodes[4]);
      tets_.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
      out_.mesh.tet_numbers.push_back(number);
      out_.mesh.tet_regions.push_back(static_cast<region_id>(entity));
    }
    quads_ += kind.purpose == element_use::quad;
  }

  void read_elements_41() {
    const auto blocks = in_.size("number of element blocks");
    const auto total = in_.size("the number of elements");
    (void)in_.size("smallest element number");
    (void)in_.size("largest element number");
    in_.check_count(blocks, in_.binary ? 20 : 8, "element blocks");
    in_.check_count(total, in_.binary ? 16 : 4, "elements");
    std::uint64_t listed = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      (void)in_.integer("entity dimension");
      const auto entity = in_.integer("entity tag");
      const auto& kind = kind_of(in_.integer("element type"));
      const auto count = in_.size("number of elements in a block");
      in_.check_count(count, (in_.binary ? 8 : 2) * (static_cast<std::size_t>(kind.nodes) + 1),
                      "elements in a block");
      if (kind.purpose == element_use::tet && tets_.empty())
        reserve_tets(total - std::min(listed, total), in_.binary ? 40 : 10);
      for (std::uint64_t i = 0; i < count; ++i) {
        const auto number = in_.size("the number of an element");
        element_nodes nodes{};
        for (std::size_t n = 0; n < static_cast<std::size_t>(kind.nodes); ++n) {
          const auto node = in_.size("a node of an element");
          if (n < nodes.size())
            nodes[n] = node;
        }
        add_element(kind, number, entity, true, nodes);
      }
      listed += count;
    }
    if (listed != total)
      in_.fail_here(ec::bad_input, "the file says " + std::to_string(total) +
                                     " elements but lists " + std::to_string(listed));
  }

  void read_elements_22() {
    const bool binary = std::exchange(in_.binary, false);
    const auto total = in_.size("the number of elements");
    in_.skip_line_end();
    in_.binary = binary;
    in_.check_count(total, binary ? 8 : 6, "elements");
    reserve_tets(total, binary ? 24 : 14);
    if (binary) {
      for (std::uint64_t listed = 0; listed < total;)
        listed += read_block_22(total - listed);
    } else {
      for (std::uint64_t i = 0; i < total; ++i)
        read_line_22();
    }
  }

  /// As many as the file says, no more than the bytes that are left can be: growing by doubling
  /// would hold half as much again.
  void reserve_tets(std::uint64_t count, std::size_t least_bytes) {
    count = std::min<std::uint64_t>(count, (in_.text().size() - in_.offset()) / least_bytes);
    tets_.reserve(count);
    out_.mesh.tet_numbers.reserve(count);
    out_.mesh.tet_regions.reserve(count);
  }

  std::uint64_t read_block_22(std::uint64_t left) {
    const auto& kind = kind_of(in_.raw_int());
    const auto count = in_.raw_int();
    const auto tags = in_.raw_int();
    if (count <= 0 || static_cast<std::uint64_t>(count) > left || tags < 0 || tags > 64)
      in_.fail_here(ec::bad_input, "an element block's counts are out of range");
    in_.check_count(static_cast<std::uint64_t>(count),
                    4 * (1 + static_cast<std::size_t>(tags + kind.nodes)), "elements in a block");
    for (int i = 0; i < count; ++i) {
      const auto number = in_.raw_int();
      read_rest_22(kind, number, tags, [&](const char*) { return in_.raw_int(); });
    }
    return static_cast<std::uint64_t>(count);
  }

  void read_line_22() {
    const auto number = in_.integer("element number");
    const auto& kind = kind_of(in_.integer_on_line("element type"));
    const auto tags = in_.integer_on_line("number of tags");
    if (tags < 0 || tags > 64)
      in_.fail_here(ec::bad_input, "an element has " + std::to_string(tags) + " tags");
    read_rest_22(kind, number, tags, [&](const char* what) { return in_.integer_on_line(what); });
  }

  template <class Next>
  void read_rest_22(const element_kind& kind, std::int64_t number, std::int64_t tags, Next&& next) {
    std::int64_t physical = 0;
    std::int64_t entity = 0;
    for (std::int64_t t = 0; t < tags; ++t) {
      const std::int64_t tag = next("a tag");
      (t == 0 ? physical : entity) = t < 2 ? tag : entity;
    }
    element_nodes nodes{};
    for (std::size_t n = 0; n < static_cast<std::size_t>(kind.nodes); ++n) {
      const std::int64_t node = next("a node of the element");
      if (node < 0)
        in_.fail_here(ec::bad_input,
                      "element " + std::to_string(number) + " names node " + std::to_string(node));
      if (n < nodes.size())
        nodes[n] = static_cast<std::uint64_t>(node);
    }
    const int dimension = kind.purpose == element_use::tet ? 3 : 2;
    if (const auto name = names_.find({dimension, physical}); physical && name != names_.end())
      entity_names_[{dimension, entity}] = name->second;
    add_element(kind, static_cast<std::uint64_t>(number), entity, tags >= 2, nodes);
  }

  // -- from file numbers to indices ---------------------------------------------------------

  void resolve() {
    if (const auto twice = index_.make(node_numbers_))
      fail_at("$Nodes", "node " + std::to_string(*twice),
              "node " + std::to_string(*twice) + " is listed twice",
              "Number the nodes anew, or remove one of the two");
    const auto index_of = [&](std::uint64_t node, const auto& element) {
      const auto index = index_.find(node);
      if (!index)
        fail_at("$Elements", element(),
                element() + " names node " + std::to_string(node) + ", which does not exist",
                "Save the mesh with all of its nodes");
      return *index;
    };
    out_.mesh.tets.reserve(tets_.size());
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      const auto name = [&] { return "tet " + std::to_string(out_.mesh.tet_numbers[t]); };
      tet corners;
      for (int i = 0; i < 4; ++i)
        corners.v[i] = index_of(tets_[t][i], name);
      out_.mesh.tets.push_back(corners);
    }
    for (const auto& triangle : triangles_) {
      const auto name = [&] {
        return "triangle " + std::to_string(&triangle - triangles_.data() + 1) + " of the file";
      };
      raw_mesh::triangle resolved{{}, triangle.entity, triangle.tagged};
      for (int i = 0; i < 3; ++i)
        resolved.v[i] = index_of(triangle.nodes[i], name);
      out_.mesh.triangles.push_back(resolved);
    }
    add_names();
    if (edge_nodes_.tets() > 0)
      out_.notices.push_back(
        edge_nodes_.describe(out_.mesh.tets, out_.mesh.positions,
                             [&](std::uint64_t node) { return index_.find(node); }));
    out_.mesh.node_numbers = std::move(node_numbers_);
  }

  /// About what was read long before: the cursor's place would lie.
  [[noreturn]] static void fail_at(const char* section, const std::string& place,
                                   std::string message, const char* remedy) {
    throw msh_failure{{ec::bad_input, std::move(message), remedy,
                       std::string("section ") + section + ", " + place}};
  }

  void add_names() {
    for (const auto& [entity, name] : entity_names_) {
      const auto [dimension, tag] = entity;
      if (dimension == 2)
        out_.mesh.surface_names.push_back({tag, name});
      else if (dimension == 3)
        out_.mesh.region_names.push_back({static_cast<region_id>(tag), name});
    }
  }

  struct raw_triangle {
    std::array<std::uint64_t, 3> nodes;
    std::int64_t entity;
    bool tagged;
  };

  msh_cursor in_;
  bool four_ = false;
  read_mesh out_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::string> names_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::string> entity_names_;
  std::vector<std::uint64_t> node_numbers_;
  std::vector<std::array<std::uint64_t, 4>> tets_;
  std::vector<raw_triangle> triangles_;
  node_index index_;
  edge_nodes edge_nodes_;
  bool has_elements_ = false;
  std::size_t quads_ = 0;  ///< Refused at the end: a hexahedron says more.
};

}  // namespace

expected<read_mesh> formats::msh::read(std::span<const char> bytes) {
  try {
    return msh_reader(bytes).run();
  } catch (const msh_failure& failure) {
    return fail(failure.reason);
  } catch (const std::bad_alloc&) {
    return fail(ec::out_of_memory, "there is not enough memory to read this mesh",
                "Close other programs or take a coarser mesh");
  }
}

}  // namespace tedit
