// SPDX-License-Identifier: AGPL-3.0-or-later
// A real server for tests, and a line to it that can be cut. TEDIT_PROGRAM names the program, TEDIT_SOURCE the sources.
import { spawn, type ChildProcess } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { connect as dial, createServer, type Server as TcpServer, type Socket } from "node:net";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { connect, type Client } from "../src/index.js";
import type { ConnectOptions } from "../src/client.js";

export const source = process.env["TEDIT_SOURCE"]!;
export const plate = new Uint8Array(readFileSync(join(source, "examples/ctc01_plate/ctc01_plate.coarse.msh")));
export const loads = () => JSON.parse(readFileSync(join(source, "examples/ctc01_plate/load_case.json"), "utf8"));
export const loadCase = "ctc01_plate static";
/** Why tests with CAD files are left out; false: they are not. */
export const noCad = existsSync(join(dirname(process.env["TEDIT_PROGRAM"]!), "tedit-cad-mesher")) ? false : "this build has no OpenCASCADE";
const startLimitMs = 60_000;

/** `tedit serve` of a user of its own. */
export class Server {
  readonly home = mkdtempSync(join(tmpdir(), "tedit-ts-"));
  url = "";
  token = "";
  private process!: ChildProcess;

  /** `config`: lines of TOML. */
  static async start(config = ""): Promise<Server> {
    const server = new Server();
    if (config) writeFileSync(join(server.home, "config.toml"), config);
    await server.run(config !== "");
    return server;
  }

  private async run(configured: boolean): Promise<void> {
    const ready = join(this.home, "ready.json");
    const env: NodeJS.ProcessEnv = { ...process.env, HOME: this.home };
    for (const kind of ["STATE", "CONFIG", "CACHE", "DATA"]) delete env[`XDG_${kind}_HOME`];
    const config = configured ? ["--config", join(this.home, "config.toml")] : [];
    this.process = spawn(process.env["TEDIT_PROGRAM"]!, ["serve", "--port", "0", "--ready-file", ready, ...config], { env, stdio: "ignore" });
    const until = Date.now() + startLimitMs;
    while (!existsSync(ready)) {
      if (this.process.exitCode !== null || Date.now() > until) throw new Error("tedit serve did not start");
      await new Promise((go) => setTimeout(go, 20));
    }
    const state = JSON.parse(readFileSync(ready, "utf8"));
    this.url = state.url;
    this.token = readFileSync(state.token_file, "utf8").trim();
  }

  get port(): number {
    return Number(new URL(this.url).port);
  }

  connect(options: ConnectOptions = {}): Promise<Client> {
    return connect(this.url, this.token, options);
  }

  async stop(): Promise<void> {
    const gone = new Promise((end) => this.process.once("exit", end));
    this.process.kill();
    await gone;
    rmSync(this.home, { recursive: true });
  }
}

/**
 * A TCP line to a server. While it is `mute`, the server hears the client and the client hears nothing; while it is
 * `shut`, nobody connects.
 */
export class Line {
  mute = false;
  shut = false;
  url = "";
  private listener!: TcpServer;
  private readonly ends = new Set<Socket>();

  static async to(port: number): Promise<Line> {
    const line = new Line();
    line.listener = createServer((near) => (line.shut ? near.destroy() : line.join(near, port)));
    await new Promise<void>((go) => line.listener.listen(0, "127.0.0.1", go));
    line.url = `ws://127.0.0.1:${line.port}/v1`;
    return line;
  }

  private get port(): number {
    return (this.listener.address() as { port: number }).port;
  }

  private join(near: Socket, port: number): void {
    const far = dial(port, "127.0.0.1");
    for (const end of [near, far]) {
      this.ends.add(end);
      end.on("error", () => {});
    }
    // A server lets nobody in who asks for another host.
    near.once("data", (header) => {
      far.write(header.toString("latin1").replace(`:${this.port}`, `:${port}`), "latin1");
      near.on("data", (data) => far.write(data));
    });
    far.on("data", (data) => this.mute || near.write(data));
    near.on("close", () => far.destroy());
    far.on("close", () => near.destroy());
  }

  /** What is connected now breaks; who connects from now on is heard. */
  cut(): void {
    this.mute = false;
    for (const end of this.ends) end.destroy();
    this.ends.clear();
  }

  close(): void {
    this.listener.close();
    this.cut();
  }
}
