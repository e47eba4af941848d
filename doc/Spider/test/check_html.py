#!/usr/bin/env python3
# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the generated manual: every relative link leads to a file, every anchor to a place in it, every picture is there.

    check_html.py <directory of the manual>
"""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """The targets and the anchors of a page."""

    def __init__(self, path):
        super().__init__()
        self.targets, self.anchors = set(), set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key in ("href", "src", "data") and value:
                self.targets.add(value)
            if key in ("id", "name") and value:
                self.anchors.add(value)


def broken(directory, name, page, pages):
    for target in page.targets:
        parts = urllib.parse.urlparse(target)
        if parts.scheme or parts.netloc or target.startswith("javascript:"):
            continue
        path = urllib.parse.unquote(parts.path)
        if path and not (directory / path).exists():
            yield f"{name}: {target} leads nowhere"
        elif parts.fragment and (path.endswith(".html") or not path):
            to = pages.get(path) or page
            if urllib.parse.unquote(parts.fragment) not in to.anchors:
                yield f"{name}: {target} has no such anchor"


def main():
    directory = pathlib.Path(sys.argv[1])
    pages = {path.name: Page(path) for path in sorted(directory.glob("*.html"))}
    if "index.html" not in pages:
        sys.exit(f"error: {directory} has no index.html")
    errors = [error for name, page in pages.items() for error in broken(directory, name, page, pages)]
    for error in errors:
        print(error, file=sys.stderr)
    print(f"{len(pages)} pages, {sum(len(page.targets) for page in pages.values())} links")
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
