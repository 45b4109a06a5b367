# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every word that is shown goes through the translation: here the language is that of capitals.

What the kernel and the user name is given in capitals too. So a small letter is an English word
that a German would read in a German sentence.
"""

import re
import string

import numpy
import pytest
import test_curve_text
import test_fill_text
import test_map_text
import test_maps
import test_surface_text
from test_plain import TOLERANCE, figure, seam

from freecad.seamwright.plain import (
    corner_text, curvature, curve_text, fill_misses, fill_text, language, lengths, map_text, maps,
    match_text, moves, new_seams, palette, preferences, profiles, ramps, repair_text, rows,
    seam_text, summary, surface_text,
)  # fmt: skip

#: Exponents of numbers.
EXPONENT = re.compile(r"(?<=\d)e-?\d")


def shout(context, text):
    """Return a text in capitals, besides the names of its fields."""
    return "".join(
        literal.upper() + ("{%s%s}" % (name, form and ":" + form) if name is not None else "")
        for literal, name, form, _ in string.Formatter().parse(text)
    )


@pytest.fixture(autouse=True)
def shouting(monkeypatch):
    monkeypatch.setattr(language, "translate", shout)


def small(*texts):
    """The words of texts that have small letters, without units that need no translation."""
    words = re.findall(r"\S+", re.sub(r"(?<=\d )(mm|1?/mm\S?)(?!\w)", "", " ".join(texts)))
    return [word for word in words if re.search("[a-z]", EXPONENT.sub("", word))]


REASON = "IT IS TOO FAR."
SEAM = {**seam(1, "defect"), "kind": "matched", "note": "", "between": "the fill itself",
        "curvature_rel": figure(0.3, 0.4)}  # fmt: skip
WIDE = {**seam(2, "defect", gap=1.0, angle=60.0), "kind": "closed", "between": "fill, FACE3"}
REPORT = {"seams": [SEAM, WIDE, seam(3, "crease")], "tolerance": TOLERANCE,
          "open": [{"edge": 1}], "freecad": {"level": "G2"}}  # fmt: skip


def curve_texts():
    fair, figures = test_curve_text.fair, test_curve_text.FIGURES
    arcs = {"curves": 2, "arcs": 1, "lines": 2, "length_mm": 50.0, "distance_mm": 0.5}
    yield curve_text.failure_text(REASON)
    for change in ({"least_arcs": 0}, {"least_arcs": 3}, {"arcs": 0, "least_arcs": 1}):
        yield curve_text.arcs_text({**arcs, **change})
    for after in (0.1, 0.3):
        variation = {"variation_before_per_mm3": 0.2, "variation_after_per_mm3": after}
        yield curve_text.fair_text(fair(kept=1, **variation))
    for flag in (False, True):
        yield curve_text.spline_text({**figures, "points": 7, "interpolates": flag})
        yield curve_text.join_text({"order": 2, "gap_mm": 1, "moved_mm": 1, "continued": flag})
        blend = {"frames": 5, "faces": 2, "keys": 3, "distance_mm": 1, "order": 2, "features": 4}
        yield curve_text.blend_text({**blend, "surface": flag})
    for radius in (None, 3.0):
        clothoid = {"pieces": 3, "length_mm": 78, "distance_mm": 1, "curves": 2}
        yield curve_text.clothoid_text({**clothoid, "least_radius_mm": radius})
        spiral = {"length_mm": 78, "turn_deg": 90, "first_radius_mm": 1, "last_radius_mm": 2}
        yield curve_text.log_spiral_text({**spiral, "arcs": 3, "distance_mm": radius})
    for weight in (0.5, 1.0, 2.0):
        conic = {"least_weight": weight, "largest_weight": weight, "length_mm": 1, "g1_joints": 2}
        yield curve_text.conic_text({**conic, "conics": 1, "distance_mm": 0.5})
        yield curve_text.conic_text({**conic, "conics": 2})
    yield curve_text.bridge_text({**figures, "orders": ("G2", "G1")})


def map_texts():
    mesh = {**test_map_text.MESH, "faults": [{"face": 1}]}
    for change in ({}, {"undefined": True}, {"least": 0.2}, {"quantity": "Smallest radius"}):
        yield map_text.curvature_text(test_map_text.curved(**change))
    yield map_text.draft_text({"shares": dict.fromkeys(("towards", "away", "steep"), 0.3), **mesh})
    yield map_text.reflection_text({"lines": "Isophotes", **mesh})
    deviation = {"least": 0, "largest": 1, "furthest_mm": 1, "furthest_at": [1, 2, 3], "beyond": 1}
    for undefined in (False, True):
        yield map_text.deviation_text({**deviation, "undefined": undefined, **mesh})
    for largest in (0.0, 0.5):
        yield map_text.comb_text({"lines": 2, "largest_per_mm": largest, "largest_at": [0, 0, 0]})


def surface_texts():
    made, met = test_surface_text.report, test_surface_text.MET
    inside = {**met, "kind": surface_text.LINE, "side": "Start", "name": "LINE 7"}
    low = {"lower": 0.3, "upper": 0.4}
    for each in (
        made(met, to={"least_mm": 1, "most_mm": 2}, fold={"distance_mm": 5}),
        made({**met, "curvature_rel": low, "name": "EDGE3"}, reached=False,
             fold={"distance_mm": 5}, sides=[{"side": "start", "reason": REASON}],
             laterals=[{"reason": REASON}]),
        made(inside, {**inside, "name": "8"}),
        made({**met, "name": "EDGE3", "curvature_rel": {"lower": 0, "upper": None}}),
    ):  # fmt: skip
        yield surface_text.summary(each)
        for row in surface_text.build_rows(each):
            yield from row.cells[:1] + row.cells[2:]
            yield row.detail
            yield row.cells[1].replace("Plate.Edge3", "")
    for reached in (False, True):
        moved = {"reached": reached, "moved_mm": 1.0 * reached, "fit_mm": 1, "outer_edges": [1]}
        yield surface_text.umbrella_summary(test_surface_text.umbrella(**moved))
    loft = {"faces": 2, "keys": 4, "distance_mm": 1, "angle_deg": 1, "curvature_rel": 1}
    for seams in ([], [met]):
        yield surface_text.loft_summary({**loft, "seams": seams})


def seam_texts():
    for name in ("gap_mm", "angle_deg"):
        for upper in (2.0, None):
            one = test_maps.seam(**{name: {"lower": 1.0, "upper": upper}})
            one["name"] = "BOX.EDGE3"
            yield seam_text.bound_line(one, name)
            yield seam_text.bound_line(one, "curvature_rel")
            for count in (1, 2):
                figures = {"count": count, "gap_mm": 1, "angle_deg": 2}
                yield seam_text.plot_text({"seams": [one], **figures})


def report_texts():
    for level in ("G1", "G2"):
        report = {**REPORT, "freecad": {"level": level}}
        yield from (summary.summary_text(report), summary.tolerance_text(report))
        for colours in (summary.CLASS, summary.LEVEL):
            for _, name, meaning in summary.legend_entries(report, colours):
                yield from (name, meaning)
    yield summary.summary_text({**REPORT, "seams": REPORT["seams"][2:]})
    for told in ({}, {"tried_match_mm": 1.0}, {"proposed_match_mm": 1.0}):
        yield summary.summary_text({**REPORT, "seams": [], "freecad": told})
    left_out = {"gap_mm": [[k / 8, k / 8 + 0.1] for k in range(8)],
                "angle_deg": [[0.25, 0.25 + 1e-9], [0.9, 1]]}  # fmt: skip
    for one in (SEAM, {**WIDE, "certified": True, "left_out": left_out, "gap_mm": figure(1, 2)}):
        yield rows.detail_text(one, TOLERANCE)
    for row in rows.build_rows(REPORT):
        for column in rows.COLUMNS:
            if column.field != "level":
                yield rows.cell_text(row, column).replace("none", "")


def repair_texts():
    seams = [{"before": SEAM, "after": after, "treated": True, "repaired": after is not None,
              "reason": "" if after else REASON} for after in (WIDE, None)]  # fmt: skip
    moved = [{"face": 1, "largest_move_mm": 0.5}]
    for after in (REPORT, None):
        report = repair_text.build_report(REPORT, after, seams, moved, "G1", False, 2)
        for change in ({}, {"moves": [], "edges_led": 0}, {"sewn": 2}):
            yield repair_text.summary_text({**report, **change})
        for row in repair_text.build_rows(report):
            yield from (*row.cells[1:], row.detail)
    for change in ({}, {"total": 1}, {"total": 1, "chosen": True}):
        yield repair_text.summary_text({**repair_text.EMPTY_REPORT, **change})
    yield from (moves.legend_footer(moved, 2), moves.legend_footer([], 2))
    for target in ("G0", "G1"):
        for row in new_seams.build_rows([SEAM, WIDE, {**SEAM, "source_edges": []}], TOLERANCE,
                                        target):  # fmt: skip
            yield from row.cells[1:]
    yield new_seams.largest_text([SEAM], TOLERANCE)
    yield new_seams.largest_text(
        [{**SEAM, **{name: {"lower": 1, "upper": 1} for name in new_seams.LARGEST}}], TOLERANCE
    )
    (row,) = new_seams.build_rows([{**SEAM, "source_edges": [3]}], TOLERANCE, "G1")
    yield row.cells[0].replace("Edge3", "")


def fill_texts():
    one = {**test_fill_text.missed(test_fill_text.bounds(0.5, 0.3, 0.2)), "hole": 1, "face": None,
           "reached": False, "reason": REASON, "faces": [7]}  # fmt: skip
    holes = ([one], [one, one], [{**one, "filled": True}], [{**one, "filled": True}, one])
    for fills in (*holes, [{**one, "filled": True, "reached": True}]):
        report = {"target": "G2", "tolerance": test_fill_text.LIMITS, "fills": fills}
        yield fill_text.summary_text(report)
        yield from fill_text.reasons(report)
    replaced = {**one, "filled": True, "face": 3}
    text = fill_text.summary_text({**report, "fills": [replaced]})
    yield text.replace("Face3", "")
    yield from (fill_text.waiting_text(["FACE7"], []), fill_text.waiting_text([], [1]))
    hole = {"id": 1, "sides": [1], "longest": True, "length_mm": 1, "centre_mm": [0, 0, 0]}
    for corners in (False, True):
        yield fill_text.hole_text({**hole, "has_corners": corners}, [hole, {"longest": False}])
    title, entries, footer = fill_misses.legend(report, 4.0)
    yield from (title, footer, *(meaning for *_, meaning in entries))


def match_texts():
    matched = {"matched": True, "reason": "joined in poles", "exact": True, "faces": ["A", "B"],
               "largest_move_mm": 1, "target": "G1", "tolerance": TOLERANCE,
               "poles": [[[1, 2], [2, 3]], [None, [4, 5]]], "before": SEAM, "after": WIDE}
    near = "joined to the tolerance by a change up to 57.03 mm from the side"
    for change in ({}, {"reason": near}, {"matched": False, "reason": REASON},
                   {"after": {**WIDE, "certified": True}}):  # fmt: skip
        yield match_text.summary({**matched, **change})
        for line in match_text.table({**matched, **change}):
            yield from line[:1] if line[1] == "none" else (line[0].replace("mm", ""), *line[1:])
    yield from (match_text.chain_reason(["A", "B"], 1.0), match_text.advised(REASON, "less_fair"))


def corner_texts():
    edges = [{"edge": 4, "convex": convex, "angle_deg": 90.0, "radius_mm": 1}
             for convex in (True, False)]  # fmt: skip
    yield from (corner_text.edge_text(edge) for edge in edges)
    yield corner_text.waiting_text([1])
    for change in ({"met": True, "filled_by": "opencascade"}, {"met": True}, {}):
        report = {**corner_text.EMPTY_REPORT, "edges": edges, "reason": REASON, **change}
        yield corner_text.summary_text({**report, "patches_reason": REASON, "seams": [SEAM]})


def legend_texts():
    values = numpy.array([0.1, -0.1, 0.2])
    weights = numpy.ones(3)
    for quantity in maps.QUANTITIES:
        for given in (None, (0.1, 0.2)):
            look = ramps.curvature_look(quantity, abs(values), weights, given)
            yield from (look.legend[0], look.legend[2])
            for _, name, meaning in look.legend[1]:
                yield from (name, meaning)
    look = ramps.draft_look(values, 3.0, 3.0)
    flat = ramps.curvature_look(maps.LARGEST, 0 * values, weights, None)
    for title, entries, footer in (look.legend, flat.legend, curvature.legend(0.5)):
        yield from (title, footer)
        for _, name, meaning in entries:
            yield from (name, meaning)
    yield from (lengths.titled(column.title.replace("{unit}", "")) for column in rows.COLUMNS)
    yield from (profiles.tip(name) for name in profiles.PROFILES)
    yield from (palette.meaning(entry.key, "G1", 5.0) for entry in palette.CLASSES)
    for change in ({"CombLines": 1}, {"CreaseAngle": 0.05}):
        with pytest.raises(ValueError) as caught:
            preferences.check({**preferences.defaults(), **change})
        yield str(caught.value)


@pytest.mark.parametrize(
    "texts",
    [
        curve_texts, map_texts, surface_texts, seam_texts, report_texts, repair_texts, fill_texts,
        match_texts, corner_texts, legend_texts,
    ],
)  # fmt: skip
def test_every_word_is_translated(texts):
    found = list(texts())
    left = {text: small(text) for text in found if small(text)}
    assert left == {} and len(found) > 4
