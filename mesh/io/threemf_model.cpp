// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/threemf_model.hpp"

#include <charconv>
#include <cstdio>
#include <map>

#include "base/text.hpp"
#include "mesh/face_key.hpp"
#include "mesh/io/compaction.hpp"
#include "mesh/io/file_surfaces.hpp"

namespace tedit {

namespace {

constexpr byte_colour no_colour{176, 176, 176};
constexpr int colours_id = 1;  // Of the group of colours or materials; objects follow.

/// A text in quotes; what XML cannot hold at all is a blank.
std::string xml_text(std::string_view text) {
  std::string result;
  for (const char c : to_utf8(text)) {
    if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '&')
      result += "&amp;";
    else if (c == '"')
      result += "&quot;";
    else
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return result;
}

/// "#20FF00FF": opaque, which readers do not take for granted.
std::string colour_text(const byte_colour& colour) {
  char text[10];
  std::snprintf(text, sizeof(text), "#%02X%02X%02XFF", unsigned{colour[0]}, unsigned{colour[1]},
                unsigned{colour[2]});
  return text;
}

/// Text of a part of the archive, number by number.
class xml_part {
public:
  explicit xml_part(std::string name) : packer_(std::move(name)) {}

  xml_part& operator<<(std::string_view text) {
    packer_.add(text);
    return *this;
  }
  xml_part& operator<<(std::size_t number) { return put(number); }
  /// Nine digits: as many as are told apart by who reads them as 32-bit numbers.
  xml_part& operator<<(double number) { return put(number, std::chars_format::general, 9); }

  [[nodiscard]] zipped_file finish() { return packer_.finish(); }

private:
  template <class... Value>
  xml_part& put(Value... value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof(text), value...).ptr;
    packer_.add({text, static_cast<std::size_t>(end - text)});
    return *this;
  }

  zip_packer packer_;
};

class model_writer {
public:
  model_writer(const mesh_version& mesh, const file_terms& terms, std::string_view unit_name,
               double unit)
      : mesh_(mesh), terms_(terms), unit_name_(unit_name), unit_(unit) {
    for (const auto& row : mesh.data().interfaces.to_vector())
      interfaces_.emplace(make_face_key(row.v).v, row.surface);
    std::size_t place = 1;  // 0 is what has no colour.
    for (const auto& [surface, colour] : terms.colours.of_surfaces)
      materials_.emplace(surface, place++);
    collect_sides();
  }

  zipped_file run() {
    out_
      << R"(<?xml version="1.0" encoding="UTF-8"?>)"
      << "\n<model unit=\"" << unit_name_
      << R"(" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02")"
      << R"( xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02">)"
      << "\n";
    // Only names that the format knows: readers refuse others without a namespace.
    if (!terms_.title.empty())
      out_ << "<metadata name=\"Title\">" << xml_text(terms_.title) << "</metadata>\n";
    out_ << "<metadata name=\"Application\">TEdit</metadata>\n<resources>\n";
    add_colours();
    std::size_t id = colours_id;
    for (const auto& [region, sides] : sides_)
      add_object(++id, region, sides);
    add_build(id);
    out_ << "</model>\n";
    return out_.finish();
  }

private:
  xml_part& line(std::string_view text) { return out_ << text << "\n"; }

  /// Faces of each region's tets with something else behind them.
  void collect_sides() {
    for (const auto t : tets_of_file(mesh_).slots)
      for (int face = 0; face < 4; ++face) {
        const auto behind = mesh_.neighbours(t)[static_cast<std::size_t>(face)];
        if (is_facet(behind) || mesh_.region_of(behind) != mesh_.region_of(t))
          sides_[mesh_.region_of(t)].push_back({t, face});
      }
  }

  surface_id surface_of(tet_side side) const {
    const auto behind = mesh_.neighbours(side.tet)[static_cast<std::size_t>(side.face)];
    if (is_facet(behind))
      return mesh_.facet(behind & ~facet_flag).surface;
    const auto found = interfaces_.find(make_face_key(mesh_.tet_at(side.tet), side.face).v);
    return found == interfaces_.end() ? surface_id{0} : found->second;
  }

  bool has_materials() const { return !materials_.empty(); }
  bool has_group() const { return !has_materials() && !terms_.colours.palette.empty(); }

