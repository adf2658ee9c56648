// SPDX-License-Identifier: AGPL-3.0-or-later
// One connection: requests and their answers, streams, and what is sent unasked.
import { create, fromBinary, toBinary, type MessageInitShape } from "@bufbuild/protobuf";
import {
  ClientMessageSchema,
  ServerMessageSchema,
  type Chunk,
  type Stream,
  type Welcome,
} from "./v1.js";
import type { ServerMessage } from "./v1.js";
import { Cancelled, ConnectionLost, errorFrom, InvalidArgument, ProtocolError, type TeditError, Timeout } from "./errors.js";
import { guarded } from "./guarded.js";
import { protocolMajor, protocolMinor } from "./gen/version.js";
import { Arrays, IncomingStream } from "./streams.js";

/** Bytes of one piece of an upload. */
const pieceBytes = 256 * 1024;
/** Bytes of an upload that wait in memory. */
const mostQueued = 4 * 1024 * 1024;
const mostStreams = 256;

/** A request as the protocol has it: `{ case: "undo", value: { document } }`. */
export type Request = NonNullable<MessageInitShape<typeof ClientMessageSchema>["body"]>;
type Body = ServerMessage["body"];
export type AnswerCase = NonNullable<Body["case"]>;
type Bodies = { [B in Body as NonNullable<B["case"]>]: B["value"] };
export type BodyOf<K extends AnswerCase> = NonNullable<Bodies[K]>;
export interface Answer<K extends AnswerCase> {
  readonly value: BodyOf<K>;
  readonly arrays: Arrays;
}

export interface CallOptions {
  /** Ends the call here and on the server, with `Cancelled`. */
  signal?: AbortSignal | undefined;
  /** Between 0 and 1, and what is being done. */
  onProgress?: ((fraction: number, stage: string) => void) | undefined;
}

export interface AskOptions extends CallOptions {
  timeoutMs?: number | undefined;
  /** Has the answer before any message that comes after it. */
  arrived?: (body: Body) => void;
  /** What the request is a part of, see ConnectOptions. */
  traceparent?: string | undefined;
}

/** The part of a WebSocket that is used here: a browser's, or that of the package ws. */
export interface SocketLike {
  binaryType: string;
  readonly bufferedAmount: number;
  readonly readyState: number;
  send(data: Uint8Array<ArrayBuffer>): void;
  close(code?: number): void;
  addEventListener(type: string, listener: (event: never) => void): void;
}

export interface LinkOptions {
  readonly url: string;
  readonly token: string;
  readonly name: string;
  readonly timeoutMs: number;
  readonly silenceMs: number;
}

export interface LinkEvents {
  event(body: Body, arrays: Arrays): void;
  lost(link: Link): void;
}

interface Pending {
  readonly wanted: AnswerCase | undefined;
  readonly onProgress: AskOptions["onProgress"];
  finish(body: Body, arrays: Arrays): void;
  fail(problem: TeditError): void;
}

interface Arrival {
  readonly body: Body;
  readonly stream: IncomingStream;
  request: Pending | undefined;
}

/** What a message announces. */
function streamOf(body: Body): Stream | undefined {
  switch (body.case) {
    case "versionSurface":
    case "editPreview":
      return body.value.surface?.stream;
    case "surfaceUpdate":
    case "fieldUpdate":
    case "fileReady":
    case "sectionReady":
    case "versionsCompared":
    case "printChecked":
      return body.value.stream;
    default:
      return undefined;
  }
}

/** A connection from Hello to its end. It does not come back: make another one. */
export class Link {
  welcome!: Welcome;
  /** Why the connection is gone; undefined while it is there. */
  end: TeditError | undefined;
  private nextId = 1n;
  private nextUpload = 1n;
  private readonly pending = new Map<bigint, Pending>();
  private readonly streams = new Map<bigint, Arrival>();
  private readonly surfaces: Arrival[] = []; // As they were announced.
  private lastWord: TeditError | undefined; // An Error for no request: why the server will close.
  private heard = Date.now();
  private readonly watch: ReturnType<typeof setInterval>;

  private constructor(
    private readonly socket: SocketLike,
    private readonly events: LinkEvents,
    private readonly silenceMs: number,
  ) {
    socket.addEventListener("message", (event: { data: unknown }) => this.receive(event.data));
    socket.addEventListener("close", (event: { code: number; reason: string }) =>
      this.finish(new ConnectionLost({ what: `the connection broke (${event.code} ${event.reason})`, remedy: "Connect again" })));
    socket.addEventListener("error", () => this.finish(new ConnectionLost("the connection broke")));
    this.watch = setInterval(() => this.probe(), silenceMs);
    (this.watch as { unref?: () => void }).unref?.();
  }

