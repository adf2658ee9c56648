// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/teller.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <cstring>

#include "base/process.hpp"
#include "cad/exchange.hpp"
#include "sandbox/sandbox.hpp"

namespace tedit::cad {

namespace {

/// A line has tabs between its fields.
std::string in_one_field(std::string text) {
  for (auto& c : text)
    if (c == '\t' || c == '\n' || c == '\r')
      c = ' ';
  return text;
}

template <class Number>
bool parse(const char* text, Number& number) {
  const auto* end = text + std::strlen(text);
  return std::from_chars(text, end, number).ptr == end;
}

}  // namespace

teller::teller(const program_call& call) : line_(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3)) {
  const auto log = (call.folder / log_file).string();
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  const int to = file >= 0 ? file : open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(to, STDOUT_FILENO);
  dup2(to, STDERR_FILENO);
  setvbuf(stdout, nullptr, _IOLBF, 4096);  // Its last words are wanted when it dies.
}

void teller::close_others() const {
  close_files_except({line_});
}

void teller::send(const std::string& line) const {
  std::size_t done = 0;
  while (done < line.size()) {
    const auto sent = write(line_, line.data() + done, line.size() - done);
    if (sent <= 0)
      _exit(4);  // Nobody listens any more.
    done += static_cast<std::size_t>(sent);
  }
}

void teller::stage(double fraction, std::string_view what) const {
  send("S\t" + std::to_string(fraction) + "\t" + in_one_field(std::string(what)) + "\n");
}

void teller::refuse(const error& why) const {
  send("E\t" + std::string(code_name(why.code)) + "\t" + in_one_field(why.message) + "\t" +
       in_one_field(why.remedy) + "\t" + in_one_field(why.where) + "\n");
  std::fflush(stdout);
  _exit(1);  // Destructors of a library in an unknown state may do anything.
}

void confine(const program_call& call, const std::filesystem::path& file, const teller& tells) {
  const rlimit time{call.cpu_seconds, call.cpu_seconds + 2};
  setrlimit(RLIMIT_CPU, &time);
  tells.close_others();
  if (!sandbox::is_wanted())
    return;
  sandbox::reach reach;
  reach.readable = sandbox::system_files();
  if (!file.empty())
    reach.readable.push_back(file);
  reach.own_folder = call.folder;
  reach.file_bytes = call.file_bytes;
  if (auto ok = sandbox::confine_files(reach); !ok)
    tells.refuse(ok.error());
  if (auto ok = sandbox::confine_calls(); !ok)
    tells.refuse(ok.error());
}

expected<program_call> parse_call(int argc, char** argv, int least) {
  program_call call;
  if (argc < least || argc < 4 || !parse(argv[2], call.cpu_seconds) ||
      !parse(argv[3], call.file_bytes))
    return fail(ec::usage, "this program is started by \"tedit import\"");
  call.folder = argv[1];
  return call;
}

}  // namespace tedit::cad
