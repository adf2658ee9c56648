#!/usr/bin/env python3
"""Makes the HTML manual from the Markdown of docs/ and ops/.

usage: scripts/manual.py FOLDER

Writes FOLDER/index.html, a page for each document below, and their pictures. Links between documents become links
between pages. Needs Debian's python3-markdown. Exit status: 0 made, 1 a picture or a document is missing.
"""
import pathlib
import re
import shutil
import sys

import markdown

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Page, title, what it is for, and its documents.
PAGES = [
    ("desktop", "The desktop client", "The window: picking, editing, looking at results; keys; unattended use.",
     ["docs/desktop.md"]),
    ("scans", "Surfaces without CAD", "STL, OBJ, PLY and 3MF in as parts: what is mended, how surfaces are found, errors.", ["docs/scans.md"]),
    ("cad", "CAD files", "STEP, IGES and BREP in: what is kept, sizes, limits, errors.", ["docs/cad.md"]),
    ("formats", "File formats", "Meshes and decks in and out: what each format keeps.", ["docs/formats.md"]),
    ("print", "Printing", "Files for a slicer, and what to look at before.", ["docs/print.md"]),
    ("command_line", "The command line", "The same work on files: edit, solve, picture, input decks.", ["docs/command_line.md"]),
    ("operations", "Operations", "What each editing operation does, its parameters and its limits.",
     ["ops/fill_hole/README.md", "ops/remove_surfaces/README.md", "ops/erode/README.md", "ops/thicken/README.md",
      "ops/open/README.md", "ops/close/README.md", "ops/improve_mesh/README.md", "ops/drill/README.md",
      "ops/pocket/README.md", "ops/boss/README.md", "ops/plane_cut/README.md", "ops/emboss/README.md", "ops/rib/README.md", "ops/sweep/README.md",
      "ops/move/README.md", "ops/pattern/README.md", "ops/resize_bore/README.md", "ops/combine/README.md", "ops/hollow/README.md",
      "ops/deform/README.md", "ops/refine/README.md", "ops/coarsen/README.md"]),
    ("load_cases", "Load cases", "Supports, loads and materials as a file.", ["docs/load_cases.md"]),
    ("results", "Results", "What stress, safety factor, error estimate and warnings mean.", ["docs/results.md"]),
    ("improve", "Improving a mesh", "How tets get a better shape, and when.", ["docs/improve.md"]),
    ("recipes", "Recipes", "Whole jobs as a file, for the command line.", ["docs/recipes.md"]),
    ("verification", "Verification", "What the numbers were compared with.", ["docs/verification.md"]),
    ("plugins", "Plugins", "An operation of your own, from its first line to its test.", ["docs/plugins.md"]),
    ("operating", "Watching over a server", "Health, metrics, alarms, copies.", ["docs/operating.md"]),
    ("machines", "Other machines", "Clients by TLS and their users; workers: certificates, joining, what happens when one dies.", ["docs/machines.md"]),
    ("integrate", "From a program", "From an installation to a program that drives the server.", ["docs/integrate.md"]),
    ("python", "From Python", "The package tedit: a beginning, and what it has.", ["clients/python/README.md"]),
    ("typescript", "From TypeScript", "The package for Node and browsers: the same.", ["clients/typescript/README.md"]),
    ("protocol", "Protocol", "How a program speaks with the server.", ["docs/protocol.md"]),
    ("protocol_reference", "Protocol reference", "Every message, event and error code.", ["docs/protocol_reference.md"]),
    ("architecture", "Architecture", "The rooms of the sources, and where each promise is kept.", ["docs/architecture.md"]),
    ("actors", "Inside the server", "Its actors and worker processes.", ["docs/actors.md"]),
]
STYLE = """
:root { color-scheme: light dark; --ink: #20262f; --ground: #fbfcfd; --faint: #5c6673; --line: #d5dae1; --accent: #b8500c; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #dfe4ea; --ground: #1b1f24; --faint: #9aa4b0; --line: #39414b; --accent: #f0904e; } }
body { margin: 0; font: 16px/1.55 system-ui, sans-serif; color: var(--ink); background: var(--ground); }
nav { border-bottom: 1px solid var(--line); padding: .7rem 1.2rem; }
nav a { margin-right: 1rem; white-space: nowrap; } nav a.here { color: var(--ink); font-weight: 600; text-decoration: none; }
main { max-width: 56rem; margin: 0 auto; padding: 1rem 1.2rem 4rem; }
a { color: var(--accent); } h1, h2, h3 { line-height: 1.2; } h2 { margin-top: 2.2rem; }
img { max-width: 100%; height: auto; border-radius: 6px; }
pre { overflow-x: auto; padding: .8rem; border: 1px solid var(--line); border-radius: 6px; } code { font-size: .92em; }
table { border-collapse: collapse; display: block; overflow-x: auto; }
td, th { border: 1px solid var(--line); padding: .3rem .6rem; text-align: left; vertical-align: top; }
.toc { color: var(--faint); } .toc ul { margin: .2rem 0; }
"""


