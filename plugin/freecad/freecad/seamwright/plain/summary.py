# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts and sentences about a report: summary line, legend and tolerance line."""

from freecad.seamwright.plain import enclosure, palette
from freecad.seamwright.plain.language import mark, tr


def class_counts(report):
    """Return the number of seams of each class, by key, in the order of ``palette.CLASSES``."""
    counts = {seam_class.key: 0 for seam_class in palette.CLASSES}
    for seam in report.get("seams", ()):
        counts[seam["class"]] += 1
    return counts


def edge_classes(report):
    """Return {edge number: class} in the order of the report's seams.

    An edge of several seams gets the worst of their classes, so that each edge is drawn once.
    """
    return edge_keys(report, CLASS)


#: What the colours of seams show, with the palette of each.
CLASS, LEVEL = mark("Class"), mark("Level")
COLOURS = {CLASS: palette.CLASSES, LEVEL: palette.LEVELS}


def edge_keys(report, colours):
    """Return {edge number: class or level} as ``edge_classes`` does, for a key of ``COLOURS``."""
    ranks = {entry.key: rank for rank, entry in enumerate(COLOURS[colours])}
    name, keys = colours.lower(), {}
    for seam in report.get("seams", ()):
        key = seam[name]
        for number in seam["edges"]:
            known = keys.get(number, key)
            keys[number] = key if ranks[key] < ranks[known] else known
    return keys


def level_counts(report):
    """Return the number of seams of each level, by key, in the order of ``palette.LEVELS``."""
    counts = {level.key: 0 for level in palette.LEVELS}
    for seam in report.get("seams", ()):
        counts[seam["level"]] += 1
    return counts


def largest(report, name):
    """Return the largest lower bound of a figure over the seams that are not creases, or None."""
    figures = [seam[name] for seam in report.get("seams", ()) if seam["class"] != "crease"]
    return max((figure["lower"] for figure in figures if figure is not None), default=None)


def uncertain(report):
    """Return the number of seams whose verdict is not certain."""
    return sum(not seam["certified"] for seam in report.get("seams", ()))


def matched(report):
    """Return the number of seams of two free edges that lie side by side."""
    return sum(seam["kind"] == "matched" for seam in report.get("seams", ()))


def level_of(report):
    """Return the level of continuity by which the report was judged."""
    return report.get("freecad", {}).get("level", "G1")


def passed(report):
    """Return whether the report has seams and none of them is a defect."""
    counts = class_counts(report)
    return sum(counts.values()) > 0 and counts["defect"] == 0


#: Of each noun that is counted: none of it, one, several.
NOUNS = {
    "arc": (mark("no arcs"), mark("{count} arc"), mark("{count} arcs")),
    "chain": (mark("no chains"), mark("{count} chain"), mark("{count} chains")),
    "conic": (mark("no conics"), mark("{count} conic"), mark("{count} conics")),
    "crease": (mark("no creases"), mark("{count} crease"), mark("{count} creases")),
    "curve": (mark("no curves"), mark("{count} curve"), mark("{count} curves")),
    "defect": (mark("no defects"), mark("{count} defect"), mark("{count} defects")),
    "edge": (mark("no edges"), mark("{count} edge"), mark("{count} edges")),
    "extremum": (mark("0 extrema"), mark("{count} extremum"), mark("{count} extrema")),
    "face": (mark("no faces"), mark("{count} face"), mark("{count} faces")),
    "feature": (mark("no features"), mark("{count} feature"), mark("{count} features")),
    "free edge": (mark("no free edges"), mark("{count} free edge"), mark("{count} free edges")),
    "hole": (mark("no holes"), mark("{count} hole"), mark("{count} holes")),
    "inflection": (
        mark("no inflections"), mark("{count} inflection"), mark("{count} inflections")
    ),
    "joint": (mark("no joints"), mark("{count} joint"), mark("{count} joints")),
    "line": (mark("no lines"), mark("{count} line"), mark("{count} lines")),
    "line of joints": (
        mark("no lines of joints"),
        mark("{count} line of joints"),
        mark("{count} lines of joints"),
    ),
    "number": (mark("no numbers"), mark("{count} number"), mark("{count} numbers")),
    "object": (mark("no objects"), mark("{count} object"), mark("{count} objects")),
    "piece": (mark("no pieces"), mark("{count} piece"), mark("{count} pieces")),
    "point": (mark("no points"), mark("{count} point"), mark("{count} points")),
    "seam": (mark("no seams"), mark("{count} seam"), mark("{count} seams")),
    "side": (mark("no sides"), mark("{count} side"), mark("{count} sides")),
    "source": (mark("no sources"), mark("{count} source"), mark("{count} sources")),
    "verdict": (mark("no verdicts"), mark("{count} verdict"), mark("{count} verdicts")),
}  # fmt: skip


def counted(number, noun):
    """ "1 seam", "2 seams", "no seams"."""
    none, one, several = NOUNS[noun]
    return tr(none if not number else one if number == 1 else several).format(count=number)


def capital(text):
    """Return a text that begins a sentence."""
    return text[:1].upper() + text[1:]


