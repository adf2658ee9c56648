// SPDX-License-Identifier: AGPL-3.0-or-later
// The package in headless Chromium against a real server, which lets in pages of one origin.
import assert from "node:assert/strict";
import { cpSync, mkdirSync, mkdtempSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { Browser, chromium, Pages } from "./browser.js";
import { Server, source } from "./serving.js";

const missing = chromium ? false : "Chromium is not installed";
const root = join(dirname(fileURLToPath(import.meta.url)), "../.."); // Of the package: this file is dist-tests/tests/...
let browser: Browser;
let own: Pages;
let foreign: Pages;
let server: Server;
let web = "";

/** A folder with examples/web as it is after `npm install`. */
function webExample(): string {
  web = mkdtempSync(join(tmpdir(), "tedit-web-"));
  cpSync(join(source, "examples/web"), web, { recursive: true });
  mkdirSync(join(web, "node_modules/@tedit"), { recursive: true });
  symlinkSync(root, join(web, "node_modules/@tedit/client"));
  symlinkSync(join(root, "node_modules/@bufbuild"), join(web, "node_modules/@bufbuild"));
  symlinkSync(join(source, "examples/ctc01_plate"), join(web, "plate"));
  return web;
}

before(async () => {
  if (missing) return;
  const folders = {
    "/tests": join(root, "tests"),
    "/built": join(root, "dist-tests"),
    "/modules": join(root, "node_modules"),
    "/plate": join(source, "examples/ctc01_plate"),
    "/web": webExample(),
  };
  [own, foreign, browser] = await Promise.all([Pages.start(folders), Pages.start(folders), Browser.start()]);
  server = await Server.start(`[server]\nallowed_origins = ["${own.origin}"]\n`);
});
after(async () => {
  if (missing) return;
  await browser.stop();
  own.stop();
  foreign.stop();
  rmSync(web, { recursive: true });
  await server.stop();
});

const fragment = () => `#${encodeURIComponent(JSON.stringify([server.url, server.token]))}`;

test("a page opens a part, edits it and has its surface and field", { skip: missing }, async () => {
  const result = await browser.visit(`${own.origin}/tests/page.html${fragment()}`, "window.result");
  const { megapascal, facetsTold, ...rest } = result as { megapascal: number; facetsTold: number };
  assert.deepEqual(rest, { isBrowser: true, facetsBefore: 8398, facetsAfter: facetsTold, fieldIsHeads: true, refused: true });
  assert.ok(Math.abs(megapascal - 13.4498) < 5e-3, `${megapascal} MPa`);
});

test("a page of another origin does not come in", { skip: missing }, async () => {
  const result = await browser.visit(`${foreign.origin}/tests/page.html${fragment()}`, "window.result");
  assert.match((result as { problem: string }).problem, /ConnectionLost: there is no server at .* does not let this page in/);
});

/** What a person does on the page of examples/web: connects, waits for the stress, closes the first hole, waits again. */
const workOnExample = `(async () => {
  const until = async (said) => { while (!said.test(document.getElementById("said").value)) await new Promise((go) => setTimeout(go, 20)); };
  const [url, token] = JSON.parse(decodeURIComponent(location.hash.slice(1)));
  document.getElementById("url").value = url;
  document.getElementById("token").value = token;
  document.querySelector("form button").click();
  await until(/^Version 0: von Mises stress, 13\\.4\\d MPa at most$/);
  const buttons = [...document.querySelectorAll("#edits button")];
  buttons[0].click();
  await until(/^Version 1: von Mises stress, 13\\.4\\d MPa at most$/);
  const gl = document.getElementById("view").getContext("webgl2");
  const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let drawn = 0, coloured = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    drawn += pixels[i + 3] === 255 ? 1 : 0;
    coloured += pixels[i + 3] === 255 && Math.abs(pixels[i] - pixels[i + 2]) > 20 ? 1 : 0;
  }
  return { buttons: buttons.length, most: document.getElementById("most").textContent, drawn: drawn / (pixels.length / 4), coloured: coloured / drawn };
})()`;

test("the example shows a part by its stress and edits it", { skip: missing }, async () => {
  const seen = (await browser.visit(`${own.origin}/web/index.html${fragment()}`, workOnExample, process.env["TEDIT_PICTURE"])) as Record<string, number>;
  assert.equal(seen["buttons"], 5);
  assert.match(String(seen["most"]), /^≥ \d\.\d\d MPa$/);
  assert.ok(seen["drawn"]! > 0.1 && seen["coloured"]! > 0.5, JSON.stringify(seen));
});
