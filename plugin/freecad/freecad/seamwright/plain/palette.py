# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colour and the wording of each class of seam.

The colours are bluish green and vermillion of the Okabe-Ito palette and a dark blue. Readers with
protanopia, deuteranopia and tritanopia can tell them apart. The legend also names the classes in
words.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class SeamClass:
    """One class of seam: its key in the report, its name for readers and its colour."""

    key: str
    name: str
    rgb: tuple  # red, green, blue, each 0..255

    @property
    def unit_rgb(self):
        """The colour as three numbers 0..1, as FreeCAD's LineColorArray takes it."""
        return tuple(channel / 255.0 for channel in self.rgb)

    @property
    def html(self):
        """The colour as #rrggbb."""
        return "#%02x%02x%02x" % self.rgb


DEFECT = SeamClass("defect", "Defect", (213, 94, 0))
CREASE = SeamClass("crease", "Crease", (40, 70, 160))
SMOOTH = SeamClass("smooth", "Smooth", (0, 158, 115))

#: Worst first: the order of the legend, of the filter and of the default sorting.
CLASSES = (DEFECT, CREASE, SMOOTH)
BY_KEY = {seam_class.key: seam_class for seam_class in CLASSES}


def rank(key):
    """Return the position of a class in ``CLASSES``; 0 is the worst.

    Raises KeyError for an unknown class.
    """
    return CLASSES.index(BY_KEY[key])


def meaning(key, level, crease_deg):
    """Return what the class says about a seam, for example "meets G1"."""
    return {
        "smooth": "meets %s" % level,
        "defect": "falls short of %s" % level,
        "crease": "sharper than %g\u00b0, taken as intended" % crease_deg,
    }[key]
