# SPDX-License-Identifier: LGPL-2.1-or-later
"""From values to colours: rows of pixels, places in them, and the lines of a legend.

A place is 0 at the left end of a row and 1 at its right end; nan has the colour UNDEFINED.
"""

from typing import Any, NamedTuple

import numpy

from freecad.seamwright.plain import curvature, enclosure
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.maps import GAUSSIAN, LARGEST, RADIUS, UNITS

#: Orange for large values, white for none, blue for negative ones; see curvature.RAMP.
DIVERGING = curvature.RAMP

#: From white over green to dark blue, darker with the value.
SEQUENTIAL = (
    (0.0, (250, 250, 240)),
    (0.2, (199, 233, 180)),
    (0.4, (127, 205, 187)),
    (0.6, (44, 147, 190)),
    (0.8, (34, 94, 168)),
    (1.0, (8, 29, 88)),
)

UNDEFINED = curvature.UNDEFINED

#: Draft angles: towards the pull, too steep, and away from the pull. Cyan, purple and sand of Paul
#: Tol's muted scheme, which readers with any colour vision can tell apart; the lines of seams, in
#: other colours, may lie on them.
TOWARDS, STEEP, AWAY = (136, 204, 238), (170, 68, 153), (221, 204, 119)

#: Pixels of a row, and of one that repeats.
PIXELS, STRIPE_PIXELS = 1024, 256

#: The shares of a range for which a legend has a line.
SHARES = (1.0, 0.75, 0.5, 0.25, 0.0)


class Look(NamedTuple):
    """How values are drawn: ``row`` (n, 3) of colours 0..255, ``places`` of the points in it.

    ``repeats``: places go on beyond 0 and 1. ``smooth``: neighbouring pixels are mixed. ``legend``:
    (title, entries, footer) or None.
    """

    row: Any
    places: Any
    repeats: bool
    smooth: bool
    legend: tuple


def row_of(stops):
    """Return PIXELS colours between stops of (place from 0 to 1, colour)."""
    at = (numpy.arange(PIXELS) + 0.5) / PIXELS
    places, colours = [place for place, _ in stops], numpy.array([rgb for _, rgb in stops], float)
    return numpy.stack([numpy.interp(at, places, channel) for channel in colours.T], axis=1)


def diverging_row():
    """Return the row of DIVERGING, -1 to 1."""
    return row_of([((share + 1) / 2, rgb) for share, rgb in DIVERGING])


def signed_look(values, limit, title, unit, meanings, footer=""):
    """Return the Look of values from -limit to limit; ``meanings``: of positive and negative."""
    shares = numpy.where(limit > 0, values / (limit or 1.0), 0.0)
    places = numpy.where(numpy.isfinite(values), numpy.clip(shares, -1, 1) / 2 + 0.5, numpy.nan)
    row, entries = diverging_row(), []
    for share in (1.0, 0.5, 0.0, -0.5, -1.0) if limit > 0 else (0.0,):
        text = "%s %s" % (curvature.signed(share * limit), unit)
        meaning = meanings[0] if share > 0 else meanings[1] if share < 0 else ""
        entries.append((_sample(row, share / 2 + 0.5), text, meaning))
    return Look(row, places, False, True, (title, entries, footer))


def range_look(values, low, high, title, unit, meaning, stops=SEQUENTIAL, footer=""):
    """Return the Look of values from low to high; ``meaning(value)``: beside each of the legend."""
    size = high - low
    shares = (values - low) / size if size > 0 else numpy.zeros(len(values))
    places = numpy.where(numpy.isfinite(values), numpy.clip(shares, 0, 1), numpy.nan)
    row = row_of(stops)
    entries = []
    for share in SHARES if size > 0 else (0.0,):
        value = low + share * size
        entries.append((_sample(row, share), "%s %s" % (figure(value), unit), meaning(value)))
    return Look(row, places, False, True, (title, entries, footer))


def curvature_look(quantity, values, weights, given):
    """Return the Look of curvature values; ``given``: (low, high) of the quantity, or None.

    Mean and Gaussian curvatures without a given range go from -limit to limit, where at most 2 % of
    the area lies beyond.
    """
    title, unit = tr("{quantity} curvature").format(quantity=tr(quantity)), UNITS[quantity]
    if quantity == RADIUS:
        return _radius_look(values, weights, given)
    if given is not None:
        # White stays 0 where the range contains it.
        stops = SEQUENTIAL if quantity == LARGEST else stops_between(*given)
        return range_look(values, *given, title, unit, lambda value: "", stops, tr(BEYOND))
    limit = _limit(quantity, values, weights)
    if quantity == LARGEST:
        return range_look(values, 0.0, limit, title, unit, _as_radius, footer=tr(BEYOND))
    meanings = {
        "Mean": (tr("concave"), tr("convex")),
        "Gaussian": (tr("as a bowl or a dome"), tr("as a saddle")),
    }[quantity]
    footer = tr("seen from the side of the normals") if quantity == "Mean" else ""
    return signed_look(values, limit, title, unit, meanings, _lines(footer, tr(BEYOND)))


