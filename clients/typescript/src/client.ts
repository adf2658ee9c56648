// SPDX-License-Identifier: AGPL-3.0-or-later
// The connection to a server, and the documents that it has.
import { Document, type OpenOptions } from "./document.js";
import { Cancelled, ConnectionLost, NotFound, TeditError } from "./errors.js";
import { Link, type Answer, type AnswerCase, type AskOptions, type CallOptions, type Request, type SocketLike } from "./link.js";
import type { Arrays } from "./streams.js";
import type { Catalogue, DocumentInfo, DocumentState, ServerMessage, ServerStatus, Welcome } from "./v1.js";

/** Asked twice these do something else the second time, and have no edit id that would keep them from it. */
const notRepeated = new Set(["copyDocument", "deleteDocument", "addDocument", "importPart"]);
/** Of the time for connecting again, how long one try may take. */
const tryMs = 5_000;

export interface ConnectOptions {
  /** As others see who changed a document; default "tedit-typescript". */
  name?: string;
  /** For connecting and for what is answered soon; default 60,000. */
  timeoutMs?: number;
  /** For how long a broken connection is made anew; 0: it stays broken. Default 30,000. */
  reconnectMs?: number;
  /**
   * After so much silence the server is asked whether it is there; when it does not answer in twice that time, the
   * connection is broken. Default 30,000.
   */
  silenceMs?: number;
  /** What each call is a part of, as the header traceparent of the W3C's Trace Context. */
  traceparent?: () => string;
  /** Instead of the global WebSocket or, in Node, that of the package ws. */
  makeSocket?: (url: string) => SocketLike;
}

/** How a CAD file or a surface is meshed. */
export interface ImportOptions extends CallOptions {
  fineness?: "coarse" | "medium" | "fine";
  /** What the coordinates of an STL, OBJ or PLY are in; default "mm". */
  lengthUnit?: "mm" | "cm" | "m" | "in";
  /** The longest edge, m, on surfaces of a CAD file, by their number or name. */
  localSizes?: Record<string, number>;
  /** For the history, and for what is said about the file. */
  fileName?: string;
  /** Where the name is taken: NAME-2, NAME-3, ... */
  orNextFree?: boolean;
}

export interface ImportedPart {
  document: string;
  /** What a person should know, a sentence each. */
  warnings: string[];
}

async function socketMaker(): Promise<(url: string) => SocketLike> {
  if (globalThis.WebSocket) return (url) => new globalThis.WebSocket(url) as unknown as SocketLike;
  const { WebSocket } = await import("ws");
  return (url) => new WebSocket(url, { perMessageDeflate: false }) as unknown as SocketLike;
}

/** `const server = await connect("ws://127.0.0.1:7464/v1", token)` */
export async function connect(url: string, token: string, options: ConnectOptions = {}): Promise<Client> {
  const client = new Client(url, token, options, options.makeSocket ?? (await socketMaker()));
  await client.start();
  return client;
}

/**
 * A connection to a server; made by `connect`. When it breaks it is made anew; documents are opened again, and what was
 * asked is asked again where that is safe: questions, and changes, which have an edit id and so are made once.
 */
export class Client {
  private link!: Link;
  private readonly documents_ = new Map<string, Document>(); // By the name of today.
  private repair: Promise<void> | undefined;
  private closed = false;
  private readonly timeoutMs: number;
  private readonly silenceMs: number;
  private readonly reconnectMs: number;
  private readonly name: string;
  private readonly traceparent: (() => string) | undefined;

  /** @internal */
  constructor(
    readonly url: string,
    private readonly token: string,
    options: ConnectOptions,
    private readonly makeSocket: (url: string) => SocketLike,
  ) {
    this.timeoutMs = options.timeoutMs ?? 60_000;
    this.silenceMs = options.silenceMs ?? 30_000;
    this.reconnectMs = options.reconnectMs ?? 30_000;
    this.name = options.name ?? "tedit-typescript";
    this.traceparent = options.traceparent;
  }

  /** @internal */
  async start(): Promise<void> {
    this.link = await this.connect(this.timeoutMs);
  }

  /** Ends the connection. Documents stay on the server. */
  close(): void {
    this.closed = true;
    this.link.close();
  }

  /** What the server said of itself: its version, `formats` of files, `results` of solves. */
  get welcome(): Welcome {
    return this.link.welcome;
  }

