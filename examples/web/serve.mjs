// SPDX-License-Identifier: AGPL-3.0-or-later
// Serves this folder's page at http://127.0.0.1:5173. The TEdit server must let that origin in: in its configuration
//   [server]
//   allowed_origins = ["http://127.0.0.1:5173"]
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { dirname, extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const types = { ".html": "text/html", ".js": "text/javascript", ".json": "application/json" };

function fileOf(path) {
  const clean = normalize(path === "/" ? "/index.html" : path); // Leads nowhere above.
  return clean.startsWith("/plate/") ? join(here, "../ctc01_plate", clean.slice(7)) : join(here, clean);
}

createServer(async (asked, answer) => {
  const file = fileOf(decodeURIComponent(new URL(asked.url, "http://x").pathname));
  const data = await readFile(file).catch(() => undefined);
  answer.writeHead(data ? 200 : 404, { "Content-Type": types[extname(file)] ?? "application/octet-stream" }).end(data);
}).listen(5173, "127.0.0.1", () => console.log("http://127.0.0.1:5173"));
