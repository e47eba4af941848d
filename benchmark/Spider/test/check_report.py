#!/usr/bin/python3
# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the report from a directory of results and opens it in headless Chromium: what a reader would miss is an error."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import matplotlib.image


def run(*command):
    return subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True).stdout


def expect(condition, what):
    if not condition:
        sys.exit(f"error: {what}")


def main():
    report, chromium, directory = sys.argv[1:4]
    directory = pathlib.Path(directory)
    virtual_screen = [] if os.environ.get("DISPLAY") else [shutil.which("xvfb-run"), "-a"]
    page = pathlib.Path(run(*virtual_screen, sys.executable, report, directory).strip()).resolve()

    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:  # Chromium's own files
        browser = [chromium, "--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}"]
        dom = run(*browser, "--dump-dom", page.as_uri())
        screenshot = directory / "report.png"
        run(*browser, "--hide-scrollbars", "--window-size=1300,6000", f"--screenshot={screenshot}", page.as_uri())

    for heading in ("Errors against radius and noise", "What it looks like", "Errors near a border", "Errors in figures",
                    "Other triangulations", "Time and memory", "Meshes without truth", "Settings", "To reproduce"):
        expect(heading in dom, f"the page lacks \"{heading}\"")
    expect(dom.count("<svg") == 6, f"the page has {dom.count('<svg')} plots, not 6")
    expect(dom.count("data:image/png") == 6, "the page lacks pictures of two shapes in three tessellations")
    expect('class="best"' in dom, "no cell is marked as the best")
    expect("src=\"http" not in dom and "href=\"http" not in dom, "the page isn't self-contained")

    pixels = matplotlib.image.imread(screenshot)[..., :3]
    red = (pixels[..., 0] > 0.6) & (pixels[..., 2] < 0.3)
    blue = (pixels[..., 2] > 0.6) & (pixels[..., 0] < 0.4)
    expect(red.mean() > 0.005 and blue.mean() > 0.005, "the screenshot shows no surfaces coloured by H")
    print(f"{page}\n{screenshot}")


if __name__ == "__main__":
    main()
