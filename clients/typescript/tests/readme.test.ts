// SPDX-License-Identifier: AGPL-3.0-or-later
// The beginnings of the README and of docs/integrate.md, as they stand there.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { Server, source } from "./serving.js";

const root = join(dirname(fileURLToPath(import.meta.url)), "../..");

/** What the page's program says. */
async function said(page: string): Promise<string> {
  const server = await Server.start();
  try {
    const program = /```js\n(.*?)```/s.exec(readFileSync(page, "utf8"))![1]!;
    assert.ok(program.includes("ws://127.0.0.1:7464/v1"));
    const file = join(root, "dist-tests/readme.mjs"); // Where "@tedit/client" is this package.
    writeFileSync(file, program.replace("ws://127.0.0.1:7464/v1", server.url));
    const env = { ...process.env, HOME: server.home, XDG_STATE_HOME: undefined };
    const { stdout, stderr } = await promisify(execFile)(process.execPath, [file], { cwd: source, env, timeout: 240_000 });
    assert.equal(stderr, "");
    return stdout;
  } finally {
    await server.stop();
  }
}

test("the README", async () => {
  const text = await said(join(root, "README.md"));
  assert.equal(text.match(/^without the hole at .* m: 13\.4\d MPa/gm)?.length, 4, text);
  assert.match(text, /^8398 triangles; 13\.4\d MPa$/m);
});

test("the integrators' manual", async () => {
  assert.match(await said(join(source, "docs/integrate.md")), /^13\.447\d* MPa\n13\.449\d* MPa\n$/);
});
