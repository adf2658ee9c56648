#!/usr/bin/env python3
"""Makes docs/protocol_reference.md from the protocol's .proto files and the error codes of base/error.hpp.

usage: scripts/protocol_reference.py [--check]

Every message, field, value and error code must have a comment, which becomes its text. With --check nothing is written.
Exit status: 0 made, or the page is as it should be; 1 a comment is missing or, with --check, the page is another.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROTOCOL = ROOT / "protocol/tedit/v1"
ERRORS = ROOT / "base/error.hpp"
PAGE = ROOT / "docs/protocol_reference.md"
# In the order in which they are read: what holds them all first.
FILES = ["envelope", "library", "session", "operation", "report", "comparison", "print", "load_case"]

FIELD = re.compile(r"(?:(optional|repeated) )?(map<[^>]+>|[\w.]+) (\w+) = (\d+);(?:\s*//\s*(.*))?$")
VALUE = re.compile(r"(\w+) = (\d+);(?:\s*//\s*(.*))?$")
BEGIN = re.compile(r"(message|enum|oneof) (\w+) \{(\})?(?:\s*//.*)?$")


class Block:
    """A message or an enumeration."""

    def __init__(self, kind, name, text):
        self.kind, self.name, self.text = kind, name, text
        self.rows = []  # (name, type, number, text), of an enumeration with an empty type.


def read(path):
    """The blocks of one .proto file; nested ones behind the one that they are in, with its name."""
    blocks, inside, comment = [], [], []
    for line in (line.strip() for line in path.read_text(encoding="utf-8").splitlines()):
        if line.startswith("//"):
            comment.append(line.lstrip("/").strip())
            continue
        text = " ".join(comment) if comment and not comment[0].startswith("--") else ""
        if begin := BEGIN.match(line):
            kind, name, empty = begin.groups()
            outer = [b.name for b in inside if b.kind != "oneof"]
            block = Block(kind, ".".join(outer[-1:] + [name]), text)
            if kind == "oneof":  # Its fields belong to the message around it.
                block.rows = inside[-1].rows
            else:
                blocks.append(block)
            if not empty:
                inside.append(block)
        elif line.startswith("}"):
            inside.pop()
        elif inside and (found := FIELD.match(line)) and inside[-1].kind != "enum":
            label, kind, name, number, behind = found.groups()
            one_of = "one of" if inside[-1].kind == "oneof" else label
            inside[-1].rows.append((name, f"{one_of or ''} {kind}".strip(), number, f"{text} {behind or ''}".strip()))
        elif inside and (found := VALUE.match(line)):
            name, number, behind = found.groups()
            inside[-1].rows.append((name, "", number, f"{text} {behind or ''}".strip()))
        comment = []
    return blocks


def read_errors():
    """(code, text) of every error code, in their order."""
    body = ERRORS.read_text(encoding="utf-8").split("enum class ec {")[1].split("};")[0]
    return re.findall(r"^\s*(\w+),\s*///< (.*)$", body, flags=re.MULTILINE)


def faults(blocks, errors):
    for block in blocks:
        if not block.text and block.kind == "message":
            yield f"message {block.name} has no comment"
        for name, _, number, text in block.rows:
            unspecified = block.kind == "enum" and number == "0" and name.endswith("UNSPECIFIED")
            if not text and not unspecified and block.name not in ("ClientMessage", "ServerMessage"):
                yield f"{block.name}.{name} has no comment"
    if len(errors) < 10:
        yield f"{ERRORS.name} has no error codes that this script can read"


def cell(text):
    return text.replace("|", "\\|").replace("<", "&lt;").replace("*", "\\*") or "not given"


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] + [
        "| " + " | ".join(row) + " |" for row in rows] + [""]


def anchor(name):
    return name.replace(".", "").lower()


def linked(kind, names, around):
    """A field's type, with a link when it is a message or an enumeration of ours."""
    def link(found):
        word = found.group(0)
        for name in (f"{around}.{word}", word):
            if name in names:
                return f"[{word}](#{anchor(name)})"
        return word
    return cell(re.sub(r"[\w.]+", link, kind))


def first_sentence(text):
    return re.split(r"(?<=[.])\s", text)[0]


def make(blocks, errors):
    names = {block.name: block for block in blocks}
    lines = ["# Protocol reference", "",
             "Made by `scripts/protocol_reference.py` from `protocol/tedit/v1/*.proto` and `base/error.hpp`: do not edit. "
             "How a conversation goes, and what the rules are: `docs/protocol.md`.", ""]
    for title, message in (("Requests", "ClientMessage"), ("Answers and events", "ServerMessage")):
        rows = [(f"`{name}`", linked(kind.removeprefix("one of "), names, message), number,
                 cell(first_sentence(names[kind.removeprefix("one of ")].text)))
                for name, kind, number, _ in names[message].rows if kind.startswith("one of ")]
        lines += [f"## {title}", "", f"The field of [{message}](#{anchor(message)}) that says which it is.", ""]
        lines += table(("field", "message", "number", "what it is"), rows)
    lines += ["## Error codes", "", "`Error.code`. They are never renamed or used for something else; new ones may come.", ""]
    lines += table(("code", "meaning"), [(f"`{code}`", cell(text)) for code, text in errors])
    lines += ["## Messages", ""]
    for block in blocks:
        lines += [f"### {block.name}", ""]
        if block.text:
            lines += [cell(block.text), ""]
        if block.name in ("ClientMessage", "ServerMessage"):
            own = [row for row in block.rows if not row[1].startswith("one of ")]
        else:
            own = block.rows
        if block.kind == "enum":
            lines += table(("value", "number", "meaning"), [(f"`{n}`", number, cell(t)) for n, _, number, t in own])
        elif own:
            lines += table(("field", "type", "number", "meaning"), [
                (f"`{n}`", linked(kind, names, block.name), number, cell(t)) for n, kind, number, t in own])
    return "\n".join(lines).rstrip() + "\n"


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        print(__doc__.strip())
        return 0 if sys.argv[1:] in (["-h"], ["--help"]) else 2
    blocks = [block for name in FILES for block in read(PROTOCOL / f"{name}.proto")]
    errors = read_errors()
    found = list(faults(blocks, errors))
    left = {path.stem for path in PROTOCOL.glob("*.proto")} - set(FILES)
    found += [f"{name}.proto is not among the files of this script" for name in sorted(left)]
    if found:
        print("\n".join(found), file=sys.stderr)
        return 1
    page = make(blocks, errors)
    if sys.argv[1:] != ["--check"]:
        PAGE.write_text(page, encoding="utf-8")
    elif not PAGE.exists() or PAGE.read_text(encoding="utf-8") != page:
        print(f"{PAGE.relative_to(ROOT)} is not what the .proto files say: run scripts/protocol_reference.py", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
