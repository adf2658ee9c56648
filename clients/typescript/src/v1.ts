// SPDX-License-Identifier: AGPL-3.0-or-later
// All messages of the protocol (docs/protocol_reference.md).
export * from "./gen/tedit/v1/comparison_pb.js";
export * from "./gen/tedit/v1/envelope_pb.js";
export * from "./gen/tedit/v1/library_pb.js";
export * from "./gen/tedit/v1/load_case_pb.js";
export * from "./gen/tedit/v1/operation_pb.js";
export * from "./gen/tedit/v1/print_pb.js";
export * from "./gen/tedit/v1/report_pb.js";
export * from "./gen/tedit/v1/session_pb.js";
