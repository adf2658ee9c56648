// SPDX-License-Identifier: AGPL-3.0-or-later
// A client of TEdit for browsers and Node: edits meshed parts on a server and shows their stress at once.
export * from "./answers.js";
export { Client, connect, type ConnectOptions, type ImportedPart, type ImportOptions } from "./client.js";
export * from "./document.js";
export * from "./errors.js";
export type { DocumentEvent, EventOf, EventType } from "./events.js";
export type { CallOptions, SocketLike } from "./link.js";
export { Arrays, type TypedArray } from "./streams.js";
export { Field, Surface, type TriangleMesh } from "./surface.js";
export * as v1 from "./v1.js";
export { makeEditId, type AttachedFile, type Parameters, type Policy, type SurfaceId, type Value } from "./values.js";
