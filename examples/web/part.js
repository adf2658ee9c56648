// SPDX-License-Identifier: AGPL-3.0-or-later
// Opens the shipped plate on a server, shows its stress, and closes holes; what others do with the document is seen, too.
import { connect } from "@tedit/client";
import { COLOURS, View } from "./view.js";

const element = (id) => document.getElementById(id);
const view = new View(element("view"));
let part;

function say(text) {
  element("said").value = text;
}

/** Runs what a person asked for; a refusal is said. */
async function attempt(what, work) {
  say(`${what} ...`);
  try {
    await work();
  } catch (problem) {
    say(problem.message);
  }
}

async function open(url, token) {
  const server = await connect(url, token, { name: "examples/web" });
  part = await server.open();
  part.on("surface", ({ surface }) => view.show(surface.mesh));
  part.on("field", ({ field }) => showStress(field));
  part.on("lost", ({ reason }) => say(reason.message));
  const mesh = await fetch("plate/ctc01_plate.coarse.msh");
  await part.importMesh(new Uint8Array(await mesh.arrayBuffer()), { fileName: "ctc01_plate.coarse.msh" });
  await part.setLoadCase(await (await fetch("plate/load_case.json")).json());
  await offerEdits();
  await part.solve();
  await part.waitField();
}

function showStress(field) {
  if (field.versionId !== part.surface.versionId) return; // The surface has gone on: its field follows.
  const stress = field.on(part.surface.mesh, "von_mises_pa");
  const sorted = Float32Array.from(stress).sort();
  const most = sorted[Math.floor(0.99 * sorted.length)]; // The rest is the last colour: few points are worth no scale.
  view.colour(stress, most);
  element("legend").hidden = false;
  element("least").textContent = "0";
  element("most").textContent = `≥ ${(most / 1e6).toFixed(2)} MPa`;
  const largest = `${(sorted.at(-1) / 1e6).toFixed(2)} MPa at most`;
  say(`Version ${part.head.number}: von Mises stress, ${largest}${field.interim ? ", a first estimate" : ""}`);
}

function button(text, work) {
  const made = document.createElement("button");
  made.textContent = text;
  made.addEventListener("click", () => attempt(text, work));
  return made;
}

async function offerEdits() {
  const holes = await part.select("holes", [], { minDiameterM: 0.022, maxDiameterM: 0.03 });
  element("edits").replaceChildren(
    ...holes.map((hole) => button(`Close the hole at x = ${(hole.centreM.x * 1e3).toFixed(0)} mm`, () => part.edit("fill_hole", hole.surfaces))),
    button("Undo", () => part.undo()),
  );
}

element("legend").firstElementChild.style.background = `linear-gradient(to right, ${COLOURS.map((one) => `rgb(${one})`)})`;
element("connect").addEventListener("submit", (event) => {
  event.preventDefault();
  void attempt("Opening", () => open(element("url").value, element("token").value.trim()));
});
