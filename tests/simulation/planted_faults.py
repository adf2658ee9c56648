#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Plants faults in the actors, one at a time, and says which the simulation finds.

usage: tests/simulation/planted_faults.py TREE [SEEDS]

TREE: a checkout of its own, which this changes and restores. Each fault is a piece of source and what
stands in its place. The tree is built in TREE/build/planted; a fault is found when `simulate 1 SEEDS`
(default 300) fails or ends by a signal.
"""
import pathlib
import subprocess
import sys

FAULTS = [
    ("a finished command does not start the next", "actors/session/session.cpp",
     "  running.reset();\n  next_command();", "  running.reset();"),
    ("who asked hears a new head twice", "actors/session/edits.cpp",
     "broadcast(moved, {asked_by.client});", "broadcast(moved);"),
    ("others do not hear of a new head", "actors/session/edits.cpp",
     "broadcast(moved, {asked_by.client});", ""),
    ("a change of loads is not remembered by its id", "actors/session/notes.cpp",
     "        past.add(made);\n", ""),
    ("an edit is not remembered by its id", "actors/session/edits.cpp",
     "  past.add(made);\n  last_preview", "  last_preview"),
    ("undo forgets where it came from", "actors/session/edits.cpp",
     "        graph.set_redo(number, child);", "        (void)child;"),
    ("a change is acknowledged before it is durable", "actors/session/session.cpp",
     "  auto shared = std::make_shared<const store::change>(std::move(change));",
     "  auto shared = std::make_shared<const store::change>(std::move(change));\n"
     "  self->send(parts.store, stored_change{shared});\n  return done(0);"),
    ("a check stays in the list of jobs", "actors/session/candidates.cpp",
     "      [=, this](const check_result& result) {\n        progress_of.erase(job);",
     "      [=, this](const check_result& result) {"),
    ("a preview that was answered stays", "actors/session/candidates.cpp",
     "std::move(previews.extract(ticket).mapped())", "previews.at(ticket)"),
    ("who waits for a solve that ends early waits on", "actors/session/solves.cpp",
     "  for (auto& waiter : ended.waiting)\n    waiter.promise.deliver(to_caf({code, why, {}, {}}));\n", ""),
    ("a solve is answered to nobody", "actors/session/solves.cpp",
     "      for (auto& waiter : done.waiting)\n        waiter.promise.deliver(event);\n", ""),
    ("a free worker takes no waiting work", "actors/supervisor/pool.cpp",
     "  c->work.reset();\n  dispatch();\n}", "  c->work.reset();\n}"),
    ("the work of a dead worker is lost", "actors/supervisor/pool.cpp",
     "  if (work)\n    try_again(std::move(*work), how);\n", ""),
    ("a worker gets work while it has some", "actors/supervisor/pool.cpp",
     "if (!c.is_there() || c.work)", "if (!c.is_there())"),
    ("a batch of pages is not counted off", "actors/pages/page_store.cpp",
     "  --transfer.in_flight;\n", ""),
    ("an answered request is kept", "actors/gateway/client_actor.cpp",
     "  end(id);\n  message.set_request_id(id);", "  message.set_request_id(id);"),
    ("the surface of another's edit is not sent", "actors/gateway/client_actor.cpp",
     "  send(*client.to, message);\n  client.follow(event);", "  send(*client.to, message);"),
    ("an edit hangs from the wrong parent", "actors/session/version_graph.cpp",
     "node.info.parent = head_;", "node.info.parent = head_ ? nodes_[*head_].info.parent : head_;"),
    ("a written file stays on the count", "actors/gateway/exports.cpp",
     "(const exported& file) {\n          --exporting;", "(const exported& file) {"),
    ("uploads stay on the account", "actors/gateway/uploads.cpp",
     "  used_ -= bytes;\n  if (all_)\n    all_->give_back(bytes);", "  used_ -= bytes;"),
    ("a repeated change is made again", "actors/session/change_log.cpp",
     "const past_change* change_log::find(const std::string& edit_id) const {\n",
     "const past_change* change_log::find(const std::string& edit_id) const {\n"
     "  if (edit_id.size() % 2 == 0)\n    return nullptr;\n"),
    ("a cancelled command that waits is not answered", "actors/session/session.cpp",
     "  refuse({ec::cancelled, \"the request was cancelled before it began\", {}, {}});", ""),
    ("a solve is not tried again", "actors/session/solves.cpp",
     "active->retries++ >= most_retries", "active->retries++ >= 0"),
    ("a document goes although another has it open", "actors/session/notes.cpp",
     "  if (others > 0)\n", "  if (others > 100)\n"),
    ("who waits for the name of a deleted document waits on", "actors/node/library.cpp",
     "    promise->deliver(deleted_document{name});\n    let_go(self, name);",
     "    promise->deliver(deleted_document{name});"),
    ("a deletion is acknowledged and not made", "actors/node/library.cpp",
     "  if (!name)\n    return to_caf(name.error());\n",
     "  if (!name)\n    return to_caf(name.error());\n"
     "  if (state.name_changes % 2 == 1)\n    return deleted_document{*name};\n"),
    ("a copy that was written stays on the count", "actors/session/notes.cpp",
     "        --copying;\n        promise->deliver(acknowledged{});",
     "        promise->deliver(acknowledged{});"),
    ("the log of a deleted document stays", "actors/store/deletion.cpp",
     "  remove_companions(file);\n  ::unlink(hidden.c_str());\n  return {};",
     "  ::unlink(hidden.c_str());\n  return {};"),
    ("new loads are not sent to others", "actors/session/notes.cpp",
     "    state.broadcast(\n      load_cases_changed{", "    (void)(\n      load_cases_changed{"),
]

# Each source by itself, so that a fault costs one of them; a fault may leave something unused.
ALONE = """
set_target_properties(tedit_actors tedit_gateway PROPERTIES UNITY_BUILD OFF)
target_compile_options(tedit_actors PRIVATE -Wno-error)
target_compile_options(tedit_gateway PRIVATE -Wno-error)
"""


def run(command, tree, **more):
    return subprocess.run(command, cwd=tree, capture_output=True, text=True, **more)


def build(tree):
    done = run(["ninja", "-C", "build/planted", "simulate"], tree)
    return done.returncode == 0, done.stdout[-2000:]


def main():
    tree = pathlib.Path(sys.argv[1]).resolve()
    seeds = sys.argv[2] if len(sys.argv) > 2 else "300"
    lists = tree / "actors/CMakeLists.txt"
    before = lists.read_text()
    lists.write_text(before + ALONE)
    try:
        run(["cmake", "--preset", "ci", "-B", "build/planted"], tree)
        plant_all(tree, seeds)
    finally:
        lists.write_text(before)


def plant_all(tree, seeds):
    good, said = build(tree)
    sound = good and run(["build/planted/bin/simulate", "1", seeds], tree).returncode == 0
    if not sound:
        sys.exit("the tree must build and pass before faults are planted: " + said)
    found = 0
    for what, name, old, new in FAULTS:
        file = tree / name
        text = file.read_text()
        if text.count(old) != 1:
            sys.exit(f"{name} does not have once: {old}")
        file.write_text(text.replace(old, new))
        try:
            good, said = build(tree)
            if not good:
                sys.exit(f"{what}: does not compile: {said}")
            done = run(["timeout", "600", "build/planted/bin/simulate", "1", seeds], tree)
        finally:
            file.write_text(text)
        found += done.returncode != 0
        lines = done.stdout.splitlines()
        how = lines[0] if done.returncode == 1 and lines else f"ended with {done.returncode}"
        print(f"{'found' if done.returncode else 'MISSED'}: {what}: {how}", flush=True)
    print(f"{found} of {len(FAULTS)} found")


if __name__ == "__main__":
    main()
