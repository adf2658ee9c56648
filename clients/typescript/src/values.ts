// SPDX-License-Identifier: AGPL-3.0-or-later
// Plain values as the protocol's messages.
import { create, fromJson, isMessage, type JsonValue, type MessageInitShape } from "@bufbuild/protobuf";
import { InvalidArgument } from "./errors.js";
import { LoadCaseSchema, LoadPolicy_Kind, type LoadCase, type LoadPolicySchema, type ParameterValueSchema } from "./v1.js";

/** Lengths and the like are in the SI unit that the catalogue states. */
export type Value = boolean | number | string | Numbers | AttachedFile;
/** Numbers of a point or a list, or points of an axis, a plane or a polyline. */
export type Numbers = readonly (number | readonly number[])[];
/** For a parameter of the kind FILE. */
export interface AttachedFile {
  readonly name: string;
  readonly bytes: Uint8Array;
}
export type Parameters = Readonly<Record<string, Value>>;
/** What becomes of loads whose surface an edit takes away. */
export type Policy = "drop" | "move" | "refuse" | MessageInitShape<typeof LoadPolicySchema>;
export type SurfaceId = number | bigint;

/** An id with which a change is made once, however often it is asked for. */
export function makeEditId(): string {
  const bytes = globalThis.crypto?.getRandomValues(new Uint8Array(16)) ?? Uint8Array.from({ length: 16 }, () => Math.random() * 256);
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

export function toParameter(value: Value): MessageInitShape<typeof ParameterValueSchema> {
  if (typeof value === "boolean") return { kind: { case: "boolean", value } };
  if (typeof value === "string") return { kind: { case: "text", value } };
  if (typeof value === "object") return { kind: { case: "text", value: "bytes" in value ? toAttachment(value) : toNumbers(value) } };
  // A parameter that is a real number takes a whole one, too, but not the other way round.
  return Number.isSafeInteger(value) ? { kind: { case: "integer", value: BigInt(value) } } : { kind: { case: "real", value } };
}

/** "0, 0.01, 0", and "0, 0, 0; 0, 0, 1" of points, as the server reads them. */
function toNumbers(values: Numbers): string {
  const points = values.some((value) => typeof value !== "number");
  return values.map((value) => (typeof value === "number" ? String(value) : value.join(", "))).join(points ? "; " : ", ");
}

function toAttachment(file: AttachedFile): string {
  let binary = "";
  for (const byte of file.bytes) binary += String.fromCharCode(byte);
  return `data:${file.name.replace(/[;,]/g, "_")};base64,${btoa(binary)}`;
}

export function toParameters(values: Parameters): Record<string, MessageInitShape<typeof ParameterValueSchema>> {
  return Object.fromEntries(Object.entries(values).map(([name, value]) => [name, toParameter(value)]));
}

export function toPolicy(policy: Policy): MessageInitShape<typeof LoadPolicySchema> {
  const kinds = { drop: LoadPolicy_Kind.DROP, move: LoadPolicy_Kind.MOVE, refuse: LoadPolicy_Kind.REFUSE };
  return typeof policy === "string" ? { kind: kinds[policy] } : policy;
}

export function toIds(surfaces: Iterable<SurfaceId>): bigint[] {
  return Array.from(surfaces, BigInt);
}

/** A message, or the JSON of a load case's file (docs/load_cases.md). Throws `InvalidArgument`. */
export function toLoadCase(given: LoadCase | JsonValue): LoadCase {
  if (isMessage(given, LoadCaseSchema)) return create(LoadCaseSchema, given);
  try {
    return fromJson(LoadCaseSchema, given as JsonValue);
  } catch (problem) {
    throw new InvalidArgument(`this is no load case: ${problem instanceof Error ? problem.message : problem}`);
  }
}