  /** What edits the server offers, with their parameters, and the plugins that it does not use. */
  async operations(): Promise<Catalogue> {
    return (await this.askQuick({ case: "listOperations", value: {} }, "catalogue")).value;
  }

  async status(): Promise<ServerStatus> {
    return (await this.askQuick({ case: "getStatus", value: {} }, "serverStatus")).value;
  }

  async documents(): Promise<DocumentInfo[]> {
    return (await this.askQuick({ case: "listDocuments", value: {} }, "documentList")).value.documents;
  }

  /** Opens a document; one that is not there is made. Without a name it is a temporary one. */
  async open(name = "", options: OpenOptions = {}): Promise<Document> {
    const document = new Document(this, name, options);
    for (;;) {
      const link = await this.connected();
      try {
        await this.openOn(link, document);
        return document;
      } catch (problem) {
        if (!(name && this.mayRepeat(problem, "openDocument"))) throw problem; // Asked twice without a name it would make two.
      }
    }
  }

  /** Gives another name a copy of a document with all its versions; the copy is not opened. */
  async copyDocument(document: string, name: string, options: CallOptions = {}): Promise<void> {
    await this.ask({ case: "copyDocument", value: { document, name } }, "documentAdded", options);
  }

  /** Takes a document from the server for good. Throws `Conflict` while others have it open. */
  async deleteDocument(document: string): Promise<void> {
    const { value } = await this.ask({ case: "deleteDocument", value: { document } }, "documentDeleted");
    const open = this.documents_.get(value.document);
    open?.takeLoss(new Cancelled("the document was deleted"), true);
    this.documents_.delete(value.document);
  }

  /** Makes a document file (.tedit) a document of the server and tells its name. */
  async addDocument(file: Uint8Array, name: string, options: CallOptions & { orNextFree?: boolean } = {}): Promise<string> {
    const orNextFree = options.orNextFree ?? false;
    const request = (upload: bigint, size: bigint): Request => ({ case: "addDocument", value: { name, orNextFree, upload, size } });
    return (await this.askWithFile(file, request, "documentAdded", options)).value.document;
  }

  /**
   * Meshes a CAD file (STEP, IGES, BREP) or a closed surface (STL, OBJ, PLY, 3MF) on the server and makes it a document,
   * without a name a temporary one; tells its name, and what a person should know.
   */
  async importPart(file: Uint8Array, name = "", options: ImportOptions = {}): Promise<ImportedPart> {
    const how = {
      name,
      orNextFree: options.orNextFree ?? false,
      fileName: options.fileName ?? "",
      fineness: options.fineness ?? "",
      lengthUnit: options.lengthUnit ?? "",
      localSizes: Object.entries(options.localSizes ?? {}).map(([surface, edgeLength]) => ({ surface, edgeLength })),
    };
    const request = (upload: bigint, size: bigint): Request => ({ case: "importPart", value: { ...how, upload, size } });
    const { document, warnings } = (await this.askWithFile(file, request, "documentAdded", options)).value;
    return { document, warnings };
  }

  // -- for documents

  /** @internal */
  async askQuick<K extends AnswerCase>(request: Request, wanted: K): Promise<Answer<K>> {
    return this.ask(request, wanted, { timeoutMs: this.timeoutMs });
  }

  /** @internal */
  async ask<K extends AnswerCase>(request: Request, wanted: K, options: AskOptions = {}): Promise<Answer<K>> {
    const traced = { ...options, traceparent: this.traceparent?.() };
    return this.repeat(request.case!, (link) => link.ask(request, wanted, traced));
  }

  /** @internal */
  async askWithFile<K extends AnswerCase>(
    file: Uint8Array,
    request: (upload: bigint, size: bigint) => Request,
    wanted: K,
    options: CallOptions = {},
  ): Promise<Answer<K>> {
    const traced = { ...options, traceparent: this.traceparent?.() };
    return this.repeat(request(0n, 0n).case!, (link) => link.askWithFile(file, request, wanted, traced));
  }

  /** @internal */
  drop(document: Document): void {
    for (const [name, one] of this.documents_) if (one === document) this.documents_.delete(name);
  }

  // -- how

  private async repeat<T>(kind: string, work: (link: Link) => Promise<T>): Promise<T> {
    for (;;) {
      const link = await this.connected();
      try {
        return await work(link);
      } catch (problem) {
        if (!this.mayRepeat(problem, kind)) throw problem;
      }
    }
  }

