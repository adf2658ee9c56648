// SPDX-License-Identifier: AGPL-3.0-or-later
// The package in Node against a real server and a real part.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, beforeEach, test, type TestContext } from "node:test";
import * as tedit from "../src/index.js";
import { Line, loadCase, loads, noCad, plate, Server, source } from "./serving.js";

let server: Server;
let client: tedit.Client;
let part: tedit.Document;
let parts = 0;

before(async () => {
  server = await Server.start();
  client = await server.connect();
});
after(async () => {
  client.close();
  await server.stop();
});
beforeEach(async () => {
  part = await client.open(`part${++parts}`); // Others may have the one before open for a while.
  await part.importMesh(plate, { fileName: "plate.msh" });
});

const toldArea = (surface: tedit.Surface) => [...surface.surfaces.values()].reduce((sum, info) => sum + info.areaM2, 0);

/** The next event of a kind. */
async function next<T extends tedit.EventType>(events: AsyncIterator<tedit.DocumentEvent>, type: T): Promise<tedit.EventOf<T>> {
  for (;;) {
    const { done, value } = await events.next();
    if (done) throw new Error(`no event ${type} came`);
    if (value.type === type) return value as tedit.EventOf<T>;
  }
}

/** A client on a line that can be cut; both end with the test. */
async function connectShaky(context: TestContext, options: tedit.ConnectOptions = {}): Promise<[Line, tedit.Client]> {
  const line = await Line.to(server.port);
  context.after(() => line.close());
  const shaky = await tedit.connect(line.url, server.token, options);
  context.after(() => shaky.close());
  return [line, shaky];
}

test("who may not come in is told why", async () => {
  await assert.rejects(tedit.connect(server.url, "0".repeat(64)), (e) => e instanceof tedit.InvalidArgument && /token is wrong/.test(e.message));
  await assert.rejects(tedit.connect("ws://127.0.0.1:9/v1", server.token), (e) => e instanceof tedit.ConnectionLost && /tedit serve/.test(e.message));
});

test("what the server offers", async () => {
  assert.match(client.welcome.server, /^tedit /);
  assert.ok((await client.operations()).operations.some((one) => one.id === "fill_hole"));
  assert.ok(client.welcome.formats.some((one) => one.name === "msh"));
  assert.ok((await client.status()).connections >= 1);
});

test("the surface follows every head", async () => {
  const first = await part.waitSurface();
  assert.equal(first.mesh.triangles.length, 3 * 8398);
  assert.ok(Math.abs(first.area() / toldArea(first) - 1) < 1e-12);
  const done = await part.edit("fill_hole", [1, 2]);
  assert.deepEqual([done.head?.number, part.head?.number, part.canUndo], [1, 1, true]);
  const filled = await part.waitSurface();
  assert.equal(BigInt(filled.mesh.triangles.length), 3n * done.head!.boundaryFacets);
  assert.ok(Math.abs(filled.area() / toldArea(filled) - 1) < 1e-12);
  assert.ok(!filled.surfaces.has(1n));
  await part.undo();
  assert.deepEqual((await part.waitSurface()).mesh, first.mesh);
  await part.redo();
  const whole = await part.surfaceOf(1); // What differences made is the same.
  assert.deepEqual((await part.waitSurface({ versionId: whole.versionId })).mesh, whole.mesh);
});

test("a preview is what the edit makes", async () => {
  const head = await part.waitSurface();
  const shown = await part.preview("fill_hole", [92n, 93n]);
  const done = await part.edit("fill_hole", [92n, 93n]);
  assert.deepEqual(shown.surface(head).mesh, (await part.waitSurface()).mesh);
  assert.equal(shown.report?.volumeChangeM3, done.report?.volumeChangeM3);
});

test("stress arrives and follows", async () => {
  await part.setLoadCase(loads());
  const solved = await part.solve();
  const field = await part.waitField({ solve: solved.solve });
  const { mesh } = await part.waitSurface();
  const stress = field.on(mesh, "von_mises_pa");
  assert.equal(stress.length, mesh.vertexSlots.length);
  assert.ok(Math.abs(stress.reduce((a, b) => Math.max(a, b)) - solved.report!.maxVonMisesPa) <= 1);
  assert.ok(Math.abs(solved.report!.maxVonMisesPa - 13.447e6) < 5e3);
  assert.equal(field.on(mesh, "displacement_m").length, 3 * stress.length);
  await part.edit("fill_hole", [1, 2]);
  assert.equal((await part.waitField()).versionId, part.head!.versionId);
  assert.equal(await part.watchFields(["stress_pa"]), "");
  assert.equal((await part.waitField()).arrays.components("stress_pa"), 6);
  await part.watchFields(["safety_factor"]);
  assert.deepEqual((await part.waitField()).arrays.names, ["vertices", "displacement_m", "von_mises_pa", "safety_factor"]);
  await part.solve({ elementOrder: 1 });
  assert.equal((await part.waitField()).report?.elementOrder, 1);
  await assert.rejects(part.watchFields(["beauty"]), tedit.InvalidArgument);
});

