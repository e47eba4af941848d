# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of meshes coloured by H, by VTK."""

import base64
import math

import numpy
import vtk
from vtk.util import numpy_support

WIDTH = 300   # pixels of one view
HEIGHT = 300
PER_ROW = 4


def poly_data(picture):
    points = vtk.vtkPoints()
    points.SetData(numpy_support.numpy_to_vtk(numpy.array(picture["points"], dtype=float), deep=True))
    faces = numpy.array(picture["faces"], dtype=numpy.int64)
    cells = vtk.vtkCellArray()
    with_counts = numpy.hstack([numpy.full((len(faces), 1), 3, dtype=numpy.int64), faces]).ravel()
    cells.SetCells(len(faces), numpy_support.numpy_to_vtkIdTypeArray(with_counts, deep=True))
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    return mesh


def colours(bound):
    """Blue, white, red, with zero white; what is NaN is grey."""
    ramp = vtk.vtkColorTransferFunction()
    ramp.SetColorSpaceToDiverging()
    ramp.AddRGBPoint(-1, 0.23, 0.30, 0.75)
    ramp.AddRGBPoint(1, 0.71, 0.016, 0.15)
    steps = 256
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(steps)
    for i in range(steps):
        table.SetTableValue(i, *ramp.GetColor(2 * i / (steps - 1) - 1), 1)
    table.SetNanColor(0.45, 0.45, 0.45, 1)
    table.SetRange(-bound, bound)
    return table


def view(picture, name, field, table, bounds):
    mesh = poly_data(picture)
    values = numpy.array([math.nan if value is None else value for value in field], dtype=float)
    mesh.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values, deep=True))
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.45)
    actor.GetProperty().SetDiffuse(0.6)
    title = vtk.vtkTextActor()
    title.SetInput(name)
    title.GetTextProperty().SetColor(0.1, 0.1, 0.1)
    title.GetTextProperty().SetFontSize(16)
    title.SetPosition(8, HEIGHT - 26)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    renderer.AddActor2D(title)
    renderer.SetViewport(*bounds)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(1.1, -1.6, 1.5)
    camera.SetViewUp(0, 0, 1)
    camera.SetFocalPoint(0, 0, 0)
    renderer.ResetCamera()
    camera.Zoom(1.25)
    return renderer


def legend(table, bounds):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.2g")
    bar.SetOrientationToHorizontal()
    bar.SetPosition(0.2, 0.05)
    bar.SetWidth(0.6)
    bar.SetHeight(0.9)
    bar.SetUnconstrainedFontSize(True)
    text = bar.GetLabelTextProperty()
    text.SetColor(0.1, 0.1, 0.1)
    text.SetFontSize(15)
    text.BoldOff()
    text.ItalicOff()
    text.ShadowOff()
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor2D(bar)
    renderer.SetViewport(*bounds)
    return renderer


def to_png(window):
    grabber = vtk.vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(grabber.GetOutputPort())
    writer.WriteToMemoryOn()
    writer.Write()
    return numpy_support.vtk_to_numpy(writer.GetResult()).tobytes()


def side_by_side(picture):
    """The truth and every estimate of a mesh in one picture, the scale that of the truth."""
    fields = picture["fields"]
    bound = numpy.quantile(numpy.abs(numpy.array(fields["truth"], dtype=float)), 0.98) * 2  # room for what is too much
    bound = bound if bound > 1e-6 else 1
    table = colours(bound)
    rows = math.ceil(len(fields) / PER_ROW)
    legend_height = 70
    height = rows * HEIGHT + legend_height
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(WIDTH * PER_ROW, height)
    paper = vtk.vtkRenderer()  # under all views, since the last row may be short
    paper.SetBackground(1, 1, 1)
    window.AddRenderer(paper)
    for i, (name, field) in enumerate(fields.items()):
        row, column = divmod(i, PER_ROW)
        top = 1 - row * HEIGHT / height
        bounds = (column / PER_ROW, top - HEIGHT / height, (column + 1) / PER_ROW, top)
        window.AddRenderer(view(picture, name, field, table, bounds))
    window.AddRenderer(legend(table, (0, 0, 1, legend_height / height)))
    window.Render()
    title = (f"{picture['shape'].replace('_', ' ')}, {picture['tessellation']}, noise {picture['noise']:g}, "
             f"radius {picture['radius']:g}")
    return {"title": title, "is_open": picture["tessellation"] == "irregular",
            "png": base64.b64encode(to_png(window)).decode()}
