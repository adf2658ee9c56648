// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client/comparison.hpp"
#include "client/preview.hpp"
#include "client/print_check.hpp"
#include "client/streams.hpp"
#include "client/surface.hpp"
#include "client/types.hpp"
#include "tedit/v1/envelope.pb.h"

/// From the protocol's messages to the client's plain data. Internal to the client: the header
/// brings protobuf in.
namespace tedit::client {

[[nodiscard]] error from_message(const v1::Error& message);
[[nodiscard]] version_info from_message(const v1::VersionInfo& message);
[[nodiscard]] participant from_message(const v1::Participant& message);
[[nodiscard]] committed from_message(const v1::Committed& message);
[[nodiscard]] solve_status from_message(const v1::SolveStatus& message);
[[nodiscard]] document_state from_message(const v1::DocumentState& message);
[[nodiscard]] history from_message(const v1::History& message);
[[nodiscard]] server_status from_message(const v1::ServerStatus& message);
[[nodiscard]] document_info from_message(const v1::DocumentInfo& message);
[[nodiscard]] offered_format from_message(const v1::FileFormat& message);
[[nodiscard]] stream_header from_message(const v1::Stream& message);

[[nodiscard]] load_cases_event from_message(const v1::LoadCasesChanged& message);

/// The section with the arrays of its complete stream. Errors: `protocol_error`, also when sizes or
/// point numbers do not fit.
[[nodiscard]] expected<section> read_section(const v1::SectionReady& message,
                                             const incoming_stream& stream);

/// The update with the arrays of its complete stream. Errors: `protocol_error`.
[[nodiscard]] expected<surface_update> read_surface(const v1::SurfaceUpdate& message,
                                                    const incoming_stream& stream);

/// The preview with the arrays of its complete stream. Errors: `protocol_error`.
[[nodiscard]] expected<edit_preview> read_preview(const v1::EditPreview& message,
                                                  const incoming_stream& stream);

/// The comparison with the arrays of its complete stream. Errors: `protocol_error`, also when sizes
/// do not fit or a mark is none.
[[nodiscard]] expected<comparison> read_comparison(const v1::VersionsCompared& message,
                                                   const incoming_stream& stream);

/// The check with the marks of its complete stream. Errors: `protocol_error`, also when sizes do
/// not fit or a mark is none.
[[nodiscard]] expected<print_check> read_print_check(const v1::PrintChecked& message,
                                                     const incoming_stream& stream);

/// The same for fields. Errors: `protocol_error`, also when the sizes do not match.
[[nodiscard]] expected<field_event> read_field(const v1::FieldUpdate& message,
                                               const incoming_stream& stream);

}  // namespace tedit::client
