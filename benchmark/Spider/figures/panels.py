# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Views of what paper_figures wrote, by VTK, as arrays of pixels."""

import math
import pathlib
import sys

import numpy
import vtk
from vtk.util import numpy_support

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from report_parts import renderings  # noqa: E402

SUPERSAMPLING = 2   # per axis, against jagged outlines
SHARP_ANGLE = 50    # degrees: edges look sharp where faces meet at more
DARK = (0.1, 0.1, 0.12)
PALE = (0.86, 0.85, 0.82)
COLOURS = {"limb": DARK, "normal": (0.0, 0.45, 0.7), "section": (0.8, 0.2, 0.1), "feature": (0.84, 0.37, 0.0),
           "ridge": (0.0, 0.5, 0.36), "valley": (0.75, 0.5, 0.0), "query": (1.0, 0.75, 0.1), "sample": (0.8, 0.2, 0.1),
           "centroid": (0.8, 0.2, 0.1)}
LABELS = ((0, 158, 115), (240, 228, 66), (0, 114, 178), (213, 94, 0), (128, 128, 128))  # as label_color() has them


def to_vtk(values):
    return numpy_support.numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)


def lookup_table(colour_map, bound):
    """A colour map of Matplotlib for VTK, from -bound to bound."""
    steps = 256
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(steps)
    for i in range(steps):
        table.SetTableValue(i, *colour_map(i / (steps - 1)))
    table.SetNanColor(0.45, 0.45, 0.45, 1)
    table.SetRange(-bound, bound)
    return table


def lit(source, mapper, colour):
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*colour)
    look.SetInterpolationToPhong()
    look.SetAmbient(0.2)
    look.SetDiffuse(0.8)
    return actor


