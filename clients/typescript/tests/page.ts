// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs in a browser: opens a document, solves, edits, and tells what arrived. Address and token are in the fragment.
import * as tedit from "../src/index.js";

declare global {
  interface Window {
    result: Promise<unknown>;
  }
}

async function file(path: string): Promise<Response> {
  const answer = await fetch(path);
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
  return answer;
}

async function show(url: string, token: string): Promise<unknown> {
  const server = await tedit.connect(url, token, { name: "page", reconnectMs: 0, timeoutMs: 20_000 });
  const part = await server.open();
  await part.importMesh(new Uint8Array(await (await file("/plate/ctc01_plate.coarse.msh")).arrayBuffer()));
  const before = await part.waitSurface();
  await part.setLoadCase(await (await file("/plate/load_case.json")).json());
  const solved = await part.solve();
  await part.waitField({ solve: solved.solve });
  const done = await part.edit("fill_hole", [1, 2]);
  const { mesh } = await part.waitSurface();
  const field = await part.waitField();
  const stress = field.on(mesh, "von_mises_pa");
  const refusal = await part.edit("fill_hole", [98]).catch((problem: unknown) => problem);
  server.close();
  return {
    isBrowser: "document" in globalThis,
    facetsBefore: before.mesh.facetSlots.length,
    facetsTold: Number(done.head?.boundaryFacets),
    facetsAfter: mesh.facetSlots.length,
    fieldIsHeads: field.versionId === part.head?.versionId,
    megapascal: stress.reduce((a, b) => Math.max(a, b)) / 1e6,
    refused: refusal instanceof tedit.NotAHole,
  };
}

const [url, token] = JSON.parse(decodeURIComponent(location.hash.slice(1))) as [string, string];
window.result = show(url, token).catch((problem: unknown) => ({ problem: String(problem) }));
