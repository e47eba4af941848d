# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables, as plain lists of titles and cells for the page's template."""

import statistics


def mean(rows, column):
    """The mean of a column over the rows that have it; None if none has."""
    found = [row[column] for row in rows if row.get(column) is not None]
    return statistics.mean(found) if found else None


def text(number):
    """Three digits."""
    if number is None:
        return "–"
    if number != 0 and not 0.001 <= abs(number) < 1000:
        return f"{number:.1e}"
    return f"{number:.0f}" if number >= 100 else f"{number:.3g}"


def cells(numbers, lowest_is_best=True):
    """The numbers of one column as cells, the lowest marked as the best."""
    known = [number for number in numbers if number is not None]
    best = min(known) if known and lowest_is_best else None
    return [{"text": text(number), "best": number is not None and number == best} for number in numbers]


AGREEMENT = "distance of H from the others', mean of medians"


def table(title, names, columns):
    """A table from (title, numbers) columns, one number per name; no best where agreement is what is counted."""
    marked = [cells(numbers, column_title != AGREEMENT) for column_title, numbers in columns]
    rows = [{"name": name, "cells": [column[i] for column in marked]} for i, name in enumerate(names)]
    return {"title": title, "columns": [column_title for column_title, _ in columns], "rows": rows}


def in_order(values):
    """Each value once, in the order of appearance."""
    return list(dict.fromkeys(values))


def bad_share(row):
    return {**row, "bad": 1000 * (row["nan"] + row["wild"]) / row["vertices"] if row["vertices"] else None}


MEASURES = [
    ("H_mean", "H, mean"),
    ("H_median", "H, median"),
    ("H_95", "H, 95th percentile"),
    ("H_worst", "H, worst"),
    ("K_mean", "K, mean"),
    ("min_curvature_mean", "smaller curvature, mean"),
    ("max_curvature_mean", "larger curvature, mean"),
    ("direction_mean", "directions, degrees"),
    ("normal_mean", "normals, degrees"),
    ("bad", "wild or NaN, per 1000"),
]


def accuracy(errors):
    """One table for each noise and radius: measures by tessellation; estimators without radius take part in all."""
    rows = [bad_share(row) for row in errors]
    tessellations = in_order(row["tessellation"] for row in rows)
    radii = sorted({row["radius"] for row in rows} - {0}) or [0]
    result = []
    for noise in sorted({row["noise"] for row in rows}):
        for radius in radii:
            chosen = [row for row in rows if row["noise"] == noise and row["radius"] in (0, radius)]
            names = in_order(row["estimator"] for row in chosen)
            groups = []
            for measure, title in MEASURES:
                for tessellation in tessellations:
                    numbers = [mean([row for row in chosen
                                     if row["estimator"] == name and row["tessellation"] == tessellation], measure)
                               for name in names]
                    groups.append((tessellation, numbers))
            one = table(f"noise {noise:g}, radius {radius:g} mean edge lengths", names, groups)
            one["groups"] = [{"title": title, "span": len(tessellations)} for _, title in MEASURES]
            result.append(one)
    return result


def is_own(name):
    return name.startswith("spider")


def best_of(rows, measure, is_wanted):
    """The lowest (error, name) among the estimators that are wanted; None if there is none."""
    names = [name for name in in_order(row["estimator"] for row in rows) if is_wanted(name)]
    found = [(mean([row for row in rows if row["estimator"] == name], measure), name) for name in names]
    return min(((error, name) for error, name in found if error is not None), default=None)


def in_short(errors):
    """Who errs least at each noise, radius and tessellation, and how far Spider's best is behind where it isn't Spider."""
    radii = sorted({row["radius"] for row in errors} - {0}) or [0]
    rows = []
    for noise in sorted({row["noise"] for row in errors}):
        for radius in radii:
            for tessellation in in_order(row["tessellation"] for row in errors):
                chosen = [row for row in errors if row["noise"] == noise and row["radius"] in (0, radius)
                          and row["tessellation"] == tessellation]
                cells_of_row = []
                for measure in ("H_mean", "direction_mean"):
                    best, own = best_of(chosen, measure, lambda name: True), best_of(chosen, measure, is_own)
                    if best is None:
                        continue
                    cells_of_row.append({
                        "leader": best[1], "error": text(best[0]), "leads": is_own(best[1]),
                        "own": own and own[1], "own_error": text(own and own[0]),
                        "behind": own and best[0] and text(own[0] / best[0])})
                rows.append({"noise": noise, "radius": radius, "tessellation": tessellation, "cells": cells_of_row})
    counts = [(title, sum(row["cells"][i]["leads"] for row in rows if len(row["cells"]) > i),
               sum(len(row["cells"]) > i for row in rows)) for i, title in enumerate(("mean curvature", "directions"))]
    return {"rows": rows, "counts": counts}


def stability(rows):
    """How much H changes on other triangulations, by radius."""
    result = []
    for radius in sorted({row["radius"] for row in rows} - {0}):
        chosen = [row for row in rows if row["radius"] in (0, radius)]
        names = in_order(row["estimator"] for row in chosen)
        columns = []
        for change in in_order(row["change"] for row in chosen):
            for measure, title in (("H_median", "median"), ("H_95", "95th percentile")):
                numbers = [mean([row for row in chosen if row["estimator"] == name and row["change"] == change], measure)
                           for name in names]
                columns.append((f"{change}, {title}", numbers))
        result.append(table(f"radius {radius:g}", names, columns))
    return result


def speed(rows):
    """Time and memory per vertex at every setting."""
    names = in_order(row["estimator"] for row in rows)
    settings = in_order((row["radius"], row["mesh_vertices"]) for row in rows)
    columns = []
    for measure, title in (("microseconds", "µs"), ("bytes_per_vertex", "bytes")):
        for radius, size in settings:
            chosen = [{**row, "bytes_per_vertex": row["peak_bytes"] / row["mesh_vertices"]} for row in rows
                      if (row["radius"], row["mesh_vertices"]) == (radius, size)]
            numbers = [mean([row for row in chosen if row["estimator"] == name], measure) for name in names]
            columns.append((f"{title}, r = {radius:g}, {size:.0f} vertices", numbers))
    return [table("Per vertex", names, columns)]


def scan(found):
    """For each mesh and radius: change on other triangulations, distance from the other estimators, time."""
    result = []
    for mesh, radius in in_order((row["mesh"], row["radius"]) for row in found["time"]):
        def at(table_name, **where):
            return [row for row in found.get(table_name, []) if row["mesh"] == mesh and row["radius"] == radius
                    and all(row[key] == value for key, value in where.items())]
        names = in_order(row["estimator"] for row in at("time"))
        columns = [(f"change of H when {change}, median",
                    [mean(at("stability", estimator=name, change=change), "H_median") for name in names])
                   for change in in_order(row["change"] for row in at("stability"))]
        columns.append((AGREEMENT,
                        [mean(at("agreement", estimator=name), "H_median") for name in names]))
        columns.append(("µs per vertex", [mean(at("time", estimator=name), "microseconds") for name in names]))
        result.append(table(f"{mesh}, radius {radius:g} mean edge lengths", names, columns))
    return result
