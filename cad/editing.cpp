// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/editing.hpp"

#include <cstring>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

namespace tedit::cad {

namespace {

using nlohmann::json;

constexpr std::array<const char*, 7> kinds{"none", "remove", "shift", "round",
                                           "cut",  "add",    "keep"};

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
  json outlines = json::array();
  for (const auto& outline : step.tool.outlines) {
    json corners = json::array();
    for (const auto& c : outline)
      corners.push_back({c.x, c.y, c.bulge});
    outlines.push_back(std::move(corners));
  }
  return write(folder / step_file, {{"kind", kinds[static_cast<std::size_t>(step.kind)]},
                                    {"surfaces", step.surfaces},
                                    {"distance", step.distance_mm},
                                    {"convex", step.convex},
                                    {"frame", step.tool.frame},
                                    {"outlines", std::move(outlines)},
                                    {"from", step.tool.from},
                                    {"to", step.tool.to},
                                    {"section", step.tool.section},
                                    {"volume_change", step.volume_change_mm3},
                                    {"size", step.size_mm},
                                    {"bodies", step.bodies}});
}

expected<cad_step> load_step(const std::filesystem::path& folder) {
  return read<cad_step>(folder / step_file, [](const json& from) {
    cad_step step;
    const auto kind = from.at("kind").get<std::string>();
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (kind == kinds[i])
        step.kind = static_cast<step_kind>(i);
    step.surfaces = from.at("surfaces").get<std::vector<int>>();
    step.distance_mm = from.at("distance").get<double>();
    step.convex = from.at("convex").get<bool>();
    step.tool.frame = from.at("frame").get<decltype(step.tool.frame)>();
    for (const auto& outline : from.at("outlines")) {
      auto& corners = step.tool.outlines.emplace_back();
      for (const auto& c : outline)
        corners.push_back({c.at(0).get<double>(), c.at(1).get<double>(), c.at(2).get<double>()});
    }
    step.tool.from = from.at("from").get<double>();
    step.tool.to = from.at("to").get<double>();
    step.tool.section = from.at("section").get<decltype(step.tool.section)>();
    step.volume_change_mm3 = from.at("volume_change").get<double>();
    step.size_mm = from.at("size").get<double>();
    step.bodies = from.at("bodies").get<std::size_t>();
    return step;
  });
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