  void add_colours() {
    if (has_materials()) {
      out_ << "<basematerials id=\"1\">\n<base name=\"other\" displaycolor=\""
           << colour_text(no_colour) << "\"/>\n";
      for (const auto& [surface, colour] : terms_.colours.of_surfaces) {
        const auto* row = mesh_.find_surface(surface);
        out_ << "<base name=\""
             << (row && !row->name.empty() ? xml_text(row->name)
                                           : "surface " + std::to_string(surface))
             << "\" displaycolor=\"" << colour_text(colour) << "\"/>\n";
      }
      line("</basematerials>");
    } else if (has_group()) {
      line("<m:colorgroup id=\"1\">");
      for (const auto& colour : terms_.colours.palette)
        out_ << "<m:color color=\"" << colour_text(colour) << "\"/>\n";
      line("</m:colorgroup>");
    }
  }

  std::string name_of(region_id region) const {
    for (const auto& row : mesh_.regions())
      if (row.id == region && !row.name.empty())
        return row.name;
    if (sides_.size() == 1 && !terms_.title.empty())
      return terms_.title;
    return "region " + std::to_string(region);
  }

  void add_object(std::size_t id, region_id region, const std::vector<tet_side>& sides) {
    out_ << "<object id=\"" << id << "\" type=\"model\" name=\"" << xml_text(name_of(region))
         << "\"";
    if (has_materials() || has_group())
      out_ << R"( pid="1" pindex="0")";
    line(">\n<mesh>\n<vertices>");
    std::vector<bool> is_used(mesh_.vertex_slots());
    for (const auto& side : sides)
      for (const auto v : corners_of(mesh_, side))
        is_used[v] = true;
    const auto vertices = compact(mesh_.vertex_slots(), mesh_.data().vertex_order,
                                  [&](vertex_id v) -> bool { return is_used[v]; });
    for (const auto v : vertices.slots) {
      const auto p = mesh_.position(v) / unit_;
      out_ << "<vertex x=\"" << p.x << "\" y=\"" << p.y << "\" z=\"" << p.z << "\"/>\n";
    }
    line("</vertices>\n<triangles>");
    for (const auto& side : sides)
      add_triangle(side, vertices);
    line("</triangles>\n</mesh>\n</object>");
  }

  void add_triangle(tet_side side, const compaction& vertices) {
    const auto v = corners_of(mesh_, side);
    out_ << "<triangle v1=\"" << std::size_t{vertices.index[v[0]]} << "\" v2=\""
         << std::size_t{vertices.index[v[1]]} << "\" v3=\"" << std::size_t{vertices.index[v[2]]};
    if (has_materials()) {
      const auto found = materials_.find(surface_of(side));
      if (found != materials_.end())
        out_ << R"(" pid="1" p1=")" << found->second;
    } else if (!terms_.colours.of_vertices.empty()) {
      const auto& of = terms_.colours.of_vertices;
      out_ << R"(" pid="1" p1=")" << std::size_t{of[v[0]]} << "\" p2=\"" << std::size_t{of[v[1]]}
           << "\" p3=\"" << std::size_t{of[v[2]]};
    } else if (!terms_.colours.of_facets.empty()) {
      const auto behind = mesh_.neighbours(side.tet)[static_cast<std::size_t>(side.face)];
      // All three, as for vertices, also where they are the same: one form for readers.
      if (is_facet(behind)) {
        const std::size_t place = terms_.colours.of_facets[behind & ~facet_flag];
        out_ << R"(" pid="1" p1=")" << place << R"(" p2=")" << place << R"(" p3=")" << place;
      }
    }
    line("\"/>");
  }

  /// Several objects are parts of one, so that a slicer does not lay them out one by one.
  void add_build(std::size_t last) {
    if (sides_.size() > 1) {
      const auto title = terms_.title.empty() ? std::string("part") : terms_.title;
      out_ << "<object id=\"" << last + 1 << "\" type=\"model\" name=\"" << xml_text(title)
           << "\">\n<components>\n";
      for (std::size_t id = colours_id + 1; id <= last; ++id)
        out_ << "<component objectid=\"" << id << "\"/>\n";
      line("</components>\n</object>");
      ++last;
    }
    out_ << "</resources>\n<build>\n<item objectid=\"" << last << "\"/>\n</build>\n";
  }

  const mesh_version& mesh_;
  const file_terms& terms_;
  std::string_view unit_name_;
  double unit_;
  xml_part out_{"3D/3dmodel.model"};
  std::map<std::array<vertex_id, 3>, surface_id> interfaces_;
  std::map<surface_id, std::size_t> materials_;
  std::map<region_id, std::vector<tet_side>> sides_;
};

}  // namespace

zipped_file threemf_model(const mesh_version& mesh, const file_terms& terms,
                          std::string_view unit_name, double unit) {
  return model_writer(mesh, terms, unit_name, unit).run();
}

}  // namespace tedit
