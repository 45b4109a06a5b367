# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a typed script uses the package; checked by test_stubs.py with mypy --strict, not run."""

from typing import List, Optional

import numpy as np
import numpy.typing as npt
import seamwright
from seamwright.curves import BezierCurve
from seamwright.results import FrenetFrame, NearestJoin, Seam


def worst_angle(path: str) -> Optional[float]:
    report = seamwright.read(path).analyze(**seamwright.PROFILES["class-a"])
    angles: List[float] = [seam.angle_deg.lower for seam in report.seams if seam.angle_deg]
    return max(angles, default=None)


def defects(report: seamwright.Report) -> List[Seam]:
    return [seam for seam in report.seams if seam.seam_class == "defect"]


def samples(curve: BezierCurve) -> npt.NDArray[np.float64]:
    return curve.point(np.linspace(0, 1, 5))


def frame(curve: BezierCurve) -> FrenetFrame:
    return seamwright.frenet_frame(curve, np.float32(0.5))


def road(points: npt.NDArray[np.float64]) -> float:
    chain = seamwright.clothoid_spline(points, start_direction_rad=0.5).chain
    spline = chain.bezier_spline(1e-3)
    arcs = seamwright.fit_arcs(spline, 0.01).chain
    return arcs.curvature_at_per_mm(0.0) + chain.direction_at_rad(1.0)


def joined(a: seamwright.BezierPatch, b: seamwright.BezierPatch) -> seamwright.BezierPatch:
    near: NearestJoin = seamwright.nearest_join(a, "u1", b, "u0")
    return seamwright.continuation(a, "u1", connection=near)
