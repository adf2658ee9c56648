// SPDX-License-Identifier: AGPL-3.0-or-later
// One mesh file in or out, in a process of its own: time, memory, bytes. Prints one line of JSON.
// usage: bench_formats read FILE
//        bench_formats write MESH FORMAT OUT
#include <sys/resource.h>

#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "mesh/build_version.hpp"
#include "mesh/io/file.hpp"
#include "mesh/io/formats.hpp"

namespace tedit {
namespace {

double cpu_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// The most that this process has had so far.
double peak_mib() {
  rusage use{};
  ::getrusage(RUSAGE_SELF, &use);
  return static_cast<double>(use.ru_maxrss) / 1024;
}

/// What a piece of work takes.
class measure {
public:
  [[nodiscard]] nlohmann::json taken() const {
    return {{"wall_ms", wall_.milliseconds()}, {"cpu_ms", cpu_ms() - cpu_}};
  }

private:
  stopwatch wall_;
  double cpu_ = cpu_ms();
};

double page_mib(const mesh_version& mesh) {
  std::size_t bytes = 0;
  mesh.for_each_page([&](const page_ptr& page) { bytes += page->bytes().size(); });
  return static_cast<double>(bytes) / 1048576;
}

int say(const error& why) {
  return std::fprintf(stderr, "%s\n", render(why).c_str()), 1;
}

/// Bytes to the mesh as the file has it; then to a checked version.
expected<version_ptr> read(const std::filesystem::path& file, nlohmann::json& json) {
  const measure all;
  const measure reading;
  auto bytes = read_file(file);
  if (!bytes)
    return fail(bytes.error());
  auto found = read_any(std::span<const char>(*bytes));
  if (!found)
    return fail(found.error());
  *bytes = std::vector<char>();  // With {} it would keep its memory.
  json["read"] = reading.taken();
  json["read_peak_mib"] = peak_mib();
  const measure building;
  auto built = build_version(std::move(found->mesh), 1e-3, slot_order::along_curve);
  if (!built)
    return fail(built.error());
  json["build"] = building.taken();
  json["all"] = all.taken();
  json["peak_mib"] = peak_mib();
  json["tets"] = built->version->tet_count();
  json["result_mib"] = page_mib(*built->version);
  json["file_mib"] = static_cast<double>(std::filesystem::file_size(file)) / 1048576;
  return built->version;
}

int read_alone(const char* file) {
  nlohmann::json json;
  const double before = peak_mib();
  if (const auto done = read(file, json); !done)
    return say(done.error());
  json["start_mib"] = before;
  std::printf("%s\n", json.dump().c_str());
  return 0;
}

int write(const char* from, const char* format, const char* to) {
  nlohmann::json ignored;
  const auto mesh = read(from, ignored);
  if (!mesh)
    return say(mesh.error());
  const measure writing;
  if (const auto ok = write_as(format, std::filesystem::path(to), **mesh, {.length_unit = "mm"});
      !ok)
    return say(ok.error());
  const nlohmann::json json{
    {"write", writing.taken()},
    {"file_mib", static_cast<double>(std::filesystem::file_size(to)) / 1048576}};
  std::printf("%s\n", json.dump().c_str());
  return 0;
}

}  // namespace
}  // namespace tedit

int main(int argc, char** argv) try {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "read" && argc == 3)
    return tedit::read_alone(argv[2]);
  if (what == "write" && argc == 5)
    return tedit::write(argv[2], argv[3], argv[4]);
  std::fprintf(stderr,
               "usage: bench_formats read FILE\n       bench_formats write MESH FORMAT OUT\n");
  return 2;
} catch (const std::exception& why) {
  return std::fprintf(stderr, "%s\n", why.what()), 1;
}
