// SPDX-License-Identifier: AGPL-3.0-or-later
// What goes wrong, a class for each error code of the protocol.
import type { Error as ErrorMessage } from "./gen/tedit/v1/envelope_pb.js";

/** What the same edit may ask for instead; the server has tried it. */
export interface Most {
  readonly parameter: string;
  /** In its SI unit: the same request with this value succeeds. */
  readonly value: number;
}

/** Whose change a request did not know of. */
export interface Rival {
  /** Of the head as it is. */
  readonly versionId: string;
  readonly number: number;
  /** Who made it, as that program named itself; empty: not known. */
  readonly client: string;
  /** "import", "edit", "undo", "redo", "goto"; empty: not known. */
  readonly cause: string;
  /** Of an edit. */
  readonly operation: string;
  /** UTC: "2026-11-23T08:45:00Z". */
  readonly madeAt: string;
}

export interface ErrorDetails {
  readonly what: string;
  readonly remedy?: string;
  readonly where?: string;
  readonly mostThatWorks?: Most | undefined;
  readonly rival?: Rival | undefined;
}

/**
 * A request that was not carried out. `message` is one line for a person: what is wrong, where, and the remedy. Codes are
 * never renamed; one that this package does not know yet comes as a plain `TeditError`.
 */
export class TeditError extends Error {
  /** What is wrong, with the numbers. */
  readonly what: string;
  /** What a person can do about it; may be empty. */
  readonly remedy: string;
  /** File and line, byte offset, element or surface; may be empty. */
  readonly where: string;
  /** Of an edit that asked for too much, where it is known. */
  readonly mostThatWorks: Most | undefined;
  /** Of a conflict, when somebody else changed the document. */
  readonly rival: Rival | undefined;

  /** `code`: the stable lower-case name, for example "under_constrained". */
  constructor(readonly code: string, details: ErrorDetails | string) {
    const all: ErrorDetails = typeof details === "string" ? { what: details } : details;
    super(all.what + (all.where ? ` (${all.where})` : "") + (all.remedy ? `. ${all.remedy}` : ""));
    this.name = new.target.name;
    this.what = all.what;
    this.remedy = all.remedy ?? "";
    this.where = all.where ?? "";
    this.mostThatWorks = all.mostThatWorks;
    this.rival = all.rival;
  }
}

/** The command line or a request is malformed. */
export class Usage extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("usage", details);
  }
}

/** A value is outside what the call accepts. */
export class InvalidArgument extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("invalid_argument", details);
  }
}

/** A file's content is malformed; `where` gives line or offset. */
export class BadInput extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("bad_input", details);
  }
}

/** The file is of a kind, version or element type that is not read. */
export class UnsupportedFormat extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("unsupported_format", details);
  }
}

/** The operating system refused to read or write. */
export class IoError extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("io_error", details);
  }
}

/** A mesh invariant is broken; the message names the element. */
export class InvalidMesh extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("invalid_mesh", details);
  }
}

/** A tet has negative volume. */
export class InvertedTet extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("inverted_tet", details);
  }
}

/** A tet has zero volume. */
export class DegenerateTet extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("degenerate_tet", details);
  }
}

/** The boundary is no closed, oriented 2-manifold. */
export class NonManifold extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("non_manifold", details);
  }
}

/** A surface id is not in the version's table. */
export class SurfaceNotFound extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("surface_not_found", details);
  }
}

/** A candidate version broke a postcondition of an edit. */
export class PostconditionFailed extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("postcondition_failed", details);
  }
}

/** No plugin offers this operation. */
export class OperationNotFound extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("operation_not_found", details);
  }
}

/** A parameter is unknown, of the wrong type or out of its range. */
export class InvalidParameter extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("invalid_parameter", details);
  }
}

/** Nothing was selected, or nothing that the operation can act on. */
export class EmptySelection extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("empty_selection", details);
  }
}

/** The selected surfaces do not bound a hole. */
export class NotAHole extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("not_a_hole", details);
  }
}

/** A rim of the selection does not lie in a plane. */
export class NonPlanarRim extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("non_planar_rim", details);
  }
}

/** A rim is neither convex nor concave all around. */
export class MixedRim extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("mixed_rim", details);
  }
}

/** A cap would cut the part or another cap. */
export class CapIntersects extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("cap_intersects", details);
  }
}

/** The space to fill has next to no volume. */
export class FlatPlug extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("flat_plug", details);
  }
}

/** The selected surfaces bound no boss, rib or fin. */
export class NotAProtrusion extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("not_a_protrusion", details);
  }
}

