// SPDX-License-Identifier: AGPL-3.0-or-later
// Bulk data: pieces put together, and read as typed arrays.
import { ArrayInfo_Type, type ArrayInfo, type Chunk, type Stream } from "./gen/tedit/v1/session_pb.js";
import { ProtocolError } from "./errors.js";

/** The largest stream that is received, bytes. */
const maxBytes = 4 * 2 ** 30;

export type TypedArray = Uint8Array | Uint32Array | BigInt64Array | Float32Array | Float64Array;

interface Kind {
  readonly bytes: number;
  view(buffer: ArrayBuffer, offset: number, length: number): TypedArray;
}

const kinds: Partial<Record<ArrayInfo_Type, Kind>> = {
  [ArrayInfo_Type.UINT8]: { bytes: 1, view: (b, o, n) => new Uint8Array(b, o, n) },
  [ArrayInfo_Type.UINT32]: { bytes: 4, view: (b, o, n) => new Uint32Array(b, o, n) },
  [ArrayInfo_Type.INT64]: { bytes: 8, view: (b, o, n) => new BigInt64Array(b, o, n) },
  [ArrayInfo_Type.FLOAT32]: { bytes: 4, view: (b, o, n) => new Float32Array(b, o, n) },
  [ArrayInfo_Type.FLOAT64]: { bytes: 8, view: (b, o, n) => new Float64Array(b, o, n) },
};

/** The arrays of a complete stream, flat: of several components, the values of one item stand beside each other. */
export class Arrays {
  static readonly none = new Arrays(0n, new Map());

  constructor(
    private readonly stream: bigint,
    private readonly all: ReadonlyMap<string, { readonly values: TypedArray; readonly components: number }>,
  ) {}

  get names(): string[] {
    return [...this.all.keys()];
  }

  /** Values per item; 0 when there is no such array. */
  components(name: string): number {
    return this.all.get(name)?.components ?? 0;
  }

  // Each throws `ProtocolError` for an array of another type and is empty for one that did not come.

  u8(name: string): Uint8Array {
    return this.of(name, Uint8Array);
  }
  u32(name: string): Uint32Array {
    return this.of(name, Uint32Array);
  }
  i64(name: string): BigInt64Array {
    return this.of(name, BigInt64Array);
  }
  f32(name: string): Float32Array {
    return this.of(name, Float32Array);
  }
  f64(name: string): Float64Array {
    return this.of(name, Float64Array);
  }

  private of<T extends TypedArray>(name: string, type: new (length: number) => T): T {
    const found = this.all.get(name)?.values;
    if (found === undefined) return new type(0);
    if (!(found instanceof type)) throw new ProtocolError(`stream ${this.stream} has array "${name}" of another type`);
    return found;
  }
}

/** What a `tedit.v1.Stream` announced: filled by pieces, then read as arrays. */
export class IncomingStream {
  readonly stream: bigint;
  private readonly bytes: number;
  private readonly places: { readonly info: ArrayInfo; readonly kind: Kind; readonly at: number }[] = [];
  private data: Uint8Array<ArrayBuffer> | undefined;
  private received = 0;

  /** With `keep` false the bytes are counted and thrown away. Throws `ProtocolError` when the sizes do not add up. */
  constructor(header: Stream, keep = true) {
    this.stream = header.stream;
    let end = 0;
    for (const info of header.arrays) {
      const kind = kinds[info.type];
      if (!kind || info.components === 0) throw this.fault(`has array "${info.name}" of an unknown type`);
      const at = info.offset === undefined ? end : Number(info.offset);
      if (at < end) throw this.fault(`has array "${info.name}" inside the one before`);
      end = at + kind.bytes * info.components * Number(info.items);
      this.places.push({ info, kind, at });
    }
    if (BigInt(end) !== header.bytes) throw this.fault(`announces ${header.bytes} bytes, but its arrays end at ${end}`);
    if (end > maxBytes) throw this.fault(`is larger than ${maxBytes} bytes`);
    this.bytes = end;
    if (keep) this.data = new Uint8Array(end);
  }

  private fault(what: string): ProtocolError {
    return new ProtocolError(`stream ${this.stream} ${what}`);
  }

  get complete(): boolean {
    return this.received === this.bytes;
  }

  /** Throws the data away, those to come too; the pieces are still checked. */
  discard(): void {
    this.data = undefined;
  }

  /** Takes the next piece; throws `ProtocolError` when it is not the next one or too long. */
  append(chunk: Chunk): void {
    if (chunk.offset !== BigInt(this.received)) throw this.fault(`goes on at byte ${chunk.offset} after ${this.received} bytes`);
    if (chunk.data.length > this.bytes - this.received) throw this.fault(`brings more than the announced ${this.bytes} bytes`);
    this.data?.set(chunk.data, this.received);
    this.received += chunk.data.length;
  }

  /** Of a complete stream: views of its memory. Only an array that begins where its type cannot is copied. */
  arrays(): Arrays {
    const buffer = this.data?.buffer ?? new ArrayBuffer(0);
    const all = new Map<string, { values: TypedArray; components: number }>();
    for (const { info, kind, at } of this.places) {
      const length = info.components * Number(info.items);
      const fits = at % kind.bytes === 0;
      const values = fits ? kind.view(buffer, at, length) : kind.view(buffer.slice(at, at + length * kind.bytes), 0, length);
      all.set(info.name, { values, components: info.components });
    }
    return new Arrays(this.stream, all);
  }
}
