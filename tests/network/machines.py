#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A server and its workers on machines of their own, with a bad network between them.

usage: tests/network/machines.py [--program build/release/bin/tedit] [--mesh MESH] [--edits 6] [--only NAME,...] [--partition 60]
                                 [--kills 0] [--cold]
       as root; PYTHONPATH must have the package tedit (build/release/clients/python).

Machines: hall (server, client), rack-1 and rack-2 (a solver each), desk (a modeling worker), bench (an optimizer). Under each condition the
same edits are made, undone and solved; each version and each largest stress must be those of a good network, and the document
must have each edit once. Printed: times from an edit to its answer and to its field, and for faults how long they were noticed and
restored. With --kills instead: so many workers of each role (of those in --only) are killed, each at a random moment of an edit and its
solve. With --cold instead: solves of parts that no solver has ever seen, over 1 Gbit/s and the same line without a bound.
"""
import argparse
import os
import pathlib
import random
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time

import bad_wire

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PLATE = ROOT / "examples/ctc01_plate"
WORKERS = {"rack-1": "solver", "rack-2": "solver", "desk": "modeling", "bench": "optimizer"}


class Hall:
    """The server with its workers, and one client who edits."""

    def __init__(self, wire, arguments, folder):
        self.wire, self.program, self.folder = wire, str(arguments.program), folder
        self.mesh, self.edits = arguments.mesh, arguments.edits
        self.log = open(folder / "server.log", "w", encoding="utf-8")
        self.workers = {}
        self.certify()
        self.server = self.serve()
        for name in WORKERS:
            self.join(name)

    def run(self, *words):
        subprocess.run([self.program, "--quiet", *words], check=True, capture_output=True)

    def certify(self):
        ca = str(self.folder / "ca")
        self.run("certs", "init", ca)
        self.run("certs", "issue", ca, "--role", "server", "--name", "hall", "--host", self.wire["hall"].address, "-o",
                 str(self.folder / "hall"))
        for name, role in WORKERS.items():
            self.run("certs", "issue", ca, "--role", role, "--name", name, "-o", str(self.folder / name))

    def serve(self):
        config = self.folder / "tedit.toml"
        config.write_text('[work]\nmodeling_workers = 0\noptimizer_workers = 0\nsolver_workers = 0\n', encoding="utf-8")
        ready = self.folder / "ready"
        server = self.wire.start("hall", [
            self.program, "serve", "--config", str(config), "--port", "0", "--documents", str(self.folder / "documents"),
            "--token-file", str(self.folder / "token"), "--node-certificates", str(self.folder / "hall"), "--node-address",
            self.wire["hall"].address, "--node-port", "7465", "--device", "cpu", "--ready-file", str(ready)],
            stdout=self.log, stderr=self.log)
        wait_until(ready.exists, 30)
        self.url = ready.read_text(encoding="utf-8").split('"url":"')[1].split('"')[0]
        return server

    def join(self, name):
        log = open(self.folder / f"{name}.log", "a", encoding="utf-8")
        self.workers[name] = self.wire.start(name, [
            self.program, "worker", "--join", f"{self.wire['hall'].address}:7465", "--role", WORKERS[name], "--certificates",
            str(self.folder / name)], stdout=log, stderr=log)

    def enter(self):
        import tedit

        self.wire.move_in("hall")
        self.client = tedit.connect(self.url, tedit.read_token(self.folder / "token"))
        self.watcher = tedit.connect(self.url, tedit.read_token(self.folder / "token"))
        wait_until(lambda: len(self.nodes()) == len(WORKERS), 30)

    def nodes(self):
        return {node.name: node.state for node in self.watcher.status().nodes if node.state != "lost"}

    def links(self):
        """The address that each worker is joined from: another one after each time that it joined."""
        return {node.name: node.address for node in self.watcher.status().nodes if node.state != "lost"}

    def open(self, name):
        part = self.client.open(name)
        part.import_mesh(self.mesh, unit="mm")
        part.set_load_case(PLATE / "load_case.json")
        part.solve()
        return part

    def processes_of(self, name):
        """Of a worker, its own process last."""
        listed = [self.workers[name].pid]
        for pid in listed:
            with open(f"/proc/{pid}/task/{pid}/children", encoding="ascii") as children:
                listed += [int(one) for one in children.read().split()]
        return listed

    def stop(self):
        for one in (self.client, self.watcher):
            one.close()
        for process in (*self.workers.values(), self.server):
            process.send_signal(signal.SIGTERM)
        for process in (*self.workers.values(), self.server):
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
        self.log.close()


def wait_until(there, seconds):
    end = time.monotonic() + seconds
    while not there():
        if time.monotonic() > end:
            raise TimeoutError(f"not within {seconds} s")
        time.sleep(0.02)
    return seconds - (end - time.monotonic())


def check_same(seen, expected):
    """The same version, and the largest stress to the tolerance of a solve: it begins with the last one's displacement."""
    if expected is not None and (seen[0] != expected[0] or abs(seen[1] / expected[1] - 1) > 1e-6):
        raise AssertionError(f"{seen} is not {expected}, as on a good network")


