// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/editing.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

namespace tedit::cad {

namespace {

using nlohmann::json;

constexpr std::array<const char*, 10> kinds{"none", "remove", "shift", "round", "cut",
                                            "add",  "keep",   "split", "copy",  "hollow"};

json json_of(const exact_tool& tool) {
  json outlines = json::array();
  for (const auto& outline : tool.outlines) {
    json corners = json::array();
    for (const auto& c : outline)
      corners.push_back({c.x, c.y, c.bulge});
    outlines.push_back(std::move(corners));
  }
  return {{"frame", tool.frame},        {"outlines", std::move(outlines)},
          {"from", tool.from},          {"to", tool.to},
          {"section", tool.section},    {"points", tool.points},
          {"triangles", tool.triangles}};
}

exact_tool tool_from(const json& from) {
  exact_tool tool;
  from.at("frame").get_to(tool.frame);
  for (const auto& outline : from.at("outlines")) {
    auto& corners = tool.outlines.emplace_back();
    for (const auto& c : outline)
      corners.push_back({c.at(0).get<double>(), c.at(1).get<double>(), c.at(2).get<double>()});
  }
  from.at("from").get_to(tool.from);
  from.at("to").get_to(tool.to);
  from.at("section").get_to(tool.section);
  from.at("points").get_to(tool.points);
  from.at("triangles").get_to(tool.triangles);
  return tool;
}

bool is_in_range(const exact_tool& tool) {
  const auto points = static_cast<int>(tool.points.size());
  for (const auto& t : tool.triangles)
    for (const int v : t)
      if (v < 0 || v >= points)
        return false;
  return true;
}

bool write(const std::filesystem::path& file, const json& what) {
  std::ofstream out(file);
  out << what.dump(-1, ' ', false, json::error_handler_t::replace);
  return static_cast<bool>(out.flush());
}

/// Calls `take` with what is in the file. Errors: `internal` for what it cannot take.
template <class Value, class Take>
expected<Value> read(const std::filesystem::path& file, const Take& take) {
  std::ifstream in(file);
  const auto found = json::parse(in, nullptr, false);
  try {
    if (!found.is_discarded())
      return take(found);
  } catch (const json::exception&) {
    // As one that is no JSON.
  }
  return fail(ec::internal, file.filename().string() + " of the edit's folder is damaged",
              "Try again; if it stays, report it with the part");
}

template <class T>
void put(std::ofstream& out, const std::vector<T>& items) {
  out.write(reinterpret_cast<const char*>(items.data()),
            static_cast<std::streamsize>(items.size() * sizeof(T)));
}

template <class T>
bool take(std::string_view& bytes, std::vector<T>& into, std::uint64_t count) {
  if (count > bytes.size() / sizeof(T))
    return false;
  into.resize(count);
  std::memcpy(into.data(), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return true;
}

bool all_in_range(const edited_surface& surface) {
  const auto points = static_cast<std::int64_t>(surface.points.size());
  for (const auto& t : surface.triangles)
    for (int i = 0; i < 3; ++i)
      if (t[i] < 0 || t[i] >= points)
        return false;
  return surface.fresh <= surface.points.size();
}

}  // namespace

bool save_step(const cad_step& step, const std::filesystem::path& folder) {
  json motions = json::array();
  for (const auto& m : step.motions)
    motions.push_back({{"columns", m.columns}, {"shift", m.shift}});
  json carried = json::array();
  for (const auto& c : step.carried)
    carried.push_back({{"surface", c.surface}, {"way", c.way_mm}});
  json more = json::array();
  for (const auto& tool : step.more)
    more.push_back(json_of(tool));
  return write(folder / step_file, {{"kind", kinds[static_cast<std::size_t>(step.kind)]},
                                    {"surfaces", step.surfaces},
                                    {"distance", step.distance_mm},
                                    {"carried", std::move(carried)},
                                    {"convex", step.convex},
                                    {"tool", json_of(step.tool)},
                                    {"motions", std::move(motions)},
                                    {"leaves", step.leaves},
                                    {"is_hole", step.is_hole},
                                    {"edge", step.edge_mm},
                                    {"more", std::move(more)},
                                    {"volume_change", step.volume_change_mm3},
                                    {"size", step.size_mm},
                                    {"bodies", step.bodies}});
}

expected<cad_step> load_step(const std::filesystem::path& folder) {
  auto loaded = read<cad_step>(folder / step_file, [](const json& from) {
    cad_step step;
    const auto kind = from.at("kind").get<std::string>();
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (kind == kinds[i])
        step.kind = static_cast<step_kind>(i);
    from.at("surfaces").get_to(step.surfaces);
    from.at("distance").get_to(step.distance_mm);
    for (const auto& c : from.at("carried"))
      step.carried.push_back(
        {c.at("surface").get<int>(), c.at("way").get<decltype(carried_surface::way_mm)>()});
    from.at("convex").get_to(step.convex);
    step.tool = tool_from(from.at("tool"));
    for (const auto& m : from.at("motions"))
      step.motions.push_back({m.at("columns").get<decltype(step_motion::columns)>(),
                              m.at("shift").get<decltype(step_motion::shift)>()});
    from.at("leaves").get_to(step.leaves);
    from.at("is_hole").get_to(step.is_hole);
    from.at("edge").get_to(step.edge_mm);
    for (const auto& tool : from.at("more"))
      step.more.push_back(tool_from(tool));
    from.at("volume_change").get_to(step.volume_change_mm3);
    from.at("size").get_to(step.size_mm);
    from.at("bodies").get_to(step.bodies);
    return step;
  });
  if (loaded && !is_in_range(loaded->tool))
    return fail(ec::internal, "the tool in the edit's folder is damaged", "Try again");
  return loaded;
}

bool save_surface(const edited_surface& surface, const std::filesystem::path& folder) {
  std::ofstream out(folder / edited_file, std::ios::binary);
  put(out, std::vector{surface_header{surface_header{}.magic, surface.points.size(), surface.fresh,
                                      surface.triangles.size()}});
  put(out, surface.points);
  put(out, surface.triangles);
  return static_cast<bool>(out.flush());
}

expected<edited_surface> load_surface(const std::filesystem::path& folder) {
  std::ifstream in(folder / edited_file, std::ios::binary);
  const std::string all{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  std::string_view bytes = all;
  std::vector<surface_header> header;
  edited_surface surface;
  if (take(bytes, header, 1) && header[0].magic == surface_header{}.magic &&
      take(bytes, surface.points, header[0].points) &&
      take(bytes, surface.triangles, header[0].triangles)) {
    surface.fresh = header[0].fresh;
    if (all_in_range(surface))
      return surface;
  }
  return fail(ec::internal, "the surface in the edit's folder is damaged", "Try again");
}

std::string reason_of(const std::vector<failed_way>& ways) {
  std::vector<failed_way> rows;
  for (const auto& one : ways) {
    const auto same = std::ranges::find(rows, one.fault, &failed_way::fault);
    if (same == rows.end())
      rows.push_back(one);
    else
      same->name += ", " + one.name;
  }
  if (rows.size() > 1)
    std::erase_if(rows, [](const auto& row) { return row.fault.empty(); });
  std::string result;
  for (const auto& row : rows) {
    std::string fault = row.fault;
    if (fault.empty())
      fault = "it cannot be done so";
    result += (result.empty() ? "" : "; ") + row.name + ": " + fault;
  }
  return result;
}

bool save_verdict(const cad_verdict& verdict, const std::filesystem::path& folder) {
  return write(folder / verdict_file, {{"same", verdict.is_same},
                                       {"how", verdict.how},
                                       {"reason", verdict.reason},
                                       {"deviation", verdict.deviation_mm}});
}

expected<cad_verdict> load_verdict(const std::filesystem::path& folder) {
  return read<cad_verdict>(folder / verdict_file, [](const json& from) {
    return cad_verdict{from.at("same").get<bool>(), from.at("how").get<std::string>(),
                       from.at("reason").get<std::string>(), from.at("deviation").get<double>()};
  });
}

}  // namespace tedit::cad
