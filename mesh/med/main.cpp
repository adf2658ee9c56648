// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads the MED file that comes on stdin and writes what it holds to stdout, or the other way
// (mesh/io/med_content.hpp). HDF5 may crash or hang on what strangers wrote; whoever starts this
// program expects that. It has no file but those two.
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <new>

#include "mesh/med/med_file.hpp"
#include "mesh/med/med_jobs.hpp"
#include "sandbox/sandbox.hpp"

namespace {

using namespace tedit;

/// HDF5 is told first what it would look for in files.
bool confine() {
  H5open();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);  // Filters come with HDF5, or not at all.
  return !sandbox::is_wanted() ||
         (sandbox::confine_files({}) && sandbox::confine_calls(sandbox::calls::of_filters));
}

std::vector<char> read_stdin() {
  std::vector<char> bytes;
  std::vector<char> piece(std::size_t{1} << 20);
  while (const auto got = std::fread(piece.data(), 1, piece.size(), stdin))
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(got));
  return bytes;
}

void end_after(std::chrono::seconds time) {
  const itimerval left{{}, {time.count(), 0}};
  setitimer(ITIMER_PROF, &left, nullptr);
}

std::vector<char> answer_to(std::span<const char> question) {
  if (is_hdf5(question))
    return to_bytes(med::read_med(question));
  const auto content = content_from(question);
  if (!content)
    throw med::refusal{content.error()};
  return med::write_med(*content);
}

std::vector<char> answer() {
  try {
    const auto question = read_stdin();
    end_after(med_time(question.size()));
    return answer_to(question);
  } catch (const med::refusal& refused) {
    return to_answer(refused.reason);
  } catch (const std::bad_alloc&) {
    return to_answer({ec::out_of_memory,
                      "tedit-med needs more memory than it may take",
                      "Write the mesh as .msh or .unv, without fields",
                      {}});
  }
}

}  // namespace

int main() {
  if (!confine())
    return 5;
  const auto bytes = answer();
  std::size_t done = 0;
  while (done < bytes.size()) {
    const auto sent = write(STDOUT_FILENO, bytes.data() + done, bytes.size() - done);
    if (sent < 0 && errno == EINTR)
      continue;
    if (sent <= 0)
      _exit(4);  // Nobody listens any more.
    done += static_cast<std::size_t>(sent);
  }
  _exit(0);  // Destructors of a library in an unknown state may do anything.
}