def make_edit(part, number):
    """Each number is another edit of the plate: a little more off its top."""
    part.edit("erode", [7], {"depth": 4e-4 + 2e-5 * number})


def edit_and_solve(part, number, expected):
    """An edit, its field and its undo: the times, and what came of it."""
    begin = time.monotonic()
    make_edit(part, number)
    edited = time.monotonic() - begin
    field = part.wait_field(timeout=300)
    solved = time.monotonic() - begin
    seen = (part.head.version_id, field.report.max_von_mises_pa)
    check_same(seen, expected)
    part.undo()
    return edited, solved, seen


def check_history(part, edits):
    """Each edit is there once."""
    made = [one for one in part.history().versions if one.operation == "erode"]
    if len(made) != edits:
        raise AssertionError(f"{len(made)} versions for {edits} edits")


def row(*cells):
    print("| " + " | ".join(str(one) for one in cells) + " |", flush=True)


def milliseconds(times):
    return f"{statistics.median(times) * 1e3:.0f} ({max(times) * 1e3:.0f})"


def measure(hall, name, results):
    part = hall.open(name.replace(" ", "-").replace(",", "").replace("%", "pct").replace("/", ""))
    before = {one: (hall.wire[one].sent, hall.wire[one].received) for one in WORKERS}
    edits, fields = [], []
    for number in range(hall.edits):
        edited, solved, results[number] = edit_and_solve(part, number, results.get(number))
        edits.append(edited)
        fields.append(solved)
    check_history(part, hall.edits)
    wire = hall.wire
    to_solvers = sum(wire[one].received - before[one][1] for one in ("rack-1", "rack-2")) / hall.edits / 1e6
    from_solvers = sum(wire[one].sent - before[one][0] for one in ("rack-1", "rack-2")) / hall.edits / 1e6
    row(name, milliseconds(edits), milliseconds(fields), f"{to_solvers:.2f}", f"{from_solvers:.2f}")
    part.close()


def conditions(hall, only):
    """Bad lines to all workers."""
    wire, results = hall.wire, {}
    lines = {
        "good": {},
        "300 ms there and back": {"delay_s": 0.15},
        "5 % loss": {"loss": 0.025},
        "300 ms, 5 % loss": {"delay_s": 0.15, "loss": 0.025},
        "10 Mbit/s": {"bytes_s": 1.25e6},
        "1 Mbit/s": {"bytes_s": 1.25e5},
    }
    print("\n| line to each worker | edit answered, ms (most) | its field, ms (most) | MB to solvers an edit | MB from them |")
    print("|---|---|---|---|---|")
    for name, how in lines.items():
        if only and name not in only and (name != "good" or only <= set(lines)):
            continue  # Faults are held against the good one.
        for worker in WORKERS:
            for what, value in how.items():
                setattr(wire[worker], what, value)
        measure(hall, name, results)
        wire.heal()
        wait_until(lambda: len(hall.nodes()) == len(WORKERS), 120)
    return results


def cut_line(hall, name):
    hall.wire[name].deaf = hall.wire[name].mute = True


def half_open(hall, name):
    hall.wire[name].mute = True


def kill(hall, name):
    os.kill(hall.processes_of(name)[-1], signal.SIGKILL)


