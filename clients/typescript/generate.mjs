// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes the messages of the protocol, src/gen, from its .proto files. usage: node generate.mjs PROTOCOL
// PROTOCOL is the folder that has tedit/v1/*.proto. Needs protoc (Debian: protobuf-compiler).
import { execFileSync } from "node:child_process";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const protocol = process.argv[2];
const made = join(here, "src/gen");

const files = readdirSync(join(protocol, "tedit/v1"))
  .filter((name) => name.endsWith(".proto"))
  .map((name) => `tedit/v1/${name}`)
  .sort();
mkdirSync(made, { recursive: true });
execFileSync(
  "protoc",
  ["-I", protocol, `--plugin=protoc-gen-es=${join(here, "node_modules/.bin/protoc-gen-es")}`, `--es_out=${made}`,
    "--es_opt=target=ts,import_extension=js", ...files],
  { stdio: "inherit" },
);

// What a client says in Hello, as the comments of its fields have it.
const text = readFileSync(join(protocol, "tedit/v1/envelope.proto"), "utf8");
const [major, minor] = ["major", "minor"].map((part) => text.match(`uint32 protocol_${part} = \\d+;\\s*// (\\d+)\\.`)?.[1]);
if (!major || !minor) throw new Error("envelope.proto does not say the protocol's version beside Hello.protocol_major and protocol_minor");
writeFileSync(join(made, "version.ts"), `export const protocolMajor = ${major};\nexport const protocolMinor = ${minor};\n`);