def _limit(quantity, values, weights):
    """Return the value with the end colour; a Gaussian curvature is the square of a curvature."""
    if quantity == GAUSSIAN:
        return curvature.limit(numpy.sign(values) * numpy.sqrt(abs(values)), weights) ** 2
    return curvature.limit(values, weights)


BEYOND = mark("values beyond have the end colours")


def stops_between(low, high):
    """Return the stops of a range; white is 0 where the range contains it."""
    if low >= 0 or high <= 0:
        return SEQUENTIAL
    middle = -low / (high - low)
    return [
        (middle + share * (1 - middle if share > 0 else middle), rgb) for share, rgb in DIVERGING
    ]


def _radius_look(values, weights, given):
    """Return the Look of radii: the colours go with the curvature, 1 / radius."""
    with numpy.errstate(divide="ignore"):
        curvatures = 1 / values
    if given is None:
        low, high = 0.0, curvature.limit(curvatures, weights)
    else:
        least, largest = given
        if least <= 0:
            raise ValueError(tr("Lowest = {least:g}: a radius is larger than 0").format(
                least=least
            ))
        low, high = 1 / largest, 1 / least
    look = range_look(curvatures, low, high, tr("Smallest radius of curvature"), "1/mm", _as_radius)
    title, entries, _ = look.legend
    entries = [(sample, meaning, text) for sample, text, meaning in entries]
    return look._replace(legend=(title, entries, tr(BEYOND)))


def _as_radius(value):
    if value <= 0:
        return tr("flat")
    return tr("radius {radius} mm").format(radius=enclosure.number(1 / value))


def draft_look(angles_deg, towards_deg, away_deg):
    """Return the Look of draft angles: three colours, sharp at the limits."""
    low, high = -90.0, 90.0
    at = low + (numpy.arange(PIXELS) + 0.5) / PIXELS * (high - low)
    row = numpy.where(
        (at >= towards_deg)[:, None], TOWARDS, numpy.where((at <= -away_deg)[:, None], AWAY, STEEP)
    ).astype(float)
    places = numpy.where(numpy.isfinite(angles_deg), (angles_deg - low) / (high - low), numpy.nan)
    at_least, at_most = (
        "%s %s\u00b0" % (sign, figure(limit))
        for sign, limit in (("\u2265", towards_deg), ("\u2264", -away_deg))
    )
    entries = [
        (curvature.Sample(TOWARDS), at_least, tr("drafts towards the pull")),
        (curvature.Sample(STEEP), tr("between"), tr("too steep")),
        (curvature.Sample(AWAY), at_most, tr("drafts away from the pull")),
    ]
    return Look(row, places, False, False, (tr("Draft angle"), entries, ""))


def with_undefined(look, name, meaning):
    """Return a Look that explains UNDEFINED in its legend, where points have it."""
    if look.legend is None or numpy.isfinite(look.places).all():
        return look
    title, entries, footer = look.legend
    entry = curvature.Sample(UNDEFINED, apart=True), name, meaning
    return look._replace(legend=(title, [*entries, entry], footer))


#: Colours of stripes.
DARK, LIGHT = (18, 18, 18), (247, 247, 247)


def stripes_look(positions, width, colours=(DARK, LIGHT)):
    """Return the Look of positions: a stripe of the first colour at each whole number.

    ``width``: of a stripe, as a share of the distance of two. It has no legend.
    """
    at = (numpy.arange(STRIPE_PIXELS) + 0.5) / STRIPE_PIXELS
    on = abs((at + 0.5) % 1.0 - 0.5) < width / 2
    row = numpy.where(on[:, None], *colours).astype(float)
    return Look(row, positions, True, True, None)


def _sample(row, place):
    pixel = min(int(place * PIXELS), PIXELS - 1)
    return curvature.Sample(tuple(int(round(channel)) for channel in row[pixel]))


def figure(value):
    """Return a number as text with its sign if it is negative, to three digits."""
    return (curvature.MINUS if value < 0 else "") + enclosure.number(abs(value))


def _lines(*texts):
    return "\n".join(filter(None, texts))


def image(look):
    """Return (width, height, bytes) of a picture: half the row of a look, half UNDEFINED.

    One that repeats is a square, so that its smaller sizes do not mix both halves.
    """
    width = len(look.row)
    half = width // 2 if look.repeats else 2
    pixels = numpy.empty((2 * half, width, 3))
    pixels[:half], pixels[half:] = look.row, UNDEFINED
    return width, 2 * half, numpy.rint(pixels).astype(numpy.uint8).tobytes()


def texture_places(look):
    """Return (n, 2) of coordinates in the picture of ``image``."""
    known = numpy.isfinite(look.places)
    across = numpy.where(known, look.places, 0.0)
    if not look.repeats:  # half a pixel inside, so that the ends do not mix with each other
        across = 0.5 / PIXELS + across * (1 - 1 / PIXELS)
    return numpy.stack([across, numpy.where(known, 0.25, 0.75)], axis=1)


