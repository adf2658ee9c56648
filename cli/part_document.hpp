// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents as the commands of files read and write them, without a server: a part with its CAD
// model.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/execution.hpp"
#include "cad/replay.hpp"
#include "edit/make_edit.hpp"
#include "fem/load_case.hpp"
#include "mesh/version.hpp"

namespace tedit::cli {

/// By its suffix.
[[nodiscard]] bool is_document(const std::filesystem::path& file);

/// What a version of a part that came from CAD has of its model.
struct cad_state {
  std::optional<cad::cad_model> model;  ///< None where an edit was made in the mesh only.
  std::string reason;                   ///< Why, with the version.
  double deviation_m = 0;
};

/// A version of a document.
struct document_part {
  std::uint32_t number = 0;
  version_ptr mesh;
  std::vector<fem::load_case> load_cases;
  std::optional<cad_state> cad;  ///< None for a part that did not come from CAD.
};

/// The current version of a document, or another one, without its CAD model. Errors: those of
/// `store::document_view`. Cost: O(its mesh).
[[nodiscard]] expected<document_part> read_version_of(const std::filesystem::path& file,
                                                      std::optional<std::uint32_t> number);

/// The same with its CAD model. An edit that a server made is made on the CAD
/// model now. Errors: those of `store::document_view` and `replay_edit`; `not_found`.
[[nodiscard]] expected<document_part> read_part(const std::filesystem::path& file,
                                                std::optional<std::uint32_t> number,
                                                const execution& run);

/// An edit that was made.
struct next_version {
  edit_request wanted;
  const checked_edit* made = nullptr;
  std::optional<cad_state> cad;
};

/// Copies a document, with all its versions, to a file that is not there, and adds the edit of its
/// current version to it. Errors: as above; nothing is left of a copy without the edit.
[[nodiscard]] expected<void> copy_with_edit(const std::filesystem::path& from,
                                            const std::filesystem::path& to,
                                            const next_version& next);

}  // namespace tedit::cli
