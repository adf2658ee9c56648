// SPDX-License-Identifier: AGPL-3.0-or-later
// Streams, surfaces and errors without a server, with numbers to check by hand.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { create, type MessageInitShape } from "@bufbuild/protobuf";
import { byCode, Conflict, errorFrom, ProtocolError, TeditError } from "../src/errors.js";
import { protocolMajor, protocolMinor } from "../src/gen/version.js";
import { Arrays, IncomingStream, type TypedArray } from "../src/streams.js";
import { Field, Surface } from "../src/surface.js";
import * as v1 from "../src/v1.js";
import { toParameter } from "../src/values.js";
import { source } from "./serving.js";

const { UINT32, FLOAT64, TYPE_UNSPECIFIED } = v1.ArrayInfo_Type;
type Info = MessageInitShape<typeof v1.ArrayInfoSchema>;

function announce(bytes: bigint, ...arrays: Info[]) {
  return create(v1.StreamSchema, { stream: 7n, bytes, arrays });
}
const u32 = (name: string, items: bigint, offset?: bigint): Info => ({ name, type: UINT32, components: 1, items, ...(offset === undefined ? {} : { offset }) });
const piece = (offset: number, data: Uint8Array) => create(v1.ChunkSchema, { stream: 7n, offset: BigInt(offset), data });

function arraysOf(all: Record<string, [TypedArray, number]>): Arrays {
  return new Arrays(7n, new Map(Object.entries(all).map(([name, [values, components]]) => [name, { values, components }])));
}

test("a file is sent as its name and content", () => {
  const bytes = new TextEncoder().encode("foobar");
  assert.deepEqual(toParameter({ name: "a;b.stl", bytes }), { kind: { case: "text", value: "data:a_b.stl;base64,Zm9vYmFy" } });
});

test("points and lists are sent as texts of numbers", () => {
  const text = (value: string) => ({ kind: { case: "text", value } });
  assert.deepEqual(toParameter([0, 0.01, -1e-7]), text("0, 0.01, -1e-7"));
  assert.deepEqual(toParameter([[0, 0, 0], [0, 0, 1]]), text("0, 0, 0; 0, 0, 1"));
});

test("arrays stand where they are said to, in the memory of the stream", () => {
  const stream = new IncomingStream(announce(40n, u32("slots", 3n, 0n), { name: "values", type: FLOAT64, components: 3, items: 1n, offset: 16n }));
  const data = new Uint8Array(40);
  new Uint32Array(data.buffer, 0, 3).set([5, 6, 7]);
  new Float64Array(data.buffer, 16, 3).set([1.5, -2, 1e300]);
  for (let at = 0; at < 40; at += 7) {
    assert.equal(stream.complete, false);
    stream.append(piece(at, data.subarray(at, at + 7))); // Pieces need not end where arrays do.
  }
  assert.equal(stream.complete, true);
  const arrays = stream.arrays();
  assert.deepEqual([...arrays.u32("slots")], [5, 6, 7]);
  assert.deepEqual([...arrays.f64("values")], [1.5, -2, 1e300]);
  assert.equal(arrays.u32("slots").buffer, arrays.f64("values").buffer);
  assert.equal(arrays.f32("other").length, 0);
  assert.throws(() => arrays.f32("slots"), ProtocolError);
});

test("without offsets each array begins where the one before ends, and is copied where its type cannot begin", () => {
  const stream = new IncomingStream(announce(12n, u32("a", 1n), { name: "b", type: FLOAT64, components: 1, items: 1n }));
  const data = new Uint8Array(12);
  new DataView(data.buffer).setFloat64(4, 2.5, true);
  stream.append(piece(0, data));
  assert.deepEqual([...stream.arrays().f64("b")], [2.5]);
});

test("what does not add up is refused", () => {
  for (const header of [
    announce(9n, u32("a", 2n)),
    announce(8n, u32("a", 2n), u32("b", 1n, 4n)),
    announce(8n, { name: "a", type: UINT32, components: 0, items: 2n }),
    announce(4n, { name: "a", type: TYPE_UNSPECIFIED, components: 1, items: 1n }),
    announce(2n ** 33n, u32("a", 2n ** 31n)),
  ])
    assert.throws(() => new IncomingStream(header), ProtocolError);
  for (const wrong of [piece(4, new Uint8Array(4)), piece(0, new Uint8Array(9))])
    assert.throws(() => new IncomingStream(announce(8n, u32("a", 2n))).append(wrong), ProtocolError);
});

/** The boundary of a tet with corners in slots 10, 20, 30 and 40; facets in slots 1 to 4, surface 1, the slanted 9. */
function tet(): Surface {
  const update = create(v1.SurfaceUpdateSchema, { versionId: "first", surfaces: [{ id: 1n }, { id: 9n }] });
  return Surface.none.apply(update, arraysOf({
    vertices: [Uint32Array.of(10, 20, 30, 40), 1],
    positions: [Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1), 3],
    facets: [Uint32Array.of(1, 2, 3, 4), 1],
    facet_vertices: [Uint32Array.of(10, 30, 20, 10, 20, 40, 10, 40, 30, 20, 30, 40), 3],
    facet_surfaces: [BigInt64Array.of(1n, 1n, 1n, 9n), 1],
  }));
}

