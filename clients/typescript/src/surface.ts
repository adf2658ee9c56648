// SPDX-License-Identifier: AGPL-3.0-or-later
// The boundary of a part, and values on it.
import type { Envelope, SolveReport } from "./gen/tedit/v1/report_pb.js";
import type { FieldUpdate, SurfaceInfo, SurfaceUpdate } from "./gen/tedit/v1/session_pb.js";
import { ProtocolError } from "./errors.js";
import type { Arrays, TypedArray } from "./streams.js";

/** A surface as most programs want it: points, and triangles as rows of points. */
export interface TriangleMesh {
  /** m; x, y, z of each point. */
  readonly points: Float64Array;
  /** Three rows of `points` each; the normal points outward. */
  readonly triangles: Uint32Array;
  /** Of each triangle: the CAD system's number. */
  readonly surfaceIds: BigInt64Array;
  /** Of each point; fields are looked up by it. */
  readonly vertexSlots: Uint32Array;
  /** Of each triangle; stable over edits. */
  readonly facetSlots: Uint32Array;
}

interface Column {
  readonly values: TypedArray;
  readonly components: number;
}

/** Where a slot stands in an ascending list; -1 when it does not. */
function rowOf(slots: Uint32Array, slot: number): number {
  let low = 0;
  let high = slots.length;
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (slots[middle]! < slot) low = middle + 1;
    else high = middle;
  }
  return slots[low] === slot ? low : -1;
}

/** Rows by slot, ascending. A change makes a new table; the one before keeps its values. */
class Table {
  constructor(
    readonly slots: Uint32Array,
    readonly columns: readonly Column[],
  ) {}

  patched(removed: Uint32Array, slots: Uint32Array, columns: readonly Column[]): Table {
    const gone = new Set<number>([...removed, ...slots]);
    const stays = Array.from(this.slots.keys()).filter((row) => !gone.has(this.slots[row]!));
    const added = Array.from(slots.keys()).sort((a, b) => slots[a]! - slots[b]!);
    const count = stays.length + added.length;
    const result = new Table(
      new Uint32Array(count),
      columns.map(({ values, components }) => ({ values: new (values.constructor as new (n: number) => TypedArray)(count * components), components })),
    );
    for (let row = 0, old = 0, fresh = 0; row < count; ++row) {
      const takeOld = fresh === added.length || (old < stays.length && this.slots[stays[old]!]! < slots[added[fresh]!]!);
      const from = takeOld ? stays[old++]! : added[fresh++]!;
      result.slots[row] = (takeOld ? this.slots : slots)[from]!;
      const source = takeOld ? this.columns : columns;
      result.columns.forEach((column, c) => copyRow(source[c]!, from, column, row));
    }
    return result;
  }
}

function copyRow(source: Column, from: number, target: Column, to: number): void {
  for (let i = 0; i < target.components; ++i) target.values[to * target.components + i] = source.values[from * target.components + i]!;
}

function checkUnique(name: string, slots: Uint32Array): void {
  if (new Set(slots).size !== slots.length) throw new ProtocolError(`a surface update lists a slot twice in "${name}"`);
}

const noSlots = new Uint32Array(0);

/** The boundary of one version. Never changes: an update makes a new one. */
export class Surface {
  static readonly none = new Surface("", new Map(), new Table(noSlots, [{ values: new Float64Array(0), components: 3 }]),
    new Table(noSlots, [{ values: new Uint32Array(0), components: 3 }, { values: new BigInt64Array(0), components: 1 }]));

  private made: TriangleMesh | undefined;

  private constructor(
    readonly versionId: string,
    /** By id. */
    readonly surfaces: ReadonlyMap<bigint, SurfaceInfo>,
    private readonly vertices: Table,
    private readonly facets: Table,
  ) {}

