# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots by Matplotlib, as inline SVG."""

import io

import markupsafe
import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as pyplot  # noqa: E402 (the backend comes first)

from report_parts.tables import in_order, mean  # noqa: E402

matplotlib.rcParams.update({
    "svg.fonttype": "none",       # text stays text
    "svg.hashsalt": "spider",     # the same page every time
    "font.family": "sans-serif",
    "axes.grid": True,
    "grid.alpha": 0.3,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    "legend.fontsize": 8,
})


class Styles:
    """One look per estimator, the same in all plots: Spider's lines are thick, Meyer's dotted as in the paper."""

    def __init__(self, names):
        others = [name for name in names if not name.startswith("spider")]
        colours = pyplot.get_cmap("tab20").colors
        self.looks = {name: {"color": colours[(2 * i) % 20 + (2 * i) // 20], "linewidth": 1.3}
                      for i, name in enumerate(others)}
        own = ["#c2185b", "#7b1fa2", "#e65100", "#ad1457"]
        for i, name in enumerate(name for name in names if name.startswith("spider")):
            self.looks[name] = {"color": own[i % len(own)], "linewidth": 2.8, "zorder": 5}
        for name in names:
            if name.startswith("meyer"):
                colour = "black" if name == "meyer" else "#888888"
                self.looks[name].update(linestyle=":", linewidth=2, color=colour)

    def __getitem__(self, name):
        return {"marker": "o", "markersize": 3, **self.looks[name]}


def to_svg(figure):
    """The figure as an <svg> element."""
    out = io.StringIO()
    figure.savefig(out, format="svg", bbox_inches="tight", metadata={"Date": None})
    pyplot.close(figure)
    text = out.getvalue()
    return markupsafe.Markup(text[text.index("<svg"):])


def panels(titles, x_label, y_label):
    """A row of plots that share their vertical axis."""
    figure, axes = pyplot.subplots(1, len(titles), figsize=(3.6 * len(titles) + 1.4, 3.4), sharey=True, squeeze=False)
    for axis, title in zip(axes[0], titles):
        axis.set_title(title, fontsize=10)
        axis.set_xlabel(x_label)
        axis.set_yscale("log")
    axes[0][0].set_ylabel(y_label)
    return figure, axes[0]


def finish(figure, axes):
    lines, labels = axes[-1].get_legend_handles_labels()
    axes[-1].legend(lines, labels, loc="center left", bbox_to_anchor=(1.02, 0.5))
    return to_svg(figure)


def curve(axis, rows, x, y, style, label):
    """The mean of y over the rows at each x."""
    xs = sorted({row[x] for row in rows})
    ys = [mean([row for row in rows if row[x] == value], y) for value in xs]
    known = [(a, b) for a, b in zip(xs, ys) if b]
    if known:
        axis.plot(*zip(*known), label=label, **style)


def across(axis, rows, xs, y, style, label):
    """A level line, for an estimator that has no radius."""
    level = mean(rows, y)
    if level:
        axis.plot([min(xs), max(xs)], [level, level], label=label, **{**style, "marker": ""})


def accuracy(errors):
    """Error against radius at the most noise (the paper's figure 5), and against noise at the largest radius."""
    names = in_order(row["estimator"] for row in errors)
    styles = Styles(names)
    tessellations = in_order(row["tessellation"] for row in errors)
    radii = sorted({row["radius"] for row in errors} - {0})
    noises = sorted({row["noise"] for row in errors})

    result = []
    for measure, what, label in (("H_mean", "Mean curvature", "mean error of H / RMS curvature"),
                                 ("direction_mean", "Principal directions", "mean error, degrees")):
        figure, axes = panels(tessellations, "radius / mean edge length", label)
        for axis, tessellation in zip(axes, tessellations):
            for name in names:
                rows = [row for row in errors if (row["estimator"], row["tessellation"], row["noise"]) ==
                        (name, tessellation, noises[-1])]
                if any(row["radius"] for row in rows):
                    curve(axis, rows, "radius", measure, styles[name], name)
                elif radii:
                    across(axis, rows, radii, measure, styles[name], name)
        result.append({"title": f"{what} against the radius, noise {noises[-1]:g}", "svg": finish(figure, axes)})

        figure, axes = panels(tessellations, "noise / mean edge length", label)
        for axis, tessellation in zip(axes, tessellations):
            for name in names:
                rows = [row for row in errors if (row["estimator"], row["tessellation"]) == (name, tessellation)
                        and row["radius"] in (0, radii[-1] if radii else 0)]
                curve(axis, rows, "noise", measure, styles[name], name)
        at_radius = f", radius {radii[-1]:g}" if radii else ""
        result.append({"title": f"{what} against noise{at_radius}", "svg": finish(figure, axes)})
    return result


def border(rows):
    """Error against the distance from a border, at the largest radius."""
    if not rows:
        return []
    radius = max(row["radius"] for row in rows)
    names = in_order(row["estimator"] for row in rows)
    styles = Styles(names)
    noises = sorted({row["noise"] for row in rows})
    figure, axes = panels([f"noise {noise:g}" for noise in noises], "distance from the border / radius",
                          "mean error of H / RMS curvature")
    for axis, noise in zip(axes, noises):
        for name in names:
            chosen = [row for row in rows if (row["estimator"], row["noise"], row["radius"]) == (name, noise, radius)]
            if chosen:
                curve(axis, chosen, "distance", "H_mean", styles[name], name)
    return [{"title": f"Mean curvature near a border, radius {radius:g}", "svg": finish(figure, axes)}]


def speed(rows):
    """Time per vertex against the radius and against the size of the mesh; memory against the latter."""
    names = in_order(row["estimator"] for row in rows)
    styles = Styles(names)
    sizes = sorted({row["mesh_vertices"] for row in rows})
    by_radius = max(sizes, key=lambda size: len({row["radius"] for row in rows if row["mesh_vertices"] == size}))
    radii = {row["radius"] for row in rows}
    by_size = max(radii, key=lambda radius: len({row["mesh_vertices"] for row in rows if row["radius"] == radius}))

    figure, axes = panels([f"{by_radius:.0f} vertices", f"radius {by_size:g}"], "radius / mean edge length",
                          "µs per vertex, one thread")
    axes[1].set_xlabel("vertices")
    axes[1].set_xscale("log")
    for name in names:
        own = [row for row in rows if row["estimator"] == name]
        curve(axes[0], [row for row in own if row["mesh_vertices"] == by_radius], "radius", "microseconds", styles[name],
              name)
        curve(axes[1], [row for row in own if row["radius"] == by_size], "mesh_vertices", "microseconds", styles[name],
              name)
    return [{"title": "Time", "svg": finish(figure, axes)}]