test("several load cases have an envelope", async () => {
  for (const [name, newtons] of [["down", -20000], ["up", 10000]] as const) {
    const json = { ...loads(), name };
    json.loads[0].force.total_n.z = newtons;
    await part.setLoadCase(json);
  }
  assert.deepEqual(part.loadCases.map((one) => one.name), ["down", "up"]);
  const solved = await part.solve({ allLoadCases: true, elementOrder: 1 });
  const [down, up, worst] = await part.waitFields({ solve: solved.solve });
  assert.deepEqual([down!.report?.loadCase, up!.report?.loadCase, worst!.envelope?.loadCases], ["down", "up", ["down", "up"]]);
  const [a, b, c] = [down!, up!, worst!].map((field) => field.arrays.f32("von_mises_pa"));
  assert.ok(c!.every((value, i) => Math.abs(value - Math.max(a![i]!, b![i]!)) <= 1e-6 * value));
});

test("questions", async () => {
  assert.deepEqual((await part.select("hole", [92]))[0]?.surfaces, [92n, 93n]);
  assert.equal((await part.select("holes", [], { minDiameterM: 0.022, maxDiameterM: 0.03 })).length, 4);
  const cut = await part.section([0.4, 0.2, 0], [1, 0, 0]);
  assert.ok(cut.arrays.f32("positions").every((value, i) => i % 3 !== 0 || Math.abs(value - 0.4) < 1e-6));
  await part.edit("fill_hole", [1, 2]);
  const { message, arrays } = await part.compare(0, 1);
  assert.deepEqual(arrays.names, []);
  assert.ok(message.surfaces.some((one) => one.id === 1n && one.where === tedit.v1.VersionsCompared_Where.ONLY_BEFORE));
  await part.annotate(1, "one hole less");
  const history = await part.history(true);
  assert.deepEqual([history.head, history.versions[1]?.name, history.versions[1]?.report?.operation], [1, "one hole less", "fill_hole"]);
  assert.equal((await part.goTo(0)).cause, "goto");
});

test("what hinders printing", async () => {
  const { message, arrays } = await part.checkPrint({ thinnerThanM: 5e-3 });
  assert.deepEqual([message.versionId, message.openEdges, message.bodies], [part.head?.versionId, 0n, 1n]);
  assert.equal(arrays.u8("marks").length, arrays.u32("facets").length);
  const ceilings = (await part.checkPrint({ overhangRad: 1.57, direction: [0, 0, -1], version: 0 })).message;
  assert.deepEqual([ceilings.version, ceilings.overhangRad, ceilings.direction?.z], [0, 1.57, -1]);
  await assert.rejects(part.checkPrint({ overhangRad: 2 }), tedit.InvalidArgument);
  await assert.rejects(part.checkPrint({ version: 7 }), tedit.NotFound);
});

test("the difference of fields", async () => {
  await part.setLoadCase(loads());
  await part.solve({ elementOrder: 1 });
  await part.edit("fill_hole", [1, 2]);
  await part.waitField();
  const { message, arrays } = await part.compare(0, 1, loadCase);
  assert.equal(message.fields[0]?.loadCase, loadCase);
  const rows = arrays.u32("vertices").length;
  assert.equal(arrays.u8("difference_mark").length, rows);
  assert.equal(arrays.f32("displacement_m_difference").length, 3 * rows);
});

test("a CAD file becomes a document", { skip: noCad }, async () => {
  const step = new Uint8Array(readFileSync(join(source, "tests/data/cad/inch_block.stp")));
  const made = await client.importPart(step, "block", { fileName: "inch_block.stp", fineness: "coarse" });
  assert.deepEqual(made, { document: "block", warnings: [] });
  const block = await client.open("block");
  assert.equal(block.head?.cad?.status, tedit.v1.CadState_Status.SAME);
  await assert.rejects(client.importPart(new Uint8Array([1, 2, 3]), "none", { fileName: "odd.step" }), (e) => e instanceof tedit.TeditError && e.where === "odd.step");
  await assert.rejects(client.importPart(step, "none", { localSizes: { Bore: 1e-3 } }), tedit.TeditError);
});

