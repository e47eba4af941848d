#!/usr/bin/python3
# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders what the examples isolines_and_features and suggestive_contours wrote: the manual's picture of their uses.

Needs Debian's python3-vtk9; without a display, run it under xvfb-run.
"""

import argparse
import math
import pathlib

import vtk

SIZE = 700         # pixels of one view
SUPERSAMPLING = 2  # per axis, against jagged outlines
TUBE_RADIUS = 0.0022  # of the surface's diagonal, as is the next
SHOWN = 0.78          # the height of what a view shows
DARK = (0.1, 0.1, 0.12)
PALE = (0.93, 0.93, 0.91)


def read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def add_actor(renderer, data, colour=None):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetScalarVisibility(colour is None)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    if colour:
        look.SetColor(*colour)
    look.SetInterpolationToPhong()
    look.SetAmbient(0.2)
    look.SetDiffuse(0.8)
    renderer.AddActor(actor)


def with_normals(surface):
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


def tubes(lines, radius):
    filter_ = vtk.vtkTubeFilter()
    filter_.SetInputData(lines)
    filter_.SetRadius(radius)
    filter_.SetNumberOfSides(8)
    filter_.Update()
    return filter_.GetOutput()


def view(number, surface, colour, lines, viewer):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.SetViewport(number / 3, 0, (number + 1) / 3, 1)
    add_actor(renderer, surface, colour)
    if lines:
        add_actor(renderer, tubes(lines, TUBE_RADIUS * surface.GetLength()), DARK)
    lights = vtk.vtkLightKit()
    lights.SetKeyLightIntensity(0.95)
    lights.AddLightsToRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(*surface.GetCenter())
    camera.SetPosition(*viewer)
    camera.SetViewUp(0, 1, 0)
    distance = sum((a - b) ** 2 for a, b in zip(viewer, surface.GetCenter())) ** 0.5
    camera.SetViewAngle(math.degrees(SHOWN * surface.GetLength() / distance))
    renderer.ResetCameraClippingRange()
    return renderer


def save(renderers, width, height, path):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(width * SUPERSAMPLING, height * SUPERSAMPLING)
    for renderer in renderers:
        window.AddRenderer(renderer)
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
    parser.add_argument("directory", type=pathlib.Path, help="where features.ply and the two OBJ files are")
    parser.add_argument("viewer", type=float, nargs=3, help="what suggestive_contours was told")
    parser.add_argument("output", type=pathlib.Path, help="the PNG file")
    arguments = parser.parse_args()

    surface = with_normals(read(vtk.vtkPLYReader(), arguments.directory / "features.ply"))
    isolines = read(vtk.vtkOBJReader(), arguments.directory / "isolines.obj")
    contours = read(vtk.vtkOBJReader(), arguments.directory / "suggestive_contours.obj")
    renderers = [view(number, surface, colour, lines, arguments.viewer)
                 for number, (colour, lines) in enumerate(((None, None), (PALE, isolines), (PALE, contours)))]
    save(renderers, 3 * SIZE, SIZE, arguments.output)


if __name__ == "__main__":
    main()
