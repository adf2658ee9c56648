// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "base/error.hpp"

/// The two forms in which values leave a process: bytes of their messages between processes of one
/// release, canonical JSON in documents and files. Each is said once, for these types (forms.cpp):
/// `edit_request` (message ApplyEdit), `edit_report` (EditReport), `solve_outcome` (Solved),
/// `std::vector<fem::load_case>` (LoadCasesChanged), `selection_query` (SelectSurfaces),
/// `std::vector<found_feature>` (SurfacesSelected) and `operation_catalogue` (Catalogue).
namespace tedit::protocol {

template <class T>
[[nodiscard]] std::string to_bytes(const T& value);

/// Errors: `protocol_error`, and those of the value's own checks.
template <class T>
[[nodiscard]] expected<T> from_bytes(std::string_view bytes);

template <class T>
[[nodiscard]] std::string to_json(const T& value);

/// Errors: `protocol_error`, also for fields that this release does not know.
template <class T>
[[nodiscard]] expected<T> from_json(std::string_view json);

}  // namespace tedit::protocol
