# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a fill that was not kept misses its tolerances: colours, legend, tolerances to allow.

A share is a figure divided by its tolerance; the largest share of the figures that decide the
target counts. Up to 1 the tolerances are met.
"""

import math

import numpy

from freecad.seamwright.plain import enclosure, fill_text, palette, ramps, rows, summary
from freecad.seamwright.plain.curvature import Sample
from freecad.seamwright.plain.language import tr

#: From yellow for little more than is allowed over vermillion to dark red for the largest share.
RAMP = ((0.0, (240, 200, 60)), (0.5, (213, 94, 0)), (1.0, (110, 0, 30)))

#: Faces that meet at a larger angle meet at an edge: no tolerance for tangent planes.
EDGE_DEG = 5.0

#: From this relative difference of curvature on, a tolerance would say nothing.
MOST_CURVATURE_REL = 1.0

#: A smaller tolerance counts as this one, so that shares stay finite.
LEAST = 1e-9


def shares(figures, limits, target):
    """Return the share at each point of a seam: of {key: values}, for the target level.

    Where no figure is known, as at a corner without a tangent plane, it is that beside.
    """
    each = [numpy.asarray(figures[name], float) / max(limits[name], LEAST)
            for name in rows.DECIDING[target]]  # fmt: skip
    found = numpy.fmax.reduce(each[1:] or each)
    known = numpy.flatnonzero(numpy.isfinite(found))
    if not len(known):
        return numpy.fmax(0.0, numpy.nan_to_num(each[0])).tolist()
    beside = numpy.interp(numpy.arange(len(found)), known, found[known])
    return numpy.fmax(beside, each[0]).tolist()


def lines(report):
    """Return [(points, shares), ...] along the seams of the fills that were not kept."""
    return [
        (along["points"], along["shares"])
        for seam in fill_text.every_seam(report)
        for along in seam.get("along", ())
    ]


def worst(seam):
    """Return (point, label) of the largest share along a seam of a fill that was not kept."""
    points = [point for along in seam["along"] for point in along["points"]]
    shares = [share for along in seam["along"] for share in along["shares"]]
    place = shares.index(max(shares))
    return points[place], "%s \u00d7" % enclosure.number(shares[place])


def largest(lines):
    """Return the largest share of all lines, at least 1."""
    return max([1.0, *(share for _, shares in lines for share in shares)])


def colours(shares, most):
    """Return a colour 0..1 for each share: that of smooth seams up to 1, then those of RAMP."""
    row = ramps.row_of(RAMP)
    return [
        palette.SMOOTH.unit_rgb if share <= 1 else _of_ramp(row, share, most) for share in shares
    ]


def _of_ramp(row, share, most):
    place = math.log(share) / math.log(most) if most > 1 else 0.0
    return tuple(channel / 255.0 for channel in row[min(int(place * len(row)), len(row) - 1)])


def legend(report, most):
    """Return (title, entries, footer) of the legend."""
    row, entries = ramps.row_of(RAMP), []
    for place in (1.0, 0.5) if most > 1 else ():
        share = most**place
        rgb = tuple(round(255 * channel) for channel in _of_ramp(row, share, most))
        name = "%s \u00d7" % enclosure.number(share)
        entries.append((Sample(rgb), name, tr("the tolerance")))
    entries.append((Sample(palette.SMOOTH.rgb), "\u2264 1 \u00d7", tr("within the tolerances")))
    judged = {"tolerance": report["tolerance"], "freecad": {"level": report["target"]}}
    return tr("Fill that is not kept"), entries, summary.tolerance_text(judged)


def allowed(report):
    """Return {argument: value}: the tolerances with which all fills would be kept that were not.

    Only those are named that are larger than now; none where a fill has another fault, or where
    faces would meet at an edge or with curvatures that have nothing in common.
    """
    left = [fill for fill in report["fills"] if not fill["filled"]]
    needed = [fill_text.allowing(fill, report["target"]) for fill in left]
    if not all(needed):
        return {}
    found = {}
    for name, now in report["tolerance"].items():
        wanted = max([0.0, *(each.get(name, 0.0) for each in needed)])
        if wanted > now:
            found[name] = wanted
    sensible = (
        found.get("angle_deg", 0.0) <= EDGE_DEG
        and found.get("curvature_rel", 0.0) < MOST_CURVATURE_REL
    )
    return found if sensible else {}
