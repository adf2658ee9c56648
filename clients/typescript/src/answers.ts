// SPDX-License-Identifier: AGPL-3.0-or-later
// Answers of several values.
import type { Arrays } from "./streams.js";
import type { Surface } from "./surface.js";
import type { EditPreview, EditReport, PrintChecked, SectionReady, VersionsCompared } from "./v1.js";

/** What an edit would make. */
export class Preview {
  constructor(
    readonly message: EditPreview,
    /** The difference to the head's surface. */
    readonly arrays: Arrays,
  ) {}

  /** As `Committed.report` would be. */
  get report(): EditReport | undefined {
    return this.message.report;
  }

  /** The surface that the edit would make of the head's; throws `ProtocolError` when it is of another version. */
  surface(head: Surface): Surface {
    return head.apply(this.message.surface!, this.arrays);
  }
}

export interface Section {
  readonly message: SectionReady;
  /** positions (m) and triangles; of a solved version von_mises_pa, displacement_m, ... */
  readonly arrays: Arrays;
}

export interface Comparison {
  readonly message: VersionsCompared;
  /** vertices, difference_mark, von_mises_pa_difference, ...; none without a load case. */
  readonly arrays: Arrays;
}

export interface PrintCheck {
  readonly message: PrintChecked;
  /** facets (slots, ascending) and marks of those that are marked: 1 thin, 2 overhanging, 3 both. */
  readonly arrays: Arrays;
}

/** Of `Document.checkPrint`. */
export interface PrintLimits {
  /** Thinner walls are marked; absent: they are not looked for. */
  thinnerThanM?: number;
  /** What looks down and leans further is marked; absent: 45 degrees. */
  overhangRad?: number;
  /** The build direction, from the plate on; absent: z. */
  direction?: readonly [number, number, number];
  /** Its number; absent: the head. */
  version?: number;
}
