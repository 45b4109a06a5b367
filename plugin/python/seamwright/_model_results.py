# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of models: seams, repairs, holes, written files."""

from __future__ import annotations

from typing import TYPE_CHECKING, Dict, List, Optional

from ._result import Result

if TYPE_CHECKING:
    from ._core import BSplineSurface


class Tolerances(Result):
    """The tolerances of a profile: arguments of ``Model.analyze`` and of all that judge.

    gap_mm          largest gap at which faces meet
    angle_deg       largest angle between their tangent planes
    curvature_rel   largest relative difference of curvature
    flat_radius_mm  surfaces of larger radii count as flat
    crease_deg      seams with a larger angle are creases
    """

    gap_mm: float
    angle_deg: float
    curvature_rel: float
    flat_radius_mm: float
    crease_deg: float


class Figure(Result):
    """The largest value of a quantity along a seam, in the unit of the figure.

    lower  a value that is reached at ``at``
    upper  no value is larger; ``None``: no bound is known
    at     0..1 along the seam
    """

    lower: float
    upper: Optional[float]
    at: float


class LeftOut(Result):
    """Intervals [first, last] in 0..1 along a seam that its figures leave out."""

    angle_deg: List[List[float]]
    curvature_per_mm: List[List[float]]
    curvature_rel: List[List[float]]


class WorstPoint(Result):
    """Where a seam is worst.

    quantity  "gap", "angle", "curvature" or "curvature_change"
    at        0..1 along the seam
    point_mm  [x, y, z]; item "point"
    """

    _keys = {"point_mm": "point"}

    quantity: str
    at: float
    point_mm: List[float]


class Seam(Result):
    """A seam of a model, as in the JSON (docs/analysis-1.schema.json).

    id, edges, faces   numbers from 1
    kind               "shared", "closed" or "matched"
    length_mm          of the seam
    gap_mm, angle_deg, curvature_per_mm, curvature_rel,
    curvature_change_per_mm2, curvature_change_rel
                       a Figure, or None
    left_out           intervals that the figures leave out
    level              "none", "G0", "G1", "G2" or "G3"
    seam_class         "smooth", "defect" or "crease"; item "class"
    certified          the verdict is certain
    worst              a WorstPoint, or None
    note               what a user should know, or ""
    """

    _keys = {"seam_class": "class"}
    _kinds = {
        "gap_mm": Figure,
        "angle_deg": Figure,
        "curvature_per_mm": Figure,
        "curvature_rel": Figure,
        "curvature_change_per_mm2": Figure,
        "curvature_change_rel": Figure,
        "left_out": LeftOut,
        "worst": WorstPoint,
    }

    id: int
    kind: str
    edges: List[int]
    faces: List[int]
    length_mm: float
    gap_mm: Optional[Figure]
    angle_deg: Optional[Figure]
    curvature_per_mm: Optional[Figure]
    curvature_rel: Optional[Figure]
    curvature_change_per_mm2: Optional[Figure]
    curvature_change_rel: Optional[Figure]
    left_out: LeftOut
    level: str
    seam_class: str
    certified: bool
    worst: Optional[WorstPoint]
    note: str


class ReasonFacts(Result):
    """Numbers and location of a reason.

    numbers       by name with the unit, such as {"move_mm": 0.3}
    faces, edges  of the given model
    """

    numbers: Dict[str, float]
    faces: List[int]
    edges: List[int]


class SeamRepair(Result):
    """What a repair did with a seam.

    before, after     the seam as it was and as it is
    treated           the repair was to improve it
    repaired          it meets the target now
    reason            why it is left, or ""; reason_code: its code, see docs/repair.md;
                      reason_facts: its numbers and location
    wants_conversion  it can be treated if analytic faces may become splines
    sewn, not_sewn    its two edges became one; why they did not, or ""; not_sewn_code and
                      not_sewn_facts as for the reason
    """

    _kinds = {
        "before": Seam,
        "after": Seam,
        "reason_facts": ReasonFacts,
        "not_sewn_facts": ReasonFacts,
    }

    before: Seam
    after: Seam
    treated: bool
    repaired: bool
    reason: str
    reason_code: str
    reason_facts: ReasonFacts
    wants_conversion: bool
    sewn: bool
    not_sewn: str
    not_sewn_code: str
    not_sewn_facts: ReasonFacts


class Bounds(Result):
    """A value between ``lower`` and ``upper``."""

    lower: float
    upper: float


class Compared(Result):
    """A value ``before`` and ``after`` a change."""

    before: Optional[float]
    after: Optional[float]


