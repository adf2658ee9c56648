#!/usr/bin/env python3
"""Checks the window's translations, or takes new words of the sources into them.

usage: scripts/translations.py [--update] [--new LANGUAGE] [--lupdate PROGRAM]

Checks that every word of client-qt, of the tables that it shows and of what the server says (said_texts.py) is in client-qt/translations/tedit_*.ts, that every translation is complete, and
that placeholders (%1), shortcuts' leading and trailing blanks and line breaks are kept. With --update it runs lupdate
first, which changes the files; --new fr also begins tedit_fr.ts, with all words to be filled in. Without lupdate
(package qt6-l10n-tools) the words of the sources are not compared. Exit status: 0 all is well, 1 something is not,
2 usage.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import said_texts

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "client-qt" / "model" / "server_words.inc"
FOLDER = ROOT / "client-qt" / "translations"


# Tables below the window whose titles it shows.
TABLES = ["fem/quantities.hpp", "mesh/formats.hpp"]


def texts_of_operations():
    """What the shipped operations say of themselves in `describe`: sentences, names, choices; and of their figures."""
    literal = re.compile(r'"((?:[^"\\]|\\.)*)"')
    for file in sorted([*ROOT.glob("ops/*/operation.cpp"), ROOT / "ops/shapes/rounding/round_edges.cpp",
                        ROOT / "ops/tools/profile_parameters.cpp"]):
        source = re.sub(r'R"\(.*?\)"', "", file.read_text(), flags=re.S)
        for body in re.findall(r"(?:describe\(\) const override|[a-z]+_parameters\(\)) \{\n(.*?)\n\s*return", source, re.S):
            joined = re.sub(r'"\s*\n\s*"', "", body)
            for choices in re.findall(r'\{("[a-z_]+"(?:, "[a-z_]+")+)\}', joined):
                yield from (one.replace("_", " ") for one in literal.findall(choices))
            for text in literal.findall(joined):
                if " " in text or text[:1].isupper():
                    yield text.replace('\\"', '"')

    yield from texts_of_figures()


def texts_of_figures():
    """What the figures of edits are called. A number among the words is %1."""
    for file in sorted(ROOT.glob("ops/**/*.cpp")):
        if "tests" in file.parts:
            continue
        for statement in re.findall(r"figures(?:\.push_back\(| = )\s*\{.*?;\n", file.read_text(), re.S):
            numbered = re.sub(r'" \+ std::to_string\(\w+\) \+\s*"', "%1", statement)
            yield from (text for text in re.findall(r'"([^"]*)"', numbered) if " " in text)


def run_lupdate(program, targets):
    with tempfile.TemporaryDirectory() as folder:
        words = pathlib.Path(folder) / "operations.cpp"
        texts = [("operations", text) for text in texts_of_operations()]
        texts += [("server", text) for text in said_texts.all_templates()]
        words.write_text("\n".join(f'QT_TRANSLATE_NOOP("{context}", {said_texts.quoted(text)});' for context, text in texts))
        command = [program, "-I", ".", "-locations", "none", "-no-obsolete", "-silent",
                   "-tr-function-alias", "QT_TRANSLATE_NOOP+=for_people", "client-qt", *TABLES, str(words), "-ts"]
        subprocess.run(command + [str(one) for one in targets], cwd=ROOT, check=True)


def messages(path):
    """(context, source) to (translation, whether it is finished)."""
    result = {}
    for context in ElementTree.parse(path).getroot().findall("context"):
        for message in context.findall("message"):
            translation = message.find("translation")
            key = (context.findtext("name"), message.findtext("source"))
            result[key] = (translation.text or "", translation.get("type") is None)
    return result


def faults_of(source, translation, finished):
    if not finished or not translation:
        yield "is not translated"
        return
    places = [sorted(re.findall(r"%(?:n|L?[0-9]+)", text)) for text in (source, translation)]
    if places[0] != places[1]:
        yield f"has other placeholders: {translation!r}"
    if source.count("\n") != translation.count("\n"):
        yield f"has other line breaks: {translation!r}"
    for strip in (str.lstrip, str.rstrip):
        if (strip(source) == source) != (strip(translation) == translation):
            yield f"has other blanks at an end: {translation!r}"


def check(path, wanted):
    found = messages(path)
    for context, source in sorted(wanted - found.keys()):
        yield f"{path.name}: {context}: {source!r} is missing"
    for context, source in sorted(found.keys() - wanted):
        yield f"{path.name}: {context}: {source!r} is no word of the window any more"
    for (context, source), (translation, finished) in found.items():
        for fault in faults_of(source, translation, finished):
            yield f"{path.name}: {context}: {source!r} {fault}"


def words_of_the_sources(lupdate):
    with tempfile.TemporaryDirectory() as folder:
        fresh = pathlib.Path(folder) / "words.ts"
        run_lupdate(lupdate, [fresh])
        return messages(fresh).keys()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--update", action="store_true", help="take new words into the files first")
    parser.add_argument("--new", metavar="LANGUAGE", help="begin the translation into a language more, as fr or pt_BR")
    parser.add_argument("--lupdate", default="/usr/lib/qt6/bin/lupdate", help="the program of qt6-l10n-tools")
    wanted = parser.parse_args()
    files = sorted(FOLDER.glob("tedit_*.ts"))
    has_lupdate = pathlib.Path(wanted.lupdate).exists()
    if wanted.new and not re.fullmatch(r"[a-z]{2,3}(_[A-Z]{2})?", wanted.new):
        parser.error(f"--new wants a language as fr or pt_BR, not {wanted.new!r}")
    if wanted.update or wanted.new:
        if not has_lupdate:
            print(f"translations.py: {wanted.lupdate} is not there; install qt6-l10n-tools", file=sys.stderr)
            return 2
        files = sorted({*files, FOLDER / f"tedit_{wanted.new}.ts"} if wanted.new else files)
        TABLE.write_text(said_texts.table())
        run_lupdate(wanted.lupdate, files)
    if wanted.new:
        print(f"fill in client-qt/translations/tedit_{wanted.new}.ts, then run scripts/translations.py")
        return 0
    words = words_of_the_sources(wanted.lupdate) if has_lupdate else messages(files[0]).keys()
    faults = [fault for path in files for fault in check(path, words)]
    if not TABLE.exists() or TABLE.read_text() != said_texts.table():
        faults.append(f"{TABLE.relative_to(ROOT)} has not what the server says")
    for fault in faults:
        print(fault, file=sys.stderr)
    if faults:
        print("run scripts/translations.py --update, then fill in what is missing", file=sys.stderr)
        return 1
    print(f"translations: {len(words)} words, {len(files)} languages besides English")
    return 0


if __name__ == "__main__":
    sys.exit(main())