  /**
   * The surface after an update, whole or as a difference to this one. Throws `ProtocolError` for an update that builds
   * on another version or does not fit.
   */
  apply(update: SurfaceUpdate, arrays: Arrays): Surface {
    if (!update.versionId) throw new ProtocolError("a surface update names no version");
    if (update.baseVersionId && update.baseVersionId !== this.versionId)
      throw new ProtocolError({
        what: `a surface update builds on version ${update.baseVersionId}, but this client holds ${this.versionId || "none"}`,
        remedy: "Open the document again to get the whole surface.",
      });
    const base = update.baseVersionId ? this : Surface.none;
    const surfaces = new Map(base.surfaces);
    for (const id of update.removed) surfaces.delete(id);
    for (const info of update.surfaces) surfaces.set(info.id, info);
    const vertices = arrays.u32("vertices");
    const facets = arrays.u32("facets");
    const removed = arrays.u32("removed_facets");
    const positions = { values: arrays.f64("positions"), components: 3 };
    const corners = { values: arrays.u32("facet_vertices"), components: 3 };
    const owners = { values: arrays.i64("facet_surfaces"), components: 1 };
    if (positions.values.length !== 3 * vertices.length || corners.values.length !== 3 * facets.length || owners.values.length !== facets.length)
      throw new ProtocolError("a surface update has arrays whose lengths do not fit");
    checkUnique("vertices", vertices);
    checkUnique("facets", facets);
    // Vertices that no facet has any more are kept: the server builds on what it has sent.
    const result = new Surface(update.versionId, surfaces, base.vertices.patched(noSlots, vertices, [positions]),
      base.facets.patched(removed, facets, [corners, owners]));
    for (const slot of corners.values)
      if (rowOf(result.vertices.slots, slot) < 0) throw new ProtocolError("a surface update has a facet with a vertex that was never sent");
    return result;
  }

  /** Points and triangles; made when it is asked for first. */
  get mesh(): TriangleMesh {
    return (this.made ??= this.makeMesh());
  }

  private makeMesh(): TriangleMesh {
    const corners = this.facets.columns[0]!.values as Uint32Array;
    const rows = corners.map((slot) => rowOf(this.vertices.slots, slot));
    const used = new Uint8Array(this.vertices.slots.length);
    for (const row of rows) used[row] = 1;
    const kept = Uint32Array.from(used.keys()).filter((row) => used[row] === 1);
    const places = new Uint32Array(used.length);
    const points = new Float64Array(3 * kept.length);
    kept.forEach((row, place) => {
      places[row] = place;
      copyRow(this.vertices.columns[0]!, row, { values: points, components: 3 }, place);
    });
    return {
      points,
      triangles: rows.map((row) => places[row]!),
      surfaceIds: this.facets.columns[1]!.values as BigInt64Array,
      vertexSlots: kept.map((row) => this.vertices.slots[row]!),
      facetSlots: this.facets.slots,
    };
  }

  /** m2, of one surface or of all. */
  area(surface?: bigint): number {
    const { points, triangles, surfaceIds } = this.mesh;
    let doubled = 0;
    for (let t = 0; t < surfaceIds.length; ++t)
      if (surface === undefined || surfaceIds[t] === surface) doubled += doubledArea(points, triangles.subarray(3 * t, 3 * t + 3));
    return doubled / 2;
  }
}

function doubledArea(points: Float64Array, corners: Uint32Array): number {
  const side = (to: number) => [0, 1, 2].map((i) => points[3 * corners[to]! + i]! - points[3 * corners[0]! + i]!);
  const [u, v] = [side(1), side(2)] as [number[], number[]];
  const cross = (i: number, j: number) => u[i]! * v[j]! - u[j]! * v[i]!;
  return Math.hypot(cross(1, 2), cross(2, 0), cross(0, 1));
}

/** Values at the vertices of the boundary: of one load case, or of the envelope of several. */
export class Field {
  /** Ascending. */
  readonly slots: Uint32Array;

  constructor(
    readonly message: FieldUpdate,
    /** By name: "displacement_m", "von_mises_pa", ...; a row for each of `slots`. */
    readonly arrays: Arrays,
  ) {
    this.slots = arrays.u32("vertices");
  }

  /** Of a load case; an envelope has none. */
  get report(): SolveReport | undefined {
    return this.message.report;
  }
  get envelope(): Envelope | undefined {
    return this.message.envelope;
  }
  get versionId(): string {
    return this.message.envelope?.versionId ?? this.message.report?.versionId ?? "";
  }
  /** A first field of a solve that still runs. */
  get interim(): boolean {
    return (this.message.envelope?.interim ?? false) || (this.message.report?.interim ?? false);
  }

  /**
   * An array of floats for the points of a mesh of the same version, `components` beside each other. Throws `RangeError`
   * when there is no such array or the mesh has vertices that the field has not.
   */
  on(mesh: TriangleMesh, name: string): Float32Array {
    const values = this.arrays.f32(name);
    const components = this.arrays.components(name);
    if (components === 0) throw new RangeError(`the field has no array "${name}", only ${this.arrays.names.join(", ")}`);
    const result = new Float32Array(components * mesh.vertexSlots.length);
    mesh.vertexSlots.forEach((slot, place) => {
      const row = rowOf(this.slots, slot);
      if (row < 0) throw new RangeError("the field belongs to another version than the surface");
      copyRow({ values, components }, row, { values: result, components }, place);
    });
    return result;
  }
}
