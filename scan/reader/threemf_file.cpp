// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include <pugixml.hpp>

#include "base/units.hpp"
#include "scan/reader/file_surface.hpp"
#include "scan/reader/zip_reader.hpp"

namespace tedit::scan {

namespace {

constexpr const char* threemf_remedy = "Save the file again in the program that it comes from";
constexpr std::size_t most_unpacked = std::size_t{512} << 20;
constexpr int deepest_components = 8;
/// Objects, each as often as it is built.
constexpr std::size_t most_items = 10'000;

/// Rows of numbers as the format has them: p' = p * rotation + shift.
struct affine_map {
  std::array<double, 12> m{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

  [[nodiscard]] vec3 at(vec3 p) const {
    return {p.x * m[0] + p.y * m[3] + p.z * m[6] + m[9],
            p.x * m[1] + p.y * m[4] + p.z * m[7] + m[10],
            p.x * m[2] + p.y * m[5] + p.z * m[8] + m[11]};
  }

  /// First this, then `next`.
  [[nodiscard]] affine_map then(const affine_map& next) const {
    affine_map result;
    const auto shifted = next.at({m[9], m[10], m[11]});
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 3; ++column)
        result.m[3 * row + column] = m[3 * row] * next.m[column] +
                                     m[3 * row + 1] * next.m[3 + column] +
                                     m[3 * row + 2] * next.m[6 + column];
    result.m[9] = shifted.x;
    result.m[10] = shifted.y;
    result.m[11] = shifted.z;
    return result;
  }
};

class threemf_reader {
public:
  explicit threemf_reader(const pugi::xml_node& model) : model_(model) {}

  file_surface read() {
    const auto unit = std::string(model_.attribute("unit").as_string("millimeter"));
    const std::map<std::string, std::string> units{{"micron", "um"},     {"millimeter", "mm"},
                                                   {"centimeter", "cm"}, {"meter", "m"},
                                                   {"inch", "in"},       {"foot", "ft"}};
    if (!model_)
      fail_at(model_, "the model of the 3MF file holds no element \"model\"");
    if (!units.contains(unit))
      fail_at(model_, "\"" + shown(unit) + "\" is no unit of a 3MF file");
    read_.unit = units.at(unit);
    take_resources();
    const auto build = model_.child("build");
    if (!build.child("item"))
      fail_at(build ? build : model_, "the 3MF file builds nothing: it has no item", ec::bad_input,
              "Put the part on the plate, and save the file again");
    for (const auto& item : build.children("item"))
      add_object(item, map_of(item), {}, 0);
    if (read_.groups.size() < 2) {
      read_.groups.clear();
      read_.group_of.clear();
    }
    if (read_.bodies.size() < 2)
      read_.body_of.clear();
    return std::move(read_);
  }

private:
  [[noreturn]] static void fail_at(const pugi::xml_node& node, std::string message,
                                   ec code = ec::bad_input, const char* remedy = threemf_remedy) {
    throw file_failure{{code, std::move(message), remedy, place_of(node)}};
  }

  static std::string place_of(const pugi::xml_node& node) {
    return "byte " + std::to_string(std::max<std::ptrdiff_t>(0, node.offset_debug())) +
           " of the model";
  }

  static double real_at(const pugi::xml_node& node, const char* name) {
    const auto value = real_of(node.attribute(name).value());
    if (!value)
      fail_at(node, std::string("a vertex of the 3MF file has ") + name + " \"" +
                      shown(node.attribute(name).value()) + "\", which is not a finite number");
    return *value;
  }

  static affine_map map_of(const pugi::xml_node& node) {
    affine_map map;
    const auto words = words_of(node.attribute("transform").value());
    if (words.empty())
      return map;
    if (words.size() != 12)
      fail_at(node, "a transform of the 3MF file has " + std::to_string(words.size()) +
                      " numbers, not 12");
    for (std::size_t i = 0; i < 12; ++i) {
      const auto value = real_of(words[i]);
      if (!value)
        fail_at(node, "a transform of the 3MF file holds \"" + shown(words[i]) +
                        "\", which is not a finite number");
      map.m[i] = *value;
    }
    return map;
  }

  static std::optional<cad::colour> colour_of(std::string_view text) {
    if (text.size() < 7 || text[0] != '#')
      return std::nullopt;
    cad::colour looks{};
    for (std::size_t i = 0; i < 3; ++i) {
      unsigned byte = 0;
      const auto* first = text.data() + 1 + 2 * i;
      if (std::from_chars(first, first + 2, byte, 16).ptr != first + 2)
        return std::nullopt;
      looks[i] = byte / 255.0;
    }
    return looks;
  }

  /// Materials and colours, each by the number of its list and its place there.
  void take_resources() {
    for (const auto& list : model_.child("resources").children()) {
      const std::string kind = list.name();
      const std::string id = list.attribute("id").value();
      if (kind == "object") {
        if (!objects_.emplace(id, list).second)
          fail_at(list, "the 3MF file has two objects \"" + shown(id) + "\"");
        continue;
      }
      int place = 0;
      for (const auto& one : list.children()) {
        const std::string name = one.attribute("name").value();
        const auto* looks = one.attribute("displaycolor") ? "displaycolor" : "color";
        looks_[{id, place++}] = {name, colour_of(one.attribute(looks).value()), 0};
      }
    }
  }

