#!/usr/bin/python3
# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders what paper_figures wrote: the paper's figures, figure_<number>.png.

Needs Debian's python3-vtk9 and python3-matplotlib; without a display, run it under xvfb-run.
"""

import argparse
import json
import math
import pathlib

import matplotlib

matplotlib.use("agg")
import matplotlib.colors  # noqa: E402 (the backend comes first)
import matplotlib.patches  # noqa: E402
import matplotlib.pyplot as pyplot  # noqa: E402
import numpy  # noqa: E402

from panels import COLOURS, LABELS, View, renderings  # noqa: E402

DPI = 100
TITLE, BAR = 34, 190   # pixels: above each panel, and right of all for the legend
SHARE_IN_RANGE = 0.95  # of the values that the scale is chosen by; the few beyond must not leave the rest pale


def red_and_blue():
    table = renderings.colours(1)
    return matplotlib.colors.ListedColormap([table.GetTableValue(i) for i in range(table.GetNumberOfTableValues())])


def blue_and_orange():
    """The paper's in figure 9: blue is positive, orange negative."""
    return matplotlib.colors.LinearSegmentedColormap.from_list("K", [(0.75, 0.35, 0.0), (0.97, 0.72, 0.45),
                                                                     (0.96, 0.96, 0.95), (0.55, 0.7, 0.88),
                                                                     (0.1, 0.3, 0.62)])


# How each figure is seen: columns of panels, the size of one in pixels, the look that View has, and what the legend says.
# `scale_by` is the panel whose values choose the shared scale.
LOOKS = {
    1: {"columns": 2, "size": (660, 520), "look": {"close_up": 1.3, "tilt": (0, 0.45, -0.35), "edges": True,
                                                   "width": 0.0015, "widths": {"query": 0.0024, "sample": 0.0012}}},
    2: {"columns": 1, "size": (860, 600), "look": {"close_up": 1.75, "tilt": (0, 0.75, -0.6), "sphere": True,
                                                   "edges": True, "width": 0.0022}},
    3: {"columns": 3, "size": (430, 430), "normals": True,
        "look": {"view": (1, 0.7, 1.4), "hedgehog": 0.06, "hedgehog_grid": 8, "width": 0.0013, "zoom": 1.05,
                 "edges": True, "edge_width": 0.6, "fill": 1.3, "bright": True}},
    4: {"columns": 1, "size": (560, 330), "look": {"width": 0.0022, "widths": {"feature": 0.0014, "query": 0.0032},
                                                   "close_up": 1.25, "tilt": (-0.5, 0.45, 0), "edges": True, "edge_width": 0.5}},
    5: {"columns": 1, "size": (600, 500), "look": {"view": (1.0, -1.5, 1.0), "up": (0, 0, 1), "edges": True,
                                                   "flat": True, "zoom": 1.25}},
    6: {"columns": 4, "size": (300, 300), "scale_by": 3, "unit": "1 / length",
        "look": {"view": (0.1, -0.7, 1.6), "up": (0, 0, 1), "edges": True, "zoom": 1.08, "edge_width": 0.5}},
    7: {"columns": 2, "size": (480, 430), "scale_by": 2, "unit": "1 / edge of the cube", "normals": True,
        "look": {"view": (1, 0.7, 1.4), "hedgehog": 0.04, "width": 0.0012, "zoom": 1.08, "sharp_angle": 60,
                 "fill": 1.2, "bright": True}},
    8: {"columns": 2, "size": (520, 540), "scale_by": 1, "unit": "1 / length",
        "look": {"view": (0.25, 0.1, -1), "edges": True, "zoom": 1.36, "edge_width": 0.4}},
    9: {"columns": 4, "size": (380, 380), "scale_by": 2, "unit": "1 / bunny length\u00b2", "colour_map": "K",
        "look": {"view": (-0.15, 0.25, 1), "zoom": 1.3}},
    10: {"columns": 2, "size": (540, 560), "labels": True,
         "look": {"view": (0.25, 0.1, -1), "zoom": 1.36, "width": 0.0012}},
    11: {"columns": 2, "size": (540, 520), "look": {"view": (1, 0.3, 0.35), "zoom": 1.4, "flat": True}},
}


def round_up(value):
    """To two digits, so that the legend is easy to read."""
    digit = 10 ** (math.floor(math.log10(value)) - 1)
    return math.ceil(value / digit) * digit


def scale(figure, layout):
    """The look with the colour map and the bound that all panels share."""
    look = dict(layout["look"])
    look["colour_map"] = blue_and_orange() if layout.get("colour_map") == "K" else red_and_blue()
    if "scale_by" in layout:
        values = numpy.array(figure["panels"][layout["scale_by"]]["field"]["values"], dtype=float)
        look["bound"] = round_up(numpy.nanquantile(numpy.abs(values), SHARE_IN_RANGE))
    return look


