// Hears every version and every result of a document, and says what became of it.
// usage: observer HOST:PORT CERTIFICATES [DOCUMENT]
// Certificates are what "tedit certs issue --role observer" made. Without a document it lists those
// that there are. Ctrl-C ends it.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "node/node.hpp"

namespace {

tedit::cancel_token stop;

int fail_with(const tedit::error& e) {
  std::fprintf(stderr, "%s\n", tedit::render(e).c_str());
  return 1;
}

void tell_version(const tedit::node::version_event& now) {
  std::printf("version %u (%s, made by %s): %zu tets, %zu load cases", now.number,
              now.cause.c_str(), now.operation.c_str(), now.mesh->tet_count(),
              now.load_cases->size());
  if (now.report)
    std::printf(", volume %+.1f mm3", now.report->volume_change * 1e9);
  std::printf("\n");
  std::fflush(stdout);
}

void tell_result(const tedit::node::result_event& now) {
  for (const auto& one : now.outcome->cases)
    std::printf("result \"%s\" on %s: %.4g MPa, %.4g mm, %zu fields\n", one.load_case.c_str(),
                one.device.c_str(), one.max_von_mises_pa * 1e-6, one.max_displacement_m * 1e3,
                now.fields.size());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string server = argc > 1 ? argv[1] : "";
  const auto colon = server.rfind(':');
  if (argc < 3 || colon == std::string::npos) {
    std::fprintf(stderr, "usage: observer HOST:PORT CERTIFICATES [DOCUMENT]\n");
    return 2;
  }
  const tedit::node::place where{
    server.substr(0, colon), static_cast<std::uint16_t>(std::atoi(&server[colon + 1])), argv[2]};
  if (argc == 3) {
    const auto names = tedit::node::documents(where);
    if (!names)
      return fail_with(names.error());
    for (const auto& name : *names)
      std::printf("%s\n", name.c_str());
    return 0;
  }
  for (const int signal : {SIGINT, SIGTERM})
    std::signal(signal, [](int) { stop.cancel(); });
  tedit::node::observer told;
  told.on_version = tell_version;
  told.on_result = tell_result;
  told.on_end = [](const std::string& document, const std::string& why) {
    std::printf("end of %s: %s\n", document.c_str(), why.c_str());
    stop.cancel();
  };
  const auto done = tedit::node::observe(where, {argv[3]}, told, stop);
  return done ? 0 : fail_with(done.error());
}
