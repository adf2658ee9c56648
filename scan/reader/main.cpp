// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads a surface file and makes it one that bounds solids. Whoever starts it expects that it may
// end in any way: a file costs its import and nothing else.
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string_view>

#include "cad/teller.hpp"
#include "mesh/io/file.hpp"
#include "scan/reader/part_of_file.hpp"

namespace {

using namespace tedit;
using namespace tedit::scan;

void read(const cad::program_call& call, const std::filesystem::path& file, std::string_view kind,
          const std::string& unit, const cad::teller& tells) {
  tells.stage(0.02, "reading the file");
  const auto bytes = read_file(file);
  if (!bytes)
    tells.refuse(bytes.error());
  auto surface = read_surface(kind, *bytes);
  if (!surface)
    tells.refuse(surface.error());
  const auto made = make_part(std::move(*surface), unit, [&](double fraction, const char* what) {
    tells.stage(fraction, what);
  });
  if (!made)
    tells.refuse(made.error());
  if (!cad::save_facts(made->facts, call.folder) || !save_surface(made->part, call.folder))
    tells.refuse({ec::io_error,
                  "the surface cannot be written",
                  "Make room on the disk of the temporary folder ($TMPDIR)",
                  {}});
}

}  // namespace

int main(int argc, char** argv) {
  const auto call = cad::parse_call(argc, argv, 7);
  if (!call)
    return 2;
  const cad::teller tells(*call);
  const std::filesystem::path file = argv[4];
  cad::confine(*call, file, tells);
  try {
    read(*call, file, argv[5], argv[6], tells);
  } catch (const std::bad_alloc&) {
    tells.refuse({ec::out_of_memory,
                  "the reader needs more memory than it may take",
                  "Give it more memory, or simplify the surface",
                  {}});
  } catch (const std::exception& why) {
    tells.refuse({ec::bad_input,
                  std::string("the surface cannot be mended: ") + why.what(),
                  "Repair it in the program that the file comes from",
                  {}});
  }
  std::fflush(stdout);
  _exit(0);
}
