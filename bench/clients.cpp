// SPDX-License-Identifier: AGPL-3.0-or-later
// What a client's line costs without TLS and with it, on this machine: a short request, an edit
// until it is acknowledged, a large file. Both servers, and others that run already, take turns.
// usage: bench_clients MESH [ROUNDS [NAME URL TOKEN_FILE]...]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "actors/node/server.hpp"
#include "base/logging/logging.hpp"
#include "certs/authority.hpp"
#include "client/client.hpp"
#include "tests/support/scratch.hpp"

namespace tedit {
namespace {

using clock_type = std::chrono::steady_clock;
using test::value;

constexpr int small_requests = 200;

template <class Work>
double seconds_of(Work work) {
  const auto start = clock_type::now();
  work();
  return std::chrono::duration<double>(clock_type::now() - start).count();
}

double at(std::vector<double> values, double part) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

/// A client of a server, with a document of two versions open.
class line {
public:
  /// Of a server of its own.
  line(const std::string& mesh, bool secure) {
    server_options options;
    options.documents = folder_.path() / "documents";
    options.token = std::string(64, 'a');
    options.worker_processes = false;
    client::connect_options how;
    if (secure) {
      value(certs::init(folder_.path() / "ca"));
      value(certs::issue(folder_.path() / "ca", {certs::role::server, "hall", {"127.0.0.1"}},
                         folder_.path() / "hall"));
      options.certificates = folder_.path() / "hall";
      how.trust.authority = folder_.path() / "hall" / certs::authority_certificate_file;
    }
    server_ = value(server::start(options));
    how.url = server_->url();
    how.token = options.token;
    open(how, mesh);
  }

  /// Of one that runs.
  line(const std::string& mesh, const std::string& url, const std::string& token_file) {
    client::connect_options how;
    how.url = url;
    std::ifstream(token_file) >> how.token;
    open(how, mesh);
  }

  void open(client::connect_options how, const std::string& mesh) {
    how.client_name = "bench";
    connect_s_ = seconds_of([&] { user_ = value(client::client::connect(how, {})); });
    value(user_->open("part", false, false));
    value(user_->import_file(mesh, "mm", {}));
    value(user_->import_file(mesh, "mm", {}));
  }

  [[nodiscard]] double connect_s() const { return connect_s_; }

  double request() const {
    return seconds_of([&] { value(user_->get_history()); });
  }

  /// An undo or redo: the shortest change that is made durable.
  double change() {
    return seconds_of([&] { value((undone_ = !undone_) ? user_->undo() : user_->redo()); });
  }

  /// The document as a file; MB/s.
  double file_rate() const {
    std::size_t bytes = 0;
    const auto s = seconds_of(
      [&] { bytes = value(user_->export_file(std::string(document_format), {}, {}, {})).size(); });
    return 1e-6 * static_cast<double>(bytes) / s;
  }

private:
  test::scratch_folder folder_;
  std::unique_ptr<server> server_;
  std::unique_ptr<client::client> user_;
  double connect_s_ = 0;
  bool undone_ = false;
};

struct figures {
  std::vector<double> request, change, rate;
};

void run(const std::string& mesh, int rounds, const std::vector<std::string>& others) {
  logging::set_level("warn");
  std::map<std::string, std::unique_ptr<line>> lines;
  lines["ws"] = std::make_unique<line>(mesh, false);
  lines["wss"] = std::make_unique<line>(mesh, true);
  for (std::size_t i = 0; i + 2 < others.size(); i += 3)
    lines[others[i]] = std::make_unique<line>(mesh, others[i + 1], others[i + 2]);
  std::map<std::string, figures> all;
  for (int round = 0; round < rounds; ++round)
    for (auto& [name, one] : lines) {
      auto& to = all[name];
      for (int i = 0; i < small_requests; ++i)
        to.request.push_back(one->request());
      for (int i = 0; i < 20; ++i)
        to.change.push_back(one->change());
      to.rate.push_back(one->file_rate());
    }
  for (const auto& [name, f] : all)
    std::printf(
      "%-4s connect %.2f ms; request p50 %.0f us, p99 %.0f us; change p50 %.2f ms, p99 "
      "%.2f ms; file %.0f MB/s (%.0f to %.0f)\n",
      name.c_str(), 1e3 * lines[name]->connect_s(), 1e6 * at(f.request, .5),
      1e6 * at(f.request, .99), 1e3 * at(f.change, .5), 1e3 * at(f.change, .99), at(f.rate, .5),
      at(f.rate, 0), at(f.rate, 1));
}

}  // namespace
}  // namespace tedit

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: bench_clients MESH [ROUNDS [NAME URL TOKEN_FILE]...]\n");
    return 2;
  }
  try {
    tedit::run(argv[1], argc > 2 ? std::atoi(argv[2]) : 10,
               {argv + std::min(argc, 3), argv + argc});
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