class Sheet:
    """A picture that is laid out by pixels."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.figure = pyplot.figure(figsize=(width / DPI, height / DPI), dpi=DPI, facecolor="white")

    def axes(self, left, top, width, height):
        return self.figure.add_axes((left / self.width, 1 - (top + height) / self.height, width / self.width,
                                     height / self.height))

    def image(self, pixels, left, top):
        axes = self.axes(left, top, pixels.shape[1], pixels.shape[0])
        axes.imshow(pixels, interpolation="none")
        axes.axis("off")

    def text(self, text, left, top, size=15, **options):
        self.figure.text(left / self.width, 1 - top / self.height, text, fontsize=size, va="center", color="#1a1a1f",
                         **options)

    def save(self, path):
        self.figure.savefig(path, dpi=DPI, metadata={"Software": None})
        pyplot.close(self.figure)


def add_scale(sheet, figure, layout, look, left, first):
    name = figure["panels"][layout["scale_by"]]["field"]["name"]
    bound = look["bound"]
    top, height = first * sheet.height, 0.44 * sheet.height
    axes = sheet.axes(left + 20, top, 22, height)
    norm = matplotlib.colors.Normalize(-bound, bound)
    bar = sheet.figure.colorbar(matplotlib.cm.ScalarMappable(norm, look["colour_map"]), cax=axes,
                                ticks=[-bound, -bound / 2, 0, bound / 2, bound])
    bar.ax.tick_params(labelsize=13)
    bar.outline.set_visible(False)
    sheet.text(name, left + 20, top - 26, 19, style="italic")
    sheet.text(layout["unit"], left + 20, top + height + 26, 12)


def add_keys(sheet, keys, left, first=0.36):
    for i, (colour, name) in enumerate(keys):
        top = first * sheet.height + 36 * i
        axes = sheet.axes(left + 20, top, 22, 22)
        axes.add_patch(matplotlib.patches.Rectangle((0, 0), 1, 1, color=colour))
        axes.axis("off")
        sheet.text(name, left + 54, top + 11, 13)


NORMAL_KEYS = (((1, 0.5, 0.5), "n = +x"), ((0.5, 1, 0.5), "n = +y"), ((0.5, 0.5, 1), "n = +z"))
LINE_KEYS = ((COLOURS["ridge"], "\u03ba\u2098\u2090\u2093 = 2t"), (COLOURS["valley"], "\u03ba\u2098\u1d62\u2099 = \u22122t"))
LABEL_KEYS = tuple(([channel / 255 for channel in LABELS[i]], name)
                   for i, name in enumerate(("convex", "concave", "flat", "saddle")))


def render(figure, path):
    layout = LOOKS[figure["number"]]
    look = scale(figure, layout)
    (width, height), columns = layout["size"], layout["columns"]
    rows = math.ceil(len(figure["panels"]) / columns)
    title = TITLE if any(panel["title"] for panel in figure["panels"]) else 0
    has_legend = any(key in layout for key in ("scale_by", "normals", "labels"))
    plot = 620 if figure["curves"] else 0
    sheet = Sheet(columns * width + plot + (BAR if has_legend else 0), rows * (height + title))
    for i, panel in enumerate(figure["panels"]):
        row, column = divmod(i, columns)
        top = row * (height + title)
        sheet.image(View(figure, panel, look).pixels(width, height), column * width, top + title)
        sheet.text(panel["title"], (column + 0.5) * width, top + title / 2, ha="center")
    legend = columns * width
    if "scale_by" in layout:
        add_scale(sheet, figure, layout, look, legend, 0.48 if "normals" in layout else 0.28)
    if "labels" in layout:
        add_keys(sheet, LABEL_KEYS, legend)
        add_keys(sheet, LINE_KEYS, legend, 0.66)
    if "normals" in layout:
        add_keys(sheet, NORMAL_KEYS, legend, 0.15 if "scale_by" in layout else 0.36)
    if figure["curves"]:
        add_curves(sheet, figure["curves"], legend)
    sheet.save(path)


def add_curves(sheet, curves, left):
    axes = sheet.axes(left + 90, 30, 500, sheet.height - 100)
    looks = ({"linestyle": ":", "color": "black", "linewidth": 2.2}, {"color": "#7b1fa2", "linewidth": 1.8, "marker": "o"},
             {"color": "#c2185b", "linewidth": 2.8, "marker": "o"})
    for curve, look in zip(curves, looks):
        axes.plot(curve["x"], curve["y"], label=curve["name"], **look)
    axes.set_yscale("log")
    axes.set_xlabel("radius / mean edge length", fontsize=13)
    axes.set_ylabel("mean relative error of H", fontsize=13)
    axes.tick_params(labelsize=12)
    axes.grid(alpha=0.3, which="both")
    axes.axvspan(1, 3, color="#888888", alpha=0.1, lw=0)
    axes.text(2, axes.get_ylim()[0] * 1.15, "the paper's radii", ha="center", fontsize=11, color="#555555")
    axes.legend(frameon=False, fontsize=12, loc="upper right")
    axes.set_ylim(top=3 * axes.get_ylim()[1])  # room for the legend
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("data", type=pathlib.Path, help="the directory that paper_figures wrote to; PNGs go there too")
    parser.add_argument("numbers", nargs="*", type=int, help="of the figures; all if none is given")
    arguments = parser.parse_args()
    for number in arguments.numbers or sorted(LOOKS):
        figure = json.loads((arguments.data / f"figure_{number}.json").read_text())
        render(figure, arguments.data / f"figure_{number}.png")


if __name__ == "__main__":
    main()