test("a whole surface", () => {
  assert.deepEqual([...tet().mesh.triangles], [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);
  assert.ok(Math.abs(tet().area(1n) - 1.5) < 1e-12);
  assert.ok(Math.abs(tet().area(9n) - Math.sqrt(3) / 2) < 1e-12);
});

test("a difference replaces what its slots held", () => {
  const first = tet();
  const update = create(v1.SurfaceUpdateSchema, { versionId: "second", baseVersionId: "first", surfaces: [{ id: 2n }], removed: [9n] });
  const second = first.apply(update, arraysOf({
    removed_facets: [Uint32Array.of(4, 1), 1],
    vertices: [Uint32Array.of(40, 15), 1],
    positions: [Float64Array.of(0, 0, 2, 1, 1, 0), 3],
    facets: [Uint32Array.of(7, 1), 1],
    facet_vertices: [Uint32Array.of(20, 15, 40, 10, 30, 15), 3],
    facet_surfaces: [BigInt64Array.of(2n, 2n), 1],
  }));
  const { mesh } = second;
  assert.deepEqual([...mesh.facetSlots], [1, 2, 3, 7]);
  assert.deepEqual([...mesh.vertexSlots], [10, 15, 20, 30, 40]);
  assert.deepEqual([...mesh.points.subarray(12)], [0, 0, 2]);
  assert.deepEqual([...mesh.triangles], [0, 3, 1, 0, 2, 4, 0, 4, 3, 2, 1, 4]);
  assert.deepEqual([...mesh.surfaceIds], [2n, 1n, 1n, 2n]);
  assert.deepEqual([...second.surfaces.keys()], [1n, 2n]);
  assert.deepEqual([...first.mesh.points.subarray(9)], [0, 0, 1]); // The one before has its values.
});

test("a vertex that no facet has is still there for later ones", () => {
  const removed = tet().apply(create(v1.SurfaceUpdateSchema, { versionId: "second", baseVersionId: "first" }),
    arraysOf({ removed_facets: [Uint32Array.of(2, 3, 4), 1] }));
  assert.deepEqual([...removed.mesh.vertexSlots], [10, 20, 30]);
  const again = removed.apply(create(v1.SurfaceUpdateSchema, { versionId: "third", baseVersionId: "second" }), arraysOf({
    facets: [Uint32Array.of(2), 1], facet_vertices: [Uint32Array.of(10, 20, 40), 3], facet_surfaces: [BigInt64Array.of(1n), 1] }));
  assert.deepEqual([...again.mesh.points.subarray(9)], [0, 0, 1]);
});

test("an update that does not fit is refused", () => {
  assert.throws(() => tet().apply(create(v1.SurfaceUpdateSchema, { versionId: "x", baseVersionId: "other" }), Arrays.none), /other, but this client holds first/);
  const fitting = create(v1.SurfaceUpdateSchema, { versionId: "x", baseVersionId: "first" });
  const facet: Record<string, [TypedArray, number]> = { facets: [Uint32Array.of(2), 1], facet_surfaces: [BigInt64Array.of(1n), 1] };
  for (const arrays of [
    { ...facet, facet_vertices: [Uint32Array.of(10, 20, 99), 3] as [TypedArray, number] },
    facet,
    { vertices: [Uint32Array.of(10, 10), 1] as [TypedArray, number], positions: [new Float64Array(6), 3] as [TypedArray, number] },
  ])
    assert.throws(() => tet().apply(fitting, arraysOf(arrays)), ProtocolError);
});

test("a field is looked up by slots", () => {
  const values = arraysOf({ vertices: [Uint32Array.of(10, 20, 30, 35, 40), 1], von_mises_pa: [Float32Array.of(0, 1, 2, 3, 4), 1] });
  const field = new Field(create(v1.FieldUpdateSchema), values);
  assert.deepEqual([...field.on(tet().mesh, "von_mises_pa")], [0, 1, 2, 4]);
  assert.throws(() => field.on(tet().mesh, "stress_pa"), /only vertices, von_mises_pa/);
  const short = arraysOf({ vertices: [Uint32Array.of(10), 1], von_mises_pa: [Float32Array.of(0), 1] });
  assert.throws(() => new Field(create(v1.FieldUpdateSchema), short).on(tet().mesh, "von_mises_pa"), /another version/);
});

test("each code of the protocol has a class", () => {
  const body = readFileSync(join(source, "base/error.hpp"), "utf8").split("enum class ec {")[1]!.split("};")[0]!;
  const told = [...body.matchAll(/^\s*(\w+),\s*\/\/\/</gm)].map((found) => found[1]);
  assert.deepEqual([...byCode.keys()].sort(), told.sort());
  for (const [code, type] of byCode) assert.equal(new type({ what: "" }).code, code);
});

test("all that the server says of an error is there", () => {
  const error = errorFrom(create(v1.ErrorSchema, {
    code: "conflict", message: "m", remedy: "r", where: "w", conflict: { client: "bench" }, mostThatWorks: { parameter: "depth", value: 0.25 } }));
  assert.ok(error instanceof Conflict);
  assert.equal(error.message, "m (w). r");
  assert.equal(error.rival?.client, "bench");
  assert.equal(error.mostThatWorks?.value, 0.25);
  const newer = errorFrom(create(v1.ErrorSchema, { code: "too_hot" }));
  assert.equal(newer.constructor, TeditError);
  assert.equal(newer.code, "too_hot");
});

test("numbers of parameters", () => {
  assert.deepEqual(toParameter(3).kind, { case: "integer", value: 3n });
  assert.deepEqual(toParameter(0.5).kind, { case: "real", value: 0.5 });
  assert.deepEqual(toParameter(true).kind, { case: "boolean", value: true });
});

test("Hello says the server's version", () => {
  const text = readFileSync(join(source, "protocol/version.hpp"), "utf8");
  const said = [...text.matchAll(/(\w+)_version = (\d+);/g)].map(([, part, number]) => `${part} ${number}`);
  assert.deepEqual(said, [`major ${protocolMajor}`, `minor ${protocolMinor}`]);
});