class SurfaceChange(Result):
    """What became of the surface of a face that moved.

    move_mm                  Bounds of the largest move of a point
    normal_move_mm           largest part along the normal
    tangential_move_mm       largest part in the tangent plane
    turn_deg                 largest turn of the normal
    curvature_change_per_mm  largest change of normal curvature
    variation_per_mm         Compared: how much the mean curvature varies
    extrema, inflections     Compared: their number along the lines
    lines                    how many iso-lines were compared
    worse, reason            the face is less fair than before, and why
    reason_code              the kind of the reason, see docs/repair.md
    """

    _kinds = {
        "move_mm": Bounds,
        "variation_per_mm": Compared,
        "extrema": Compared,
        "inflections": Compared,
    }

    move_mm: Bounds
    normal_move_mm: float
    tangential_move_mm: float
    turn_deg: float
    curvature_change_per_mm: float
    variation_per_mm: Compared
    extrema: Compared
    inflections: Compared
    lines: int
    worse: bool
    reason: str
    reason_code: str


class FaceMove(Result):
    """A face that moved.

    face             its number, from 1
    largest_move_mm  of a point
    surface          a SurfaceChange; None: it could not be measured
    """

    _kinds = {"surface": SurfaceChange}

    face: int
    largest_move_mm: float
    surface: Optional[SurfaceChange]


class EdgeMove(Result):
    """An edge that got a new pcurve on a face that stays: its number, and the largest move."""

    edge: int
    largest_move_mm: float


class FaceConversion(Result):
    """A face that became a spline.

    face      its number, from 1
    kind      what it was
    error_mm  largest distance from what it was
    """

    face: int
    kind: str
    error_mm: float


class RepairSummary(Result):
    """Counts of a repair.

    seams, treated, repaired, left   seams: all, those to be improved, those that were, the others
    wants_conversion                 seams that need analytic faces to become splines
    sewn, lowered                    seams sewn; seams at a lower level that the target allows
    defects_before, defects_after    defects
    largest_move_mm                  of a point
    worse_faces                      faces that are less fair than before
    changed, passed                  something moved; no seam is a defect
    """

    seams: int
    treated: int
    repaired: int
    left: int
    wants_conversion: int
    sewn: int
    lowered: int
    defects_before: int
    defects_after: int
    largest_move_mm: float
    worse_faces: int
    changed: bool
    passed: bool


class HoleSide(Result):
    """A side of a hole: numbers of its edges and of the faces beside them, and its length."""

    edges: List[int]
    faces: List[int]
    length_mm: float


class Hole(Result):
    """A closed loop of free edges.

    id           number from 1
    length_mm    around
    centre_mm    [x, y, z]
    has_corners  the tangent turns somewhere
    longest      the longest loop of its shell
    sides        HoleSides
    """

    _kinds = {"sides": HoleSide}

    id: int
    length_mm: float
    centre_mm: List[float]
    has_corners: bool
    longest: bool
    sides: List[HoleSide]


class SideRibbon(Result):
    """A side of a model as a spline surface inside of it.

    surface    BSplineSurface: u runs along the side, v from inside to the side at v = 1
    edge       "v1", the name of that boundary
    edges      numbers of the edges along it
    faces      numbers of the faces that it stands for
    length_mm  of the side
    seams      Seams between these and the continuation of the ribbon beyond the side, face 0
    reached    all seams certainly have the order asked for, and the ribbon does not turn over
    reason     why seams do not cover the side, or where the ribbon turns over; or empty
    """

    surface: BSplineSurface
    edge: str
    edges: List[int]
    faces: List[int]
    length_mm: float
    seams: List[Seam]
    reached: bool
    reason: str


class ShapeAttribute(Result):
    """What a file says about a part of the shape.

    kind    "Face", "Solid", ...
    index   number from 1 among the parts of that kind
    name    "" if there is none
    color   red, green, blue in 0..1, linear; or None
    layers  names
    """

    kind: str
    index: int
    name: str
    color: Optional[List[float]]
    layers: List[str]


class MeshFault(Result):
    """A face whose triangles are missing or do not cover it: its number, and why."""

    face: int
    reason: str


class WriteResult(Result):
    """The outcome of writing a file.

    format                            of the file
    followed_source                   structure, names and colours of the source were kept
    changed_faces, changed_edges,
    changed_vertices                  how many differ from the source
    notes                             what a user should know
    """

    format: str
    followed_source: bool
    changed_faces: int
    changed_edges: int
    changed_vertices: int
    notes: List[str]


class FileSeam(Result):
    """A seam that is a defect in a file and not in the model.

    edges, faces  numbers in the model
    """

    edges: List[int]
    faces: List[int]


class WrittenFile(Result):
    """What was found in a file that was read back.

    only_in_file       a FileSeam for each seam that is a defect in the file alone
    spoilt_by_writing  how many of them writing alone spoils, without a change of the model; None
                       if that was not examined
    """

    _kinds = {"only_in_file": FileSeam}

    path: str
    format: str
    edges: int
    faces: int
    open_edges: int
    defects: int
    only_in_file: List[FileSeam]
    spoilt_by_writing: Optional[int]


class CheckedWriteResult(WriteResult):
    """The outcome of writing a file that was then read back and analysed.

    output       a WrittenFile
    differences  one line that says how the file differs from the model, or ""
    """

    _kinds = {"output": WrittenFile}

    output: WrittenFile
    differences: str
