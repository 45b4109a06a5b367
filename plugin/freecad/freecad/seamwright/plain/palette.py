# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colour and the wording of each class and of each level of seams.

The colours of classes are bluish green and vermillion of the Okabe-Ito palette and a dark blue,
those of levels run from dark red over orange to blue. Readers with protanopia, deuteranopia and
tritanopia can tell them apart. The legend also names classes and levels in words.
"""

from dataclasses import dataclass

from freecad.seamwright.plain.language import mark, tr


@dataclass(frozen=True)
class SeamClass:
    """One class or level of seams: its key in the report, its name for readers and its colour."""

    key: str
    name: str
    standard_rgb: tuple  # red, green, blue, each 0..255

    @property
    def rgb(self):
        """The colour that the user has chosen, or the standard one."""
        return _chosen.get(self.key, self.standard_rgb)

    @property
    def unit_rgb(self):
        """The colour as three numbers 0..1, as FreeCAD's LineColorArray takes it."""
        return tuple(channel / 255.0 for channel in self.rgb)

    @property
    def html(self):
        """The colour as #rrggbb."""
        return "#%02x%02x%02x" % self.rgb


DEFECT = SeamClass("defect", mark("Defect"), (213, 94, 0))
CREASE = SeamClass("crease", mark("Crease"), (40, 70, 160))
SMOOTH = SeamClass("smooth", mark("Smooth"), (0, 158, 115))

#: Worst first: the order of the legend, of the filter and of the default sorting.
CLASSES = (DEFECT, CREASE, SMOOTH)
#: The levels of continuity, worst first.
LEVELS = (
    SeamClass("none", mark("No level"), (110, 0, 30)),
    SeamClass("G0", "G0", (213, 94, 0)),
    SeamClass("G1", "G1", (240, 180, 60)),
    SeamClass("G2", "G2", (70, 150, 220)),
    SeamClass("G3", "G3", (30, 50, 130)),
)

#: What each level says about the faces at a seam.
LEVEL_MEANINGS = {
    "none": mark("gap larger than the tolerance"),
    "G0": mark("meet with an angle"),
    "G1": mark("meet without a kink"),
    "G2": mark("equal curvature"),
    "G3": mark("equal change of curvature"),
}

BY_KEY = {seam_class.key: seam_class for seam_class in CLASSES}

#: {key: (red, green, blue)} that the user has chosen for classes and levels.
_chosen = {}


def use(colours):
    """Use these colours, {key: (red, green, blue)}; all others are the standard ones."""
    _chosen.clear()
    _chosen.update(colours)


def packed(rgb):
    """Return a colour as one number, 0xrrggbb00."""
    red, green, blue = rgb
    return red << 24 | green << 16 | blue << 8


def unpacked(number):
    """Return (red, green, blue) of a number that ``packed`` returns."""
    return number >> 24 & 255, number >> 16 & 255, number >> 8 & 255


def rank(key):
    """Return the position of a class in ``CLASSES``; 0 is the worst.

    Raises KeyError for an unknown class.
    """
    return CLASSES.index(BY_KEY[key])


def meaning(key, level, crease_deg):
    """Return what the class says about a seam, for example "meets G1"."""
    return {
        "smooth": tr("meets {level}").format(level=level),
        "defect": tr("falls short of {level}").format(level=level),
        "crease": tr("sharper than {crease_deg:g}\u00b0, taken as intended").format(
            crease_deg=crease_deg
        ),
    }[key]
