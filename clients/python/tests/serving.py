# SPDX-License-Identifier: AGPL-3.0-or-later
"""A real server for tests, and a line to it that can be cut. TEDIT_PROGRAM names the program, TEDIT_SOURCE the sources."""
from __future__ import annotations

import json
import os
import pathlib
import signal
import socket
import subprocess
import tempfile
import threading
import time

import tedit

PROGRAM = os.environ["TEDIT_PROGRAM"]
SOURCE = pathlib.Path(os.environ["TEDIT_SOURCE"])
PLATE = SOURCE / "examples/ctc01_plate"
MESH = PLATE / "ctc01_plate.coarse.msh"
LOADS = PLATE / "load_case.json"
LOAD_CASE = "ctc01_plate static"
START_LIMIT_S = 60


class Server:
    """`tedit serve` in a folder of its own."""

    def __init__(self) -> None:
        self.folder = tempfile.TemporaryDirectory()
        self.environment = dict(os.environ)
        for variable in ("STATE", "CONFIG", "CACHE", "DATA"):
            self.environment[f"XDG_{variable}_HOME"] = self.folder.name
        self.environment["TEDIT_CAD_PRIORITY"] = "normal"  # The machine is never idle while tests run.
        self.start(port=0)

    def start(self, port: int) -> None:
        ready = pathlib.Path(self.folder.name) / "ready.json"
        ready.unlink(missing_ok=True)
        command = [PROGRAM, "serve", "--port", str(port), "--ready-file", str(ready)]
        self.process = subprocess.Popen(command, env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        until = time.monotonic() + START_LIMIT_S
        while not ready.exists():
            if self.process.poll() is not None or time.monotonic() > until:
                raise RuntimeError(f"{PROGRAM} serve did not start")
            time.sleep(0.02)
        state = json.loads(ready.read_text())
        self.url, self.port = state["url"], int(state["url"].split(":")[2].split("/")[0])
        self.token = tedit.read_token(state["token_file"])

    def connect(self, **options) -> tedit.Client:
        return tedit.connect(self.url, self.token, **options)

    def kill(self) -> None:
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()

    def stop(self) -> None:
        self.process.terminate()
        self.process.wait()
        self.folder.cleanup()


class Line:
    """A TCP line to a server. While it is `mute`, the server hears the client and the client hears nothing; while it is
    `shut`, nobody connects."""

    def __init__(self, port: int) -> None:
        self._server_port = port
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._port = self._listener.getsockname()[1]
        self._ends: list[socket.socket] = []
        self._broken: set[socket.socket] = set()
        self.mute = False
        self.shut = False
        self.url = f"ws://127.0.0.1:{self._port}/v1"
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        while True:
            try:
                near = self._listener.accept()[0]
            except OSError:
                return
            if self.shut:
                near.close()
                continue
            try:
                self._join(near)
            except OSError:  # The server is not there.
                near.close()

    def _join(self, near: socket.socket) -> None:
        far = socket.create_connection(("127.0.0.1", self._server_port))
        self._ends += [near, far]
        # A server lets nobody in who asks for another host.
        far.sendall(near.recv(65536).replace(b":%d" % self._port, b":%d" % self._server_port))
        threading.Thread(target=self._pump, args=(near, far, False), daemon=True).start()
        threading.Thread(target=self._pump, args=(far, near, True), daemon=True).start()

    def _pump(self, source: socket.socket, target: socket.socket, may_be_mute: bool) -> None:
        try:
            while data := source.recv(65536):
                if not (may_be_mute and self.mute) and target not in self._broken:
                    target.sendall(data)
            target.shutdown(socket.SHUT_WR)
        except OSError:
            pass

    def cut(self) -> None:
        """What is connected now breaks, without another word; who connects from now on is heard."""
        ends, self._ends = self._ends, []
        self._broken.update(ends)
        self.mute = False
        for end in ends:
            try:
                end.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass
            end.close()

    def close(self) -> None:
        self._listener.close()
        self.cut()
