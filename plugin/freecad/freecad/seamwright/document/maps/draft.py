# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draft Angle: which faces of a part leave a mould that is pulled in a direction.

The class path is written into documents: neither rename nor move it.
"""

import numpy

from freecad.seamwright.document.maps.surface_map import SurfaceMap, joined
from freecad.seamwright.plain import map_text, maps, ramps
from freecad.seamwright.plain.options import ANGLE, NUMBERS, Option

#: Rounding of sines of angles: a face with exactly the least draft has it.
SLACK = 1e-9


class DraftAngle(SurfaceMap):
    """Proxy of a map of draft angles."""

    Type = "DraftAngle"
    LABEL = "Draft Angle"
    ICON = "seamwright-draft"
    TIP = (
        "Colour the faces of the selected objects by their angle to a direction of pull: those "
        "that leave a mould, those that are too steep, and those of the other half of the mould."
    )
    OPTIONS = (
        Option("Pull", "pull", NUMBERS, [0.0, 0.0, 1.0], "Direction of pull",
               "Three numbers x; y; z: the direction in which the mould is pulled off"),
        Option("Towards", "towards_deg", ANGLE, 3.0, "Least draft towards it",
               "Faces with at least this draft angle leave the half that is pulled", least=0.0),
        Option("Away", "away_deg", ANGLE, 3.0, "Least draft away from it",
               "Faces with at least this draft angle leave the other half", least=0.0),
    )  # fmt: skip
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def measured(cls, mesh, values):
        """Return the draft angle of each point in degrees."""
        return maps.draft_angles_deg(mesh.normals, values["pull"])

    @classmethod
    def look(cls, found, values):
        """Return the Look of a list of Values."""
        return ramps.draft_look(joined(found), values["towards_deg"], values["away_deg"])

    @classmethod
    def work(cls, inputs, values):
        """Return a callable(progress) -> [Values]; a bad direction is found before the work."""
        maps.unit(values["pull"], "Direction of pull")
        return super().work(inputs, values)

    @classmethod
    def report(cls, found, values):
        """Return the extremes, and the shares of the area of the three classes."""
        parts = numpy.sum([_areas(each, values) for each in found], axis=0)
        towards, away, whole = parts / max(parts[2], 1e-300)
        shares = {"towards": towards, "away": away, "steep": max(whole - towards - away, 0.0)}
        return {
            **super().report(found, values),
            "shares": {key: float(share) for key, share in shares.items()},
        }

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return map_text.draft_text(report)


def _areas(mapped, values):
    """Return the areas of Values that draft towards the pull, away from it, and in all.

    On a ball the sine of the draft angle is linear, so that its triangles are divided exactly.
    """
    sines = numpy.sin(numpy.radians(mapped.values))
    limits = numpy.sin(numpy.radians([values["towards_deg"], values["away_deg"]])) - SLACK
    mesh = mapped.mesh
    towards, whole = maps.area_above(mesh.points, mesh.triangles, sines, limits[0])
    away, _ = maps.area_above(mesh.points, mesh.triangles, -sines, limits[1])
    return towards, away, whole
