#!/usr/bin/python3
# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the manual's curves and tables of what compare_accuracy and compare_speed wrote.

Writes figures.json, from which a test knows the numbers that documents may state, accuracy_table.md, speed_table.md, and
fig/radius.svg, fig/border.svg and fig/speed.svg. Needs Debian's python3-matplotlib.
"""

import argparse
import collections
import json
import pathlib
import re
import statistics

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as pyplot  # noqa: E402 (the backend comes first)

matplotlib.rcParams.update({
    "svg.fonttype": "none",    # text stays text
    "svg.hashsalt": "spider",  # the same file every time
    "font.family": "sans-serif",
    "font.sans-serif": ["Helvetica", "Arial", "DejaVu Sans", "sans-serif"],
    "axes.grid": True,
    "grid.alpha": 0.3,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
})

SHOWN = {  # what the documents call the estimators, and how their curves look; Okabe and Ito's colours
    "spider": ("Spider", {"color": "#D55E00", "linewidth": 2.8, "zorder": 5}),
    "spider_d4": ("Spider, degree 4", {"color": "#D55E00", "linewidth": 1.6, "linestyle": "--", "zorder": 4}),
    "spider_published": ("Spider as published", {"color": "#CC79A7", "linewidth": 1.6}),
    "jet2_ball": ("jets, degree 2", {"color": "#0072B2", "linewidth": 1.6}),
    "jet4_ball": ("jets, degree 4", {"color": "#0072B2", "linewidth": 1.6, "linestyle": "--"}),
    "icc_ball_area": ("corrected curvatures", {"color": "#009E73", "linewidth": 1.6}),
    "normal_cycle": ("normal cycle", {"color": "#777777", "linewidth": 1.6}),
    "rusinkiewicz": ("Rusinkiewicz 2004", {}),
    "meyer": ("Meyer et al. 2003", {}),
}
TESSELLATIONS = ("regular", "irregular", "slivers")
RADIUS = 4  # mean edge lengths: that of the tables, and of the curve along borders


def read(directory, program):
    return json.loads((directory / f"{program}.json").read_text())


def mean(rows, measure):
    """The mean over seeds and surfaces; None if nothing was measured, as of directions on a sphere."""
    values = [row[measure] for row in rows if row.get(measure) is not None]
    return statistics.fmean(values) if values else None


def grouped(rows, *columns):
    """Rows by the values of some columns."""
    groups = collections.defaultdict(list)
    for row in rows:
        groups[tuple(row[column] for column in columns)].append(row)
    return groups


def rounded(value, digits=3):
    return None if value is None else float(f"{value:.{digits}g}")


def accuracy(rows):
    groups = grouped(rows, "estimator", "noise", "tessellation")
    return [{"estimator": estimator, "noise": noise, "tessellation": tessellation, "H": rounded(mean(group, "H_mean")),
             "direction": rounded(mean(group, "direction_mean"))}
            for (estimator, noise, tessellation), group in groups.items()]


def curves(rows):
    return [{"estimator": estimator, "noise": noise, "radius": radius, "H": rounded(mean(group, "H_mean"))}
            for (estimator, noise, radius), group in grouped(rows, "estimator", "noise", "radius").items()]


def border(rows):
    at_radius = [row for row in rows if row["radius"] == RADIUS]
    return [{"estimator": estimator, "noise": noise, "distance": distance, "H": rounded(mean(group, "H_mean"))}
            for (estimator, noise, distance), group in grouped(at_radius, "estimator", "noise", "distance").items()]


def speed(rows):
    """The best of repeated measurements, in units of that of the jets that everybody knows."""
    size = statistics.mode(row["mesh_vertices"] for row in rows)
    best = {key: min(row["microseconds"] for row in group)
            for key, group in grouped([row for row in rows if row["mesh_vertices"] == size],
                                      "estimator", "radius").items()}
    return [{"estimator": estimator, "radius": radius, "time": rounded(time / best["jet2_ball", RADIUS])}
            for (estimator, radius), time in best.items()]


def find(rows, measure, **wanted):
    return next((row[measure] for row in rows if all(row[key] == value for key, value in wanted.items())), None)


def headlines(data):
    """What the documents say in words; the test looks for these texts."""
    def average(estimator, noise, measure):
        return statistics.fmean(find(data["accuracy"], measure, estimator=estimator, noise=noise, tessellation=t)
                                for t in TESSELLATIONS)

    def beside(other, noise, measure):
        ratio = average("spider", noise, measure) / average(other, noise, measure)
        return f"{abs(1 - ratio):.0%} {'smaller' if ratio < 1 else 'larger'}".replace("%", " %")

    def times(radius):
        return (find(data["speed"], "time", estimator="jet2_ball", radius=radius)
                / find(data["speed"], "time", estimator="spider", radius=radius))

    result = {
        "H": f"errors of mean curvature {beside('jet2_ball', 1, 'H')}",
        "H_low_noise": f"{beside('jet2_ball', 0.25, 'H')} at a quarter of the noise",
        "direction": f"errors of directions {beside('jet2_ball', 1, 'direction')}",
        "speed": f"{times(RADIUS):.1f} times as fast",
        "speed_large": f"{times(2 * RADIUS):.1f} times as fast at twice the radius",
    }
    if any(row["estimator"] == "icc_ball_area" for row in data["accuracy"]):
        result["corrected"] = (f"errors of H {beside('icc_ball_area', 1, 'H')} and errors of directions "
                               f"{beside('icc_ball_area', 1, 'direction')}")
        result["corrected_low_noise"] = (f"{beside('icc_ball_area', 0.25, 'H')} and "
                                         f"{beside('icc_ball_area', 0.25, 'direction')} at a quarter of the noise")
    if any(row["estimator"] == "spider_published" for row in data["accuracy"]):
        ratio = average("spider_published", 1, "H") / average("spider", 1, "H")
        result["published"] = f"{ratio:.0f} times the error of H at s = 1"
    return result


def panels(titles, x_label, y_label):
    figure, axes = pyplot.subplots(1, len(titles), figsize=(3.2 * len(titles), 3.6), sharey=True, squeeze=False)
    for axis, title in zip(axes[0], titles):
        axis.set_title(title, fontsize=11)
        axis.set_xlabel(x_label)
        axis.set_yscale("log")
        axis.minorticks_off()
    axes[0][0].set_ylabel(y_label)
    return figure, axes[0]


def plot(axis, rows, x, y):
    for name, (label, style) in SHOWN.items():
        points = sorted((row[x], row[y]) for row in rows if row["estimator"] == name and row[y] is not None)
        if points:
            axis.plot(*zip(*points), label=label, marker="o", markersize=3.5, **style)


def save(figure, axes, path):
    lines, labels = axes[-1].get_legend_handles_labels()
    figure.legend(lines, labels, loc="lower center", ncol=3, bbox_to_anchor=(0.5, -0.14), fontsize=10)
    figure.tight_layout()
    figure.savefig(path, bbox_inches="tight", metadata={"Date": None})
    pyplot.close(figure)


def edges_axis(axis, radii):
    axis.set_xscale("log")
    axis.set_xticks(radii, [f"{radius:g}" for radius in radii])
    axis.set_xticks([], minor=True)


def draw(data, directory):
    noises = sorted({row["noise"] for row in data["curves"]})
    figure, axes = panels([f"noise s = {noise:g}" for noise in noises], "r / a", "mean error of H / RMS curvature")
    for axis, noise in zip(axes, noises):
        plot(axis, [row for row in data["curves"] if row["noise"] == noise], "radius", "H")
        edges_axis(axis, sorted({row["radius"] for row in data["curves"]}))
    save(figure, axes, directory / "radius.svg")

    figure, axes = panels([f"noise s = {noise:g}" for noise in noises], "distance / r",
                          "mean error of H / RMS curvature")
    for axis, noise in zip(axes, noises):
        plot(axis, [row for row in data["border"] if row["noise"] == noise], "distance", "H")
    save(figure, axes, directory / "border.svg")

    radii = sorted({row["radius"] for row in data["speed"]})
    figure, axes = panels([""], "r / a", f"time, jets of degree 2 at r = {RADIUS} a being 1")
    figure.set_size_inches(6.4, 4)
    plot(axes[0], data["speed"], "radius", "time")
    edges_axis(axes[0], radii)
    save(figure, axes, directory / "speed.svg")


def table(first, columns, rows):
    lines = ["| " + " | ".join([first] + columns) + " |", "| --- |" + " ---: |" * len(columns)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def shown_number(value):
    return "–" if value is None else f"{value:.2g}" if value < 9.5 else f"{value:.0f}"


def accuracy_table(data):
    columns = [(noise, tessellation) for noise in sorted({row["noise"] for row in data["accuracy"]})
               for tessellation in TESSELLATIONS]
    values = {name: [find(data["accuracy"], "H", estimator=name, noise=noise, tessellation=tessellation)
                     for noise, tessellation in columns] for name in SHOWN}
    best = [min(row[i] for row in values.values() if row[i] is not None) for i in range(len(columns))]
    rows = [[SHOWN[name][0]] + [f"**{shown_number(v)}**" if v == b else shown_number(v) for v, b in zip(row, best)]
            for name, row in values.items() if any(v is not None for v in row)]
    return table("error of H", [f"s = {noise:g}, {tessellation}" for noise, tessellation in columns], rows)


def speed_table(data):
    radii = sorted({row["radius"] for row in data["speed"]})
    rows = [[SHOWN[name][0]] + [shown_number(find(data["speed"], "time", estimator=name, radius=radius))
                                for radius in radii]
            for name in SHOWN if any(row["estimator"] == name for row in data["speed"])]
    return table("time", [f"r = {radius:g} a" for radius in radii], rows)


def run_of(results):
    command = re.sub(r" --(no-progress|output \S+)", "", results["command_line"])
    return {"command_line": command, "CGAL": results["CGAL"], "compiler": results["compiler"]}


ACCURACY_NOTE = f"""Mean absolute errors of H over interior vertices, in units of the surface's root mean square curvature; the least of
  each column is bold. Averages over sphere, torus, ellipsoid, saddle and waves of about 10,000 vertices each, one seed; vertices
  moved by uniform noise of ± s a/2 along the normal, a the mean edge length. The radius is {RADIUS} a, but for the last two, which look at one ring."""

SPEED_NOTE = f"""Times per vertex on an irregular torus of 10,000 vertices, one core, the best of five, in units of that of jets of
  degree 2 at r = {RADIUS} a."""


def note(text, data, runs):
    """What a table's numbers are, and the commands that made them."""
    commands = ", ".join(f"`{data['runs'][name]['command_line']}`" for name in runs)
    about = data["runs"][runs[0]]
    return f"\n- {text}\n- Run with CGAL {about['CGAL']} and g++ {about['compiler'].split()[0]}: {commands}.\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("curves", type=pathlib.Path, help="what compare_accuracy wrote at several radii")
    parser.add_argument("tables", type=pathlib.Path, nargs="+", help="what it wrote at one radius, and compare_speed")
    parser.add_argument("--output", type=pathlib.Path, required=True, help="doc/Spider")
    arguments = parser.parse_args()

    at_radii = read(arguments.curves, "accuracy")
    at_one = [read(directory, "accuracy") for directory in arguments.tables if (directory / "accuracy.json").exists()]
    times = next(read(directory, "speed") for directory in arguments.tables if (directory / "speed.json").exists())
    accuracies = [f"accuracy {i + 1}" for i in range(len(at_one))]
    data = {
        "runs": {"curves": run_of(at_radii), **dict(zip(accuracies, map(run_of, at_one))), "speed": run_of(times)},
        "accuracy": accuracy([row for results in at_one for row in results["tables"]["errors"]]),
        "curves": curves(at_radii["tables"]["errors"]),
        "border": border(at_radii["tables"]["border"]),
        "speed": speed(times["tables"]["speed"]),
    }
    data["headlines"] = headlines(data)
    draw(data, arguments.output / "fig")
    (arguments.output / "accuracy_table.md").write_text(accuracy_table(data) + note(ACCURACY_NOTE, data, accuracies))
    (arguments.output / "speed_table.md").write_text(speed_table(data) + note(SPEED_NOTE, data, ["speed"]))
    (arguments.output / "figures.json").write_text(json.dumps(data, indent=1) + "\n")


if __name__ == "__main__":
    main()