def facts(report):
    """Return {property of a Seam Analysis: value} of a report; the Summary is the last."""
    counts = class_counts(report)
    return {
        "Seams": sum(counts.values()),
        "Defects": counts["defect"],
        "Creases": counts["crease"],
        "Uncertain": uncertain(report),
        "Matched": matched(report),
        "OpenEdges": len(report.get("open", ())),
        "MaxGap": largest(report, "gap_mm") or 0.0,
        "MaxAngle": largest(report, "angle_deg") or 0.0,
        "Passed": passed(report),
        "Summary": summary_text(report),
    }


def summary_text(report):
    """Return one line: seams of each class, largest figures, certainty, and the verdict."""
    counts = class_counts(report)
    total = sum(counts.values())
    if total == 0:
        text = tr("No seams: no two faces share an edge.")
        if report.get("open"):
            text += " " + free_edges_text(report)
        return text
    parts = [
        tr("{total}: {defect}, {crease}, {smooth} smooth").format(
            total=_total_text(report, total),
            defect=counted(counts["defect"], "defect"),
            crease=counted(counts["crease"], "crease"),
            smooth=counts["smooth"],
        )
    ]
    open_edges = len(report.get("open", ()))
    if open_edges:
        parts.append(counted(open_edges, "free edge"))
    parts.append(_largest_text(report))
    parts.append(_sharp_text(report))
    parts.append(tr("{certain} of {verdicts} certain").format(
        certain=total - uncertain(report), verdicts=counted(total, "verdict")
    ))
    verdict = tr("{level} is met") if passed(report) else tr("{level} is not met")
    parts.append(verdict.format(level=level_of(report)))
    return "; ".join(part for part in parts if part) + "."


def proposed_match_mm(report):
    """Return the match distance that the analysis proposes, or None."""
    return report.get("freecad", {}).get("proposed_match_mm")


def free_edges_text(report):
    """Return a sentence about the free edges of a report without seams."""
    edges, proposed = counted(len(report["open"]), "free edge"), proposed_match_mm(report)
    tried = report.get("freecad", {}).get("tried_match_mm")
    if proposed is not None:
        return tr("{edges}; edges lie side by side: match them within {proposed:g} mm.").format(
            edges=edges, proposed=proposed
        )
    if tried is not None:
        return tr("{edges}; none lie side by side within {tried:g} mm.").format(
            edges=edges, tried=tried
        )
    return tr("{edges} can be matched: see Tolerances.").format(edges=edges)


def _total_text(report, total):
    text = counted(total, "seam")
    return text + tr(", {matched} of them matched").format(
        matched=matched(report)
    ) if matched(report) else text


def _largest_text(report):
    gap, angle = _largest_enclosed(report, "gap_mm"), _largest_enclosed(report, "angle_deg")
    if not gap or not angle:
        return ""
    return tr("apart from creases, largest gap {gap} mm, largest angle {angle}\u00b0").format(
        gap=gap, angle=angle
    )


def _sharp_text(report):
    """Return how many defects are as sharp as creases: their gap is above the tolerance."""
    tolerance = report["tolerance"]
    limits = {"angle_deg": tolerance["crease_deg"], "gap_mm": tolerance["gap_mm"]}
    sharp = sum(
        seam["class"] == "defect"
        and all(seam[name] and seam[name]["lower"] > limit for name, limit in limits.items())
        for seam in report["seams"]
    )
    if not sharp:
        return ""
    return tr("{defects} as sharp as a crease, but with a gap").format(
        defects=counted(sharp, "defect")
    )


def _largest_enclosed(report, name):
    """Return the largest figure over the seams that are not creases as text; "" without figures."""
    figures = [seam[name] for seam in report["seams"] if seam["class"] != "crease" and seam[name]]
    if not figures:
        return ""
    uppers = [figure["upper"] for figure in figures]
    largest_figure = {
        "lower": largest(report, name),
        "upper": None if None in uppers else max(uppers),
    }
    return enclosure.text(largest_figure, limit=report["tolerance"][name])


def tolerance_text(report):
    """The tolerances that decide the report's level, for example "G1: gap ≤ 0.01 mm, ..."."""
    tolerance, level = report["tolerance"], level_of(report)
    parts = [tr("gap \u2264 {gap_mm:g} mm").format(gap_mm=tolerance["gap_mm"])]
    if level != "G0":
        parts.append(tr("angle \u2264 {angle_deg:g}\u00b0").format(
            angle_deg=tolerance["angle_deg"]
        ))
    if level in ("G2", "G3"):
        parts.append(tr("curvature \u2264 {curvature_rel:g} %").format(
            curvature_rel=100 * tolerance["curvature_rel"]
        ))
    return "%s: %s" % (level, ", ".join(parts))


def legend_entries(report, colours=CLASS):
    """Return [(SeamClass, "Defect: 2", "falls short of G1"), ...] for the legend, worst first.

    ``colours``: a key of ``COLOURS``.
    """
    if colours == LEVEL:
        counts, meanings = level_counts(report), {}
        for key, meaning in palette.LEVEL_MEANINGS.items():
            meanings[key] = tr(meaning)
    else:
        counts = class_counts(report)
        level, crease = level_of(report), report["tolerance"]["crease_deg"]
        meanings = {key: palette.meaning(key, level, crease) for key in counts}
    return [
        (entry, "%s: %d" % (tr(entry.name), counts[entry.key]), meanings[entry.key])
        for entry in COLOURS[colours]
    ]