/** The tetrahedral mesher gave no usable mesh. */
export class MesherFailed extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("mesher_failed", details);
  }
}

/** A plugin could not be loaded; the message says why. */
export class PluginRefused extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("plugin_refused", details);
  }
}

/** Rigid-body motion is left; the message names the free modes. */
export class UnderConstrained extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("under_constrained", details);
  }
}

/** A material's numbers are outside physics, or a region has none. */
export class InvalidMaterial extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("invalid_material", details);
  }
}

/** A load acts on nothing or is not a finite number. */
export class InvalidLoad extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("invalid_load", details);
  }
}

/** The solver did not reach the tolerance. */
export class NotConverged extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("not_converged", details);
  }
}

/** The requested device does not exist or cannot do the work. */
export class DeviceUnavailable extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("device_unavailable", details);
  }
}

/** The device failed while it worked. */
export class DeviceLost extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("device_lost", details);
  }
}

/** The work needs more memory than there is. */
export class OutOfMemory extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("out_of_memory", details);
  }
}

/** The caller cancelled the work. */
export class Cancelled extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("cancelled", details);
  }
}

/** A newer version made the work pointless. */
export class Superseded extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("superseded", details);
  }
}

/** The work did not end within its time limit. */
export class Timeout extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("timeout", details);
  }
}

/** A worker or server that is needed is not there. */
export class ServiceUnavailable extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("service_unavailable", details);
  }
}

/** The named document, version or page does not exist. */
export class NotFound extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("not_found", details);
  }
}

/** The request refers to a state that is no longer current. */
export class Conflict extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("conflict", details);
  }
}

/** A message could not be understood. */
export class ProtocolError extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("protocol_error", details);
  }
}

/** The document's storage failed. */
export class StorageError extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("storage_error", details);
  }
}

/** A defect of the program itself. */
export class Internal extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("internal", details);
  }
}

/** The caller's role is too low; the message names the least one. */
export class PermissionDenied extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("permission_denied", details);
  }
}

/** A server's certificate is not one that the client trusts. */
export class UntrustedServer extends TeditError {
  constructor(details: ErrorDetails | string) {
    super("untrusted_server", details);
  }
}

/** The connection to the server broke, or none could be made. What was asked may have been done. */
export class ConnectionLost extends ServiceUnavailable {}

/** Each error code and its class. */
export const byCode: ReadonlyMap<string, new (details: ErrorDetails) => TeditError> = new Map([
  ["usage", Usage],
  ["invalid_argument", InvalidArgument],
  ["bad_input", BadInput],
  ["unsupported_format", UnsupportedFormat],
  ["io_error", IoError],
  ["invalid_mesh", InvalidMesh],
  ["inverted_tet", InvertedTet],
  ["degenerate_tet", DegenerateTet],
  ["non_manifold", NonManifold],
  ["surface_not_found", SurfaceNotFound],
  ["postcondition_failed", PostconditionFailed],
  ["operation_not_found", OperationNotFound],
  ["invalid_parameter", InvalidParameter],
  ["empty_selection", EmptySelection],
  ["not_a_hole", NotAHole],
  ["non_planar_rim", NonPlanarRim],
  ["mixed_rim", MixedRim],
  ["cap_intersects", CapIntersects],
  ["flat_plug", FlatPlug],
  ["not_a_protrusion", NotAProtrusion],
  ["mesher_failed", MesherFailed],
  ["plugin_refused", PluginRefused],
  ["under_constrained", UnderConstrained],
  ["invalid_material", InvalidMaterial],
  ["invalid_load", InvalidLoad],
  ["not_converged", NotConverged],
  ["device_unavailable", DeviceUnavailable],
  ["device_lost", DeviceLost],
  ["out_of_memory", OutOfMemory],
  ["cancelled", Cancelled],
  ["superseded", Superseded],
  ["timeout", Timeout],
  ["service_unavailable", ServiceUnavailable],
  ["not_found", NotFound],
  ["conflict", Conflict],
  ["protocol_error", ProtocolError],
  ["storage_error", StorageError],
  ["internal", Internal],
  ["permission_denied", PermissionDenied],
  ["untrusted_server", UntrustedServer],
] as [string, new (details: ErrorDetails) => TeditError][]);

/** The exception for a `tedit.v1.Error`. */
export function errorFrom(message: ErrorMessage): TeditError {
  const details = {
    what: message.message,
    remedy: message.remedy,
    where: message.where,
    mostThatWorks: message.mostThatWorks,
    rival: message.conflict,
  };
  const known = byCode.get(message.code);
  return known ? new known(details) : new TeditError(message.code, details);
}