def freeze(hall, name):
    os.kill(hall.processes_of(name)[-1], signal.SIGSTOP)


def thaw(hall, name):
    for pid in hall.processes_of(name):
        os.kill(pid, signal.SIGCONT)


def strike(hall, part, role, fault):
    """The fault comes as soon as a worker of the role works; then until it is out of the list of those who work."""
    struck = {}

    def watch():
        for _ in range(3000):
            for node, state in hall.nodes().items():
                if WORKERS[node] == role and state == "working":
                    fault(hall, node)
                    struck["node"], struck["at"] = node, time.monotonic()
                    wait_until(lambda: hall.nodes().get(node) != "working", 60)
                    struck["noticed"] = time.monotonic() - struck["at"]
                    return
            time.sleep(0.001)

    thread = threading.Thread(target=watch)
    thread.start()
    make_edit(part, 0)
    field = part.wait_field(timeout=300)
    struck["done"] = time.monotonic()
    thread.join()
    return struck, (part.head.version_id, field.report.max_von_mises_pa)


def faults(hall, results, only, partition):
    cases = [("a solver is killed", "solver", kill), ("a solver is frozen", "solver", freeze),
             ("a solver's line is cut", "solver", cut_line), ("a solver is heard no more", "solver", half_open),
             ("the modeling worker is killed", "modeling", kill)]
    print("\n| what happens while it works | noticed after, s | the field after, s | joined again after, s |")
    print("|---|---|---|---|")
    for name, role, fault in cases:
        if only and name not in only:
            continue
        part = hall.open(name.replace(" ", "-").replace("'", ""))
        struck, seen = strike(hall, part, role, fault)
        if "node" not in struck:
            row(name, "it was done before", "", "")
            continue
        check_same(seen, results[0])
        check_history(part, 1)
        away = partition if fault in (cut_line, half_open) else 0
        time.sleep(max(0.0, struck["at"] + away - time.monotonic()))
        healed = time.monotonic()
        hall.wire.heal()
        if fault is freeze:
            thaw(hall, struck["node"])
        wait_until(lambda: len(hall.nodes()) == len(WORKERS), 120)
        row(name + (f", for {away} s" if away else ""), f"{struck.get('noticed', 0):.2f}", f"{struck['done'] - struck['at']:.2f}",
            f"{time.monotonic() - healed:.1f}")
        part.close()


def fresh_field(part, after):
    """The final field of the head, of a solve later than `after`."""
    end = time.monotonic() + 120
    while time.monotonic() < end:
        field = part.wait_field(timeout=120)
        if field.message.solve > after:
            return field
        time.sleep(0.005)
    raise TimeoutError("no field of the head")


def one_kill(hall, part, number, role, calm, last):
    """A worker of the role is killed within the time that an edit and its solve take: whether it worked, and what came of it."""
    of_role = [name for name in WORKERS if WORKERS[name] == role]
    failed = []

    def edit():
        try:
            make_edit(part, number)
        except Exception as e:  # pylint: disable=broad-except
            failed.append(e)

    thread = threading.Thread(target=edit)
    begin = time.monotonic()
    thread.start()
    time.sleep(random.uniform(0, calm))
    states, before = hall.nodes(), hall.links()
    victim = next((name for name in of_role if states.get(name) == "working"), random.choice(of_role))
    kill(hall, victim)
    struck = time.monotonic()
    thread.join()
    if failed:
        raise failed[0]
    field = fresh_field(part, last)
    done = time.monotonic()
    seen = (part.head.version_id, field.report.max_von_mises_pa)
    part.undo()
    wait_until(lambda: hall.links().get(victim) not in (None, before[victim]), 60)  # Not the link that has just been cut.
    return states.get(victim) == "working", done - begin, time.monotonic() - struck, field.message.solve, seen


