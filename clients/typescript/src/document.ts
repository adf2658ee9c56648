// SPDX-License-Identifier: AGPL-3.0-or-later
// A document: its versions, its loads, its surface and its fields.
import { equals, type JsonValue, type MessageInitShape } from "@bufbuild/protobuf";
import { Preview, type Comparison, type PrintCheck, type PrintLimits, type Section } from "./answers.js";
import type { Client } from "./client.js";
import { guarded } from "./guarded.js";
import { Cancelled, ProtocolError, Timeout, type TeditError } from "./errors.js";
import { EventQueue, type DocumentEvent, type EventOf, type EventType } from "./events.js";
import type { Answer, AnswerCase, AskOptions, CallOptions, Request } from "./link.js";
import type { Arrays } from "./streams.js";
import { Field, Surface } from "./surface.js";
import {
  LoadCaseSchema,
  SelectSurfaces_Kind,
  type ApplyEditSchema,
  type Committed,
  type DocumentState,
  type Feature,
  type History,
  type LoadCase,
  type OpenDocumentSchema,
  type Participant,
  type SelectSurfacesSchema,
  type ServerMessage,
  type Solved,
  type SolveSchema,
  type SurfaceUpdate,
  type VersionInfo,
  type WatchFieldsSchema,
} from "./v1.js";
import { makeEditId, toIds, toLoadCase, toParameters, toPolicy, type Parameters, type Policy, type SurfaceId } from "./values.js";

/** Solves whose fields are kept. */
const keptSolves = 4;
const waitMs = 60_000;

/** What is sent and kept current by itself; both unless they are false. */
export interface OpenOptions {
  surface?: boolean;
  fields?: boolean;
}

/** Of a change. */
export interface ChangeOptions extends CallOptions {
  /** Refused with `Conflict` unless this is the head; absent: any head. */
  expectedVersion?: string;
  /** Asked again with the same id, a change is not made twice; made here unless it is given. */
  editId?: string;
}

export interface EditOptions extends ChangeOptions {
  /**
   * Where the head is another than `expectedVersion`, the edit is made on it all the same if it touches nothing that was
   * changed since.
   */
  carryOver?: boolean;
  /** What becomes of loads and supports whose surface goes; "drop" when absent. */
  loads?: Policy;
}

export interface WaitOptions {
  /** Absent: the head, whichever that is. */
  versionId?: string;
  timeoutMs?: number;
}

/** Made by `Client.open`. `head`, `loadCases`, `surface` and fields follow what anybody does with the document. */
export class Document {
  head: VersionInfo | undefined;
  canUndo = false;
  canRedo = false;
  /** Of the head. */
  loadCases: readonly LoadCase[] = [];
  /** All who have the document open, this client too. */
  participants: readonly Participant[] = [];
  /** Which of them this client is: `Participant.id`. */
  participant = 0n;
  /** Whole, of `surface.versionId`: the head's, or on its way there. */
  surface = Surface.none;
  /** What `watchFields` asked for. */
  watched: readonly string[] = [];

  private gone: TeditError | undefined;
  private surfaceFault: TeditError | undefined;
  private solves: Field[][] = [];
  private begun: Field[] = []; // Of a solve whose others still come.
  private readonly queues = new Set<EventQueue>();
  private readonly waiting = new Set<() => void>(); // Each looks whether what it waits for is here.
  private readonly listeners = new Set<(event: DocumentEvent) => void>();

  /** @internal */
  constructor(
    private readonly client: Client,
    /** Follows when somebody renames the document. */
    public name: string,
    private readonly wants: OpenOptions,
  ) {}

  // -- changes

  /** Uploads a mesh file and makes it the new head. `unit` is the file's length unit, "mm" when absent. */
  async importMesh(file: Uint8Array, options: ChangeOptions & { fileName?: string; unit?: string } = {}): Promise<Committed> {
    this.check();
    const change = { ...this.terms(options), fileName: options.fileName ?? "", lengthUnit: options.unit ?? "" };
    const request = (upload: bigint, size: bigint): Request => ({ case: "importMesh", value: { ...change, upload, size } });
    return (await this.client.askWithFile(file, request, "committed", options)).value;
  }