  static async open(socket: SocketLike, { url, token, name, timeoutMs, silenceMs }: LinkOptions, events: LinkEvents): Promise<Link> {
    socket.binaryType = "arraybuffer";
    await opened(socket, url, timeoutMs);
    const link = new Link(socket, events, silenceMs);
    try {
      const hello: Request = { case: "hello", value: { protocolMajor, protocolMinor, client: name, token } };
      link.welcome = (await link.ask(hello, "welcome", { timeoutMs })).value;
    } catch (problem) {
      link.close();
      throw problem;
    }
    return link;
  }

  close(): void {
    this.finish(new ConnectionLost("the connection was closed"));
  }

  /** Sends a request and gives its answer. Throws what the server says, `Timeout`, `Cancelled`, `ConnectionLost`. */
  ask<K extends AnswerCase>(request: Request, wanted: K, options: AskOptions = {}): Promise<Answer<K>> {
    const id = this.nextId++;
    return new Promise<Answer<K>>((resolve, reject) => {
      if (this.end) return reject(this.end);
      if (options.signal?.aborted) return reject(new Cancelled("the call was cancelled"));
      const give = (problem: TeditError) => {
        this.cancel(id);
        pending.fail(problem);
      };
      const abort = () => give(new Cancelled("the call was cancelled"));
      const limit = options.timeoutMs;
      const timer = limit === undefined ? undefined : setTimeout(() => give(new Timeout(`the server gave no answer within ${limit} ms`)), limit);
      const settle = () => {
        clearTimeout(timer);
        options.signal?.removeEventListener("abort", abort);
        this.pending.delete(id);
      };
      const pending: Pending = {
        wanted,
        onProgress: options.onProgress,
        finish: (body, arrays) => {
          settle();
          if (body.case !== wanted) return reject(new ProtocolError(`the server answered with ${body.case}, not ${wanted}`));
          options.arrived?.(body);
          resolve({ value: body.value as unknown as BodyOf<K>, arrays });
        },
        fail: (problem) => {
          settle();
          this.forget(pending);
          reject(problem);
        },
      };
      this.pending.set(id, pending);
      options.signal?.addEventListener("abort", abort);
      try {
        this.send(id, request, options.traceparent);
      } catch (problem) {
        pending.fail(problem as TeditError);
      }
    });
  }

  /** Uploads a file, then asks for what `request` says of it. */
  async askWithFile<K extends AnswerCase>(
    data: Uint8Array,
    request: (upload: bigint, size: bigint) => Request,
    wanted: K,
    options: AskOptions = {},
  ): Promise<Answer<K>> {
    const upload = this.nextUpload++;
    const id = this.nextId++; // Pieces have no answer, but may be refused: they share one number.
    let refusal: TeditError | undefined;
    this.pending.set(id, { wanted: undefined, onProgress: undefined, finish: () => {}, fail: (problem) => (refusal ??= problem) });
    try {
      for (let offset = 0; offset < data.length && !refusal; offset += pieceBytes) {
        if (options.signal?.aborted) throw new Cancelled("the call was cancelled");
        while (this.socket.bufferedAmount > mostQueued && !this.end) await new Promise((go) => setTimeout(go, 5));
        this.send(id, { case: "uploadChunk", value: { upload, offset: BigInt(offset), data: data.subarray(offset, offset + pieceBytes) } });
      }
      return await this.ask(request(upload, BigInt(data.length)), wanted, options);
    } catch (problem) {
      throw problem instanceof ProtocolError && refusal ? refusal : problem; // A piece that was refused is the reason.
    } finally {
      this.pending.delete(id);
    }
  }

  private send(requestId: bigint, body: Request, traceparent = ""): void {
    if (this.end) throw this.end;
    const bytes = toBinary(ClientMessageSchema, create(ClientMessageSchema, { requestId, traceparent, body }));
    const most = this.welcome?.maxMessageBytes;
    if (most && BigInt(bytes.length) > most) throw new InvalidArgument(`the request has ${bytes.length} bytes, the server takes ${most}`);
    this.socket.send(bytes as Uint8Array<ArrayBuffer>);
  }