def many_kills(hall, count, only):
    """Kills at random moments: the versions and stresses of an undisturbed run, each edit once, all workers back each time."""
    part = hall.open("killed-workers")
    different = 12  # More than there are results at hand, so that each version is solved anew.
    calm = [edit_and_solve(part, number, None) for number in range(different)]
    made, last = different, part.wait_field(timeout=60).message.solve
    print("\n| role killed | kills | while it worked | the edit's field after, s | longest | joined again after, s | longest |")
    print("|---|---|---|---|---|---|---|")
    for role in sorted(set(WORKERS.values())):
        if only and role not in only:
            continue
        worked, fields, back = 0, [], []
        for _ in range(count):
            number = made % different
            busy, took, joined, last, seen = one_kill(hall, part, number, role, calm[number][1], last)
            check_same(seen, calm[number][2])
            worked += busy
            fields.append(took)
            back.append(joined)
            made += 1
        check_history(part, made)
        row(role, count, worked, f"{statistics.median(fields):.2f}", f"{max(fields):.2f}", f"{statistics.median(back):.2f}",
            f"{max(back):.2f}")
    part.close()


def renew_solvers(hall):
    """Their processes end and begin anew: nothing that they had is there."""
    racks = [name for name in WORKERS if WORKERS[name] == "solver"]
    before = hall.links()
    for name in racks:
        kill(hall, name)
    wait_until(lambda: all(hall.links().get(name) not in (None, before[name]) for name in racks), 60)


def cold_solve(hall, name, order):
    """A part that no solver has: the times to its first and its final field, MB to the solvers and from them."""
    import tedit.events

    part = hall.client.open(name)
    part.import_mesh(hall.mesh, unit="mm")
    part.set_load_case(PLATE / "load_case.json")
    heard = part.events(timeout=600)
    before = [(hall.wire[one].received, hall.wire[one].sent) for one in ("rack-1", "rack-2")]
    begin, first = time.monotonic(), []

    def listen():
        for event in heard:
            if isinstance(event, tedit.events.FieldArrived):
                first.append(time.monotonic() - begin)
                return

    thread = threading.Thread(target=listen)
    thread.start()
    solved = part.solve(element_order=order)
    part.wait_field(solve=solved.solve, timeout=300)
    done = time.monotonic() - begin
    thread.join()
    moved = [sum(getattr(hall.wire[one], what) - was[i] for one, was in zip(("rack-1", "rack-2"), before)) / 1e6
             for i, what in enumerate(("received", "sent"))]
    part.close()
    return first[0], done, *moved


def cold(hall):
    print("\n| line to each worker | tets | first field, s | final field, s | MB to solvers | MB from them |")
    print("|---|---|---|---|---|---|")
    for name, bytes_s in (("no bound", 0.0), ("1 Gbit/s", 125e6)):
        for worker in WORKERS:
            hall.wire[worker].bytes_s = bytes_s
        for order in (1, 2):
            renew_solvers(hall)
            times = cold_solve(hall, f"cold-{order}-{bytes_s:.0f}", order)
            row(name, "linear" if order == 1 else "quadratic", *(f"{one:.2f}" for one in times))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/bin/tedit")
    parser.add_argument("--mesh", type=pathlib.Path, default=PLATE / "ctc01_plate.coarse.msh")
    parser.add_argument("--edits", type=int, default=6)
    parser.add_argument("--only", default="")
    parser.add_argument("--partition", type=float, default=60)
    parser.add_argument("--kills", type=int, default=0)
    parser.add_argument("--cold", action="store_true")
    arguments = parser.parse_args()
    if os.geteuid() != 0:
        sys.exit("network namespaces need root")
    only = {one for one in arguments.only.split(",") if one}
    with tempfile.TemporaryDirectory() as folder, bad_wire.Wire(["hall", *WORKERS], mtu=60000 if arguments.cold else 1500) as wire:
        hall = Hall(wire, arguments, pathlib.Path(folder))
        try:
            hall.enter()
            if arguments.cold:
                cold(hall)
                return
            if arguments.kills:
                many_kills(hall, arguments.kills, only)
                return
            results = conditions(hall, only)
            faults(hall, results, only, arguments.partition)
        except BaseException:
            for name in ("server", *WORKERS):
                said = pathlib.Path(folder, f"{name}.log").read_text(encoding="utf-8")
                print(f"{name}:\n{said[-3000 if name == 'server' else -600:]}", file=sys.stderr)
            raise
        finally:
            hall.stop()


if __name__ == "__main__":
    main()
