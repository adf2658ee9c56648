// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <tl/expected.hpp>

namespace tedit {

/// Every way in which something can fail. The names travel in the protocol and in the CLI's JSON
/// (`code_name`), so they are never renamed or reused; each has one sentence.
enum class ec {
  // -- input ----------------------------------------------------------------
  usage,               ///< The command line or a request is malformed.
  invalid_argument,    ///< A value is outside what the call accepts.
  bad_input,           ///< A file's content is malformed; `where` gives line or offset.
  unsupported_format,  ///< The file is of a kind, version or element type that is not read.
  io_error,            ///< The operating system refused to read or write.
  // -- mesh -----------------------------------------------------------------
  invalid_mesh,          ///< A mesh invariant is broken; the message names the element.
  inverted_tet,          ///< A tet has negative volume.
  degenerate_tet,        ///< A tet has zero volume.
  non_manifold,          ///< The boundary is no closed, oriented 2-manifold.
  surface_not_found,     ///< A surface id is not in the version's table.
  postcondition_failed,  ///< A candidate version broke a postcondition of an edit.
  // -- operations -----------------------------------------------------------
  operation_not_found,  ///< No plugin offers this operation.
  invalid_parameter,    ///< A parameter is unknown, of the wrong type or out of its range.
  empty_selection,      ///< Nothing was selected, or nothing that the operation can act on.
  not_a_hole,           ///< The selected surfaces do not bound a hole.
  non_planar_rim,       ///< A rim of the selection does not lie in a plane.
  mixed_rim,            ///< A rim is neither convex nor concave all around.
  cap_intersects,       ///< A cap would cut the part or another cap.
  flat_plug,            ///< The space to fill has next to no volume.
  not_a_protrusion,     ///< The selected surfaces bound no boss, rib or fin.
  mesher_failed,        ///< The tetrahedral mesher gave no usable mesh.
  plugin_refused,       ///< A plugin could not be loaded; the message says why.
  // -- finite elements ------------------------------------------------------
  under_constrained,   ///< Rigid-body motion is left; the message names the free modes.
  invalid_material,    ///< A material's numbers are outside physics, or a region has none.
  invalid_load,        ///< A load acts on nothing or is not a finite number.
  not_converged,       ///< The solver did not reach the tolerance.
  device_unavailable,  ///< The requested device does not exist or cannot do the work.
  device_lost,         ///< The device failed while it worked.
  out_of_memory,       ///< The work needs more memory than there is.
  // -- running --------------------------------------------------------------
  cancelled,            ///< The caller cancelled the work.
  superseded,           ///< A newer version made the work pointless.
  timeout,              ///< The work did not end within its time limit.
  service_unavailable,  ///< A worker or server that is needed is not there.
  not_found,            ///< The named document, version or page does not exist.
  conflict,             ///< The request refers to a state that is no longer current.
  protocol_error,       ///< A message could not be understood.
  storage_error,        ///< The document's storage failed.
  internal,             ///< A defect of the program itself.
  // -- access, last: plugins were built with the numbers of those above ------
  permission_denied,  ///< The caller's role is too low; the message names the least one.
  untrusted_server,   ///< A server's certificate is not one that the client trusts.
};

/// The stable lower-case name of a code, for example "under_constrained".
[[nodiscard]] std::string_view code_name(ec code) noexcept;

/// The code with this name; `ec::internal` when there is none.
[[nodiscard]] ec code_from_name(std::string_view name) noexcept;

/// The process exit status for a code: 1 operation failed, 2 usage, 65 bad input, 69 service or
/// device unavailable, 130 cancelled.
[[nodiscard]] int exit_status(ec code) noexcept;

/// What a refused request may ask for instead: tried before it is told.
struct most_that_works {
  std::string parameter;  ///< Id of the parameter that asked for too much.
  double value = 0;       ///< In its unit (SI): the same request with this value succeeds.

  friend bool operator==(const most_that_works&, const most_that_works&) = default;
};

/// Whose change a request did not know of (`ec::conflict`): what made the version that is the head.
struct rival_change {
  std::string version_id;
  std::uint32_t number = 0;
  std::string client;     ///< Who made it, as that program named itself; empty: not known.
  std::string cause;      ///< "import", "edit", "undo", "redo", "goto"; empty: not known.
  std::string operation;  ///< Of an edit.
  std::string made_at;    ///< UTC: "2026-11-23T08:45:00Z".

  friend bool operator==(const rival_change&, const rival_change&) = default;
};

/// A failure that a person can act on.
struct error {
  ec code = ec::internal;
  std::string message;  ///< What is wrong, with the numbers.
  std::string remedy;   ///< What the person can do about it; may be empty.
  std::string where;    ///< File:line, byte offset, element or surface; may be empty.
  std::optional<most_that_works> most = {};  ///< Where it is known.
  std::optional<rival_change> rival = {};    ///< Of a conflict, where it is known.
};

/// One line for a person: message, place and remedy.
[[nodiscard]] std::string render(const error& e);

template <class T>
using expected = tl::expected<T, error>;

/// Builds the unexpected value that a function returning `expected<T>` hands back.
[[nodiscard]] inline tl::unexpected<error> fail(ec code, std::string message,
                                                std::string remedy = {}, std::string where = {}) {
  return tl::unexpected<error>(
    error{code, std::move(message), std::move(remedy), std::move(where), {}});
}

/// Hands an error on unchanged.
[[nodiscard]] inline tl::unexpected<error> fail(error e) {
  return tl::unexpected<error>(std::move(e));
}

}  // namespace tedit
