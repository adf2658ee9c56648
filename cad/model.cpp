// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/model.hpp"

#include <fstream>
#include <ostream>

#include "cad/private_folder.hpp"
#include "mesh/io/file.hpp"

namespace tedit::cad {

expected<cad_model> load_model(const std::filesystem::path& folder) {
  auto facts = load_facts(folder);
  const auto bytes = read_file(folder / shape_file);
  if (!facts || !bytes)
    return fail(facts ? bytes.error() : facts.error());
  return cad_model{std::make_shared<const std::string>(bytes->begin(), bytes->end()),
                   std::move(*facts)};
}

expected<void> save_model(const cad_model& model, const std::filesystem::path& folder) {
  std::ofstream shape(folder / shape_file, std::ios::binary);
  shape << *model.shape;
  if (shape.flush() && save_facts(model.facts, folder))
    return {};
  return fail(ec::io_error, "the CAD model cannot be written",
              "Make room on the disk of the temporary folder ($TMPDIR)");
}

expected<void> write_step(const cad_model& model, const std::filesystem::path& file,
                          const program_limits& limits, const execution& run) {
  if (auto there = find_program("tedit-cad-writer"); !there)
    return fail(there.error());
  const private_folder folder("tedit-cad-write-");
  if (folder.path().empty())
    return fail(no_private_folder());
  if (auto ok = save_model(model, folder.path()); !ok)
    return fail(ok.error());
  const auto end = run_program("tedit-cad-writer", "the writer", folder.path(), {}, limits, run);
  if (!end.done)
    return fail(end.why);
  const auto bytes = read_file(folder.path() / step_output);
  if (!bytes)
    return fail(bytes.error());
  return write_file(file, [&](std::ostream& out) {
    out.write(bytes->data(), static_cast<std::streamsize>(bytes->size()));
  });
}

}  // namespace tedit::cad