def page_of():
    """Each document, by its path, to its page."""
    return {document: f"{page}.html" for page, _, _, documents in PAGES for document in documents}


def link_documents(html):
    """`docs/results.md`, in the text or as a target, becomes a link to its page."""
    for document, page in page_of().items():
        html = re.sub(rf"<code>{re.escape(document)}</code>", f'<a href="{page}">{pathlib.Path(document).stem}</a>', html)
        html = html.replace(f'href="{document}"', f'href="{page}"')
        if document.startswith("docs/"):
            html = html.replace(f'href="{pathlib.Path(document).name}', f'href="{page}')
    return html


def copy_pictures(html, source, folder):
    for name in re.findall(r'<img[^>]* src="([^":]+)"', html):
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / source.parent / name, target)


def frame(title, here, body):
    links = "".join(
        f'<a href="{page}.html"{" class=here" if page == here else ""}>{name}</a>'
        for page, name in [("index", "Contents")] + [(page, name) for page, name, _, _ in PAGES])
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width"><title>{title} - TEdit</title>'
            f"<style>{STYLE}</style></head>\n<body><nav>{links}</nav><main>\n{body}\n</main></body></html>\n")


def to_html(path, several):
    """One document; beside others on its page its title is a heading with its folder's name as anchor."""
    text = (ROOT / path).read_text(encoding="utf-8")
    if several:
        text = re.sub(r"^(#+) ", r"#\1 ", text, flags=re.MULTILINE)
    return markdown.markdown(text, extensions=["tables", "fenced_code", "toc", "sane_lists"])


def make_page(page, title, documents, folder):
    several = len(documents) > 1
    body = f"<h1>{title}</h1>" if several else ""
    if several:
        names = [pathlib.Path(path).parent.name for path in documents]
        body += "<div class=toc><ul>" + "".join(f'<li><a href="#{name}">{name}</a></li>' for name in names) + "</ul></div>"
    for path in documents:
        html = to_html(path, several)
        copy_pictures(html, pathlib.Path(path), folder)
        body += html
    (folder / f"{page}.html").write_text(frame(title, page, link_documents(body)), encoding="utf-8")


def make_index(folder):
    rows = "".join(f'<li><a href="{page}.html">{title}</a>: {about}</li>' for page, title, about, _ in PAGES)
    body = ('<h1>TEdit</h1><p>Changes a meshed part and shows its stress at once.</p>'
            f'<p><img src="desktop.png" alt="The desktop client"></p><ul>{rows}</ul>')
    (folder / "index.html").write_text(frame("Manual", "index", body), encoding="utf-8")


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__.strip())
        return 0 if len(sys.argv) == 2 else 2
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    try:
        for page, title, _, documents in PAGES:
            make_page(page, title, documents, folder)
        make_index(folder)
    except OSError as fault:
        print(f"manual.py: {fault}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
