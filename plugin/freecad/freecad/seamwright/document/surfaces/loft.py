# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loft through Frames: the surface through two or more curves and all curves between them.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document.curves import blend
from freecad.seamwright.document.curves.blend import ORDERS, BlendCurves
from freecad.seamwright.document.surfaces.free import FreeSurface
from freecad.seamwright.document.surfaces.surface import TOLERANCES
from freecad.seamwright.plain import surface_text
from freecad.seamwright.plain.language import mark

#: What the curves between are made for.
FIXED = {"result": blend.SURFACE, "frames": 2}


class FrameLoft(FreeSurface):
    """Proxy of a Part::FeaturePython that holds the surface through curves."""

    Type = "FrameLoft"
    LABEL = "Loft through Frames"
    ICON = "seamwright-loft"
    TIP = (
        "Make the surface through two or more selected curves. Across the lines that join "
        "corresponding joints of the curves it is as smooth as the curves are: G1, G2 or more."
    )
    NEEDS = BlendCurves.NEEDS
    OPTIONS = (
        *(option for option in BlendCurves.OPTIONS if option.argument not in FIXED),
        *TOLERANCES,
    )
    RESULTS = (
        *FreeSurface.RESULTS,
        ("Distance", "App::PropertyLength", "Distance from the curves, in mm", "distance_mm"),
        ("Faces", "App::PropertyInteger", "Number of faces", "faces"),
    )
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def gather(cls, module, shapes, values):
        """Return the splines of the curves, in the order of the shapes."""
        return BlendCurves.gather(module, shapes, {**values, **FIXED})

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return the Blended."""
        return BlendCurves.compute(module, gathered, {**values, **FIXED}, progress)

    @classmethod
    def build(cls, module, found, values):
        """Return (report, faces)."""
        report, shape = BlendCurves.build(module, found, {**values, **FIXED})
        lines = [line.seam for loft in found.lofts for line in module.enclose_knot_lines(loft)]
        target = "G%d" % min(found.order, 2)
        seams = [
            {
                "id": number,
                "kind": surface_text.LINE,
                "edges": [],
                "worst": None,
                **seam.to_dict(),
                "side": mark("Inside"),
                "name": str(number),
                "target": target,
            }
            for number, seam in enumerate(lines, 1)
        ]
        return {**report, **cls.judged(seams, values)}, shape

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return surface_text.loft_summary(report)
