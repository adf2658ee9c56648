// SPDX-License-Identifier: AGPL-3.0-or-later
// A plugin whose code leaves a trace in $HOME wherever it can: from its start-up code, from
// describe() and from apply(). With $TEDIT_EARLY it also opens a network connection from there:
// "start" or "describe".
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "ops/sdk/operation.hpp"

namespace {

using namespace tedit;

/// A file and a socket by name.
void leave_traces(const std::string& stage) {
  const char* home = std::getenv("HOME");
  const auto name = std::string(home ? home : "") + "/early-" + stage;
  std::ofstream(name) << getpid();
  sockaddr_un place{};
  place.sun_family = AF_UNIX;
  (name + ".socket").copy(place.sun_path, sizeof(place.sun_path) - 1);
  if (const int line = socket(AF_UNIX, SOCK_STREAM, 0); line >= 0)
    (void)bind(line, reinterpret_cast<const sockaddr*>(&place), sizeof(place));
  const char* chosen = std::getenv("TEDIT_EARLY");
  if (chosen && stage == chosen)
    (void)socket(AF_INET, SOCK_STREAM, 0);
}

struct at_start {
  at_start() { leave_traces("start"); }
} const started;

class early final : public ops::operation {
public:
  ops::operation_description describe() const override {
    leave_traces("describe");
    ops::operation_description d;
    d.id = "early";
    d.name = "Early";
    d.summary = "Leaves traces.";
    d.version = "1.0.0";
    d.selection.help = "Any surface.";
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr&, const ops::selection&,
                                   const ops::parameters&, ops::context&) const override {
    leave_traces("apply");
    return fail(ec::conflict, "it was called", "None");
  }
};

}  // namespace

TEDIT_PLUGIN("early", "1.0.0", early)