  /** Replaces the load case of this name at the head, or adds it: a message, or the JSON of its file. */
  async setLoadCase(loads: LoadCase | JsonValue, options: ChangeOptions = {}): Promise<void> {
    await this.ask({ case: "setLoadCase", value: { ...this.terms(options), loadCase: toLoadCase(loads) } }, "done", options);
  }

  async removeLoadCase(name: string, options: ChangeOptions = {}): Promise<void> {
    await this.ask({ case: "removeLoadCase", value: { ...this.terms(options), loadCase: name } }, "done", options);
  }

  /**
   * Applies an operation (`Client.operations`) to the head; done once the new version is durable. Parameters are in SI
   * units.
   */
  async edit(operation: string, surfaces: Iterable<SurfaceId>, parameters: Parameters = {}, options: EditOptions = {}): Promise<Committed> {
    const value = this.describeEdit(operation, surfaces, parameters, options);
    return (await this.ask({ case: "applyEdit", value: { ...value, carryOver: options.carryOver ?? false } }, "committed", options)).value;
  }

  async undo(options: ChangeOptions = {}): Promise<Committed> {
    return (await this.ask({ case: "undo", value: this.terms(options) }, "committed", options)).value;
  }

  async redo(options: ChangeOptions = {}): Promise<Committed> {
    return (await this.ask({ case: "redo", value: this.terms(options) }, "committed", options)).value;
  }

  /** Makes any version the head. */
  async goTo(number: number, options: ChangeOptions = {}): Promise<Committed> {
    return (await this.ask({ case: "goToVersion", value: { ...this.terms(options), number } }, "committed", options)).value;
  }

  /** Gives a version a name and a note instead of those it had. */
  async annotate(number: number, name: string, note = "", editId = makeEditId()): Promise<void> {
    await this.ask({ case: "annotateVersion", value: { document: this.name, number, name, note, editId } }, "done");
  }

  /** Gives the document another name; all who have it open hear of it. */
  async rename(name: string): Promise<void> {
    await this.ask({ case: "renameDocument", value: { document: this.name, name } }, "done");
  }

  // -- questions

  /**
   * What such an edit would make of the head; nothing is changed. Throws `Superseded` when the document is changed, or
   * another preview is asked for, meanwhile. A `draft` has the surface, the loads and the change of volume alone,
   * several times sooner; the edit may be refused all the same.
   */
  async preview(
    operation: string,
    surfaces: Iterable<SurfaceId>,
    parameters: Parameters = {},
    options: EditOptions & { findMost?: boolean; draft?: boolean } = {},
  ): Promise<Preview> {
    const edit = this.describeEdit(operation, surfaces, parameters, options);
    const { findMost = false, draft = false } = options;
    const { value, arrays } = await this.ask({ case: "previewEdit", value: { edit, findMost, draft } }, "editPreview", options);
    return new Preview(value, arrays);
  }

  /**
   * Surfaces of the head that belong together: "hole" and "protrusion" (of one picked surface), "holes" (all, of a
   * diameter), "smooth" and "neighbours" (over edges of a small angle).
   */
  async select(
    kind: "hole" | "protrusion" | "holes" | "smooth" | "neighbours",
    surfaces: Iterable<SurfaceId> = [],
    limits: Pick<MessageInitShape<typeof SelectSurfacesSchema>, "angleRad" | "minDiameterM" | "maxDiameterM"> = {},
  ): Promise<Feature[]> {
    const wanted = SelectSurfaces_Kind[kind.toUpperCase() as keyof typeof SelectSurfaces_Kind];
    const value = { ...limits, document: this.name, kind: wanted, surfaces: toIds(surfaces) };
    return (await this.ask({ case: "selectSurfaces", value }, "surfacesSelected")).value.features;
  }

  /** All versions; with `reports` what their edits reported. */
  async history(reports = false): Promise<History> {
    return (await this.ask({ case: "getHistory", value: { document: this.name, reports } }, "history")).value;
  }

