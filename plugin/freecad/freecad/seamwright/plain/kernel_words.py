# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences of the kernel in the words and units of the panels: degrees, % and labels of fields."""

import math
import re

from freecad.seamwright.plain.language import mark, tr

NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"

#: Numbers that a sentence compares with the one that it names: "G1 allows 0.0017".
LIMIT = r"(allows|at least|at most) (%s)(?! ?mm)" % NUMBER

#: How faces were matched. The group is the depth of the change in mm.
JOINED_IN_POLES = r"joined in poles(?:, inner knots along the seam repeated \w+ more)?"
JOINED_NEAR_THE_SEAM = r"joined to the tolerance by a change up to (\S+) mm from the side"

#: Arguments of the kernel that the panels have no field for.
WORDS = {"gap_mm": mark("gap"), "flat_rad": mark("tangents in one plane within")}


def in_words(text, labels=None):
    """Return a sentence without radians and names of arguments such as gap_mm or angle_rad.

    ``labels``: {argument: label of its field}, for sentences about the argument itself.
    """
    if re.search(r"_rad = |\brad\b", text):
        text = re.sub(LIMIT, lambda found: "%s %s" % (found[1], _degrees(found[2])), text)
    elif "curvature_rel = " in text:
        text = re.sub(LIMIT, lambda found: "%s %s" % (found[1], _percent(found[2])), text)
    text = re.sub(r"\w+_rad = %s \((%s) degrees\)" % (NUMBER, NUMBER), "\\1\u00b0", text)
    text = re.sub(r"\w+_rad = (%s)" % NUMBER, lambda found: _degrees(found[1]), text)
    text = re.sub(r"\b(%s) rad\b" % NUMBER, lambda found: _degrees(found[1]), text)
    text = re.sub(
        r"curvature_rel = (%s)" % NUMBER,
        lambda found: "a difference of curvature of %s" % _percent(found[1]),
        text,
    )
    text = re.sub(r"gap_mm = (%s)" % NUMBER, r"a gap of \1 mm", text)
    text = re.sub(r"(a gap of .*?), (%s) is possible" % NUMBER, r"\1, \2 mm is possible", text)
    named = {**WORDS, **(labels or {})}
    text = with_degree_signs(text)
    return re.sub(
        r"\b(\w+) (?=is %s)" % NUMBER,
        lambda found: "\u201c%s\u201d " % tr(named[found[1]]) if found[1] in named else found[0],
        text,
    )


def with_degree_signs(text):
    """Return a sentence that says 5° instead of 5 degrees, as the fields do."""
    return re.sub(r"\b(%s) degrees?\b" % NUMBER, "\\1\u00b0", text)


def _degrees(number):
    return "%.3g\u00b0" % math.degrees(float(number))


def _percent(number):
    return "%.3g %%" % (100 * float(number))
