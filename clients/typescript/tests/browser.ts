// SPDX-License-Identifier: AGPL-3.0-or-later
// Headless Chromium, driven over its DevTools protocol, and a web server for its pages.
import { spawn, type ChildProcess } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer, type Server as HttpServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join, normalize } from "node:path";
import { createInterface } from "node:readline";
import { WebSocket } from "ws";

export const chromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);

const types: Record<string, string> = { ".html": "text/html", ".js": "text/javascript", ".json": "application/json" };

/** Serves folders by the first part of the path: { "/app": "/home/..." }. */
export class Pages {
  private constructor(
    private readonly server: HttpServer,
    readonly origin: string,
  ) {}

  static async start(folders: Readonly<Record<string, string>>): Promise<Pages> {
    const server = createServer((asked, answer) => {
      const [, first, ...rest] = normalize(new URL(asked.url!, "http://x").pathname).split("/");
      const folder = folders[`/${first}`];
      const file = folder && join(folder, ...rest);
      if (!file || !existsSync(file)) return answer.writeHead(404).end();
      answer.writeHead(200, { "Content-Type": types[extname(file)] ?? "application/octet-stream" }).end(readFileSync(file));
    });
    await new Promise<void>((go) => server.listen(0, "127.0.0.1", go));
    return new Pages(server, `http://127.0.0.1:${(server.address() as { port: number }).port}`);
  }

  stop(): void {
    this.server.close();
    this.server.closeAllConnections();
  }
}

interface Reply {
  id?: number;
  result?: unknown;
  error?: { message: string };
}

export class Browser {
  private readonly folder = mkdtempSync(join(tmpdir(), "tedit-chromium-"));
  private process!: ChildProcess;
  private socket!: WebSocket;
  private lastId = 0;
  private readonly waiting = new Map<number, (reply: Reply) => void>();

  static async start(): Promise<Browser> {
    const browser = new Browser();
    await browser.run();
    return browser;
  }

  private async run(): Promise<void> {
    const flags = ["--headless=new", "--no-sandbox", "--disable-gpu-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
      "--disable-dev-shm-usage", "--no-first-run", "--remote-debugging-port=0", `--user-data-dir=${this.folder}`, "about:blank"];
    this.process = spawn(chromium!, flags, { stdio: ["ignore", "ignore", "pipe"], detached: true });
    const said: string[] = [];
    const url = await new Promise<string>((resolve, reject) => {
      this.process.once("exit", () => reject(new Error(`Chromium ended: ${said.join("\n")}`)));
      createInterface({ input: this.process.stderr! }).on("line", (line) => {
        said.push(line);
        const found = /^DevTools listening on (ws:\S+)/.exec(line);
        if (found) resolve(found[1]!);
      });
    });
    this.socket = new WebSocket(url, { perMessageDeflate: false, maxPayload: 1 << 28 });
    this.socket.on("message", (data) => {
      const reply = JSON.parse(String(data)) as Reply;
      this.waiting.get(reply.id ?? 0)?.(reply);
    });
    await new Promise((go) => this.socket.once("open", go));
  }

  private async ask<T>(method: string, params: object, sessionId?: string): Promise<T> {
    const id = ++this.lastId;
    const reply = await new Promise<Reply>((resolve) => {
      this.waiting.set(id, resolve);
      this.socket.send(JSON.stringify({ id, method, params, sessionId }));
    });
    this.waiting.delete(id);
    if (reply.error) throw new Error(`${method}: ${reply.error.message}`);
    return reply.result as T;
  }

  /** Opens a page, and gives what the promise becomes that `expression` makes there once it is loaded. */
  async visit(url: string, expression: string, pictureFile?: string): Promise<unknown> {
    const { targetId } = await this.ask<{ targetId: string }>("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await this.ask<{ sessionId: string }>("Target.attachToTarget", { targetId, flatten: true });
    await this.ask("Page.enable", {}, sessionId);
    await this.ask("Page.navigate", { url }, sessionId);
    const loaded = "new Promise((go) => (document.readyState === 'complete' ? go() : addEventListener('load', go)))";
    const told = await this.ask<{ result: { value: unknown }; exceptionDetails?: { text: string; exception?: { description?: string } } }>(
      "Runtime.evaluate", { expression: `${loaded}.then(() => ${expression})`, awaitPromise: true, returnByValue: true }, sessionId);
    if (told.exceptionDetails) throw new Error(told.exceptionDetails.exception?.description ?? told.exceptionDetails.text);
    if (pictureFile) {
      const { data } = await this.ask<{ data: string }>("Page.captureScreenshot", { format: "png" }, sessionId);
      writeFileSync(pictureFile, Buffer.from(data, "base64"));
    }
    await this.ask("Target.closeTarget", { targetId });
    return told.result.value;
  }

  async stop(): Promise<void> {
    const gone = new Promise((end) => this.process.once("exit", end));
    this.socket.close();
    process.kill(-this.process.pid!, "SIGKILL"); // Its helpers, too.
    await gone;
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 20 });
  }
}
