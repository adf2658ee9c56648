// SPDX-License-Identifier: AGPL-3.0-or-later
// What a document tells by itself.
import type { TeditError } from "./errors.js";
import type { Field, Surface } from "./surface.js";
import type { BacklogNotice, CadStateChanged, Committed, DocumentRenamed, LoadCasesChanged, ParticipantChanged, Solved, SolveStatus, VersionAnnotated } from "./v1.js";

export type DocumentEvent =
  | { readonly type: "committed"; readonly message: Committed }
  | { readonly type: "solved"; readonly message: Solved }
  | { readonly type: "solveStatus"; readonly message: SolveStatus }
  | { readonly type: "loadCasesChanged"; readonly message: LoadCasesChanged }
  | { readonly type: "versionAnnotated"; readonly message: VersionAnnotated }
  /** How a version stands on the CAD model of its part is known now. */
  | { readonly type: "cadStateChanged"; readonly message: CadStateChanged }
  /** Somebody else opened the document, or has it open no more. */
  | { readonly type: "participantChanged"; readonly message: ParticipantChanged }
  | { readonly type: "documentRenamed"; readonly message: DocumentRenamed }
  /** The server sends more than this client takes; it ends the connection unless that changes. */
  | { readonly type: "backlogNotice"; readonly message: BacklogNotice }
  | { readonly type: "surface"; readonly surface: Surface }
  /** Of one load case or of an envelope; maybe a first one (`field.interim`). */
  | { readonly type: "field"; readonly field: Field }
  /** `forGood` false: the connection is being made anew. */
  | { readonly type: "lost"; readonly reason: TeditError; readonly forGood: boolean }
  /** The connection is there again. What was said meanwhile was missed; `head` and the like are those of now. */
  | { readonly type: "reconnected" };

export type EventType = DocumentEvent["type"];
export type EventOf<T extends EventType> = Extract<DocumentEvent, { type: T }>;

/** Events that an iterator may be behind; the oldest go. */
const mostKept = 1000;

/** Events on their way to one iterator. */
export class EventQueue implements AsyncIterableIterator<DocumentEvent> {
  private readonly waiting: DocumentEvent[] = [];
  private wake: (() => void) | undefined;
  private ended = false;

  constructor(private readonly onEnd: () => void) {}

  put(event: DocumentEvent): void {
    this.waiting.push(event);
    if (this.waiting.length > mostKept) this.waiting.shift();
    this.wake?.();
  }

  end(): void {
    this.ended = true;
    this.wake?.();
  }

  async next(): Promise<IteratorResult<DocumentEvent>> {
    while (this.waiting.length === 0 && !this.ended) {
      await new Promise<void>((wake) => (this.wake = wake));
      this.wake = undefined;
    }
    const event = this.waiting.shift();
    return event ? { done: false, value: event } : { done: true, value: undefined };
  }

  async return(): Promise<IteratorResult<DocumentEvent>> {
    this.ended = true;
    this.waiting.length = 0;
    this.onEnd();
    this.wake?.();
    return { done: true, value: undefined };
  }

  [Symbol.asyncIterator](): this {
    return this;
  }
}