class View:
    """One panel: a mesh and what is drawn on it, seen from one side."""

    def __init__(self, figure, panel, look):
        self.panel, self.look = panel, look
        self.mesh = renderings.poly_data(figure["meshes"][panel["mesh"]])
        self.size = numpy.linalg.norm(numpy.ptp(numpy.array(figure["meshes"][panel["mesh"]]["points"]), axis=0))
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.add_surface()
        for kind, lines in panel["lines"].items():
            self.add_tubes(lines, self.width(kind), COLOURS[kind])
        for kind, points in panel.get("points", {}).items():
            self.add_balls(points, self.width(kind), COLOURS[kind])
        if look.get("hedgehog") and "vectors" in panel:
            self.add_hedgehog()
        if look.get("sphere"):
            self.add_sphere()
        self.add_lights()
        self.aim()

    def width(self, kind):
        """Of tubes and balls, in units of the mesh's extent."""
        return self.size * self.look.get("widths", {}).get(kind, self.look.get("width", 0.002))

    def add_surface(self):
        scalars = self.mesh.GetPointData()
        if "field" in self.panel and self.panel["field"]["name"] == "label":
            codes = numpy.array(self.panel["field"]["values"], dtype=int)
            scalars.SetScalars(to_vtk(numpy.array(LABELS, dtype=numpy.uint8)[codes]))
        elif "field" in self.panel:
            scalars.SetScalars(to_vtk(numpy.array(self.panel["field"]["values"], dtype=float)))
        elif "vectors" in self.panel:  # directions as colours: x, y, z as red, green, blue
            shares = (numpy.array(self.panel["vectors"], dtype=float) + 1) / 2
            scalars.SetScalars(to_vtk((255 * shares).astype(numpy.uint8)))
        normals = vtk.vtkPolyDataNormals()
        normals.SetInputData(self.mesh)
        normals.SetFeatureAngle(self.look.get("sharp_angle", SHARP_ANGLE))
        normals.ConsistencyOff()
        mapper = vtk.vtkPolyDataMapper()
        if "field" in self.panel and self.panel["field"]["name"] != "label":
            mapper.SetLookupTable(lookup_table(self.look["colour_map"], self.look["bound"]))
            mapper.UseLookupTableScalarRangeOn()
            mapper.InterpolateScalarsBeforeMappingOn()
        actor = lit(normals, mapper, PALE)
        if self.look.get("bright"):  # colours are to be told from one another, not from light and shade
            actor.GetProperty().SetAmbient(0.6)
            actor.GetProperty().SetDiffuse(0.45)
        if self.look.get("edges") and ("field" not in self.panel or self.look.get("edges_on_fields")):
            actor.GetProperty().EdgeVisibilityOn()
            actor.GetProperty().SetEdgeColor(0.35, 0.35, 0.38)
            actor.GetProperty().SetLineWidth(self.look.get("edge_width", 1.0) * SUPERSAMPLING)
        if self.look.get("flat"):
            actor.GetProperty().SetInterpolationToFlat()
        self.renderer.AddActor(actor)

    def add_tubes(self, lines, radius, colour):
        points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
        for line in lines or []:
            cells.InsertNextCell(len(line))
            for point in line:
                cells.InsertCellPoint(points.InsertNextPoint(point))
        data = vtk.vtkPolyData()
        data.SetPoints(points)
        data.SetLines(cells)
        tubes = vtk.vtkTubeFilter()
        tubes.SetInputData(data)
        tubes.SetRadius(radius)
        tubes.SetNumberOfSides(12)
        tubes.CappingOn()
        self.renderer.AddActor(lit(tubes, vtk.vtkPolyDataMapper(), colour))

    def add_balls(self, points, radius, colour):
        for point in points:
            ball = vtk.vtkSphereSource()
            ball.SetCenter(point)
            ball.SetRadius(2.2 * radius)
            ball.SetThetaResolution(24)
            ball.SetPhiResolution(24)
            self.renderer.AddActor(lit(ball, vtk.vtkPolyDataMapper(), colour))

    def add_hedgehog(self):
        length = self.look["hedgehog"] * self.size
        points = numpy_support.vtk_to_numpy(self.mesh.GetPoints().GetData())
        vectors = numpy.array(self.panel["vectors"], dtype=float)
        grid = self.look.get("hedgehog_grid")  # where strokes start, if not from all vertices
        if grid:
            chosen = numpy.abs(grid * points - numpy.round(grid * points)).max(axis=1) < 1e-5
            points, vectors = points[chosen], vectors[chosen]
        ends = points + length * vectors
        self.add_tubes(list(zip(points.tolist(), ends.tolist())), self.width("hedgehog"), DARK)

    def add_sphere(self):
        ball = vtk.vtkSphereSource()
        ball.SetCenter(self.panel["points"]["query"][0])
        ball.SetRadius(self.panel["radius"])
        ball.SetThetaResolution(96)
        ball.SetPhiResolution(96)
        actor = lit(ball, vtk.vtkPolyDataMapper(), (0.35, 0.55, 0.8))
        actor.GetProperty().SetOpacity(0.22)
        self.renderer.AddActor(actor)
        plane = vtk.vtkRegularPolygonSource()  # that fits the section best: through its centroid
        plane.SetCenter(self.panel["points"]["centroid"][0])
        plane.SetNormal(self.panel["direction"])
        plane.SetRadius(1.15 * self.panel["radius"])
        plane.SetNumberOfSides(96)
        actor = lit(plane, vtk.vtkPolyDataMapper(), (0.9, 0.6, 0.2))
        actor.GetProperty().SetOpacity(0.35)
        self.renderer.AddActor(actor)

    def add_lights(self):
        kit = vtk.vtkLightKit()
        kit.SetKeyLightIntensity(self.look.get("light", 0.9))
        kit.SetKeyLightAngle(40, -25)
        kit.SetKeyToFillRatio(self.look.get("fill", 2.0))
        for set_warmth in (kit.SetKeyLightWarmth, kit.SetFillLightWarmth, kit.SetHeadLightWarmth,
                           kit.SetBackLightWarmth):
            set_warmth(0.5)  # white: colour is for the field
        kit.AddLightsToRenderer(self.renderer)

    def aim(self):
        camera = self.renderer.GetActiveCamera()
        camera.SetViewAngle(20)
        camera.SetViewUp(*self.look.get("up", (0, 1, 0)))
        if "close_up" not in self.look:
            camera.SetPosition(*self.look["view"])
            camera.SetFocalPoint(0, 0, 0)
            bounds = self.look.get("bounds")
            self.renderer.ResetCamera(bounds) if bounds else self.renderer.ResetCamera()
            camera.Zoom(self.look.get("zoom", 1.35))
            camera.SetWindowCenter(*self.look.get("shift", (0, 0)))
            return
        # so many radii around the query point are in view, seen from its normal's end or, tilted, from aside
        query = numpy.array(self.panel["points"]["query"][0])
        view = numpy.array(self.panel["direction"]) + numpy.array(self.look.get("tilt", (0, 0, 0)))
        distance = self.look["close_up"] * self.panel["radius"] / math.tan(math.radians(10))
        camera.SetFocalPoint(*query)
        camera.SetPosition(*(query + distance * view / numpy.linalg.norm(view)))
        self.renderer.ResetCameraClippingRange()

    def pixels(self, width, height):
        window = vtk.vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(0)
        window.SetSize(width * SUPERSAMPLING, height * SUPERSAMPLING)
        window.AddRenderer(self.renderer)
        window.Render()
        grabber = vtk.vtkWindowToImageFilter()
        grabber.SetInput(window)
        grabber.ReadFrontBufferOff()
        smaller = vtk.vtkImageShrink3D()
        smaller.SetInputConnection(grabber.GetOutputPort())
        smaller.SetShrinkFactors(SUPERSAMPLING, SUPERSAMPLING, 1)
        smaller.AveragingOn()
        smaller.Update()
        image = numpy_support.vtk_to_numpy(smaller.GetOutput().GetPointData().GetScalars())
        return image.reshape(height, width, -1)[::-1, :, :3]
