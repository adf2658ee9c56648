// SPDX-License-Identifier: AGPL-3.0-or-later
#include <unistd.h>

#include "base/child_process.hpp"
#include "mesh/formats.hpp"
#include "mesh/io/med_content.hpp"

namespace tedit {

namespace {

constexpr auto as_unv = "Write the mesh as .unv, .msh or .inp there; nothing else is lost";

/// It watches its own processor time (mesh/med/main.cpp); by the clock it has four times that, as
/// others may have the processors meanwhile.
child_limits limits_of_med(std::size_t bytes) {
  child_limits limits;
  limits.time = 4 * med_time(bytes);
  limits.output_bytes = (std::size_t{1} << 20) + most_unpacked * bytes;
  return limits;
}

/// What ended a program that said nothing of why. `reads`: else it writes.
error about_end(error why, bool reads) {
  if (why.code == ec::timeout)
    return {ec::timeout,
            std::string("tedit-med found no end while it was ") +
              (reads ? "reading the file" : "writing the file"),
            reads ? "The file may be damaged: write or copy it again" : "Try again",
            {}};
  if (why.code != ec::mesher_failed)
    return why;
  return {
    reads ? ec::bad_input : ec::internal,
    why.message + (reads ? " while it was reading the file" : " while it was writing the file"),
    reads ? std::string("The file may be damaged, or made to do harm. ") + as_unv : "Try again",
    {}};
}

}  // namespace

std::chrono::seconds med_time(std::size_t bytes) {
  return std::chrono::seconds(10 + bytes / (std::size_t{10} << 20));
}

expected<std::vector<char>> ask_med(std::span<const char> question) {
  const auto program = helper_program(formats::med::program).string();
  if (access(program.c_str(), X_OK) != 0)
    return fail(ec::service_unavailable,
                "this installation reads and writes no MED files: there is no " + program,
                "Build TEdit where the package libmedc-dev is installed "
                "(scripts/install_deps.sh), or set TEDIT_LIBEXEC to the program's folder");
  auto answer = run_child({program}, question, limits_of_med(question.size()), {});
  if (!answer)
    return fail(about_end(std::move(answer.error()), is_hdf5(question)));
  if (auto refused = refusal_in(*answer))
    return fail(std::move(*refused));
  return answer;
}

}  // namespace tedit
