// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/error.hpp"

#include <array>

namespace tedit {

namespace {

struct code_row {
  ec code;
  std::string_view name;
};

constexpr std::array code_rows{
  code_row{ec::usage, "usage"},
  code_row{ec::invalid_argument, "invalid_argument"},
  code_row{ec::bad_input, "bad_input"},
  code_row{ec::unsupported_format, "unsupported_format"},
  code_row{ec::io_error, "io_error"},
  code_row{ec::invalid_mesh, "invalid_mesh"},
  code_row{ec::inverted_tet, "inverted_tet"},
  code_row{ec::degenerate_tet, "degenerate_tet"},
  code_row{ec::non_manifold, "non_manifold"},
  code_row{ec::surface_not_found, "surface_not_found"},
  code_row{ec::postcondition_failed, "postcondition_failed"},
  code_row{ec::operation_not_found, "operation_not_found"},
  code_row{ec::invalid_parameter, "invalid_parameter"},
  code_row{ec::empty_selection, "empty_selection"},
  code_row{ec::not_a_hole, "not_a_hole"},
  code_row{ec::non_planar_rim, "non_planar_rim"},
  code_row{ec::mixed_rim, "mixed_rim"},
  code_row{ec::cap_intersects, "cap_intersects"},
  code_row{ec::flat_plug, "flat_plug"},
  code_row{ec::not_a_protrusion, "not_a_protrusion"},
  code_row{ec::mesher_failed, "mesher_failed"},
  code_row{ec::plugin_refused, "plugin_refused"},
  code_row{ec::under_constrained, "under_constrained"},
  code_row{ec::invalid_material, "invalid_material"},
  code_row{ec::invalid_load, "invalid_load"},
  code_row{ec::not_converged, "not_converged"},
  code_row{ec::device_unavailable, "device_unavailable"},
  code_row{ec::device_lost, "device_lost"},
  code_row{ec::out_of_memory, "out_of_memory"},
  code_row{ec::cancelled, "cancelled"},
  code_row{ec::superseded, "superseded"},
  code_row{ec::timeout, "timeout"},
  code_row{ec::service_unavailable, "service_unavailable"},
  code_row{ec::not_found, "not_found"},
  code_row{ec::conflict, "conflict"},
  code_row{ec::protocol_error, "protocol_error"},
  code_row{ec::storage_error, "storage_error"},
  code_row{ec::internal, "internal"},
  code_row{ec::permission_denied, "permission_denied"},
  code_row{ec::untrusted_server, "untrusted_server"},
};

}  // namespace

std::string_view code_name(ec code) noexcept {
  for (const auto& row : code_rows)
    if (row.code == code)
      return row.name;
  return "internal";
}

ec code_from_name(std::string_view name) noexcept {
  for (const auto& row : code_rows)
    if (row.name == name)
      return row.code;
  return ec::internal;
}

int exit_status(ec code) noexcept {
  switch (code) {
    case ec::usage:
      return 2;
    case ec::bad_input:
    case ec::unsupported_format:
    case ec::io_error:
      return 65;
    case ec::service_unavailable:
    case ec::device_unavailable:
    case ec::untrusted_server:
      return 69;
    case ec::cancelled:
      return 130;
    default:
      return 1;
  }
}

std::string render(const error& e) {
  std::string text = e.message;
  if (!e.where.empty())
    text += " [" + e.where + "]";
  if (!e.remedy.empty())
    text += ". " + e.remedy;
  return text;
}

}  // namespace tedit