  /** The surface of any version; the head stays where it is. */
  async surfaceOf(number: number): Promise<Surface> {
    const { value, arrays } = await this.ask({ case: "getSurface", value: { document: this.name, number } }, "versionSurface");
    return Surface.none.apply(value.surface!, arrays);
  }

  /** Cuts the head with a plane, with the field of a load case (absent: the only one, or the envelope). */
  async section(pointM: readonly [number, number, number], normal: readonly [number, number, number], loadCase = ""): Promise<Section> {
    const vector = ([x, y, z]: readonly [number, number, number]) => ({ x, y, z });
    const value = { document: this.name, pointM: vector(pointM), normal: vector(normal), loadCase };
    const { value: message, arrays } = await this.ask({ case: "cutSection", value }, "sectionReady");
    return { message, arrays };
  }

  /** What two versions differ in; with a load case also the difference of its fields. */
  async compare(before: number, after: number, loadCase = "", options: CallOptions = {}): Promise<Comparison> {
    const value = { document: this.name, before, after, loadCase };
    const { value: message, arrays } = await this.ask({ case: "compareVersions", value }, "versionsCompared", options);
    return { message, arrays };
  }

  /** What hinders printing a version in 3D: whether it is watertight, thin walls, overhangs, volume and box. */
  async checkPrint(limits: PrintLimits = {}, options: CallOptions = {}): Promise<PrintCheck> {
    const { direction = [0, 0, 1], ...rest } = limits;
    const [x, y, z] = direction;
    const value = { ...rest, document: this.name, direction: { x, y, z } };
    const { value: message, arrays } = await this.ask({ case: "checkPrint", value }, "printChecked", options);
    return { message, arrays };
  }

  /** A version as a file's bytes; `format` is a name of `Client.welcome.formats`, or "tedit": the whole document. With
   * a load case "inp" and "bdf" are decks that CalculiX and Nastran run. */
  async export(format: string, options: CallOptions & { versionId?: string; unit?: string; loadCase?: string } = {}): Promise<Uint8Array> {
    const value = { document: this.name, format, versionId: options.versionId ?? "", lengthUnit: options.unit ?? "", loadCase: options.loadCase ?? "" };
    return (await this.ask({ case: "exportFile", value }, "fileReady", options)).arrays.u8("file");
  }

  // -- solving

  /**
   * Solves one load case (none named: the first) or several on the head; later heads are solved with the same settings
   * by themselves. `waitField` has what comes of it on the surface; fields of before are forgotten.
   */
  async solve(settings: Omit<MessageInitShape<typeof SolveSchema>, "document" | "$typeName"> = {}, options: CallOptions = {}): Promise<Solved> {
    const arrived = () => this.forgetFields();
    return (await this.ask({ case: "solve", value: { ...settings, document: this.name } }, "solved", { ...options, arrived })).value;
  }

  /** Ends the solve that runs, whoever asked for it. */
  async cancelSolve(): Promise<void> {
    await this.ask({ case: "cancelSolve", value: { document: this.name } }, "done");
  }

  /**
   * What every field and section has from now on beside the usual: names of `Client.welcome.results` that are sent on
   * request. The head's field comes again, and `waitField` waits for that one; when it cannot come, the result says why.
   */
  async watchFields(quantities: readonly string[]): Promise<string> {
    const request: Request = { case: "watchFields", value: { document: this.name, quantities: [...quantities] } };
    const { value } = await this.ask(request, "done", { arrived: () => this.forgetFields() });
    this.watched = [...quantities];
    return value.note;
  }

  // -- what is kept current

  /** The surface of the head, or of a version while that is the head, once it is here. Throws `Timeout`. */
  waitSurface({ versionId, timeoutMs = waitMs }: WaitOptions = {}): Promise<Surface> {
    return this.wait("the surface", timeoutMs, () => {
      if (this.surfaceFault) throw this.surfaceFault;
      const wanted = versionId ?? this.head?.versionId;
      return wanted !== undefined && this.surface.versionId === wanted ? this.surface : undefined;
    });
  }

