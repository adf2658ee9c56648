// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads a CAD file and writes its solids as a BREP beside what is known of them. What others wrote
// may end this program in any way: whoever starts it expects that.
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <new>

#include <BRepTools.hxx>
#include <Standard_Failure.hxx>

#include "cad/annotations.hpp"
#include "cad/geometry_file.hpp"
#include "cad/reader/content.hpp"
#include "cad/reader/text_faults.hpp"
#include "cad/reading.hpp"

namespace {

using namespace tedit;
using namespace tedit::cad;

struct wanted {
  program_call call;
  std::filesystem::path file;
  std::string kind;  ///< "step", "iges", "brep".
  std::string how;   ///< cad/reading.hpp.
};

cad_content read(const wanted& what, const teller& tells) {
  if (const auto finite = check_finite(what.kind, what.file.string()); !finite)
    tells.refuse(finite.error());
  if (what.kind == "iges")
    return read_iges(what.file.string(), tells);
  if (what.kind == "brep")
    return read_brep(what.file.string(), tells);
  if (what.how == reads_all)
    return read_step(what.file.string(), tells);
  tells.stage(0.02, "leaving out annotations");
  const auto plain = what.call.folder / plain_file;
  const auto gone = write_without_annotations(what.file, plain);
  if (!gone)
    tells.refuse(gone.error());
  auto content = read_step(plain.string(), tells);
  if (*gone > 0)
    content.notices.push_back("annotations (tolerances, datums, notes) were left out, " +
                              std::to_string(*gone) +
                              " in all: the file could not be read with them");
  return content;
}

/// A file that could not be read is asked for a fault of its text, without OpenCASCADE.
void explain(const wanted& what, const teller& tells) {
  if (const auto fault = fault_of_text(what.kind, what.file.string()))
    tells.refuse(*fault);
}

void convert(const wanted& what, const teller& tells) {
  auto content = read(what, tells);
  sew_loose_faces(content, tells);
  close_up_edges(content, tells);
  const auto part = join_solids(content, tells);
  tells.stage(0.9, "writing the shape");
  const auto shape = (what.call.folder / shape_file).string();
  if (!BRepTools::Write(part.shape, shape.c_str()) || !save_facts(part.facts, what.call.folder) ||
      !save_geometries(part.geometries, what.call.folder))
    tells.refuse({ec::io_error,
                  "the shape that was read cannot be written",
                  "Make room on the disk of the temporary folder ($TMPDIR)",
                  {}});
}

}  // namespace

int main(int argc, char** argv) {
  const auto call = parse_call(argc, argv, 7);
  if (!call)
    return 2;
  const wanted what{*call, argv[4], argv[5], argv[6]};
  const teller tells(*call);
  confine(*call, what.file, tells);
  try {
    what.how == reads_text ? explain(what, tells) : convert(what, tells);
  } catch (const std::bad_alloc&) {
    tells.refuse({ec::out_of_memory,
                  "the reader needs more memory than it may take",
                  "Give it more memory, or take a simpler part",
                  {}});
  } catch (const Standard_Failure& why) {
    tells.refuse({ec::bad_input,
                  std::string("OpenCASCADE cannot read the file: ") + why.DynamicType()->Name() +
                    " " + why.GetMessageString(),
                  "Export the part again from the CAD program",
                  {}});
  } catch (const std::exception& why) {
    tells.refuse({ec::bad_input,
                  std::string("the file cannot be read: ") + why.what(),
                  "Export the part again from the CAD program",
                  {}});
  }
  std::fflush(stdout);
  _exit(0);  // What was read is taken apart by the system.
}
