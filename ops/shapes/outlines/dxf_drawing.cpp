// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/outlines/dxf_drawing.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <set>

namespace tedit::ops {

namespace {

constexpr int most_depth = 16;
constexpr std::size_t most_groups = 10'000'000;  // Seven times what a file can hold.
constexpr double most_reach = 1e12;
constexpr std::size_t most_kinds = 12;

struct drawing_unit {
  int code;
  double metres;
  const char* name;
};

// Of $INSUNITS. Source: Autodesk, DXF Reference, HEADER; those of the sky are left out.
constexpr std::array<drawing_unit, 17> units{{{1, 0.0254, "in"},
                                              {2, 0.3048, "ft"},
                                              {3, 1609.344, "mi"},
                                              {4, 1e-3, "mm"},
                                              {5, 1e-2, "cm"},
                                              {6, 1, "m"},
                                              {7, 1e3, "km"},
                                              {8, 2.54e-8, "microinches"},
                                              {9, 2.54e-5, "mil"},
                                              {10, 0.9144, "yd"},
                                              {11, 1e-10, "angstrom"},
                                              {12, 1e-9, "nm"},
                                              {13, 1e-6, "um"},
                                              {14, 0.1, "dm"},
                                              {15, 10, "dam"},
                                              {16, 100, "hm"},
                                              {21, 1200.0 / 3937, "US survey feet"}}};

/// Names of layers and blocks are the same in both cases.
std::string folded(std::string_view name) {
  std::string result(name);
  for (auto& c : result)
    if (c >= 'a' && c <= 'z')
      c = static_cast<char>(c - 'a' + 'A');
  return result;
}

using items = std::span<const dxf_item>;

struct dxf_block {
  const dxf_item* begin = nullptr;
  items content;
};

/// An entity's kind for people: that of a damaged file may be anything.
std::string kind_of(const dxf_item& item) {
  const bool plain =
    item.kind.size() <= 20 && !item.kind.empty() &&
    item.kind.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") == std::string_view::npos;
  return plain ? std::string(item.kind) : "others";
}

/// How what is drawn gets into the drawing: by a block that is inserted, or as it is.
struct insertion {
  affine place = {};
  std::string layer = "0";  ///< That layer 0 of its content is on.
  int depth = 0;
};

class drawing_reader {
public:
  expected<dxf_drawing> run(items all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].kind != "SECTION")
        continue;
      std::size_t end = i + 1;
      while (end < all.size() && all[end].kind != "ENDSEC")
        ++end;
      const auto content = all.subspan(i + 1, end - i - 1);
      const auto name = dxf_values(all[i]).text(2);
      if (name == "HEADER")
        read_header(all[i]);
      else if (name == "TABLES")
        read_layers(content);
      else if (name == "BLOCKS")
        read_blocks(content);
      else if (name == "ENTITIES")
        model_ = content;
      i = end;
    }
    if (!fault_)
      draw(model_, {});
    if (fault_)
      return fail(*fault_);
    tell_what_is_left_out();
    return std::move(drawing_);
  }

