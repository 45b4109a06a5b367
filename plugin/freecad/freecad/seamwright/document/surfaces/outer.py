# SPDX-License-Identifier: LGPL-2.1-or-later
"""The given outer edges of faces around a point, found for each of its sectors."""

import FreeCAD as App

from freecad.seamwright.document.curves import inputs
from freecad.seamwright.document.surfaces.spoke import fitted
from freecad.seamwright.plain.language import tr

#: A face has no more outer edges than this.
MOST_EDGES = 2


def edges_between(module, spokes, edges, values):
    """Return ([[curve, ...] for the sector behind each of the Spokes], largest distance in mm).

    One edge runs from the end of the spoke to that of the next one. Two run from the ends of both
    to a corner. Raises ValueError where an edge does not lead from one spoke to its neighbour.
    """
    within = max(values["meet_mm"], inputs.GAP_MM)
    tips = [App.Vector(*curve.point(1.0)) for curve in spokes.curves]
    found, waiting, fit_mm = [[] for _ in tips], list(enumerate(edges, 1)), 0.0
    while waiting:
        chain, start, end = _chain(waiting, tips, within)
        sector, count = (start if (start + 1) % len(tips) == end else end), len(chain)
        if {start, end} != {sector, (sector + 1) % len(tips)} or found[sector]:
            raise ValueError(_not_beside(chain, spokes.numbers, start, end))
        if count > MOST_EDGES:
            raise ValueError(
                tr(
                    "the outer boundary has {count} edges between edges {first} and {second}: "
                    "one or two are possible"
                ).format(
                    count=count,
                    first=spokes.numbers[sector],
                    second=spokes.numbers[(sector + 1) % len(tips)],
                )
            )
        runs = chain if start == sector else [(each, not last) for each, last in chain[::-1]]
        for place, ((number, edge), from_last) in enumerate(runs):
            name = tr("edge {number} of the outer boundary").format(number=number)
            curve, distance = fitted(
                module, edge, name, from_last != bool(place), values["fit_mm"], values["rational"]
            )
            found[sector].append(curve)
            fit_mm = max(fit_mm, distance)
    return found, fit_mm


def _chain(waiting, tips, within):
    """Take edges that lead from a tip of a spoke to another one out of the waiting ones.

    Returns ([((number, edge), whether it runs from its last point), ...], and the two tips).
    """
    for first in waiting:
        ends = inputs.ends_of(first[1])
        starts = [(_at(tips, end, within), place) for place, end in enumerate(ends)]
        start, last = next((each for each in starts if each[0] is not None), (None, 0))
        if start is None:
            continue
        waiting.remove(first)
        chain, end = [(first, bool(last))], ends[1 - last]
        while _at(tips, end, within) is None:
            chain.append(_next(waiting, end, within, tips, chain))
            (_, edge), from_last = chain[-1]
            end = inputs.ends_of(edge)[0 if from_last else 1]
        return chain, start, _at(tips, end, within)
    number, edge = waiting[0]
    raise ValueError(_apart(number, inputs.ends_of(edge), tips))


def _next(waiting, point, within, tips, chain):
    """Take the edge that goes on at a point out of the waiting ones."""
    for each in waiting:
        for place, end in enumerate(inputs.ends_of(each[1])):
            if end.distanceToPoint(point) <= within:
                waiting.remove(each)
                return each, bool(place)
    free = [end for _, edge in waiting for end in inputs.ends_of(edge)]
    raise ValueError(_apart(chain[-1][0][0], [point], tips + free))


def _at(tips, point, within):
    """Return the place of the tip at a point; None where there is none."""
    places = [k for k, tip in enumerate(tips) if tip.distanceToPoint(point) <= within]
    return places[0] if places else None


def _apart(number, ends, points):
    nearest = min(point.distanceToPoint(end) for point in points for end in ends)
    return tr(
        "edge {number} of the outer boundary does not lead from the end of an edge to that of its "
        "neighbour: it ends {distance} mm from the nearest end"
    ).format(number=number, distance="%.3g" % nearest)


def _not_beside(chain, numbers, start, end):
    return tr(
        "edge {number} of the outer boundary leads from edge {first} to edge {second}: choose one "
        "or two edges for each two neighbours"
    ).format(number=chain[0][0][0], first=numbers[start], second=numbers[end])
