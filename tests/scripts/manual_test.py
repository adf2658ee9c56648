#!/usr/bin/env python3
"""usage: manual_test.py FOLDER: every link, anchor and picture of the HTML manual leads somewhere, and no Markdown is
left in it."""
import html.parser
import pathlib
import sys


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.targets, self.pictures, self.anchors, self.words = [], [], set(), ""
        self.inside = []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.anchors.add(attrs.get("id"))
        if tag == "a":
            self.targets.append(attrs["href"])
        elif tag == "img":
            self.pictures.append(attrs["src"])
        elif tag in ("code", "style"):
            self.inside.append(tag)

    def handle_endtag(self, tag):
        if tag in ("code", "style"):
            self.inside.pop()

    def handle_data(self, data):
        if not self.inside:
            self.words += data


def faults_of(folder, pages):
    for name, page in pages.items():
        for target in page.targets:
            file, _, anchor = target.partition("#")
            if "://" in file:
                continue
            if (file or name) not in pages:
                yield f"{name}: {target} is no page"
            elif anchor and anchor not in pages[file or name].anchors:
                yield f"{name}: {target} has no such place"
        for picture in page.pictures:
            if not (folder / picture).stat().st_size:
                yield f"{name}: {picture} is empty"
        for left in ("|---", "](", "**", "```"):
            if left in page.words:
                yield f"{name}: Markdown is left in it: {left}"


def main():
    folder = pathlib.Path(sys.argv[1])
    pages = {path.name: Page(path) for path in folder.glob("*.html")}
    assert {"index.html", "desktop.html", "operations.html", "results.html"} <= pages.keys(), pages.keys()
    assert {"fill_hole", "erode"} <= pages["operations.html"].anchors
    faults = list(faults_of(folder, pages))
    print("\n".join(faults) or f"{len(pages)} pages")
    return 1 if faults else 0


sys.exit(main())
