#!/usr/bin/python3
# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders what bunny_with_spider wrote from bunny00.off: the README's picture.

Needs Debian's python3-vtk9; without a display, run it under xvfb-run.
"""

import argparse
import json
import pathlib
import sys

import numpy
import vtk
from vtk.util import numpy_support

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from report_parts import renderings  # noqa: E402

WIDTH, HEIGHT = 1600, 1200  # pixels
SUPERSAMPLING = 2           # per axis, against jagged outlines
SHARE_IN_RANGE = 0.93       # of the vertices; the few sharp ridges beyond must not leave the rest pale
TUBE_RADIUS = 0.22          # in mean edge lengths, as are the next two
LIFT = 0.1                  # of the limbs off the surface, so that no facet hides them
QUERY_RADIUS = 1.0
DARK = (0.1, 0.1, 0.12)
GOLD = (1.0, 0.75, 0.1)     # of the query point, since H has no such colour


def to_vtk(values):
    return numpy_support.numpy_to_vtk(numpy.array(values, dtype=float), deep=True)


def add_actor(renderer, source, mapper, colour=DARK):
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*colour)
    look.SetInterpolationToPhong()
    look.SetAmbient(0.12)
    look.SetDiffuse(0.88)
    look.SetSpecular(0.15)
    look.SetSpecularPower(30)
    renderer.AddActor(actor)


def add_surface(renderer, picture, table):
    mesh = renderings.poly_data(picture)
    mesh.GetPointData().SetScalars(to_vtk(picture["H"]))  # None becomes NaN
    mesh.GetPointData().SetNormals(to_vtk(picture["normals"]))
    source = vtk.vtkTrivialProducer()
    source.SetOutput(mesh)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    add_actor(renderer, source, mapper)
    return mesh


def polylines(limbs, surface, lift):
    """The limbs, each point moved along the normal of the vertex next to it."""
    nearest = vtk.vtkStaticPointLocator()
    nearest.SetDataSet(surface)
    nearest.BuildLocator()
    normals = surface.GetPointData().GetNormals()
    points, lines = vtk.vtkPoints(), vtk.vtkCellArray()
    for limb in limbs:
        lines.InsertNextCell(len(limb))
        for point in limb:
            normal = normals.GetTuple(nearest.FindClosestPoint(point))
            lines.InsertCellPoint(points.InsertNextPoint(numpy.add(point, numpy.multiply(lift, normal))))
    result = vtk.vtkPolyData()
    result.SetPoints(points)
    result.SetLines(lines)
    return result


def add_spider(renderer, picture, surface):
    edge = picture["mean_edge_length"]
    tubes = vtk.vtkTubeFilter()
    tubes.SetInputData(polylines(picture["spider"]["limbs"], surface, LIFT * edge))
    tubes.SetRadius(TUBE_RADIUS * edge)
    tubes.SetNumberOfSides(16)
    tubes.CappingOn()
    add_actor(renderer, tubes, vtk.vtkPolyDataMapper())
    query = vtk.vtkSphereSource()
    query.SetCenter(picture["spider"]["query"])
    query.SetRadius(QUERY_RADIUS * edge)
    query.SetThetaResolution(32)
    query.SetPhiResolution(32)
    add_actor(renderer, query, vtk.vtkPolyDataMapper(), GOLD)


def add_text(renderer, text, x, y, size):
    actor = vtk.vtkTextActor()
    actor.SetInput(text)
    actor.SetPosition(x * SUPERSAMPLING, y * SUPERSAMPLING)
    look = actor.GetTextProperty()
    look.SetColor(*DARK)
    look.SetFontSize(size * SUPERSAMPLING)
    look.SetVerticalJustificationToCentered()
    renderer.AddActor2D(actor)


def add_legend(renderer, table):
    left, bottom, width, height = 1290, 700, 22, 360  # in the corner that the bunny's back leaves free
    low, high = table.GetRange()
    bar = vtk.vtkPlaneSource()
    bar.SetOrigin(left * SUPERSAMPLING, bottom * SUPERSAMPLING, 0)
    bar.SetPoint1((left + width) * SUPERSAMPLING, bottom * SUPERSAMPLING, 0)
    bar.SetPoint2(left * SUPERSAMPLING, (bottom + height) * SUPERSAMPLING, 0)
    bar.SetYResolution(table.GetNumberOfTableValues())
    values = vtk.vtkElevationFilter()
    values.SetInputConnection(bar.GetOutputPort())
    values.SetLowPoint(0, bottom * SUPERSAMPLING, 0)
    values.SetHighPoint(0, (bottom + height) * SUPERSAMPLING, 0)
    values.SetScalarRange(low, high)
    mapper = vtk.vtkPolyDataMapper2D()
    mapper.SetInputConnection(values.GetOutputPort())
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(low, high)
    actor = vtk.vtkActor2D()
    actor.SetMapper(mapper)
    renderer.AddActor2D(actor)
    add_text(renderer, "H", left, bottom + height + 46, 34)
    for share, label in ((0, f"\u2212{high:g}  concave"), (0.5, "0  flat"), (1, f"+{high:g}  convex")):
        add_text(renderer, label, left + width + 14, bottom + share * height, 24)
    add_text(renderer, "1 / bunny length", left, bottom - 46, 24)  # bunny00.off is one unit long


def scene(picture):
    bound = round(numpy.nanquantile(numpy.abs(numpy.array(picture["H"], dtype=float)), SHARE_IN_RANGE))
    table = renderings.colours(bound)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    surface = add_surface(renderer, picture, table)
    add_spider(renderer, picture, surface)
    add_legend(renderer, table)
    lights = vtk.vtkLightKit()
    lights.SetKeyLightIntensity(0.9)
    lights.SetKeyLightAngle(40, -25)
    lights.SetKeyToFillRatio(2.2)
    for set_warmth in (lights.SetKeyLightWarmth, lights.SetFillLightWarmth, lights.SetHeadLightWarmth,
                       lights.SetBackLightWarmth):
        set_warmth(0.5)  # white: colour is for H
    lights.AddLightsToRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(-0.15, 0.25, 1)  # the bunny's flank, a little from the front and from above
    camera.SetViewUp(0, 1, 0)
    camera.SetViewAngle(20)
    renderer.ResetCamera()
    camera.Zoom(1.4)
    camera.SetWindowCenter(0.17, -0.065)  # the legend is on the right
    return renderer


def render(picture, path):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(WIDTH * SUPERSAMPLING, HEIGHT * SUPERSAMPLING)
    window.AddRenderer(scene(picture))
    window.Render()
    grabber = vtk.vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    smaller = vtk.vtkImageShrink3D()
    smaller.SetInputConnection(grabber.GetOutputPort())
    smaller.SetShrinkFactors(SUPERSAMPLING, SUPERSAMPLING, 1)
    smaller.AveragingOn()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(smaller.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", type=pathlib.Path, help="what bunny_with_spider wrote")
    parser.add_argument("output", type=pathlib.Path, help="the PNG file")
    arguments = parser.parse_args()
    render(json.loads(arguments.picture.read_text()), arguments.output)


if __name__ == "__main__":
    main()