test("files and documents", async () => {
  const whole = await part.export("tedit");
  assert.equal(await client.addDocument(whole, part.name, { orNextFree: true }), `${part.name}-2`);
  const again = await client.open(`${part.name}-2`);
  assert.equal(again.head?.versionId, part.head?.versionId);
  await again.importMesh(await part.export("msh"), { fileName: "again.msh" });
  assert.deepEqual([again.head?.number, again.head?.tets], [1, part.head?.tets]);
  await client.copyDocument(again.name, "copy");
  await assert.rejects(client.copyDocument(again.name, "copy"), tedit.Conflict);
  const names = async () => (await client.documents()).map((one) => one.name);
  assert.ok((await names()).includes("copy") && (await names()).includes(again.name));
  await client.deleteDocument("copy");
  await client.deleteDocument(again.name);
  assert.ok(!(await names()).includes("copy") && !(await names()).includes(again.name));
  await assert.rejects(again.undo(), tedit.Cancelled);
  await assert.rejects(part.export("docx"), tedit.InvalidArgument);
});

test("refusals are typed", async () => {
  await assert.rejects(part.edit("fill_hole", [98]), tedit.NotAHole);
  await assert.rejects(part.edit("fill_hole", [123456]), tedit.SurfaceNotFound);
  await assert.rejects(part.edit("fold", [1]), tedit.OperationNotFound);
  await assert.rejects(part.edit("fill_hole", [1, 2], { no_such: 1.5 }), tedit.InvalidParameter);
  await assert.rejects(part.goTo(7), tedit.NotFound);
  await assert.rejects(part.setLoadCase({ no: "load case" }), tedit.InvalidArgument);
  await assert.rejects(client.open("../elsewhere"), tedit.InvalidArgument);
});

test("a conflict names the rival", async () => {
  const bench = await server.connect({ name: "bench" });
  const expectedVersion = part.head!.versionId;
  await (await bench.open(part.name)).edit("fill_hole", [1, 2]);
  await assert.rejects(part.edit("fill_hole", [92, 93], {}, { expectedVersion }), (e) => e instanceof tedit.Conflict && e.rival?.client === "bench");
  bench.close();
});

test("an edit elsewhere is carried over, and who is there is known", async () => {
  const came = new Promise<string>((known) =>
    part.on("participantChanged", ({ message }) => !message.gone && known(message.participant!.client)),
  );
  const bench = await server.connect({ name: "bench" });
  const expectedVersion = part.head!.versionId;
  const theirs = await bench.open(part.name);
  assert.equal(await came, "bench");
  assert.equal(theirs.participants.at(-1)!.id, theirs.participant);
  await theirs.edit("fill_hole", [1, 2]);
  const made = await part.edit("fill_hole", [92, 93], {}, { expectedVersion, carryOver: true });
  assert.match(made.report!.notices.join(), /carried over/);
  assert.equal((await part.history()).versions[1]!.madeBy, "bench");
  bench.close();
});

test("an edit that is asked twice is made once", async () => {
  const first = await part.edit("fill_hole", [1, 2], {}, { editId: "the-edit" });
  const second = await part.edit("fill_hole", [1, 2], {}, { editId: "the-edit" });
  assert.deepEqual([first.repeated, second.repeated, second.head?.versionId], [false, true, first.head?.versionId]);
  assert.equal((await part.history()).versions.length, 2);
});

test("a cancelled call ends here and there, and progress comes", async () => {
  await part.setLoadCase(loads());
  const stop = new AbortController();
  const off = part.on("solveStatus", () => stop.abort());
  await assert.rejects(part.solve({ tolerance: 1e-12 }, { signal: stop.signal }), tedit.Cancelled);
  off();
  await assert.rejects(part.solve({}, { signal: stop.signal }), tedit.Cancelled);
  const fractions: number[] = [];
  await part.solve({}, { onProgress: (fraction) => fractions.push(fraction) });
  assert.ok(fractions.length > 0 && fractions.every((one) => one >= 0 && one <= 1));
});