  private mayRepeat(problem: unknown, kind: string): boolean {
    return problem instanceof ConnectionLost && this.reconnectMs > 0 && !this.closed && !notRepeated.has(kind);
  }

  private async connected(): Promise<Link> {
    if (!this.repair && this.link.end && this.reconnectMs > 0 && !this.closed) this.beginRepair();
    if (this.repair) await this.repair;
    return this.link;
  }

  private connect(timeoutMs: number): Promise<Link> {
    const { url, token, name, silenceMs } = this;
    return Link.open(this.makeSocket(url), { url, token, name, timeoutMs, silenceMs }, {
      event: (body, arrays) => this.takeEvent(body, arrays),
      lost: (link) => this.takeLoss(link),
    });
  }

  private async openOn(link: Link, document: Document): Promise<void> {
    await link.ask({ case: "openDocument", value: document.request() }, "documentState", {
      arrived: (body) => this.adopt(document, body.value as DocumentState),
    });
  }

  /** Before anything of it arrives. */
  private adopt(document: Document, state: DocumentState): void {
    const before = this.documents_.get(state.document);
    if (before && before !== document) before.takeLoss(new Cancelled("the document was opened again"), true);
    this.drop(document);
    this.documents_.set(state.document, document);
    document.takeState(state);
  }

  private takeLoss(link: Link): void {
    if (this.link !== link || this.repair) return;
    if (this.reconnectMs > 0 && !this.closed) this.beginRepair();
    else this.tellLoss(link.end!, true);
  }

  private tellLoss(reason: TeditError, forGood: boolean): void {
    for (const document of this.documents_.values()) document.takeLoss(reason, forGood);
  }

  private beginRepair(): void {
    this.tellLoss(this.link.end!, false);
    this.repair = this.reconnect().finally(() => (this.repair = undefined));
    this.repair.catch(() => {}); // Who asks next is told.
  }

  private async reconnect(): Promise<void> {
    const until = Date.now() + this.reconnectMs;
    for (let waitMs = 100; ; waitMs = Math.min(2 * waitMs, 2_000)) {
      try {
        await this.renewLink();
        for (const document of [...this.documents_.values()]) await this.openAgain(document);
        return;
      } catch (problem) {
        if (!(problem instanceof ConnectionLost) || this.closed || Date.now() + waitMs > until) {
          this.tellLoss(problem as TeditError, true);
          throw problem;
        }
      }
      await new Promise((go) => setTimeout(go, waitMs));
    }
  }

  /** A client that is closed meanwhile has no link afterwards. */
  private async renewLink(): Promise<void> {
    if (!this.closed) this.link = await this.connect(Math.min(this.timeoutMs, tryMs));
    if (!this.closed) return;
    this.link.close();
    throw new ConnectionLost("the client was closed");
  }

  private async openAgain(document: Document): Promise<void> {
    const hadVersions = document.head !== undefined;
    try {
      await this.openOn(this.link, document);
      if (hadVersions && document.head === undefined) {
        // A name that leads nowhere begins a new document.
        await this.link.ask({ case: "closeDocument", value: { document: document.name } }, "done");
        throw new NotFound(`the document ${document.name} was deleted`);
      }
      if (document.wantsFields) // A solve may have ended meanwhile.
        await this.link.ask({ case: "watchFields", value: document.watchAgain() }, "done");
      document.tell({ type: "reconnected" });
    } catch (problem) {
      if (problem instanceof ConnectionLost || !(problem instanceof TeditError)) throw problem;
      this.drop(document); // Deleted meanwhile, for example: the others go on.
      document.takeLoss(problem, true);
    }
  }

  private takeEvent(body: ServerMessage["body"], arrays: Arrays): void {
    if (body.case === "documentRenamed") {
      const renamed = this.documents_.get(body.value.before);
      this.documents_.delete(body.value.before);
      if (renamed) this.documents_.set(body.value.document, renamed);
    }
    if (body.case === "backlogNotice") // Of the connection: all of its documents tell it.
      for (const document of this.documents_.values()) document.tell({ type: body.case, message: body.value });
    const name = body.value && "document" in body.value ? (body.value.document as string) : "";
    this.documents_.get(name)?.take(body, arrays);
  }
}
