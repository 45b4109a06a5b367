# SPDX-License-Identifier: LGPL-2.1-or-later
"""The classes of results.

>>> joint = seamwright.measure_joint(line, parabola)
>>> joint.order_reached, joint["order_reached"], joint.to_dict()

Each value of a result is an attribute and an item. The key of the item is the name of the
attribute, unless the class says otherwise. A result is a ``dict`` of its items: it can be
unpacked, compared, copied, pickled and, if it holds no arrays, written as JSON. Attributes can't be
assigned.

Lengths end with ``_mm``, angles with ``_rad`` or ``_deg``, curvatures with ``_per_mm``. Arrays are
numpy arrays. A value that does not exist is ``None``.
"""

from ._curve_results import (
    ArcLength,
    BetaFit,
    CurveDegeneracies,
    CurveInterval,
    CurveJoint,
    DegeneratePoint,
    EnclosedSeam,
    FrenetFrame,
    MovingFrames,
    NearestCurveJoin,
    PairMeasure,
    SurfaceShape,
)
from ._join_results import (
    AlphaNearestJoin,
    AlphaOptimum,
    AlphaSeamCondition,
    AlphaSeamFit,
    Connection,
    ConnectionFit,
    FillCorner,
    G1Connection,
    InterpolatingSpline,
    JoinCondition,
    JoinResidual,
    NSidedFill,
    NearestJoin,
    RingFill,
    ThreeSidedFill,
    Umbrella,
)
from ._model_results import (
    Bounds,
    CheckedWriteResult,
    Compared,
    EdgeMove,
    FaceConversion,
    FaceMove,
    Figure,
    Hole,
    HoleSide,
    LeftOut,
    MeshFault,
    RepairSummary,
    Seam,
    SeamRepair,
    ShapeAttribute,
    SurfaceChange,
    Tolerances,
    WorstPoint,
    WriteResult,
    WrittenFile,
)
from ._result import Result

__all__ = [
    "AlphaNearestJoin",
    "AlphaOptimum",
    "AlphaSeamCondition",
    "AlphaSeamFit",
    "ArcLength",
    "BetaFit",
    "Bounds",
    "CheckedWriteResult",
    "Compared",
    "Connection",
    "ConnectionFit",
    "CurveDegeneracies",
    "CurveInterval",
    "CurveJoint",
    "DegeneratePoint",
    "EdgeMove",
    "EnclosedSeam",
    "FaceConversion",
    "FaceMove",
    "Figure",
    "FillCorner",
    "FrenetFrame",
    "G1Connection",
    "Hole",
    "HoleSide",
    "InterpolatingSpline",
    "JoinCondition",
    "JoinResidual",
    "LeftOut",
    "MeshFault",
    "MovingFrames",
    "NSidedFill",
    "NearestCurveJoin",
    "NearestJoin",
    "PairMeasure",
    "RepairSummary",
    "Result",
    "RingFill",
    "Seam",
    "SeamRepair",
    "ShapeAttribute",
    "SurfaceChange",
    "SurfaceShape",
    "ThreeSidedFill",
    "Tolerances",
    "Umbrella",
    "WorstPoint",
    "WriteResult",
    "WrittenFile",
]