  /**
   * The final fields of a version, once all are here: of the load case, or of several in their order and last of their
   * envelope. `solve`: of that solve (`Solved.solve`) alone. Throws `Timeout`.
   */
  waitFields({ versionId, solve, timeoutMs = waitMs }: WaitOptions & { solve?: bigint } = {}): Promise<readonly Field[]> {
    return this.wait("the fields", timeoutMs, () => {
      const wanted = versionId ?? this.head?.versionId;
      return [...this.solves].reverse().find(([first]) => first!.versionId === wanted && (solve === undefined || first!.message.solve === solve));
    });
  }

  /** The last of them: the load case's, or the envelope's of several. */
  async waitField(options: WaitOptions & { solve?: bigint } = {}): Promise<Field> {
    return (await this.waitFields(options)).at(-1)!;
  }

  // -- events

  /** Calls `listener` with each event of a kind; gives what ends that. */
  on<T extends EventType>(type: T, listener: (event: EventOf<T>) => void): () => void {
    const call = (event: DocumentEvent) => {
      if (event.type === type) listener(event as EventOf<T>);
    };
    this.listeners.add(call);
    return () => this.listeners.delete(call);
  }

  /** What happens from this call on, one's own changes included: `for await (const event of part.events())`. */
  events(): AsyncIterableIterator<DocumentEvent> {
    const queue: EventQueue = new EventQueue(() => this.queues.delete(queue));
    if (this.gone) queue.end();
    else this.queues.add(queue);
    return queue;
  }

  /** Stops the document's events; it stays on the server. */
  async close(): Promise<void> {
    await this.ask({ case: "closeDocument", value: { document: this.name } }, "done");
    this.client.drop(this);
    this.takeLoss(new Cancelled("the document was closed"), true);
  }

  // -- how

  private check(): void {
    if (this.gone) throw this.gone;
  }

  private async ask<K extends AnswerCase>(request: Request, wanted: K, options: AskOptions = {}): Promise<Answer<K>> {
    this.check();
    return this.client.ask(request, wanted, options);
  }

  private terms(options: ChangeOptions) {
    return { document: this.name, expectedVersion: options.expectedVersion ?? "", editId: options.editId ?? makeEditId() };
  }

  private describeEdit(
    operation: string,
    surfaces: Iterable<SurfaceId>,
    parameters: Parameters,
    options: EditOptions,
  ): MessageInitShape<typeof ApplyEditSchema> {
    const what = { operation, surfaces: toIds(surfaces), parameters: toParameters(parameters), loads: toPolicy(options.loads ?? "drop") };
    return { ...this.terms(options), ...what };
  }

  private wait<T>(what: string, timeoutMs: number, find: () => T | undefined): Promise<T> {
    return new Promise((resolve, reject) => {
      const look = () => {
        try {
          const found = find();
          if (found === undefined) return this.check();
          done();
          resolve(found);
        } catch (problem) {
          done();
          reject(problem);
        }
      };
      const done = () => {
        clearTimeout(timer);
        this.waiting.delete(look);
      };
      const timer = setTimeout(() => {
        done();
        reject(new Timeout(`${what} did not arrive within ${timeoutMs} ms`));
      }, timeoutMs);
      this.waiting.add(look);
      look();
    });
  }

  // -- from the connection

  /** @internal */
  request(): MessageInitShape<typeof OpenDocumentSchema> {
    const heldVersionId = this.surfaceFault ? "" : this.surface.versionId; // From an earlier connection.
    return { name: this.name, watchSurface: this.wants.surface ?? true, watchFields: this.wantsFields, heldVersionId };
  }

  /** @internal */
  get wantsFields(): boolean {
    return this.wants.fields ?? true;
  }

  /** What was watched before the connection was lost; fields that are here are named, so that they do not come again. @internal */
  watchAgain(): MessageInitShape<typeof WatchFieldsSchema> {
    const last = this.solves.at(-1) ?? [];
    const complete = last.every(({ report, arrays }) => !report || this.watched.every((name) => arrays.components(name) > 0));
    const field = last.at(-1);
    const held = complete && field !== undefined && field.versionId === this.head?.versionId;
    return { document: this.name, quantities: [...this.watched], heldSolve: held ? field.message.solve : 0n };
  }

  /** Those that are meant come after the answer. */
  private forgetFields(): void {
    this.solves = [];
    this.begun = [];
  }

