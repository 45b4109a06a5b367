# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts and sentences about a report: summary line, legend and tolerance line."""

from freecad.seamwright.plain import enclosure, palette


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
CLASS, LEVEL = "Class", "Level"
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


def counted(number, noun):
    """ "1 seam", "2 seams", "no seams"."""
    return "%s %s%s" % (number or "no", noun, "" if number == 1 else "s")


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
        text = "No seams: no two faces share an edge."
        if report.get("open"):
            text += " " + free_edges_text(report)
        return text
    parts = [
        "%s: %s, %s, %d smooth"
        % (
            _total_text(report, total),
            counted(counts["defect"], "defect"),
            counted(counts["crease"], "crease"),
            counts["smooth"],
        )
    ]
    open_edges = len(report.get("open", ()))
    if open_edges:
        parts.append(counted(open_edges, "free edge"))
    parts.append(_largest_text(report))
    parts.append("%d of %s certain" % (total - uncertain(report), counted(total, "verdict")))
    verdict = "%s is met" if passed(report) else "%s is not met"
    parts.append(verdict % level_of(report))
    return "; ".join(part for part in parts if part) + "."


def proposed_match_mm(report):
    """Return the match distance that the analysis proposes, or None."""
    return report.get("freecad", {}).get("proposed_match_mm")


def free_edges_text(report):
    """Return a sentence about the free edges of a report without seams."""
    edges, proposed = counted(len(report["open"]), "free edge"), proposed_match_mm(report)
    tried = report.get("freecad", {}).get("tried_match_mm")
    if proposed is not None:
        return "%s; edges lie side by side: match them within %g mm." % (edges, proposed)
    if tried is not None:
        return "%s; none lie side by side within %g mm." % (edges, tried)
    return "%s can be matched: see Tolerances." % edges


def _total_text(report, total):
    text = counted(total, "seam")
    return text + ", %d of them matched" % matched(report) if matched(report) else text


def _largest_text(report):
    gap, angle = _largest_enclosed(report, "gap_mm"), _largest_enclosed(report, "angle_deg")
    if not gap or not angle:
        return ""
    return "apart from creases, largest gap %s mm, largest angle %s\u00b0" % (gap, angle)


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
    parts = ["gap \u2264 %g mm" % tolerance["gap_mm"]]
    if level != "G0":
        parts.append("angle \u2264 %g\u00b0" % tolerance["angle_deg"])
    if level in ("G2", "G3"):
        parts.append("curvature \u2264 %g %%" % (100 * tolerance["curvature_rel"]))
    return "%s: %s" % (level, ", ".join(parts))


def legend_entries(report, colours=CLASS):
    """Return [(SeamClass, "Defect: 2", "falls short of G1"), ...] for the legend, worst first.

    ``colours``: a key of ``COLOURS``.
    """
    if colours == LEVEL:
        counts, meanings = level_counts(report), palette.LEVEL_MEANINGS
    else:
        counts = class_counts(report)
        level, crease = level_of(report), report["tolerance"]["crease_deg"]
        meanings = {key: palette.meaning(key, level, crease) for key in counts}
    return [
        (entry, "%s: %d" % (entry.name, counts[entry.key]), meanings[entry.key])
        for entry in COLOURS[colours]
    ]
