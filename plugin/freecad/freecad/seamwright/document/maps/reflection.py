# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reflection Lines: zebra stripes, isophotes or highlight lines on faces.

The class path is written into documents: neither rename nor move it.
"""

import numpy

from freecad.seamwright.document.maps.surface_map import SurfaceMap, joined
from freecad.seamwright.plain import map_text, maps, ramps
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import ANGLE, CHOICE, COUNT, FLOAT, LENGTH, NUMBERS, Option
from freecad.seamwright.plain.preferences import ZEBRA_STRIPES

ZEBRA, ISOPHOTES = mark("Zebra stripes"), mark("Isophotes")
HIGHLIGHTS = mark("Highlight lines")

#: Without a given spacing, this many light lines lie over the model.
LIGHTS = 12

#: Without a given distance, they are this part of the size of the model above its middle.
HEIGHT = 0.5


def _is(kind):
    return lambda values: values["lines"] == kind


class ReflectionLines(SurfaceMap):
    """Proxy of a map of lines that shows how smoothly faces join."""

    Type = "ReflectionLines"
    LABEL = "Reflection Lines"
    ICON = "seamwright-reflection"
    TIP = (
        "Draw lines on the faces of the selected objects that break where faces meet at an angle, "
        "and bend where the curvature jumps: zebra stripes with options, isophotes or highlight "
        "lines. With nothing selected, they are drawn on all visible objects."
    )
    OPTIONS = (
        Option("Lines", "lines", CHOICE, ZEBRA, "Lines",
               "Zebra stripes: a mirror of light tubes, which moves with the view. Isophotes: "
               "lines of equal angle to a direction. Highlight lines: where the normals meet "
               "parallel lamps", choices=(ZEBRA, ISOPHOTES, HIGHLIGHTS)),
        Option("Stripes", "stripes", COUNT, ZEBRA_STRIPES.default, "Number of stripes",
               "Light stripes on a whole ball", least=1, used=_is(ZEBRA)),
        Option("Lean", "lean_deg", ANGLE, 30.0, "Direction of the stripes",
               "Angle by which the stripes lean; 0: upright, 90: level", used=_is(ZEBRA)),
        Option("Direction", "direction", NUMBERS, [0.0, 0.0, 1.0], "Direction",
               "Three numbers x; y; z: the direction to which angles are measured",
               used=_is(ISOPHOTES)),
        Option("Step", "step_deg", ANGLE, 10.0, "Angle between lines",
               "Angle from one isophote to the next", least=0.01, used=_is(ISOPHOTES)),
        Option("Lamps", "along", NUMBERS, [1.0, 0.0, 0.0], "Direction of the lamps",
               "Three numbers x; y; z: the direction of the parallel lamps", used=_is(HIGHLIGHTS)),
        Option("Above", "towards", NUMBERS, [0.0, 0.0, 1.0], "Lamps lie towards",
               "Three numbers x; y; z: the direction from the model to the lamps",
               used=_is(HIGHLIGHTS)),
        Option("Distance", "distance_mm", LENGTH, 0.0, "Distance of the lamps",
               "From the middle of the model; 0: half of the size of the model", least=0.0,
               zero=mark("automatic"), used=_is(HIGHLIGHTS)),
        Option("Spacing", "spacing_mm", LENGTH, 0.0, "Spacing of the lamps",
               "Distance from one lamp to the next; 0: 12 lamps over the model",
               least=0.0, zero=mark("automatic"), used=_is(HIGHLIGHTS)),
        Option("Width", "width", FLOAT, 0.5, "Width of the stripes",
               "Width of a light stripe, as a part of a light and a dark one", least=0.01,
               used=_is(ZEBRA)),
        Option("LineWidth", "line_width", FLOAT, 0.25, "Width of the lines",
               "Width of a line, as a part of the distance of two", least=0.01,
               used=lambda values: values["lines"] != ZEBRA),
    )  # fmt: skip
    RESULTS = ()
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def work(cls, inputs, values):
        """Return a callable(progress) -> [Values]; the lamps are placed over all of the objects."""
        check_width(values["width"])
        check_width(values["line_width"])
        for argument, what in (
            ("direction", "Direction"),
            ("along", "Direction of the lamps"),
            ("towards", "Lamps lie towards"),
        ):
            maps.unit(values[argument], what)
        meshes = super().work(inputs, values)

        def run(progress):
            found = meshes(progress)
            if found is None or values["lines"] != HIGHLIGHTS:
                return found
            return highlights(found, values)

        return run

    @classmethod
    def measured(cls, mesh, values):
        """Return angles in degrees for isophotes; highlight lines need all meshes together."""
        if values["lines"] == ISOPHOTES:
            return maps.isophote_angles_deg(mesh.normals, values["direction"])
        return numpy.zeros(len(mesh.points))

    @classmethod
    def mirrors(cls, values):
        """Return whether these are zebra stripes."""
        return values["lines"] == ZEBRA

    @classmethod
    def look(cls, found, values):
        """Return the Look of a list of Values; that of zebra stripes is the shader's."""
        places = joined(found)
        if values["lines"] == ISOPHOTES:
            places = places / values["step_deg"]
        return ramps.stripes_look(places, values["line_width"])

    @classmethod
    def report(cls, found, values):
        """Return what is drawn."""
        report = super().report(found, values)
        return {**report, "lines": values["lines"], "step_deg": values["step_deg"]}

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return map_text.reflection_text(report)


def check_width(width):
    """Raise ValueError where stripes would cover everything."""
    if not width < 1:
        raise ValueError(tr("Width = {width:g}: less than 1 is needed").format(width=width))


def highlights(found, values):
    """Return a list of Values with the positions of highlight lines, for meshes of all objects."""
    points = numpy.concatenate([each.mesh.points for each in found])
    if not len(points):
        return found
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    size = float(numpy.linalg.norm(numpy.ptp(points, axis=0)))
    distance = values["distance_mm"] or HEIGHT * size
    spacing = values["spacing_mm"] or size / LIGHTS
    return [
        each._replace(
            values=maps.highlight_positions(
                each.mesh.points - middle,
                each.mesh.normals,
                values["along"],
                values["towards"],
                distance,
                spacing,
            )
        )
        for each in found
    ]
