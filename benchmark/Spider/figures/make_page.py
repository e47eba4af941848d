#!/usr/bin/python3
# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gathers the claims of all figures that paper_figures wrote, and writes the page that shows them beside the pictures."""

import argparse
import json
import pathlib
import sys

HEAD = """# The paper's figures, made anew

The figures of Simari, Singh and Pedersen, *Spider: A robust curvature estimator for noisy, irregular meshes*, computed and
rendered by the programs in `benchmark/Spider/figures`, with what each claims, in the paper and measured here. The paper's scans
can't be had, so that other meshes stand in for them. One target makes pictures, numbers and this page anew:
`cmake --build <directory> --target spider_figures`, with `SPIDER_BUILD_BENCHMARKS` on. The numbers are also in
[paper_figures.json](fig/paper_figures.json).

In short: {reproduced} of {claims} claims are reproduced.{missing}

H is mean curvature, K Gaussian curvature, r the geodesic radius, a the mean edge length. *As published* means `as_published()`,
the paper's settings; `surface_fit` is Spider's default.
"""

# What each figure shows, and on what.
ABOUT = {
    1: "Four directions, so eight limbs, at a vertex on the elephant's chest, r = 4 a. The blue stroke is the "
       "normal. On the right the same limbs, resampled.",
    2: "Where the sphere of radius r = 3.5 a around a point on the elephant cuts the mesh (red), and the plane that fits that "
       "section best. Its normal (blue) starts the iteration in the paper.",
    3: "Three tessellations of the cube, irregular ones: diagonals turned at random, vertices moved by up to a quarter of a cell. "
       "Corresponding vertices are those of the coarsest cube. Colours and strokes are the normals that the iteration ends at, as "
       "published; the table has regular tessellations and the default estimator too. That one doesn't "
       "reproduce the claim: it measures limbs along the tangent plane, and they climb the cube's walls. Such a cube is for "
       "feature edges (figure 7), or for `section_fit`.",
    4: "A spider on the fandisk; feature edges (orange) are those at which faces turn by more than 40 degrees.",
    5: "The paper's saddle z = (x\u00b2 \u2212 y\u00b2)/2 of 2,500 vertices with its noise, five seeds, the interior. H passes through "
       "zero on a saddle, so errors are in units of its mean magnitude. The paper's radii are from a to 3 a; ours go on to 6 a.",
    6: "A wavy surface whose rows of vertices are up to 20 times as far apart in some places as in others, with a tenth of the "
       "edges flipped; no noise. Its curvature is known, so errors can be told.",
    7: "The cube of 20 cells with the paper's noise. With feature edges, limbs stop where sides meet. Errors are over the "
       "vertices inside of sides.",
    8: "The armadillo instead of the paper's scan.",
    9: "The bunny instead of the paper's scan, in the paper's colours: blue is positive, orange negative.",
    10: "The armadillo instead of the Buddha's base, r = 3 a: `classify_vertices()`, and the lines along which the larger "
        "curvature is twice the threshold of flatness (green) or the smaller one is minus that (ochre).",
    11: "The elephant, whose faces differ in size and shape, with the paper's noise, rounds and factor.",
}


def cell(text):
    return (text or "\u2013").replace("|", "\\|")


def verdict(claim):
    return {True: "yes", False: "**no**", None: "\u2013"}[claim["reproduced"]]


def table(claims):
    rows = ["| | paper | ours | reproduced |", "| --- | --- | --- | --- |"]
    rows += [f"| {cell(c['about'])} | {cell(c['paper'])} | {cell(c['ours'])} | {verdict(c)} |" for c in claims]
    return "\n".join(rows)


def section(figure):
    number = figure["number"]
    return (f"\n## Figure {number}: {figure['title']}\n\n![{figure['title']}](fig/figure_{number}.png)\n\n"
            f"{ABOUT[number]}\n\n{table(figure['claims'])}\n")


def head(figures):
    judged = [(f["number"], c) for f in figures for c in f["claims"] if c["reproduced"] is not None]
    missed = sorted({number for number, claim in judged if not claim["reproduced"]})
    missing = f" Those that aren't are in figure{'s' if len(missed) > 1 else ''} {', '.join(map(str, missed))}." if missed else ""
    return HEAD.format(reproduced=len(judged) - sum(not c["reproduced"] for _, c in judged), claims=len(judged),
                       missing=missing)


def page_of(figures):
    return head(figures) + "".join(section(figure) for figure in figures)


def gather(data):
    figures = []
    for number in sorted(ABOUT):
        figure = json.loads((data / f"figure_{number}.json").read_text())
        figures.append({key: figure[key] for key in ("number", "title", "claims", "curves")})
    return figures


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("page", type=pathlib.Path, help="the page; numbers go to fig/paper_figures.json beside it")
    parser.add_argument("--data", type=pathlib.Path,
                        help="the directory that paper_figures wrote to; without, the page is only checked against its numbers")
    arguments = parser.parse_args()
    numbers = arguments.page.parent / "fig" / "paper_figures.json"
    if arguments.data:
        numbers.write_text(json.dumps(gather(arguments.data), indent=1, ensure_ascii=False) + "\n")
        arguments.page.write_text(page_of(json.loads(numbers.read_text())))
    elif arguments.page.read_text() != page_of(json.loads(numbers.read_text())):
        sys.exit(f"{arguments.page} does not say what {numbers} does: make both anew, by the target spider_figures")


if __name__ == "__main__":
    main()
