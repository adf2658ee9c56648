// SPDX-License-Identifier: AGPL-3.0-or-later
// bench_compare MESH LOAD_CASE --fill IDS... [--order N] [--repeat N]: fills a hole of a part on a
// server inside this program, solves both versions and compares them in two ways, in turns: asked
// of the server, and as files that a client fetches, reads and compares itself. Prints one JSON
// object with medians in ms and the bytes that a client receives.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "actors/node/server.hpp"
#include "base/memory.hpp"
#include "base/stopwatch.hpp"
#include "client/client.hpp"
#include "compare/compare_versions.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"

namespace {

using namespace tedit;
using json = nlohmann::json;

constexpr auto token = "0123456789abcdef";

struct options {
  std::string mesh_file, load_file, program;
  std::vector<surface_id> surfaces;
  int order = 1;
  int repeats = 5;
};

std::map<std::string, std::vector<double>> times;

/// The value, and how long it took under a name.
template <class Work>
auto timed(const std::string& name, const Work& work) {
  const stopwatch clock;
  auto result = work();
  times[name].push_back(clock.milliseconds());
  if (!result)
    throw std::runtime_error(name + ": " + render(result.error()));
  return std::move(*result);
}

/// A version as a client without the request would have it.
version_ptr fetched(client::client& user, const std::string& id, std::uint64_t& bytes) {
  const auto file = user.export_file("msh", id, "mm", {});
  if (!file)
    throw std::runtime_error(render(file.error()));
  bytes += file->size();
  const auto read = import_mesh_bytes(*file, "mm");
  if (!read)
    throw std::runtime_error(render(read.error()));
  return read->version;
}

expected<version_comparison> compare_as_files(client::client& user, const std::string& before,
                                              const std::string& after, std::uint64_t& bytes) {
  bytes = 0;
  const auto was = fetched(user, before, bytes);
  const auto is = fetched(user, after, bytes);
  const auto match = match_versions(*was, *is, {});
  return match ? compare_versions({*was}, {*is}, *match, {}) : fail(match.error());
}

/// Bytes of the arrays of a difference.
std::uint64_t bytes_of(const client::comparison& made) {
  std::uint64_t bytes = made.vertices.size() * 4 + made.marks.size();
  for (const auto& [name, values] : made.differences)
    bytes += values.size() * sizeof(float);
  return bytes;
}

json measure(client::client& user, const options& o, const fem::load_case& loads) {
  client::solve_settings settings;
  settings.device = "cpu";
  settings.element_order = o.order;
  const auto need = [](auto result) {
    if (!result)
      throw std::runtime_error(render(result.error()));
    if constexpr (requires { *result; })
      return std::move(*result);
  };
  need(user.open("part", false, false));
  const auto imported = need(user.import_file(o.mesh_file, "mm", {}));
  need(user.set_load_case(loads));
  need(user.solve(settings, {}));
  const auto edited = need(user.edit("fill_hole", o.surfaces, {}, {}));
  need(user.solve(settings, {}));
  std::uint64_t file_bytes = 0;
  std::uint64_t field_bytes = 0;
  field_comparison figures;
  for (int i = 0; i < o.repeats; ++i) {
    const auto summary = timed("summary", [&] { return user.compare(0, 1); });
    const auto field = timed("summary_and_field", [&] { return user.compare(0, 1, loads.name); });
    const auto same = timed("same_version", [&] { return user.compare(1, 1, loads.name); });
    const auto files = timed("as_files", [&] {
      return compare_as_files(user, imported.head.version_id, edited.head.version_id, file_bytes);
    });
    if (files.tets_in_common != summary.what.tets_in_common || field.what.fields.size() != 1)
      throw std::runtime_error("the two ways do not say the same");
    field_bytes = bytes_of(field);
    figures = field.what.fields.front();
  }
  return {{"tets", edited.head.tets},    {"vertices", edited.head.vertices},
          {"same", figures.same},        {"interpolated", figures.interpolated},
          {"outside", figures.outside},  {"field_bytes", field_bytes},
          {"as_files_bytes", file_bytes}};
}

}  // namespace

int main(int argc, char** argv) try {
  return_large_blocks();
  options o;
  CLI::App app("Two versions compared by the server, and as files");
  app.add_option("mesh", o.mesh_file)->required();
  app.add_option("load_case", o.load_file)->required();
  app.add_option("--fill", o.surfaces, "The walls of the hole")->required();
  app.add_option("--program", o.program, "tedit, for the worker processes")->required();
  app.add_option("--order", o.order);
  app.add_option("--repeat", o.repeats)->check(CLI::Range(1, 100));
  CLI11_PARSE(app, argc, argv);
  auto folder = (std::filesystem::temp_directory_path() / "tedit-bench-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr)
    return 1;
  int status = 0;
  try {
    const auto loads = protocol::load_case_from_file(o.load_file);
    if (!loads)
      throw std::runtime_error(render(loads.error()));
    server_options options;
    options.documents = folder;
    options.token = token;
    options.program = o.program;
    const auto host = server::start(options);
    if (!host)
      throw std::runtime_error(render(host.error()));
    client::connect_options how;
    how.url = (*host)->url();
    how.token = token;
    how.client_name = "bench";
    const auto user = client::client::connect(how, {});
    if (!user)
      throw std::runtime_error(render(user.error()));
    auto result = measure(**user, o, *loads);
    for (auto& [name, values] : times) {
      std::ranges::sort(values);
      result["ms"][name] = values[values.size() / 2];
    }
    std::cout << result.dump(1) << '\n';
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    status = 1;
  }
  std::filesystem::remove_all(folder);
  return status;
} catch (const std::exception& why) {
  std::fprintf(stderr, "%s\n", why.what());
  return 1;
}
