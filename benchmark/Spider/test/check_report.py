#!/usr/bin/python3
# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the report from a directory of results: what a reader would miss is an error."""

import os
import pathlib
import shutil
import subprocess
import sys


def expect(condition, what):
    if not condition:
        sys.exit(f"error: {what}")


def main():
    report, directory = sys.argv[1:3]
    virtual_screen = [] if os.environ.get("DISPLAY") else [shutil.which("xvfb-run"), "-a"]
    made = subprocess.run([*virtual_screen, sys.executable, report, directory], check=True, capture_output=True, text=True)
    last_line = made.stdout.splitlines()[-1]
    page = pathlib.Path(last_line).read_text()

    for heading in ("In short", "Errors against radius and noise", "What it looks like", "Errors near a border",
                    "Errors in figures", "Other triangulations", "Time and memory", "Meshes without truth", "Settings",
                    "To reproduce"):
        expect(heading in page, f"the page lacks \"{heading}\"")
    expect(page.count("<svg") == 6, f"the page has {page.count('<svg')} plots, not 6")
    expect(page.count("data:image/png") == 4, "the page lacks pictures of two shapes in two tessellations")
    expect('class="best"' in page, "no cell is marked as the best")
    expect("src=\"http" not in page and "href=\"http" not in page, "the page isn't self-contained")
    print(last_line)


if __name__ == "__main__":
    main()
