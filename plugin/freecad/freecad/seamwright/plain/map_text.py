# SPDX-License-Identifier: LGPL-2.1-or-later
"""The summaries of the analysis tools."""

from freecad.seamwright.plain.language import tr
from freecad.seamwright.plain.ramps import figure
from freecad.seamwright.plain.summary import counted


def _at(point):
    return tr("at ({point})").format(point=", ".join(figure(round(each, 6)) for each in point))


def _range(report, unit):
    least, largest = figure(report["least"]), figure(report["largest"])
    if least == largest:
        return tr("{least} {unit} everywhere").format(least=least, unit=unit)
    strongest = max(("least", "largest"), key=lambda name: abs(report[name]))
    return tr("{least} to {largest} {unit}, the strongest {place}").format(
        least=least, largest=largest, unit=unit, place=_at(report[strongest + "_at"])
    )


def _mesh(report):
    faults = len(report["faults"])
    text = "%s, %s" % (counted(report["faces"], "face"), counted(report["points"], "point"))
    return text + (tr(", {faults} not drawn correctly").format(
        faults=counted(faults, "face")
    ) if faults else "")


def curvature_text(report):
    """Return the summary of a Curvature Map."""
    of_radius = report["quantity"] == "Smallest radius"
    if report["undefined"]:
        text = tr("No value is defined")
        if of_radius:
            text = tr("The faces are flat: they have no radius")
        return "%s. %s." % (text, _mesh(report))
    if of_radius:
        return tr("Smallest radius {least} mm {least_at}. {mesh}.").format(
            least=figure(report["least"]), least_at=_at(report["least_at"]), mesh=_mesh(report)
        )
    return tr("{quantity} curvature {range}. {mesh}.").format(
        quantity=tr(report["quantity"]), range=_range(report, report["unit"]), mesh=_mesh(report)
    )


def draft_text(report):
    """Return the summary of a Draft Angle."""
    shares = report["shares"]
    percent = {key: figure(round(100 * share, 1)) for key, share in shares.items()}
    return tr(
        "Of the area, {towards} % drafts towards the pull, {away} % away, {steep} % is too steep. "
        "{mesh}."
    ).format(
        towards=percent["towards"], away=percent["away"], steep=percent["steep"], mesh=_mesh(report)
    )


def reflection_text(report):
    """Return the summary of Reflection Lines."""
    return "%s. %s." % (tr(report["lines"]), _mesh(report))


def deviation_text(report):
    """Return the summary of a Deviation."""
    if report["undefined"]:
        return tr("No point lies over the other shape") + "."
    parts = tr("No deviation above rounding")
    if report["furthest_mm"]:
        parts = tr(
            "Largest deviation {furthest_mm} mm {furthest_at}; {least} to {largest} mm"
        ).format(
            furthest_mm=figure(report["furthest_mm"]),
            furthest_at=_at(report["furthest_at"]),
            least=figure(report["least"]),
            largest=figure(report["largest"]),
        )
    if report["beyond"]:
        parts += tr("; {beyond} beyond the edges of the other shape left out").format(
            beyond=counted(report["beyond"], "point")
        )
    return tr("{parts}. Sampled at {points}: between them it may be larger.").format(
        parts=parts, points=counted(report["points"], "point")
    )


def comb_text(report):
    """Return the summary of a Curvature Comb."""
    if not report["largest_per_mm"]:
        return tr("{lines}; all are straight.").format(lines=counted(report["lines"], "curve"))
    return tr(
        "{lines}; largest curvature {largest_per_mm} 1/mm, radius {radius} mm, "
        "{largest_at}. Sampled."
    ).format(
        lines=counted(report["lines"], "curve"),
        largest_per_mm=figure(report["largest_per_mm"]),
        radius=figure(1 / report["largest_per_mm"]),
        largest_at=_at(report["largest_at"]),
    )
