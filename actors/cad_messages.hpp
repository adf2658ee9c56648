// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <caf/allowed_unsafe_message_type.hpp>

#include "actors/store/document.hpp"
#include "edit/report.hpp"
#include "mesh/version.hpp"

/// What is said about edits on CAD models (docs/cad.md); within one process, as the messages of
/// actors/local_messages.hpp.
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

}  // namespace tedit::actors

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::cad_query)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::stored_cad)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::cad_order)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::cad_outcome)