test("faults of listeners are theirs", async (context) => {
  const reported = context.mock.method(console, "error", () => {});
  const fail = () => {
    throw new Error("of the listener");
  };
  part.on("solved", fail);
  await part.setLoadCase(loads());
  await part.solve({ elementOrder: 1 }, { onProgress: fail });
  assert.equal((await part.history()).head, 0);
  assert.ok(reported.mock.callCount() >= 2);
});

test("others' changes are heard, and the document's end", async () => {
  const events = part.events();
  const other = await server.connect();
  const theirs = await other.open(part.name, { surface: false, fields: false });
  await theirs.edit("fill_hole", [92, 93]);
  assert.equal((await next(events, "committed")).message.cause, "edit");
  assert.equal((await next(events, "surface")).surface.versionId, part.head?.versionId);
  await theirs.setLoadCase(loads());
  assert.equal((await next(events, "loadCasesChanged")).message.loadCases[0]?.name, loadCase);
  await theirs.rename("ours");
  await next(events, "documentRenamed");
  await part.removeLoadCase(loadCase); // By the new name.
  other.close();
  const mine = await client.open("mine");
  const last = mine.events();
  await mine.close();
  assert.ok((await next(last, "lost")).reason instanceof tedit.Cancelled);
  assert.equal((await last.next()).done, true);
  await assert.rejects(mine.undo(), tedit.Cancelled);
});

test("an edit whose answer was lost is made once", async (context) => {
  const [line, shaky] = await connectShaky(context);
  const seen = part.events();
  const mine = await shaky.open(part.name);
  line.mute = true;
  const answer = mine.edit("fill_hole", [1, 2]);
  await next(seen, "committed"); // It was made; its answer was lost.
  line.cut();
  assert.equal((await answer).repeated, true);
  assert.equal((await mine.history()).versions.length, 2);
  assert.deepEqual([mine.head?.number, (await mine.waitSurface()).versionId], [1, part.head?.versionId]);
});

test("a document that was deleted meanwhile is no new one", async (context) => {
  const [line, shaky] = await connectShaky(context, { reconnectMs: 120_000 });
  const mine = await shaky.open("doomed");
  await mine.importMesh(plate);
  const events = mine.events();
  line.shut = true;
  line.cut();
  while ((await client.documents()).some((one) => one.name === "doomed"))
    await client.deleteDocument("doomed").catch((problem: unknown) => assert.ok(problem instanceof tedit.Conflict)); // Not seen yet that the line is cut.
  line.shut = false;
  for (let lost = await next(events, "lost"); ; lost = await next(events, "lost"))
    if (lost.forGood) {
      assert.ok(lost.reason instanceof tedit.NotFound, lost.reason.message);
      break;
    }
  await assert.rejects(mine.undo(), tedit.NotFound);
  // It was opened to see that, and is gone when the server closes what nobody has open; there is no file.
  const left = (await client.documents()).filter((one) => one.name === "doomed");
  assert.deepEqual(left.map((one) => [one.clients, one.bytes, one.versions]), [[0, 0n, 0]]);
});

test("a line that is silent without a word is found out", async (context) => {
  const [line, shaky] = await connectShaky(context, { silenceMs: 500 });
  const mine = await shaky.open(part.name);
  const events = mine.events();
  line.mute = true;
  assert.match((await next(events, "lost")).reason.message, /has not answered/);
  line.mute = false;
  await next(events, "reconnected");
  assert.equal((await mine.history()).head, 0);
});

test("a client that is closed while it connects again is gone", async (context) => {
  for (let step = 0; step < 12; ++step) {
    const [line, shaky] = await connectShaky(context);
    const mine = await shaky.open(part.name);
    const events = mine.events();
    line.cut();
    await next(events, "lost");
    const asked = mine.history().catch((problem: unknown) => problem);
    await new Promise((go) => setTimeout(go, 12 * step)); // Before, while and after it is connected.
    shaky.close();
    const answer = await asked;
    assert.ok(answer instanceof tedit.ConnectionLost || "versions" in (answer as object), String(answer));
    for (;;) {
      const { done, value } = await events.next();
      if (done) break;
      assert.notEqual(value.type, "committed");
    }
  }
  while ((await client.status()).connections > 1) await new Promise((go) => setTimeout(go, 20));
});

test("without reconnecting the loss is told", async (context) => {
  const [line, shaky] = await connectShaky(context, { reconnectMs: 0 });
  const mine = await shaky.open(part.name);
  const events = mine.events();
  line.cut();
  assert.equal((await next(events, "lost")).forGood, true);
  await assert.rejects(mine.undo(), tedit.ConnectionLost);
});
