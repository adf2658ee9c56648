// SPDX-License-Identifier: AGPL-3.0-or-later
#include "verification/calculix.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "base/child_process.hpp"
#include "base/stopwatch.hpp"
#include "fem/calculix_deck.hpp"

namespace tedit::verification {

namespace {

namespace fs = std::filesystem;

/// A new folder, removed with all that is in it.
class scratch_folder {
public:
  scratch_folder() {
    std::error_code code;
    auto name = (fs::temp_directory_path(code) / "tedit_ccx_XXXXXX").string();
    if (!code && mkdtemp(name.data()) != nullptr)
      path_ = name;
  }
  scratch_folder(const scratch_folder&) = delete;
  scratch_folder& operator=(const scratch_folder&) = delete;
  ~scratch_folder() {
    std::error_code ignored;
    if (!path_.empty())
      fs::remove_all(path_, ignored);
  }

  /// Empty when it could not be made.
  [[nodiscard]] const fs::path& path() const { return path_; }

private:
  fs::path path_;
};

/// The largest shipped part needs about 3 GB; nothing here may take the machine down.
constexpr std::size_t most_memory = std::size_t{16} << 30;
constexpr child_limits limits{std::chrono::minutes(5), most_memory};
constexpr child_limits long_limits{std::chrono::minutes(60), most_memory};

/// The force that a support of the node exerts: only along its held directions, (1 - S) r.
void keep_held_directions(const std::array<double, 6>& s, double* r) {
  const std::array<double, 3> all{r[0], r[1], r[2]};
  r[0] -= s[0] * all[0] + s[1] * all[1] + s[2] * all[2];
  r[1] -= s[1] * all[0] + s[3] * all[1] + s[4] * all[2];
  r[2] -= s[2] * all[0] + s[4] * all[1] + s[5] * all[2];
}

/// "CalculiX 2.20" from the banner "CalculiX Version 2.20, Copyright ...".
std::string version_in(std::string_view banner) {
  constexpr std::string_view before = "CalculiX Version ";
  const auto at = banner.find(before);
  if (at == std::string_view::npos)
    return "CalculiX";
  const auto rest = banner.substr(at + before.size());
  return "CalculiX " + std::string(rest.substr(0, rest.find_first_of(", \n")));
}

}  // namespace

fs::path find_calculix() {
  const char* list = std::getenv("PATH");
  std::istringstream folders(list == nullptr ? "" : list);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (auto program = fs::path(folder) / "ccx"; access(program.c_str(), X_OK) == 0)
      return program;
  return {};
}

expected<calculix_table> read_calculix_table(std::istream& dat, std::size_t node_count) {
  calculix_table table{std::vector<double>(3 * node_count), std::vector<double>(3 * node_count)};
  std::vector<double>* target = nullptr;
  std::vector<bool> seen(node_count);
  for (std::string line; std::getline(dat, line);) {
    if (line.find_first_of("fs") != std::string::npos) {  // A heading: "... for set NAME and time"
      target = line.starts_with(" displacements") ? &table.displacement
               : line.starts_with(" forces")      ? &table.forces
                                                  : nullptr;
      continue;
    }
    std::istringstream row(line);
    std::size_t node = 0;
    std::array<double, 3> v{};
    if (target == nullptr || !(row >> node >> v[0] >> v[1] >> v[2]) || node < 1 ||
        node > node_count)
      continue;
    std::ranges::copy(v, target->begin() + static_cast<std::ptrdiff_t>(3 * (node - 1)));
    if (target == &table.displacement)
      seen[node - 1] = true;
  }
  if (const auto missing = std::ranges::find(seen, false); missing != seen.end())
    return fail(ec::bad_input, "the results of CalculiX lack the displacement of node " +
                                 std::to_string(missing - seen.begin() + 1));
  return table;
}

namespace {

/// Runs it on FOLDER/NAME.inp and reads NAME.dat.
expected<calculix_solution> run_in(const fs::path& program, const fs::path& folder,
                                   const std::string& name, const fem::problem& p,
                                   const child_limits& most, const execution& run) {
  const stopwatch clock;
  // CalculiX also writes into the folder that it is started in.
  const auto said = run_child({"/usr/bin/env", "--chdir=" + folder.string(), "OMP_NUM_THREADS=1",
                               program.string(), "-i", name},
                              {}, most, run);
  if (!said)
    return fail(
      said.error().code == ec::mesher_failed ? ec::service_unavailable : said.error().code,
      "CalculiX failed: " + said.error().message,
      "See what it says: write the deck with tedit export and run ccx on it");
  std::ifstream dat(folder / (name + ".dat"));
  auto table = read_calculix_table(dat, p.node_count());
  if (!table)
    return fail(table.error());
  calculix_solution result{std::move(table->displacement),
                           std::move(table->forces),
                           {},
                           version_in({said->data(), said->size()}),
                           0};
  for (std::size_t i = 0; i < p.dofs(); ++i)
    result.reactions[i] -= p.loads[i];
  for (std::size_t n = 0; n < p.node_count(); ++n)
    keep_held_directions(p.filter[n], &result.reactions[3 * n]);
  result.milliseconds = clock.milliseconds();
  return result;
}

}  // namespace

expected<calculix_solution> run_calculix(const fs::path& program, const fs::path& folder,
                                         const std::string& name, const fem::problem& p,
                                         const execution& run) {
  std::error_code code;
  auto result = run_in(program, fs::absolute(folder, code), name, p, long_limits, run);
  if (!result)
    return result;
  if (std::ifstream frd(folder / (name + ".frd")); frd) {
    auto stress = read_calculix_stress(frd, p.node_count());
    if (!stress)
      return fail(stress.error());
    result->stress = *std::move(stress);
  }
  return result;
}

expected<calculix_solution> solve_with_calculix(const fs::path& program, const fem::problem& p,
                                                const execution& run) {
  const stopwatch clock;
  const scratch_folder folder;
  std::ofstream deck(folder.path() / "deck.inp");
  fem::write_calculix_deck(p, {.title = "side by side", .fields = false}, deck);
  deck.close();
  if (folder.path().empty() || !deck)
    return fail(ec::io_error, "the deck for CalculiX cannot be written to a temporary folder",
                "Make space there, or set TMPDIR to another folder");
  auto result = run_in(program, folder.path(), "deck", p, limits, run);
  if (result)
    result->milliseconds = clock.milliseconds();
  return result;
}

}  // namespace tedit::verification
