#!/usr/bin/python3
# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the report in headless Chromium: what isn't drawn there is an error. Skipped (77) where there is no Chromium."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

import matplotlib.image

SKIPPED = 77  # what CTest is told to take for it


def find_chromium():
    """The first that runs: Ubuntu's package is a stub that only asks for a snap."""
    for name in ("chromium", "chromium-browser", "google-chrome"):
        path = shutil.which(name)
        if path and subprocess.run([path, "--version"], capture_output=True).returncode == 0:
            return path
    print("skipped: no Chromium to open the report in (Debian: chromium)")
    sys.exit(SKIPPED)


def take_screenshot(chromium, page, screenshot):
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:  # Chromium's own files
        subprocess.run([chromium, "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                        "--disable-background-networking", "--disable-component-update", "--disable-sync",
                        f"--user-data-dir={profile}", "--hide-scrollbars", "--window-size=1300,6000",
                        f"--screenshot={screenshot}", page.as_uri()], check=True, capture_output=True)


def main():
    page = pathlib.Path(sys.argv[1]).resolve()
    screenshot = page.with_suffix(".png")
    take_screenshot(find_chromium(), page, screenshot)

    pixels = matplotlib.image.imread(screenshot)[..., :3]
    red = (pixels[..., 0] > 0.6) & (pixels[..., 2] < 0.3)
    blue = (pixels[..., 2] > 0.6) & (pixels[..., 0] < 0.4)
    # measured: 0.0072 and 0.0045; 0.0006 each, the plots' lines, on a page without the pictures
    if not (red.mean() > 0.002 and blue.mean() > 0.002):
        sys.exit("error: the screenshot shows no surfaces coloured by H")
    print(screenshot)


if __name__ == "__main__":
    main()
