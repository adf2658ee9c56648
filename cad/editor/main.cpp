// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes an edit of the mesh on the B-rep, too, and keeps the result only where it is the same.
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <new>

#include <Standard_Failure.hxx>

#include "cad/editor/judge.hpp"
#include "cad/editor/ways.hpp"
#include "cad/teller.hpp"

namespace {

using namespace tedit;
using namespace tedit::cad;

error damaged(const std::string& what) {
  return {ec::io_error, what, "Make room on the disk of the temporary folder ($TMPDIR)", {}};
}

/// Nothing where the way leads nowhere.
TopoDS_Shape try_way(const way& one, std::string& fault) {
  try {
    return one.make();
  } catch (const Standard_Failure& why) {
    fault = std::string("OpenCASCADE gives up: ") + why.DynamicType()->Name();
    return {};
  }
}

cad_verdict replay(const std::filesystem::path& folder, part_model& part, const cad_step& step,
                   const edited_surface& mesh, const teller& tells) {
  std::vector<failed_way> failed;
  for (const auto& one : ways_of(part, step, mesh)) {
    std::string fault;
    tells.stage(0.2, "trying \"" + one.name + "\"");
    const auto made = try_way(one, fault);
    if (!made.IsNull()) {
      tells.stage(0.5, "comparing \"" + one.name + "\" with the mesh");
      auto found = judge(part, made, step, mesh);
      if (found.fault.empty()) {
        if (!save_part(found.part, folder))
          tells.refuse(damaged("the edited shape cannot be written"));
        return {true, one.name, "", found.deviation_mm};
      }
      fault = found.fault;
    }
    failed.push_back({one.name, fault});
  }
  cad_verdict verdict;
  verdict.reason =
    failed.empty() ? "the surfaces are no faces of the CAD model any more" : reason_of(failed);
  return verdict;
}

}  // namespace

int main(int argc, char** argv) {
  const auto call = parse_call(argc, argv, 4);
  if (!call)
    return 2;
  const teller tells(*call);
  confine(*call, {}, tells);
  try {
    tells.stage(0, "reading the shape");
    auto part = load_part(call->folder);
    const auto step = load_step(call->folder);
    const auto mesh = load_surface(call->folder);
    if (!part || !step || !mesh)
      tells.refuse(!part ? part.error() : !step ? step.error() : mesh.error());
    if (!save_verdict(replay(call->folder, *part, *step, *mesh, tells), call->folder))
      tells.refuse(damaged("what came of the edit cannot be written"));
  } catch (const std::bad_alloc&) {
    tells.refuse({ec::out_of_memory, "the edit needs more memory than it may take", "", {}});
  } catch (const Standard_Failure& why) {
    tells.refuse({ec::internal,
                  std::string("OpenCASCADE cannot compare the shapes: ") +
                    why.DynamicType()->Name() + " " + why.GetMessageString(),
                  "",
                  {}});
  } catch (const std::exception& why) {
    tells.refuse({ec::internal, std::string("the edit cannot be made: ") + why.what(), "", {}});
  }
  std::fflush(stdout);
  _exit(0);  // The shapes are taken apart by the system.
}
