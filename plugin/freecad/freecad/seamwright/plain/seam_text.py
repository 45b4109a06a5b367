# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts of a Seam Plot."""

from freecad.seamwright.plain import enclosure
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.summary import counted

#: key, name, unit, by what values of the report are multiplied, accepted value of the default
#: profile in that unit
FIGURES = (
    ("gap_mm", mark("Gap"), "mm", 1.0, 0.01),
    ("angle_deg", mark("Angle"), "\u00b0", 1.0, 0.1),
    ("curvature_per_mm", mark("Curvature"), "1/mm", 1.0, None),
    ("curvature_rel", mark("Relative curvature"), "%", 100.0, 2.0),
)


def with_unit(number, unit):
    """Return a number that is a text with its unit, as it is printed."""
    return number + ("" if unit in ("", "\u00b0") else " ") + unit


def bounds_text(seam, key):
    """Return the enclosure of a figure of a seam of the report as text."""
    for known, name, unit, factor, limit in FIGURES:
        if known == key:
            bounds = seam["bounds"][key]
            if bounds is None:
                return tr("{name}: not measured").format(name=tr(name))
            return "%s %s" % (tr(name), with_unit(enclosure.text(bounds, factor, limit), unit))
    raise KeyError(key)


def bound_line(seam, key):
    """Return what is known about the largest value of a figure on a seam, as a sentence."""
    bounds = seam["bounds"][key]
    if bounds is None:
        return tr("{name}: not measured where the angle is that of a crease.").format(
            name=seam["name"]
        )
    known = tr("proven") if bounds["upper"] is not None else tr("seen, without an upper bound")
    return tr("{name}: the largest value is {seam}, {known}.").format(
        name=seam["name"], seam=bounds_text(seam, key)[len(_name(key)) + 1 :], known=known
    )


def _name(key):
    return tr(next(name for known, name, *_ in FIGURES if known == key))


def plot_text(report):
    """Return the summary of a report."""
    first = report["seams"][0]
    parts = [
        bounds_text(first, key) for key in ("gap_mm", "angle_deg", "curvature_rel")
    ]
    if report["count"] > 1:
        return tr("{count}; largest gap seen {gap_mm} mm, largest angle {angle_deg}\u00b0.").format(
            count=counted(report["count"], "seam"),
            gap_mm=enclosure.number(report["gap_mm"]),
            angle_deg=enclosure.number(report["angle_deg"]),
        )
    return "%s: %s, %s." % (first["name"], first["level"], ", ".join(parts))