  /** @internal */
  takeState(state: DocumentState): void {
    this.name = state.document;
    this.head = state.head;
    this.canUndo = state.canUndo;
    this.canRedo = state.canRedo;
    const sameLoads =
      this.loadCases.length === state.loadCases.length &&
      state.loadCases.every((one, i) => equals(LoadCaseSchema, one, this.loadCases[i]!));
    if (!sameLoads) this.solves = [];
    this.loadCases = state.loadCases;
    this.participants = state.participants;
    this.participant = state.participant;
    this.surfaceFault = undefined;
    this.begun = [];
  }

  /** @internal */
  take(body: ServerMessage["body"], arrays: Arrays): void {
    const event = this.note(body, arrays);
    if (event) this.tell(event);
  }

  /** Takes over what a message says; what others are told of it. */
  private note(body: ServerMessage["body"], arrays: Arrays): DocumentEvent | undefined {
    switch (body.case) {
      case "surfaceUpdate":
        return this.takeSurface(body.value, arrays);
      case "fieldUpdate":
        return this.takeField(new Field(body.value, arrays));
      case "committed":
        if (body.value.repeated) return undefined; // It was told when it was made; others may have gone on since.
        this.takeHead(body.value);
        return { type: body.case, message: body.value };
      case "loadCasesChanged":
        this.loadCases = body.value.loadCases;
        return { type: body.case, message: body.value };
      case "participantChanged": {
        const { participant, gone } = body.value;
        const others = this.participants.filter((one) => one.id !== participant?.id);
        this.participants = gone || !participant ? others : [...others, participant];
        return { type: body.case, message: body.value };
      }
      case "documentRenamed":
        this.name = body.value.document;
        return { type: body.case, message: body.value };
      case "solved":
        return { type: body.case, message: body.value };
      case "solveStatus":
        return { type: body.case, message: body.value };
      case "versionAnnotated":
        return { type: body.case, message: body.value };
      case "cadStateChanged":
        if (body.value.version?.cad && this.head?.number === body.value.version.number)
          this.head.cad = body.value.version.cad;
        return { type: body.case, message: body.value };
      default:
        return undefined;
    }
  }

  private takeHead(moved: Committed): void {
    this.head = moved.head;
    this.canUndo = moved.canUndo;
    this.canRedo = moved.canRedo;
    this.loadCases = moved.loadCases;
    // A version that becomes the head again may have other loads than when its fields came.
    this.solves = this.solves.filter(([first]) => first!.versionId !== moved.head?.versionId);
    this.begun = [];
  }

  private takeSurface(update: SurfaceUpdate, arrays: Arrays): DocumentEvent | undefined {
    try {
      this.surface = this.surface.apply(update, arrays);
      this.surfaceFault = undefined;
      return { type: "surface", surface: this.surface };
    } catch (problem) {
      if (!(problem instanceof ProtocolError)) throw problem;
      this.surfaceFault = problem; // Who waits for a surface is told.
      for (const look of [...this.waiting]) look();
      return undefined;
    }
  }

  private takeField(field: Field): DocumentEvent {
    if (!field.interim) {
      const { solve, remaining } = field.message; // Who waits for a field waits for the final one.
      const last = this.begun.at(-1)?.message;
      if (last && (last.solve !== solve || last.remaining !== remaining + 1)) this.begun = []; // A newer solve came in between.
      this.begun.push(field);
      if (remaining === 0) {
        this.solves = [...this.solves, this.begun].slice(-keptSolves);
        this.begun = [];
      }
    }
    return { type: "field", field };
  }

  /** @internal */
  tell(event: DocumentEvent): void {
    for (const look of [...this.waiting]) look();
    for (const listener of [...this.listeners]) guarded(() => listener(event));
    for (const queue of this.queues) queue.put(event);
  }

  /** @internal */
  takeLoss(reason: TeditError, forGood: boolean): void {
    if (forGood) this.gone = reason;
    this.tell({ type: "lost", reason, forGood });
    if (!forGood) return;
    for (const queue of this.queues) queue.end();
    this.queues.clear();
  }
}
