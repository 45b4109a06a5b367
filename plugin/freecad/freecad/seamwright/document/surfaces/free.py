# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common parts of the document objects that are surfaces made of curves, not beside faces."""

import Part

from freecad.seamwright.document.curves import inputs
from freecad.seamwright.document.shape_feature import ShapeFeature
from freecad.seamwright.document.surfaces.surface import TOLERANCES
from freecad.seamwright.plain import kernel, options, surface_text

SOURCES = "Sources"


class FreeSurface(ShapeFeature):
    """Proxy of a Part::FeaturePython that holds faces made of curves.

    Its report has the entries of ``surface_text.build_rows``, and ``marks``.
    """

    GROUP = "Surface"
    LINKS = ((SOURCES, "Made from", "Edges, wires or sketches from which the surface is made"),)
    REQUIRED = (SOURCES,)
    RESULTS = (
        ("Reached", "App::PropertyBool", "Whether every seam certainly has its level", "reached"),
        ("MaxGap", "App::PropertyLength", "Upper bound of the gaps, in mm", "gap_mm"),
        ("MaxAngle", "App::PropertyAngle", "Upper bound of the angles of the seams, in degrees",
         "angle_deg"),
    )  # fmt: skip

    @classmethod
    def arranged(cls, chosen):
        """Return ({property: links}, {argument: value}) for the links of a selection.

        Raises SourceError or ValueError where they are not what is needed.
        """
        module = kernel.load(Part.OCC_VERSION)
        shapes = inputs.shapes_of(chosen)
        gathered = cls.gather(module, shapes, options.defaults(cls.OPTIONS))
        return {SOURCES: chosen}, cls.suggested(gathered)

    @classmethod
    def check(cls, name, chosen):
        """Raise SourceError or ValueError where the surface cannot have these links."""
        cls.arranged(chosen)

    @classmethod
    def marks(cls, report):
        """Return [(point, text), ...] that the panel shows in the view."""
        return report.get("marks", [])

    @classmethod
    def judged(cls, seams, values):
        """Return the entries of a report that are about seams with a side, name and target."""
        tolerance = {each.argument: values[each.argument] for each in TOLERANCES}
        rows = surface_text.build_rows({"seams": seams, "tolerance": tolerance})
        return {
            **surface_text.largest(seams),
            "seams": seams,
            "tolerance": tolerance,
            "reached": all(row.met for row in rows),
        }