  /** Whoever cancels waits no longer: the answer to Cancel is for nobody. */
  private cancel(requestId: bigint): void {
    if (!this.end) this.send(this.nextId++, { case: "cancel", value: { requestId } });
  }

  private forget(request: Pending): void {
    for (const arrival of this.streams.values())
      if (arrival.request === request) {
        arrival.request = undefined;
        arrival.stream.discard();
      }
  }

  /** A line may break without a word: browsers cannot ping, but they can ask. */
  private probe(): void {
    if (this.end || Date.now() - this.heard < this.silenceMs) return;
    const timeoutMs = 2 * this.silenceMs;
    this.ask({ case: "getStatus", value: {} }, "serverStatus", { timeoutMs }).catch((problem: TeditError) => {
      if (problem instanceof Timeout) this.finish(new ConnectionLost(`the server has not answered for ${timeoutMs} ms`));
    });
  }

  private finish(reason: TeditError): void {
    if (this.end) return;
    this.end = this.lastWord ?? reason;
    clearInterval(this.watch);
    for (const request of [...this.pending.values()]) request.fail(this.end);
    this.streams.clear();
    this.socket.close();
    this.events.lost(this);
  }

  // -- what comes

  private receive(data: unknown): void {
    if (this.end) return;
    this.heard = Date.now();
    try {
      const message = fromBinary(ServerMessageSchema, new Uint8Array(data as ArrayBuffer));
      this.lastWord = undefined; // It explains the end only as the last word.
      this.take(message.requestId, message.body);
    } catch (problem) {
      this.finish(problem instanceof ProtocolError ? problem : new ProtocolError(`the server sent what cannot be understood: ${problem}`));
    }
  }

  private take(id: bigint, body: Body): void {
    const request = id === 0n ? undefined : this.pending.get(id);
    const header = streamOf(body);
    if (body.case === "chunk") return this.takeChunk(body.value);
    if (body.case === "progress") return guarded(() => request?.onProgress?.(body.value.fraction, body.value.stage));
    if (body.case === "error") {
      if (id === 0n) this.lastWord = errorFrom(body.value);
      return request?.fail(errorFrom(body.value));
    }
    if (header) return this.begin({ body, stream: new IncomingStream(header, id === 0n || request !== undefined), request });
    if (id === 0n || body.case === "committed" || body.case === "solved") this.events.event(body, Arrays.none);
    request?.finish(body, Arrays.none);
  }

  private begin(arrival: Arrival): void {
    const { stream } = arrival;
    if (this.streams.size >= mostStreams || this.streams.has(stream.stream))
      throw new ProtocolError(`the server announces stream ${stream.stream} before others are done`);
    this.streams.set(stream.stream, arrival);
    if (arrival.body.case === "surfaceUpdate") this.surfaces.push(arrival);
    if (stream.complete) this.complete(arrival);
  }

  private takeChunk(chunk: Chunk): void {
    const arrival = this.streams.get(chunk.stream);
    if (!arrival) throw new ProtocolError(`the server sends a piece of stream ${chunk.stream}, which it has not announced`);
    arrival.stream.append(chunk);
    if (arrival.stream.complete) this.complete(arrival);
  }

  private complete(arrival: Arrival): void {
    this.streams.delete(arrival.stream.stream);
    if (arrival.body.case === "surfaceUpdate") {
      // Differences build on each other in the order of their announcements.
      while (this.surfaces[0]?.stream.complete) {
        const first = this.surfaces.shift()!;
        this.events.event(first.body, first.stream.arrays());
      }
    } else if (arrival.body.case === "fieldUpdate") this.events.event(arrival.body, arrival.stream.arrays());
    else arrival.request?.finish(arrival.body, arrival.stream.arrays());
  }
}

function opened(socket: SocketLike, url: string, timeoutMs: number): Promise<void> {
  return new Promise((resolve, reject) => {
    const refuse = (why: string) => {
      clearTimeout(timer);
      reject(new ConnectionLost({ what: `there is no server at ${url}${why}`, remedy: "Start one with: tedit serve" }));
    };
    const timer = setTimeout(() => {
      refuse(` that answers within ${timeoutMs} ms`);
      socket.close();
    }, timeoutMs);
    socket.addEventListener("open", () => {
      clearTimeout(timer);
      resolve();
    });
    socket.addEventListener("error", (event: { message?: string }) => refuse(event.message ? `: ${event.message}` : ", or it does not let this page in"));
    socket.addEventListener("close", () => refuse(""));
  });
}
