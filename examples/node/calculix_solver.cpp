// CalculiX as a solver of a TEdit server: clients choose it by the device "calculix".
// usage: calculix_solver HOST:PORT CERTIFICATES
// Certificates are what "tedit certs issue --role solver" made; ccx must be in the path. It joins
// again when the server goes; Ctrl-C ends it.
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "fem/calculix_deck.hpp"
#include "node/node.hpp"

namespace {

namespace fs = std::filesystem;
using tedit::ec;
using tedit::expected;
using tedit::fail;

tedit::cancel_token stop;

/// The table of displacements in CalculiX's .dat file: node, u, v, w.
expected<std::vector<double>> read_displacements(const fs::path& file, std::size_t nodes) {
  std::vector<double> result(3 * nodes);
  std::size_t seen = 0;
  bool inside = false;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.find("time") != std::string::npos) {
      inside = line.find("displacements") != std::string::npos;
      continue;
    }
    std::istringstream row(line);
    std::size_t node = 0;
    double u = 0, v = 0, w = 0;
    if (!inside || !(row >> node >> u >> v >> w) || node < 1 || node > nodes)
      continue;
    result[3 * node - 3] = u;
    result[3 * node - 2] = v;
    result[3 * node - 1] = w;
    ++seen;
  }
  if (seen < nodes)
    return fail(ec::bad_input,
                "CalculiX gave displacements of " + std::to_string(seen) + " of " +
                  std::to_string(nodes) + " nodes",
                "Look at what it says: run ccx on a deck of tedit export");
  return result;
}

expected<std::vector<double>> solve(const tedit::fem::problem& problem, const tedit::execution&) {
  auto folder = (fs::temp_directory_path() / "calculix_XXXXXX").string();
  if (!mkdtemp(folder.data()))
    return fail(ec::io_error, "no folder for CalculiX can be made in " + folder,
                "Set TMPDIR to another folder");
  std::ofstream deck(folder + "/deck.inp");
  tedit::fem::write_calculix_deck(problem, {.title = "TEdit", .fields = false}, deck);
  deck.close();
  const auto command = "cd '" + folder + "' && timeout 600 ccx -i deck > log 2>&1";
  const int status = deck ? std::system(command.c_str()) : -1;
  auto result = status == 0 ? read_displacements(folder + "/deck.dat", problem.node_count())
                            : fail(ec::service_unavailable, "CalculiX failed",
                                   "See whether ccx runs on the machine of this solver");
  fs::remove_all(folder);
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string server = argc > 1 ? argv[1] : "";
  const auto colon = server.rfind(':');
  if (argc < 3 || colon == std::string::npos) {
    std::fprintf(stderr, "usage: calculix_solver HOST:PORT CERTIFICATES\n");
    return 2;
  }
  const tedit::node::place where{
    server.substr(0, colon), static_cast<std::uint16_t>(std::atoi(&server[colon + 1])), argv[2]};
  for (const int signal : {SIGINT, SIGTERM})
    std::signal(signal, [](int) { stop.cancel(); });
  while (!stop.cancelled()) {
    const auto done = tedit::node::serve_solver(where, {"calculix", solve}, stop);
    if (done)
      break;
    std::fprintf(stderr, "%s\n", tedit::render(done.error()).c_str());
    if (done.error().code != ec::service_unavailable && done.error().code != ec::timeout)
      return 1;  // A person must mend it first.
    std::this_thread::sleep_for(std::chrono::seconds(2));
  }
  return 0;
}