  /// `use`: an item or a component.
  void add_object(const pugi::xml_node& use, const affine_map& map, const std::string& name,
                  int depth) {
    const std::string id = use.attribute("objectid").value();
    for (const auto& attribute : use.attributes())
      if (std::string_view(attribute.name()).ends_with(":path"))
        fail_at(use, "object \"" + shown(id) + "\" of the 3MF file is in another model file in it",
                ec::unsupported_format,
                "Export the part as STL, or as a 3MF of the core specification alone");
    const auto found = objects_.find(id);
    if (found == objects_.end())
      fail_at(use, "the 3MF file names object \"" + shown(id) + "\", which it does not have");
    if (depth > deepest_components || ++items_ > most_items)
      fail_at(use, "objects of the 3MF file are made of each other without end");
    const auto& object = found->second;
    if (const std::string kind = object.attribute("type").as_string("model"); kind != "model")
      return;
    const std::string own = object.attribute("name").value();
    for (const auto& part : object.child("components").children("component"))
      add_object(part, map_of(part).then(map), own.empty() ? name : own, depth + 1);
    if (object.child("mesh"))
      add_mesh(object, map, own.empty() ? name : own);
  }

  void add_vertex(const pugi::xml_node& v, const affine_map& map) {
    const auto place = map.at({real_at(v, "x"), real_at(v, "y"), real_at(v, "z")});
    if (!is_finite(place))
      fail_at(v, "a vertex of the 3MF file lies, after its transforms, beyond all numbers");
    read_.surface.points.push_back(place);
  }

  void add_mesh(const pugi::xml_node& object, const affine_map& map, const std::string& name) {
    const auto first = read_.surface.points.size();
    const auto body = static_cast<std::uint32_t>(read_.bodies.size());
    read_.bodies.push_back(name);
    const auto mesh = object.child("mesh");
    for (const auto& v : mesh.child("vertices").children("vertex"))
      add_vertex(v, map);
    const auto count = read_.surface.points.size() - first;
    for (const auto& t : mesh.child("triangles").children("triangle")) {
      triangle_corners corners{};
      constexpr std::array names{"v1", "v2", "v3"};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto place = integer_of(t.attribute(names[k]).value());
        if (!place || *place < 0 || static_cast<std::uint64_t>(*place) >= count)
          fail_at(t, "a triangle of the 3MF file names vertex \"" +
                       shown(t.attribute(names[k]).value()) + "\" of " + std::to_string(count) +
                       "; they count from 0");
        corners[k] = static_cast<std::uint32_t>(first + static_cast<std::uint64_t>(*place));
      }
      read_.surface.triangles.push_back(corners);
      read_.group_of.push_back(group_of(object, t));
      read_.body_of.push_back(body);
    }
    if (read_.surface.triangles.size() > most_triangles)
      fail_at(object, "the 3MF file builds more than 2,000,000 triangles", ec::bad_input,
              "Simplify the part first, for example in MeshLab");
  }

  /// A triangle's material, else its object's.
  std::uint32_t group_of(const pugi::xml_node& object, const pugi::xml_node& t) {
    const bool own = t.attribute("pid") || t.attribute("p1");
    const auto list = t.attribute("pid") ? t.attribute("pid") : object.attribute("pid");
    const auto place = own ? t.attribute("p1").as_int(0) : object.attribute("pindex").as_int(0);
    const std::pair<std::string, int> key{list.value(), place};
    const auto next = static_cast<std::uint32_t>(read_.groups.size());
    const auto [found, is_new] = places_.emplace(key, next);
    if (is_new) {
      const auto known = looks_.find(key);
      read_.groups.push_back(known == looks_.end() ? face_group{} : known->second);
    }
    return found->second;
  }

  const pugi::xml_node model_;
  file_surface read_;
  std::map<std::string, pugi::xml_node> objects_;
  std::map<std::pair<std::string, int>, face_group> looks_;
  std::map<std::pair<std::string, int>, std::uint32_t> places_;
  std::size_t items_ = 0;
};

/// By its suffix: its place is in a file of relations, which all programs fill alike.
std::string model_name(const zip_archive& archive) {
  for (const auto& name : archive.names())
    if (name == "3D/3dmodel.model")
      return name;
  for (const auto& name : archive.names())
    if (name.ends_with(".model"))
      return name;
  return "3D/3dmodel.model";
}

}  // namespace

expected<file_surface> read_3mf(std::span<const char> bytes) {
  const auto archive = zip_archive::open(bytes);
  if (!archive)
    return fail(archive.error());
  auto text = archive->unpack(model_name(*archive), most_unpacked);
  if (!text)
    return fail(text.error());
  pugi::xml_document document;
  const auto parsed = document.load_buffer_inplace(text->data(), text->size());
  if (!parsed)
    return fail(ec::bad_input,
                std::string("the model of the 3MF file is no XML: ") + parsed.description(),
                threemf_remedy, "byte " + std::to_string(parsed.offset) + " of the model");
  auto read = guarded([&] { return threemf_reader(document.child("model")).read(); });
  return read ? checked(std::move(*read), "3MF") : read;
}

}  // namespace tedit::scan
