# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object Seam Repair: a model whose seams join as they should.

The shape is the model of the source. Faces are moved where seams fell short; faces and edges keep
their order. The source is only read. The class path is written into documents: neither rename nor
move it.
"""

import Part

from freecad.seamwright.document import elements, feature, preferences, properties
from freecad.seamwright.document.feature import empty_report, report_of, tolerances
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.plain import kernel, repair_text
from freecad.seamwright.plain.language import mark, tr

__all__ = ["SeamRepair", "candidates_job", "create", "error_text", "is_repair", "report_of"]

#: property, argument of the kernel, property type, default, help
TOLERANCES = properties.TOLERANCES + (
    ("MatchDistance", "match_mm", "App::PropertyLength", 0.0,
     "Free edges no further apart than this are repaired as seams too, in mm; 0: off"),
)  # fmt: skip

TARGETS = ["G1", "G2"]

#: property, kind of element, help
ELEMENTS = (
    ("Edges", "Edge", "The edges of the seams to repair; empty: all defects"),
    ("FixedFaces", "Face", "Faces that must not move"),
)

RESULTS = (
    ("Summary", "App::PropertyString", "The result in one line, or why there is none"),
    ("Changed", "App::PropertyBool", "Whether the shape changed"),
    ("Wanted", "App::PropertyInteger", "Number of seams that were to be repaired"),
    ("Repaired", "App::PropertyInteger", "Number of seams that were repaired"),
    ("MovedFaces", "App::PropertyInteger", "Number of faces that moved"),
    (
        "LargestMove",
        "App::PropertyLength",
        "Largest move of a pole, in mm; no point of a face moved further",
    ),
    ("DefectsBefore", "App::PropertyInteger", "Number of defects before the repair"),
    ("DefectsAfter", "App::PropertyInteger", "Number of defects after the repair"),
    (
        "MaxGapBefore",
        "App::PropertyLength",
        "Largest gap seen before the repair, creases excluded, in mm",
    ),
    (
        "MaxGapAfter",
        "App::PropertyLength",
        "Largest gap seen after the repair, creases excluded, in mm",
    ),
    (
        "MaxAngleBefore",
        "App::PropertyAngle",
        "Largest angle seen before the repair, creases excluded, in degrees",
    ),
    (
        "MaxAngleAfter",
        "App::PropertyAngle",
        "Largest angle seen after the repair, creases excluded, in degrees",
    ),
)


class SeamRepair(feature.Feature):
    """Proxy of a Part::FeaturePython that holds its source with the seams repaired."""

    Type = "SeamRepair"
    TOLERANCES = TOLERANCES
    EMPTY_REPORT = repair_text.EMPTY_REPORT
    INPUTS = ("Source", "Target", "MaxMove", *(name for name, *_ in ELEMENTS))

    @staticmethod
    def add_properties(obj):
        """Add the properties that an object lacks, with their defaults."""
        adder = properties.Adder(obj)
        adder.add(
            "App::PropertyLinkGlobal", "Source", "Seams", "The object whose seams are repaired"
        )
        for name, _, tip in ELEMENTS:
            adder.add("App::PropertyLinkSubGlobal", name, "Seams", tip)
        adder.add_choice("Target", "Repair", "Level of continuity to reach", TARGETS, TARGETS[0])
        tip = (
            "No point of a face may move further than this, in mm; 0: a hundredth of the size of "
            "the face plus twice the largest gap of its seams"
        )
        adder.add("App::PropertyLength", "MaxMove", "Repair", tip)
        adder.add_tolerances(TOLERANCES)
        adder.add_results(RESULTS, feature.INTERNAL)
        obj.setEditorMode("Placement", ["Hidden"])

    @staticmethod
    def source_objects(obj):
        """Return the object whose seams are repaired."""
        return elements.source_objects(obj)

    @staticmethod
    def job(module, obj, private=False):
        """Return the Job that finds (report, shape)."""
        return repair_job(module, obj, private)

    @staticmethod
    def store(obj, report, shape):
        """Put the results into the read-only properties; the Summary is written last."""
        feature.keep_report(obj, report)
        obj.Changed = repair_text.has_changed(report)
        obj.Wanted = len(report["seams"])
        obj.Repaired = repair_text.repaired_count(report)
        obj.MovedFaces = len(report["moves"])
        obj.LargestMove = repair_text.largest_move_mm(report)
        for index, when in enumerate(("Before", "After")):
            for name, figure in (
                ("Defects", "defects"),
                ("MaxGap", "gap_mm"),
                ("MaxAngle", "angle_deg"),
            ):
                setattr(obj, name + when, report[figure][index] or 0)
        feature.put_shape(obj, shape)
        obj.Summary = repair_text.summary_text(report)

    @staticmethod
    def store_failure(obj, reason):
        """Store an empty report and the reason."""
        reason = repair_text.named(reason)
        SeamRepair.store(obj, empty_report(obj), Part.Shape())
        obj.Summary = tr("Not repaired: {reason}").format(reason=reason)
        return reason


def is_repair(obj):
    """Return whether a document object is a Seam Repair."""
    return feature.is_of(obj, SeamRepair)


def repair_job(module, obj, private=False):
    """Return the Job that finds (report, shape).

    Raises SourceError for broken links; ``run`` of the Job raises ValueError for bad values.
    """
    shape = elements.source_shape(obj)
    edges, faces = (elements.numbers(obj, shape, *entry[:2]) for entry in ELEMENTS)
    target, make = obj.Target, feature.model_maker(module, shape, private)
    given = {
        "target": target, "edges": edges or None, "fixed_faces": faces,
        "max_move_mm": properties.number(obj, "MaxMove") or "auto", **tolerances(obj),
        "jobs": preferences.threads()
    }  # fmt: skip

    def run(progress):
        result = make().repair(progress=progress, **given)
        report = repair_text.build_report(
            result.before.to_dict(), result.after.to_dict(), result.seams, result.moves,
            target, bool(edges), len(result.edge_moves)
        )  # fmt: skip
        return report, result

    def finish(found):
        report, result = found
        return report, result.model.to_freecad() if result.changed else shape

    return feature.Job(tr("Repairing seams\u2026"), run, finish)


def candidates_job(module, obj, private=False):
    """Return the Job that finds (report, text) of the seams that a repair would treat.

    The report has these seams as they are now; the text is one line about them. This function and
    ``run`` of the Job raise SourceError, ModelError or ValueError where the seams cannot be found.
    """
    shape = elements.source_shape(obj)
    edges, _ = (elements.numbers(obj, shape, *entry[:2]) for entry in ELEMENTS)
    target, given, make = obj.Target, tolerances(obj), feature.model_maker(module, shape, private)
    given["jobs"] = preferences.threads()

    def finish(before):
        seams = repair_text.waiting(before, target, set(edges))
        report = repair_text.build_report(before, None, seams, [], target, bool(edges))
        return report, repair_text.summary_text(report)

    def run(progress):
        return make().analyze(level=target, progress=progress, **given).to_dict()

    return feature.Job(tr("Analysing seams\u2026"), run, finish)


def create(source, *, edges=(), fixed_faces=(), target="G1", max_move_mm=0.0, **tolerances):
    """Repair the seams of an object: add a Seam Repair to its document, compute and return it.

    ``edges``: ["Edge5", ...] or [5, ...]; the seams of these edges are repaired. Without edges, all
    defects are repaired. ``fixed_faces``: ["Face3", ...] or [3, ...]; these faces stay. ``target``:
    "G1" or "G2". ``max_move_mm``: no point of a face may move further; 0 means a hundredth of the
    size of the face plus twice the largest gap of its seams to be repaired. ``tolerances``: gap_mm,
    angle_deg, curvature_rel, flat_radius_mm, crease_deg, match_mm, profile, as for an analysis.
    Raises TypeError and ValueError for bad arguments, kernel.KernelUnavailable when the compiled
    part is missing. When nothing can be repaired, the object has no shape and ``error_text`` says
    why. Seams that could not be repaired are not errors; the report has the reasons.
    """
    obj = prepare(
        source,
        edges=edges,
        fixed_faces=fixed_faces,
        target=target,
        max_move_mm=max_move_mm,
        **tolerances
    )
    obj.Document.recompute()
    return obj


def prepare(source, *, edges=(), fixed_faces=(), target="G1", max_move_mm=0.0, **tolerances):
    """Add a Seam Repair as ``create`` does, but compute nothing yet."""
    kernel.load(Part.OCC_VERSION)
    table = TOLERANCES + (("MaxMove", "max_move_mm"),)
    given = {**tolerances, "max_move_mm": max_move_mm, "target": target}
    values = properties.checked(given, table, {"target": ("Target", TARGETS)})
    edges, fixed_faces = (
        elements.checked_names(*each)
        for each in (("edges", edges, "Edge"), ("fixed_faces", fixed_faces, "Face"))
    )
    doc = elements.checked_object("source", source).Document
    obj = feature.add(doc, SeamRepair, mark("Seam Repair"))
    obj.Source = source
    elements.set_names(obj, "Edges", edges)
    elements.set_names(obj, "FixedFaces", fixed_faces)
    for name, value in values.items():
        setattr(obj, name, value)
    hooks.attach_view(obj)
    return obj
