# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seam Plot: gap, angle and difference of curvature along seams, with the proven bounds.

The curves are sampled. The bounds are enclosures of the largest value on the whole seam. The class
path is written into documents: neither rename nor move it.
"""

from typing import Any, NamedTuple

import FreeCAD as App
import numpy
import Part

from freecad.seamwright.document import feature, sources
from freecad.seamwright.document.maps.tool import Input, Tool, element_shape
from freecad.seamwright.plain import kernel, seam_profile, seam_text
from freecad.seamwright.plain.language import tr
from freecad.seamwright.plain.options import COUNT, Option
from freecad.seamwright.plain.summary import counted

#: What is plotted: keys of reports and of profiles.
FIGURES = ("gap_mm", "angle_deg", "curvature_per_mm", "curvature_rel")

#: The default tolerances of an analysis, which decide where there is a curvature.
CREASE_DEG, FLAT_RADIUS_MM = 5.0, 1e5


class Seam(NamedTuple):
    """One seam: its ``name``, ``lengths_mm`` (n,) along it, ``points`` (n, 3), and
    ``figures`` {key of FIGURES: (n,)}. ``bounds``: {key: {lower, upper, at} or None}, proven for
    the whole seam where ``upper`` is a number. ``level``, ``note``: of the report."""

    name: str
    lengths_mm: Any
    points: Any
    figures: dict
    bounds: dict
    level: str
    note: str


class SeamPlot(Tool):
    """Proxy of plots along seams; ``found`` is a list of Seam."""

    Type = "SeamPlot"
    LABEL = "Seam Plot"
    ICON = "seamwright-plot"
    TIP = (
        "Plot gap, angle and curvature along the seams of the selected edges, with the proven "
        "bounds of the largest value. The mouse in the plot marks the point on the seam."
    )
    NEEDS = "select edges at which two faces meet"
    LINKS = (("Sources", "Seams", "Edges at which two faces meet"),)
    OPTIONS = (
        Option("Samples", "samples", COUNT, 201, "Points on a seam",
               "Number of points at which each seam is sampled", least=3),
    )  # fmt: skip
    RESULTS = (
        ("Seams", "App::PropertyInteger", "Number of seams", "count"),
        ("MaxGap", "App::PropertyLength", "Largest gap that was seen, in mm", "gap_mm"),
        ("MaxAngle", "App::PropertyAngle", "Largest angle that was seen, in degrees", "angle_deg"),
    )
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def check(cls, name, chosen):
        """Raise SourceError or ValueError where an element is no seam."""
        if not chosen:
            raise ValueError(tr("nothing is selected: {needs}").format(needs=tr(cls.NEEDS)))
        for obj, element in chosen:
            if not element.startswith("Edge"):
                raise ValueError(
                    tr("{name} is no edge: {needs}").format(
                        name=".".join(filter(None, (obj.Label, element))), needs=tr(cls.NEEDS)
                    )
                )
            sources.world_shape(obj)
            given = Input(obj.Label, Part.getShape(obj), sources.parent_placement(obj), element)
            _edge_and_faces(given)

    @classmethod
    def work(cls, inputs, values):
        """Return a callable(progress) -> [Seam]."""
        module = kernel.load(Part.OCC_VERSION)
        works = []
        for given in inputs["Sources"]:
            works.append(_prepared(module, *_edge_and_faces(given), place_name(given)))
        count = max(values["samples"], 3)

        def run(progress):
            found = []
            for index, work in enumerate(works):
                part = progress and (
                    lambda share, index=index: progress((index + share) / len(works))
                )
                found.append(work(count, part))
            return found

        return run

    @classmethod
    def job(cls, module, obj, private=False):
        """Return the Job; a stopped analysis raises Cancelled itself."""
        work, values = cls.prepared(obj)

        def finish(found):
            return cls.report(found, values), Part.Shape()

        return feature.Job(tr("Measuring the seams\u2026"), work, finish)

    @classmethod
    def report(cls, found, values):
        """Return the arrays and bounds of all seams as lists."""
        largest = {
            key: max((float(numpy.nanmax(each.figures[key], initial=0.0)) for each in found))
            for key in ("gap_mm", "angle_deg")
        }
        return {"count": len(found), **largest, "seams": [_plain(each) for each in found]}

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return seam_text.plot_text(report)


def place_name(given):
    """Return an Input as the user reads it: "Box.Edge3"."""
    return ".".join(filter(None, (given.label or given.name, given.element)))


def _edge_and_faces(given):
    """Return (edge, [faces]): the two faces that meet at an Input, or the one that closes there.

    Raises SourceError for an element that is no such edge.
    """
    whole = element_shape(given._replace(element=""))
    edge = element_shape(given._replace(shape=whole, parent=App.Placement()))
    found = [face for face in whole.Faces if any(each.isSame(edge) for each in face.Edges)]
    closes = len(found) == 1 and edge.isSeam(found[0])
    if len(found) != 2 and not closes:
        raise sources.SourceError(
            tr("{edge} bounds {faces}: {needs}").format(
                edge=place_name(given), faces=counted(len(found), "face"), needs=tr(SeamPlot.NEEDS)
            )
        )
    return edge, found


def _prepared(module, edge, faces, name):
    """Return a callable(samples, progress) -> Seam of an edge, for any thread."""
    part = Part.Compound(faces)
    number = next(n for n, each in enumerate(part.Edges, 1) if each.isSame(edge))
    make = module.bridge.model_later(part)
    # A copy, since FreeCAD may draw or change the shape meanwhile.
    part = part.copy()

    def run(samples, progress):
        report = make().analyze(level="G2", jobs=1, progress=progress).to_dict()
        seam = next((each for each in report["seams"] if number in each["edges"]), None)
        if seam is None:
            raise ValueError(tr("{name} is no seam: its faces do not meet there").format(name=name))
        lengths, points, figures = sampled(part.Edges[number - 1], part.Faces, samples)
        bounds = {key: seam[key] for key in FIGURES}
        return Seam(name, lengths, points, figures, bounds, seam["level"], seam["note"])

    return run


def sampled(edge, faces, samples):
    """Return (lengths_mm, points, {key of FIGURES: values}) along an edge of one or two faces.

    Both faces are evaluated along their own curves of the parameter plane, at the same parameters.
    """
    uses = [each for face in faces for each in face.Edges if each.isSame(edge)]
    curves = [_parameter_curve(face, edge, uses) for face in faces]
    if len(faces) == 1:
        curves.append(_parameter_curve(faces[0], edge.reversed(), uses))
    places = numpy.linspace(*edge.ParameterRange, samples)
    sides = [
        _side(face.Surface, curve, places)
        for face, curve in zip(faces if len(faces) == 2 else [*faces, *faces], curves)
    ]
    points = sides[0].points
    steps = numpy.linalg.norm(numpy.diff(points, axis=0), axis=1)
    lengths = numpy.concatenate([[0.0], numpy.cumsum(steps)])
    return lengths, points, seam_profile.profile(*sides, FLAT_RADIUS_MM, CREASE_DEG)


def _parameter_curve(face, edge, uses):
    found = face.curveOnSurface(edge)
    if found is None:
        raise ValueError(tr("a face has no curve in its parameters along the seam"))
    return found[0]


def _side(surface, curve, places):
    spots = [curve.value(float(at)) for at in places]
    pairs = [(spot.x, spot.y) for spot in spots]
    derivatives = {
        order: numpy.array([tuple(surface.getDN(u, v, *order)) for u, v in pairs])
        for order in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
    }
    points = numpy.array([tuple(surface.getD0(u, v)) for u, v in pairs])
    first = derivatives[1, 0], derivatives[0, 1]
    return seam_profile.side(
        points, first, (derivatives[2, 0], derivatives[1, 1], derivatives[0, 2])
    )


def _plain(seam):
    return {
        "name": seam.name,
        "lengths_mm": seam.lengths_mm.tolist(),
        "points": seam.points.tolist(),
        "figures": {
            key: [float(each) if numpy.isfinite(each) else None for each in values]
            for key, values in seam.figures.items()
        },
        "bounds": seam.bounds,
        "level": seam.level,
        "note": seam.note,
    }
