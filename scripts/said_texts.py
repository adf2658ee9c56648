#!/usr/bin/env python3
"""What the server says to people, as templates: "surface %1 has no room for the rounding at %2".

A small reader of C++ expressions. It finds the texts of refusals (an argument that follows a code, `ec::`), of notices
and of the helpers that put pieces of them together, and puts %1, %2, ... where a number or a name comes in. Used by
translations.py; run alone it prints the templates with their files.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Rooms whose refusals, notices and stages of work reach a window.
ROOMS = ["base", "mesh", "fem", "edit", "ops", "cad", "scan", "decks", "protocol", "client", "client-qt/net", "actors"]

# Read by developers, integrators and operators alone: the kits of plugins, input decks and file headers, what is said
# of bytes that two programs of one release send each other, logs; what "tedit doc" alone says.
LEFT_OUT = re.compile(r"""
    ops/(conformance|probe|sdk)/ | ops/loader/(plugin_fit|probe|operation_log|child_operation|edit_answer)
  | ops/[a-z_]+/operation\. | ops/tools/(profile_parameters|tools\.)
  | fem/(calculix_deck|quantities) | mesh/(layout|manifest|paged_array|formats\.hpp|version\.) | mesh/io/((vtu|obj|stl|ply)_writer|threemf_model)
  | base/tracing/ | base/(error|metrics|random_token|virtual_display|process_usage|forked_call|units|child_process)
  | client/(recipes/|recipe_) | protocol/(forms|json)
  | actors/(links|pages|exits|session/numbers|supervisor/pool_numbers|versions|wire_value|node/(server|worker|system)) | actors/store/(seal|documents_folder|removal|cleaning|check\.|document_view)
  | actors/gateway/(http_session|ws_session|transport|gateway\.|users)
""", re.X)

# Where pieces of sentences are put together by helpers: all words count, not only those behind a code.
PIECES = re.compile(r"(base|mesh|fem|ops)/|cad/(steps|editing|mesh_file|repair|editor/|reader/((brep|iges|step)_|main|short_edges|solids))|scan/part_file|actors/cad/|client/(server_url|socket|streams|inbox|messages)|actors/(supervisor/(pool|placement)|session/|store/document_lock|solver/|errors)")

TOKEN = re.compile(r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<raw>R"\((?P<rawtext>.*?)\)")
  | (?P<text>"(?:[^"\\\n]|\\.)*")
  | (?P<letter>'(?:[^'\\\n]|\\.)+')
  | (?P<word>[A-Za-z_][A-Za-z0-9_]*|[0-9][0-9a-zA-Z_.']*)
  | (?P<mark>::|->|\+=|==|!=|<=|>=|&&|\|\||<<|.)
""", re.X | re.S)


def tokens_of(source):
    """(kind, text) of everything but comments and blanks; `#include` lines are left out."""
    source = re.sub(r"^[ \t]*#[^\n]*(?:\\\n[^\n]*)*", "", source, flags=re.M)
    result = []
    for found in TOKEN.finditer(source):
        kind = found.lastgroup if found.lastgroup != "rawtext" else "raw"
        if kind == "comment" or (kind == "mark" and found.group().isspace()):
            continue
        result.append((kind, found.group()))
    return result


OPEN = {"(": ")", "{": "}", "[": "]"}


def end_of(tokens, at):
    """Behind the bracket that closes the one at `at`."""
    depth = 0
    for i in range(at, len(tokens)):
        if tokens[i][0] != "mark":
            continue
        if tokens[i][1] in OPEN:
            depth += 1
        elif tokens[i][1] in OPEN.values():
            depth -= 1
            if depth == 0:
                return i + 1
    return len(tokens)


def split(tokens, mark):
    """At a mark that stands in no bracket."""
    parts, begin, i = [], 0, 0
    while i < len(tokens):
        kind, text = tokens[i]
        if kind == "mark" and text in OPEN:
            i = end_of(tokens, i)
            continue
        if kind == "mark" and text == mark:
            parts.append(tokens[begin:i])
            begin = i + 1
        i += 1
    return parts + [tokens[begin:]]


HOLE = "\0"


def unquoted(text):
    """As it is at run time, with HOLE for what printf fills in."""
    text = re.sub(r"%[-+.0-9]*[zl]*[a-z]", HOLE, text.replace("%%", "\1")).replace("\1", "%")
    return re.sub(r"\\(.)", lambda m: {"n": "\n", "t": "\t"}.get(m.group(1), m.group(1)), text[1:-1])


def stripped(tokens):
    """Without brackets around all of it and std::string(...) around a text."""
    while tokens:
        if tokens[0] == ("mark", "(") and end_of(tokens, 0) == len(tokens):
            tokens = tokens[1:-1]
        elif [t for _, t in tokens[:4]] == ["std", "::", "string", "("] and end_of(tokens, 3) == len(tokens):
            tokens = tokens[4:-1]
        else:
            return tokens
    return tokens


def shapes(tokens):
    """All texts that an expression can be, with HOLE for what is not written there."""
    tokens = stripped(tokens)
    choice = split(tokens, "?")
    if len(choice) > 1:
        rest = tokens[len(choice[0]) + 1:]
        ways = split_choice(rest)
        return [one for way in ways for one in shapes(way)]
    terms = split(tokens, "+")
    if len(terms) > 1:
        result = [""]
        for term in terms:
            result = [a + b for a in result for b in shapes(term)]
        return result
    if tokens and all(kind == "text" for kind, _ in tokens):
        return ["".join(unquoted(text) for _, text in tokens)]
    if len(tokens) == 1 and tokens[0][0] == "letter":
        return [unquoted(tokens[0][1])]
    return [HOLE]


