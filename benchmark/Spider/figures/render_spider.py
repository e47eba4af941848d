#!/usr/bin/python3
# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders one spider on its mesh, as the paper's figure 1: what the example trace_spider wrote.

Needs Debian's python3-vtk9; without a display, run it under xvfb-run.
"""

import argparse
import pathlib
import sys

import numpy
import vtk
from vtk.util import numpy_support

sys.dont_write_bytecode = True  # the source tree stays as it is

from render_uses import DARK, PALE, add_actor, read, save, tubes, with_normals  # noqa: E402

WIDTH, HEIGHT = 1400, 900  # pixels
VERMILION, GOLD, EDGES = (0.84, 0.37, 0.0), (1.0, 0.75, 0.1), (0.72, 0.72, 0.74)
LIFT = 0.004        # of the limbs off the surface, in radii, so that no facet hides them
TUBE_RADIUS = 0.008  # in radii of the spider, as are all that follow
STEP_RADIUS = 0.017
END_RADIUS = 0.024
SHOWN = 1.25        # half of the height of what is seen
STEP = 0.1          # of resampling: the paper's


def limbs_of(data):
    points = numpy_support.vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    lines, ids = data.GetLines(), vtk.vtkIdList()
    lines.InitTraversal()
    result = []
    while lines.GetNextCell(ids):
        result.append(numpy.array([points[ids.GetId(i)] for i in range(ids.GetNumberOfIds())]))
    return result


def along(limb, length):
    """The point at an arc length."""
    steps = numpy.linalg.norm(numpy.diff(limb, axis=0), axis=1)
    reached = numpy.concatenate([[0], numpy.cumsum(steps)])
    return numpy.array([numpy.interp(length, reached, limb[:, i]) for i in range(3)])


def add_balls(renderer, centres, radius, colour):
    for centre in centres:
        ball = vtk.vtkSphereSource()
        ball.SetCenter(*centre)
        ball.SetRadius(radius)
        ball.SetThetaResolution(24)
        ball.SetPhiResolution(24)
        ball.Update()
        add_actor(renderer, ball.GetOutput(), colour)


def polylines(limbs, offset):
    points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
    for limb in limbs:
        cells.InsertNextCell(len(limb))
        for point in limb + offset:
            cells.InsertCellPoint(points.InsertNextPoint(*point))
    result = vtk.vtkPolyData()
    result.SetPoints(points)
    result.SetLines(cells)
    return result


def scene(surface, limbs):
    centre, radius = limbs[0][0], numpy.linalg.norm(numpy.diff(limbs[0], axis=0), axis=1).sum()
    ends = numpy.array([limb[-1] for limb in limbs]) - centre
    normal = numpy.cross(ends, numpy.roll(ends, -1, axis=0)).sum(axis=0)
    normal /= numpy.linalg.norm(normal)

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    add_actor(renderer, surface, PALE)
    edges = vtk.vtkExtractEdges()
    edges.SetInputData(surface)
    edges.Update()
    add_actor(renderer, tubes(edges.GetOutput(), TUBE_RADIUS / 3 * radius), EDGES)
    add_actor(renderer, tubes(polylines(limbs, LIFT * radius * normal), TUBE_RADIUS * radius), DARK)
    samples = [along(limb, STEP * i * radius) for limb in limbs for i in range(2, 10)]
    add_balls(renderer, samples, STEP_RADIUS * radius, DARK)
    add_balls(renderer, [limb[-1] for limb in limbs], END_RADIUS * radius, VERMILION)
    add_balls(renderer, [centre], 1.5 * END_RADIUS * radius, GOLD)

    lights = vtk.vtkLightKit()
    lights.SetKeyLightIntensity(0.9)
    lights.AddLightsToRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(SHOWN * radius)
    camera.SetFocalPoint(*centre)
    tilted = normal + 0.45 * ends[0] / numpy.linalg.norm(ends[0])  # a little from the side, so that heights show
    camera.SetPosition(*(centre + 10 * radius * tilted))
    camera.SetViewUp(*(-ends[0]))
    renderer.ResetCameraClippingRange()
    return renderer


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesh", type=pathlib.Path, help="the mesh as PLY, as isolines_and_features writes it")
    parser.add_argument("limbs", type=pathlib.Path, help="what trace_spider wrote")
    parser.add_argument("output", type=pathlib.Path, help="the PNG file")
    arguments = parser.parse_args()
    surface = with_normals(read(vtk.vtkPLYReader(), arguments.mesh))
    limbs = limbs_of(read(vtk.vtkOBJReader(), arguments.limbs))
    save([scene(surface, limbs)], WIDTH, HEIGHT, arguments.output)


if __name__ == "__main__":
    main()
