#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Plants faults in the actors and says which of them the simulation finds.

usage: tests/simulation/planted_faults.py [--seeds 300] [--only WORDS] [--places] [TREE]

TREE (this one) is not changed: the faults are in a copy, TREE/build/planted, all in one program; a variable of
the environment makes one act. A fault is found when `simulate 1 SEEDS` fails, ends by a signal or takes ten
minutes. Without any fault the seeds must pass. --places only looks whether each fault still has its place.
"""
import argparse
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "mutation"))
import planting

# What is wrong, where, a piece of source, and what stands in its place. There FAULT says whether the fault acts,
# and OLD is the piece itself.
LEFT_OUT = "if (!FAULT) {\nOLD\n}"
FAULTS = [
    ("a finished command does not start the next", "actors/session/session.cpp",
     "running.reset();\n  store_cad();\n  next_command();", "running.reset();\n  store_cad();\n  if (!FAULT)\n    next_command();"),
    ("who asked hears a new head twice", "actors/session/edits.cpp",
     "broadcast(moved, {asked_by.client});", "if (FAULT)\n    broadcast(moved);\n  else {\n    OLD\n  }"),
    ("others do not hear of a new head", "actors/session/edits.cpp",
     "broadcast(moved, {asked_by.client});", LEFT_OUT),
    ("a change of loads is not remembered by its id", "actors/session/notes.cpp",
     "        past.add(made);\n", LEFT_OUT),
    ("an edit is not remembered by its id", "actors/session/edits.cpp",
     "past.add(made);\n  last_preview", "if (!FAULT)\n    past.add(made);\n  last_preview"),
    ("undo forgets where it came from", "actors/session/edits.cpp",
     "graph.set_redo(number, child);", LEFT_OUT),
    ("a change is acknowledged before it is durable", "actors/session/session.cpp",
     "auto shared = std::make_shared<const store::change>(std::move(change));",
     "OLD\n  if (FAULT) {\n    self->request(parts.store, std::chrono::minutes(5), stored_change{shared})"
     ".then([](acknowledged) {}, [](const caf::error&) {});\n    return done(0);\n  }"),
    ("a check stays in the list of jobs", "actors/session/candidates.cpp",
     "(const check_result& result) {\n        progress_of.erase(job);",
     "(const check_result& result) {\n        if (!FAULT)\n          progress_of.erase(job);"),
    ("a preview that was answered stays", "actors/session/candidates.cpp",
     "std::move(previews.extract(ticket).mapped())", "FAULT ? previews.at(ticket) : OLD"),
    ("who waits for a solve that ends early waits on", "actors/session/solves.cpp",
     "for (auto& waiter : ended.waiting)\n    waiter.promise.deliver(to_caf({code, why, {}, {}}));", LEFT_OUT),
    ("a solve is answered to nobody", "actors/session/solves.cpp",
     "for (auto& waiter : done.waiting)\n        waiter.promise.deliver(event);", LEFT_OUT),
    # Not only once it is free: a pool looks at what waits at each tick, too.
    ("who has worked once takes no waiting work", "actors/supervisor/placement.cpp",
     "void pool_state::dispatch() {\n",
     "void pool_state::dispatch() {\n  if (FAULT && std::ranges::any_of(children, [](const child& c) { return c.jobs_done > 0; }))\n    return;\n"),
    ("the work of a dead worker is lost", "actors/supervisor/pool.cpp",
     "  if (work)\n    try_again(std::move(*work), starved ? how + as_memory_ran_out : how);", "  if (work && !FAULT)\n    try_again(std::move(*work), starved ? how + as_memory_ran_out : how);"),
    ("a worker gets work while it has some", "actors/supervisor/placement.cpp",
     "!c.is_there() || c.work ||", "!c.is_there() || (c.work && !FAULT) ||"),
    ("a batch of pages is not counted off", "actors/pages/page_store.cpp", "--transfer.in_flight;", LEFT_OUT),
    ("an answered request is kept", "actors/gateway/client_actor.cpp",
     "end(id);\n  message.set_request_id(id);", "if (!FAULT)\n    end(id);\n  message.set_request_id(id);"),
    ("the surface of another's edit is not sent", "actors/gateway/client_actor.cpp",
     "  client.follow(event);\n}\n\nvoid on_load_cases", "  if (!FAULT)\n    client.follow(event);\n}\n\nvoid on_load_cases"),
    ("an edit hangs from the wrong parent", "actors/session/version_graph.cpp",
     "node.info.parent = head_;", "node.info.parent = FAULT && head_ ? nodes_[*head_].info.parent : head_;"),
    ("a written file stays on the count", "actors/gateway/exports.cpp",
     "(const exported& file) {\n          --exporting;", "(const exported& file) {\n          if (!FAULT)\n            --exporting;"),
    ("uploads stay on the account", "actors/gateway/uploads.cpp", "all_->give_back(bytes);", LEFT_OUT),
    ("a repeated change is made again", "actors/session/change_log.cpp",
     "return edit_id.empty() ||", "return (FAULT && edit_id.size() % 2 == 0) || edit_id.empty() ||"),
    ("a cancelled command that waits is not answered", "actors/session/session.cpp",
     "refuse({ec::cancelled, \"the request was cancelled before it began\", {}, {}});", LEFT_OUT),
    ("a solve is not tried again", "actors/session/solves.cpp",
     "active->retries++ >= most_retries", "active->retries++ >= (FAULT ? 0 : most_retries)"),
    ("a document goes although another has it open", "actors/session/notes.cpp",
     "  if (!others.empty())\n", "  if (!others.empty() && !FAULT)\n"),
    ("who waits for the name of a deleted document waits on", "actors/node/library.cpp",
     "promise->deliver(deleted_document{name});\n    let_go(self, name);",
     "promise->deliver(deleted_document{name});\n    if (!FAULT)\n      let_go(self, name);"),
    ("a deletion is acknowledged and not made", "actors/node/library.cpp",
     "  const auto promise = std::make_shared<caf::typed_response_promise<deleted_document>>(",
     "  if (FAULT && state.name_changes % 2 == 1)\n    return deleted_document{*name};\nOLD"),
    ("a copy that was written stays on the count", "actors/session/notes.cpp",
     "--copying;\n        promise->deliver(acknowledged{});",
     "if (!FAULT)\n          --copying;\n        promise->deliver(acknowledged{});"),
    ("a deleted document stays under its hidden name", "actors/store/deletion.cpp",
     "::unlink(hidden.c_str());\n  return {};", "if (!FAULT)\n    ::unlink(hidden.c_str());\n  return {};"),
    ("new loads are not sent to others", "actors/session/notes.cpp",
     "state.broadcast(\n      load_cases_changed{state.parts.document, to_hex(state.graph.head()->info.id), shared});",
     LEFT_OUT),
]


def planted(tree):
    """The sources (path: text) with every fault in them."""
    changed = {}
    for number, (what, name, old, new) in enumerate(FAULTS):
        path = pathlib.Path(name)
        text = changed.get(path) or planting.with_switch((tree / path).read_text())
        if text.count(old) != 1:
            sys.exit(f"{what}: {name} has {text.count(old)} times: {old}")
        new = new.replace("FAULT", f"tedit::mutation::acts({number})").replace("OLD", old)
        changed[path] = text.replace(old, new)
    return changed


def play(program, seeds, number=None):
    """How the seeds failed with a fault, or nothing."""
    with tempfile.TemporaryDirectory(dir="/dev/shm" if os.path.isdir("/dev/shm") else None) as folder:
        environment = {**os.environ, "TMPDIR": folder} | ({} if number is None else {"TEDIT_MUTANT": str(number)})
        done = subprocess.run(["timeout", "600", program, "1", str(seeds), "--first"], env=environment,
                              capture_output=True, text=True)
    lines = done.stdout.splitlines()
    return None if done.returncode == 0 else lines[0] if lines else f"ended with {done.returncode}"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("tree", nargs="?", type=pathlib.Path, default=pathlib.Path(__file__).parents[2])
    options.add_argument("--seeds", type=int, default=300)
    options.add_argument("--only", default="", help="faults with these words in their names")
    options.add_argument("--places", action="store_true", help="build and play nothing")
    given = options.parse_args()
    tree = given.tree.resolve()
    if given.places:
        planted(tree)
        return
    planting.copy_sources(tree, tree / "build" / "planted", planted(tree))
    folder = planting.configure(tree / "build" / "planted")
    if said := planting.build(folder, ["simulate"]):
        sys.exit("what is planted does not compile:\n" + "\n".join(l for l in said.splitlines() if "error:" in l))
    program = folder / "bin" / "simulate"
    if said := play(program, given.seeds):
        sys.exit("the seeds must pass without a fault: " + said)
    chosen = [n for n, fault in enumerate(FAULTS) if given.only in fault[0]]
    found = 0
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for number, how in zip(chosen, pool.map(lambda n: play(program, given.seeds, n), chosen)):
            print(f"{'found' if how else 'MISSED'}: {FAULTS[number][0]}: {how or ''}", flush=True)
            found += how is not None
    print(f"{found} of {len(chosen)} found")


if __name__ == "__main__":
    main()