def split_choice(tokens):
    """`a : b` of a choice; either may be a choice again."""
    depth, i = 0, 0
    while i < len(tokens):
        kind, text = tokens[i]
        if kind == "mark" and text in OPEN:
            i = end_of(tokens, i)
            continue
        if kind == "mark" and text == "?":
            depth += 1
        if kind == "mark" and text == ":":
            if depth == 0:
                return [tokens[:i], tokens[i + 1:]]
            depth -= 1
        i += 1
    return [tokens]


def template(shape):
    """%1, %2, ... for the holes; holes side by side are one."""
    shape = re.sub(HOLE + "+", HOLE, shape)
    count = 0
    out = ""
    for letter in shape:
        if letter == HOLE:
            count += 1
            out += f"%{count}"
        else:
            out += letter
    return out


def says_something(text):
    """Two letters side by side beyond the holes."""
    bare = re.sub(r"%\d+", " ", text)
    return re.search(r"[A-Za-z]{2}", bare) is not None


def expressions(tokens):
    """Every expression with a text in it, cut at , ; = return and brackets; the longest ones."""
    i, begin = 0, 0
    cuts = {",", ";", "=", "{", "}", "return", "+=", "==", "!=", "<<", "&&", "||", "<", ">"}

    def walk(part):
        pieces, start, k = [], 0, 0
        while k < len(part):
            kind, text = part[k]
            if kind == "mark" and text in ("(", "["):
                k = end_of(part, k)
                continue
            if text in cuts and kind in ("mark", "word"):
                pieces.append(part[start:k])
                start = k + 1
            k += 1
        pieces.append(part[start:])
        for piece in pieces:
            if not any(kind == "text" for kind, _ in piece):
                continue
            if has_own_text(piece):
                yield piece
            for inner in brackets(piece):
                yield from walk(inner)

    yield from walk(tokens)


def has_own_text(piece):
    return any(HOLE != one and one.replace(HOLE, "") for one in shapes(piece))


def brackets(piece):
    """What stands in brackets, but those that `shapes` looks into."""
    k = 0
    while k < len(piece):
        if piece[k] == ("mark", "("):
            end = end_of(piece, k)
            yield piece[k + 1:end - 1]
            k = end
        else:
            k += 1


def behind_a_code(tokens):
    """The arguments that follow `ec::name,`: message, remedy, place."""
    for i in range(len(tokens) - 3):
        if tokens[i] != ("word", "ec") or tokens[i + 1][1] != "::" or tokens[i + 3][1] != ",":
            continue
        end = i + 4
        while end < len(tokens) and tokens[end][1] not in (")", "}", ";"):
            end = end_of(tokens, end) if tokens[end][1] in OPEN and tokens[end][0] == "mark" else end + 1
        yield from split(tokens[i + 4:end], ",")


def arguments_of(tokens, names):
    """The arguments of calls of members with one of these names."""
    for i in range(1, len(tokens) - 1):
        if tokens[i][1] in names and tokens[i - 1][1] in (".", "->") and tokens[i + 1][1] == "(":
            yield from split(tokens[i + 2:end_of(tokens, i + 1) - 1], ",")


def is_piece(text):
    """Two words at least, whole, and no text of a database or of a log."""
    if re.fullmatch(r'[a-z]+ "%1": %2|%1 is %2', text):
        return True
    return (text.count('"') % 2 == 0 and text.count("(") == text.count(")") and re.search(r"[a-z]{2,}(?:'s)?[,:]? +(?:[a-z(]|%1)|%1 [a-z]{3,}", text) is not None and text == text.strip()
            and not text.endswith(":") and not text[0] in ";:,)" and not re.search(r"\{\}|[A-Z]{5,}|\n", text.replace("OpenCASCADE", "")))


def templates_of(path):
    """What the sources in one file say, each once, in their order."""
    tokens = tokens_of(path.read_text())
    said = [*behind_a_code(tokens), *arguments_of(tokens, {"report"})]
    texts = [template(shape) for piece in said for shape in shapes(piece)]
    if PIECES.match(str(path.relative_to(ROOT))):
        pieces = (template(shape) for piece in expressions(tokens) for shape in shapes(piece))
        texts += [text for text in pieces if says_something(text) and is_piece(text)]
    return [text for text in dict.fromkeys(texts) if says_something(text)]


def sources():
    for room in ROOMS:
        for path in sorted(ROOT.glob(f"{room}/**/*.?pp")):
            place = path.relative_to(ROOT)
            if "tests" not in place.parts and not LEFT_OUT.match(str(place)):
                yield path


def all_templates():
    """Sorted, each once: so that the list stays as it is while sources move."""
    return sorted({text for path in sources() for text in templates_of(path)})


def quoted(text):
    """As C++ writes it."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


def table():
    """The list for the window: a row of a C++ array each."""
    head = "// SPDX-License-Identifier: AGPL-3.0-or-later\n// Made by scripts/translations.py --update: do not edit.\n"
    return head + "".join(f"{quoted(text)},\n" for text in all_templates())


def main():
    for path in sources():
        for text in templates_of(path):
            print(f"{path.relative_to(ROOT)}\t{text!r}")


if __name__ == "__main__":
    sys.exit(main())
