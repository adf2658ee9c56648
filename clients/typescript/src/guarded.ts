// SPDX-License-Identifier: AGPL-3.0-or-later

/** Calls a function of the package's user, whose faults are not the connection's: they are reported. */
export function guarded(call: () => void): void {
  try {
    call();
  } catch (problem) {
    (globalThis.reportError ?? console.error)(problem);
  }
}
