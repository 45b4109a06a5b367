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
from freecad.seamwright.document.maps import beside
from freecad.seamwright.document.maps.beside import MATCH_MM, Free
from freecad.seamwright.document.maps.tool import Input, Tool, element_shape
from freecad.seamwright.plain import kernel, seam_profile, seam_text
from freecad.seamwright.plain.language import tr
from freecad.seamwright.plain.options import COUNT, LENGTH, Option
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
    NEEDS = "select edges at which two faces meet, or edges that lie side by side"
    LINKS = (("Sources", "Seams", "Edges at which two faces meet, or edges side by side"),)
    OPTIONS = (
        Option("Samples", "samples", COUNT, 201, "Points on a seam",
               "Number of points at which each seam is sampled", least=3),
        Option("MatchDistance", "match_mm", LENGTH, MATCH_MM, "Edges lie side by side within",
               "Free edges no further apart than this are a seam, in mm", least=1e-9),
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
            if not element.startswith(("Edge", "Face")):
                raise ValueError(
                    tr("{name} is no edge: {needs}").format(
                        name=".".join(filter(None, (obj.Label, element))), needs=tr(cls.NEEDS)
                    )
                )
            sources.world_shape(obj)
        if not any(element.startswith("Edge") for _, element in chosen):
            raise ValueError(
                tr("{name} is no edge: {needs}").format(
                    name="%s.%s" % (chosen[0][0].Label, chosen[0][1]), needs=tr(cls.NEEDS)
                )
            )
        _, free = _divided(_inputs(cls.completed(chosen)))
        for each in free:
            if not any(
                beside.lie_side_by_side(each.edge, other.edge)
                for other in free
                if not other.edge.isSame(each.edge)
            ):
                raise _no_seam(each.name, 1)

    @classmethod
    def completed(cls, chosen):
        """Return links with the edges that lie beside free ones where the document knows them.

        The boundary of a blend lies beside the edges from which it was made.
        """
        found = list(chosen)
        _, free = _divided(_inputs(chosen))
        for each in free:
            others = [other for other in free if not other.edge.isSame(each.edge)]
            if any(beside.lie_side_by_side(each.edge, other.edge) for other in others):
                continue
            for link in beside.known_neighbours(chosen[each.place][0]):
                is_face = link[1].startswith("Face")
                if link not in found and (is_face or _is_beside(each.edge, link)):
                    found.append(link)
        return found

    @classmethod
    def work(cls, inputs, values):
        """Return a callable(progress) -> [Seam]."""
        module = kernel.load(Part.OCC_VERSION)
        count = max(values["samples"], 3)
        shared, free = _divided(inputs["Sources"])
        works = [_prepared(module, *each) for each in shared]
        if free:
            works.append(_side_by_side(module, free, values["match_mm"]))

        def run(progress):
            found = []
            for index, work in enumerate(works):
                part = progress and (
                    lambda share, index=index: progress((index + share) / len(works))
                )
                found += work(count, part)
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


def _inputs(chosen):
    return [
        Input(obj.Label, Part.getShape(obj), sources.parent_placement(obj), element)
        for obj, element in chosen
    ]


def _divided(inputs):
    """Return ([(edge, [faces], name)] of seams within an object, [Free]) of Inputs.

    Of an edge between two faces, one of which is an Input too, that face is the one that counts.
    Raises SourceError for an element that is no edge of a face.
    """
    inputs, shared, free = _with_common_shapes(inputs), [], []
    chosen_faces = {(each.shape.hashCode(), each.element) for each in inputs}
    for place, given in enumerate(inputs):
        if given.element.startswith("Face"):
            continue
        key, whole = given.shape.hashCode(), given.shape
        edge = element_shape(given)
        found = [
            (face, (key, "Face%d" % number) in chosen_faces)
            for number, face in enumerate(whole.Faces, 1)
            if any(each.isSame(edge) for each in face.Edges)
        ]
        faces, name = [face for face, _ in found], place_name(given)
        chosen = [face for face, is_chosen in found if is_chosen]
        if len(faces) == 1 and edge.isSeam(faces[0]) or len(faces) == 2 and not chosen:
            shared.append((edge, faces, name))
        elif len(faces) == 1 or len(chosen) == 1:
            free.append(Free(name, edge, (chosen or faces)[0], place))
        else:
            raise _no_seam(name, len(faces))
    return shared, free


def _with_common_shapes(inputs):
    """Return Inputs at their positions in the model, those of one object with the same shape.

    FreeCAD gives a shape another location each time it is asked for.
    """
    firsts, found = [], []
    for given in inputs:
        first = next(
            (
                (known, placed)
                for known, placed in firsts
                if (known.name, known.parent) == (given.name, given.parent)
                and known.shape.isPartner(given.shape)
            ),
            None,
        )
        if first is None:
            first = given, element_shape(given._replace(element=""))
            firsts.append(first)
        found.append(given._replace(shape=first[1], parent=App.Placement()))
    return found


def _is_beside(edge, link):
    """Return whether the edge of a link lies beside another one."""
    try:
        other = element_shape(_inputs([link])[0])
    except sources.SourceError:
        return False
    return other.ShapeType == "Edge" and beside.lie_side_by_side(edge, other)


def _no_seam(name, faces):
    return sources.SourceError(
        tr("{edge} bounds {faces}: {needs}").format(
            edge=name, faces=counted(faces, "face"), needs=tr(SeamPlot.NEEDS)
        )
    )


def _prepared(module, edge, faces, name):
    """Return a callable(samples, progress) -> [Seam] of an edge, for any thread."""
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
        return [_seam(name, seam, *sampled(part.Edges[number - 1], part.Faces, samples))]

    return run


def _seam(name, seam, lengths, points, figures):
    bounds = {key: seam[key] for key in FIGURES}
    leaves_out = any(seam["left_out"].values())
    known = {
        key: seam_profile.within(values, bounds[key], leaves_out)
        for key, values in figures.items()
    }
    return Seam(name, lengths, points, known, bounds, seam["level"], seam["note"])


def _side_by_side(module, free, match_mm):
    """Return a callable(samples, progress) -> [Seam] of Free, for any thread."""
    find = beside.seams_of(module, free, match_mm)

    def run(samples, progress):
        found, left = find(progress)
        if left:
            raise ValueError(
                tr("{name} has no other chosen edge beside it within {match_mm:g} mm").format(
                    name=left[0].name, match_mm=match_mm
                )
            )
        return [
            _seam(
                "%s \u2013 %s" % (one.name, other.name),
                seam,
                *sampled_beside(*sorted((one, other), key=lambda each: each.edge.Length), samples)
            )
            for seam, one, other in found
        ]

    return run


def sampled(edge, faces, samples):
    """Return (lengths_mm, points, {key of FIGURES: values}) along an edge of one or two faces.

    Both faces are evaluated along their own curves of the parameter plane, at the same parameters.
    """
    curves = [_parameter_curve(face, edge) for face in faces]
    if len(faces) == 1:
        curves.append(_parameter_curve(faces[0], edge.reversed()))
    places = numpy.linspace(*edge.ParameterRange, samples)
    return _measured(*(
        _side(face.Surface, curve, places)
        for face, curve in zip(faces if len(faces) == 2 else [*faces, *faces], curves)
    ))  # fmt: skip


def sampled_beside(one, other, samples):
    """Return what ``sampled`` does for two Free that lie side by side, along the first."""
    parameters = beside.corresponding(one.edge, other.edge, samples)
    return _measured(*(
        _side(each.face.Surface, _parameter_curve(each.face, each.edge), places)
        for each, places in zip((one, other), parameters)
    ))  # fmt: skip


def _measured(one, other):
    steps = numpy.linalg.norm(numpy.diff(one.points, axis=0), axis=1)
    lengths = numpy.concatenate([[0.0], numpy.cumsum(steps)])
    return lengths, one.points, seam_profile.profile(one, other, FLAT_RADIUS_MM, CREASE_DEG)


def _parameter_curve(face, edge):
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