private:
  void read_header(const dxf_item& header) {
    bool next = false;
    for (const auto& group : header.groups) {
      if (next && group.code == 70) {
        dxf_values values(header);
        set_unit(static_cast<int>(values.number_in(group)));
        keep(values.fault());
      }
      next = group.code == 9 ? group.value == "$INSUNITS" : next;
    }
  }

  void set_unit(int code) {
    if (code == 0)
      return;
    for (const auto& unit : units)
      if (unit.code == code) {
        drawing_.metres_per_unit = unit.metres;
        drawing_.unit = unit.name;
        return;
      }
    keep(error{ec::bad_input,
               "the drawing's unit, $INSUNITS " + std::to_string(code) +
                 ", is none that parts are measured in",
               "Set it to millimetres or inches and export it again", ""});
  }

  void read_layers(items content) {
    constexpr int frozen = 1;
    for (const auto& item : content) {
      if (item.kind != "LAYER")
        continue;
      dxf_values values(item);
      // A layer that is off has a negative colour.
      if ((values.whole(70, 0) & frozen) != 0)
        frozen_.insert(folded(values.text(2)));
      else if (values.whole(62, 7) < 0)
        off_.insert(folded(values.text(2)));
      keep(values.fault());
    }
  }

  void read_blocks(items content) {
    for (std::size_t i = 0; i < content.size(); ++i) {
      if (content[i].kind != "BLOCK")
        continue;
      std::size_t end = i + 1;
      while (end < content.size() && content[end].kind != "ENDBLK")
        ++end;
      blocks_[folded(dxf_values(content[i]).text(2))] = {&content[i],
                                                         content.subspan(i + 1, end - i - 1)};
      i = end;
    }
  }

  void keep(const std::optional<error>& fault) {
    if (fault && !fault_)
      fault_ = fault;
  }

  /// On paper, invisible, or on a layer that is not shown.
  bool is_hidden(const dxf_item& item, const insertion& by, std::string& layer) {
    dxf_values values(item);
    layer = folded(values.text(8));
    if (layer.empty() || layer == "0")
      layer = by.layer;
    const bool hidden = values.whole(67, 0) == 1 || values.whole(60, 0) == 1;
    keep(values.fault());
    // What a block that is off holds on other layers is still shown.
    return hidden || frozen_.contains(layer) || (item.kind != "INSERT" && off_.contains(layer));
  }

  void draw(items content, const insertion& by) {
    for (std::size_t i = 0; i < content.size() && !fault_; ++i) {
      const auto& item = content[i];
      groups_ += item.groups.size() + 1;
      std::size_t end = i + 1;
      while (item.kind == "POLYLINE" && end < content.size() && content[end].kind == "VERTEX")
        ++end;
      const auto vertices = content.subspan(i + 1, end - i - 1);
      i = end - 1;
      std::string layer;
      if (item.kind == "SEQEND" || item.kind == "VERTEX" || item.kind == "VIEWPORT" ||
          is_hidden(item, by, layer))
        continue;
      if (item.kind == "INSERT")
        insert(item, by, layer);
      else if (is_outline_entity(item.kind))
        add_path(item, vertices, by);
      else
        leave_out(kind_of(item));
    }
  }

  void add_path(const dxf_item& item, items vertices, const insertion& by) {
    auto path = path_of_entity(item, vertices);
    if (!path)
      return keep(path.error());
    drawn_ += path->curves.size();
    if (!has_room(item) || path->curves.empty())
      return;
    plane_box box;
    for (auto& curve : path->curves) {
      curve = moved(curve, by.place);
      add_to(box, curve);
    }
    const double reach =
      std::max(std::max(-box.low[0], box.high[0]), std::max(-box.low[1], box.high[1]));
    if (!(reach < most_reach))
      return keep(error{ec::bad_input, "the drawing reaches further than any part",
                        "Check the scales of its blocks", "line " + std::to_string(item.line)});
    drawing_.paths.push_back(std::move(*path));
  }

  void leave_out(const std::string& kind) {
    const bool known = left_out_.contains(kind) || left_out_.size() < most_kinds;
    ++left_out_[known ? kind : "others"];
  }

  bool has_room(const dxf_item& item) {
    if (drawn_ > most_drawn || groups_ > most_groups)
      keep(error{ec::bad_input, "the drawing has more than 20,000 lines and arcs",
                 "Leave out what is no outline: put it on a layer that is frozen or off",
                 "line " + std::to_string(item.line)});
    return !fault_;
  }

  void insert(const dxf_item& item, const insertion& by, const std::string& layer) {
    dxf_values values(item);
    const auto name = folded(values.text(2));
    const auto block = blocks_.find(name);
    const auto where = "line " + std::to_string(item.line);
    if (block == blocks_.end())
      return keep(error{ec::bad_input, "the drawing inserts a block that it does not have",
                        "Explode the blocks, or export it again", where});
    if (by.depth == most_depth)
      return keep(error{ec::bad_input,
                        "blocks of the drawing are inserted in each other without end",
                        "Explode the blocks", where});
    const auto axes = axes_of_entity(item);
    if (!axes)
      return keep(axes.error());
    const affine shift{1, 0, 0, 1, values.number(10, 0), values.number(20, 0)};
    const double angle = values.number(50, 0) * std::numbers::pi / 180;
    const affine turn{std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
    const affine scale{values.number(41, 1), 0, 0, values.number(42, 1), 0, 0};
    dxf_values of_block(*block->second.begin);
    const affine base{1, 0, 0, 1, -of_block.number(10, 0), -of_block.number(20, 0)};
    const affine content = scale.of(base);
    const int columns = std::max(1, values.whole(70, 1));
    const int rows = std::max(1, values.whole(71, 1));
    const point2 step{values.number(44, 0), values.number(45, 0)};
    keep(values.fault());
    keep(of_block.fault());
    for (int row = 0; row < rows && !fault_; ++row)
      for (int column = 0; column < columns && !fault_; ++column) {
        ++drawn_;
        if (!has_room(item))
          return;
        const affine cell{1, 0, 0, 1, column * step[0], row * step[1]};
        draw(block->second.content,
             {by.place.of(axes->of(shift.of(turn.of(cell.of(content))))), layer, by.depth + 1});
      }
  }

  void tell_what_is_left_out() {
    if (drawing_.unit.empty())
      drawing_.notices.push_back("the drawing does not say its unit: it is taken for millimetres");
    std::string kinds;
    for (const auto& [kind, count] : left_out_)
      kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
    if (!kinds.empty())
      drawing_.notices.push_back("left out of the drawing: " + kinds);
  }

  dxf_drawing drawing_;
  std::set<std::string> frozen_;
  std::set<std::string> off_;
  std::map<std::string, dxf_block> blocks_;
  std::map<std::string, std::size_t> left_out_;
  items model_;
  std::size_t drawn_ = 0;   ///< Curves and blocks.
  std::size_t groups_ = 0;  ///< Looked at, again for each time that a block is inserted.
  std::optional<error> fault_;
};

}  // namespace

expected<dxf_drawing> read_dxf(const attachment& file) {
  const auto groups = dxf_groups(file);
  if (!groups)
    return fail(groups.error());
  const auto all = dxf_items(*groups);
  return drawing_reader{}.run(all);
}

}  // namespace tedit::ops
