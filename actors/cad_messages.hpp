// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <caf/actor.hpp>
#include <caf/allowed_unsafe_message_type.hpp>

#include "actors/store/document.hpp"
#include "base/execution.hpp"
#include "edit/report.hpp"
#include "mesh/version.hpp"

/// What is said about CAD files and edits on CAD models (docs/cad.md); within one process, as the
/// messages of actors/local_messages.hpp.
namespace tedit::actors {

enum class cad_status { pending, same, mesh_only, failed };

/// How a version stands on the CAD model of its part.
struct cad_state {
  cad_status status = cad_status::pending;
  std::string reason;    ///< Of `mesh_only` and `failed`, for a person.
  double deviation = 0;  ///< m, of `same`: of the mesh's new vertices from the model, at most.

  friend bool operator==(const cad_state&, const cad_state&) = default;
};

/// The CAD model of a version is wanted.
struct cad_query {
  std::uint32_t number = 0;
};

struct stored_cad {
  std::shared_ptr<const store::cad_row> row;  ///< Null where the document has none.
};

/// An edit that is to be made on the CAD model of the version before it.
struct cad_order {
  std::shared_ptr<const store::cad_row> model;
  version_ptr before;
  version_ptr after;
  edit_request wanted;
  std::shared_ptr<const edit_report> report;
};

/// What came of it: the row of the version, but for its number.
struct cad_outcome {
  std::shared_ptr<const store::cad_row> row;
};

/// Shorter edges on a surface of a CAD part.
struct part_local_size {
  std::string surface;  ///< A number or a name.
  double mm = 0;        ///< The longest edge there.
};

/// A CAD file, or a closed surface without CAD, that a client sent to become a document.
struct part_order {
  std::vector<page_ptr> file;
  std::shared_ptr<const void> held = {};  ///< Keeps the file on the account of who sent it.
  std::string file_name = {};             ///< As its owner knows it.
  std::string length_unit = {};           ///< As `scan::part_file_request::unit`.
  std::string size = "medium";            ///< How fine: "coarse", "medium", "fine".
  std::vector<part_local_size> local_sizes = {};
  std::string client_name = {};  ///< Who sent it.
  std::uint64_t ticket = 0;      ///< Of the request: `client` is told how far it is.
  caf::actor client = {};
  cancel_token stop = {};
};

/// What came of it: the bytes of a document, and what a person should know.
struct part_document {
  std::vector<page_ptr> file;
  std::vector<std::string> warnings;
};

/// The same for the hub: the name that the document is to have.
struct part_request {
  std::string name;           ///< Empty: a temporary document.
  bool or_next_free = false;  ///< Where the name is taken: NAME-2, ...
  part_order part;
};

}  // namespace tedit::actors

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::cad_query)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::stored_cad)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::cad_order)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::cad_outcome)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::part_order)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::part_document)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::part_request)
