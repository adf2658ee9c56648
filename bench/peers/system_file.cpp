// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "bench/peers/system.hpp"
#include "bench/peers/system_magic.hpp"

namespace tedit::bench {

namespace {

template <class T>
bool read(std::istream& in, std::vector<T>& values, std::size_t count) {
  values.resize(count);
  in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
  return in.good();
}

tl::unexpected<error> cut_short(const std::filesystem::path& path) {
  return fail(ec::bad_input, path.string() + " ends too early", "Write it again", path.string());
}

/// Bytes that a file with this header has, if its numbers can be true at all.
std::uint64_t bytes_of(const system_header& h) {
  constexpr std::uint64_t most = std::uint64_t{1} << 40;
  if (h.nodes > most || h.blocks > most)
    return 0;
  return sizeof(h) + 8 * (h.nodes + 1) + 48 * h.nodes + (4 + 72) * h.blocks;
}

}  // namespace

expected<system_file> system_file::open(const std::filesystem::path& path) {
  system_file file;
  file.path_ = path;
  file.in_.open(path, std::ios::binary);
  if (!file.in_)
    return fail(ec::io_error, "cannot read " + path.string(), "Give a file of --write-system");
  auto& h = file.header_;
  file.in_.read(reinterpret_cast<char*>(&h), sizeof(h));
  if (!file.in_ || h.magic != system_magic)
    return fail(ec::bad_input, path.string() + " is no system file",
                "Write one with bench_solve --write-system", path.string());
  std::error_code why;
  if (bytes_of(h) != std::filesystem::file_size(path, why) || why)
    return cut_short(path);
  if (!read(file.in_, file.row_first_, h.nodes + 1) || !read(file.in_, file.load_, 3 * h.nodes) ||
      !read(file.in_, file.positions_, 3 * h.nodes))
    return cut_short(path);
  if (file.row_first_.front() != 0 || file.row_first_.back() != h.blocks ||
      !std::ranges::is_sorted(file.row_first_))
    return fail(ec::bad_input, path.string() + " has rows out of order", "Write it again",
                path.string());
  file.rows_at_ = file.in_.tellg();
  return file;
}

expected<void> system_file::for_rows(const row_sink& sink) {
  in_.clear();
  in_.seekg(rows_at_);
  std::vector<std::uint32_t> columns;
  std::vector<double> blocks;
  for (std::size_t row = 0; row < nodes(); ++row) {
    const auto count = row_first_[row + 1] - row_first_[row];
    if (!read(in_, columns, count) || !read(in_, blocks, 9 * count))
      return cut_short(path_);
    if (std::ranges::any_of(columns, [&](std::uint32_t c) { return c >= nodes(); }))
      return fail(ec::bad_input,
                  "row " + std::to_string(row) + " has a column beyond the last node",
                  "Write it again", path_.string());
    sink(row, columns, blocks);
  }
  return {};
}

expected<system_check> check_solution(system_file& system, std::span<const double> u) {
  double left = 0;
  double whole = 0;
  system_check result;
  const auto& f = system.load();
  const auto read_all = system.for_rows([&](std::size_t row, auto columns, auto blocks) {
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      double r = f[3 * row + i];
      for (std::size_t k = 0; k < columns.size(); ++k)
        for (std::size_t j = 0; j < 3; ++j)
          r -= blocks[9 * k + 3 * i + j] * u[3 * columns[k] + j];
      left += r * r;
      whole += f[3 * row + i] * f[3 * row + i];
      result.compliance += f[3 * row + i] * u[3 * row + i];
      square += u[3 * row + i] * u[3 * row + i];
    }
    result.max_displacement = std::max(result.max_displacement, std::sqrt(square));
  });
  if (!read_all)
    return fail(read_all.error());
  result.relative_residual = std::sqrt(left / whole);
  return result;
}

}  // namespace tedit::bench
