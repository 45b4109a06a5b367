# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gap, angle and difference of curvature along a seam, at sampled points.

The formulas are those of docs/seams.md; here they are evaluated at single points. What bounds the
figures between the points is the enclosure of the kernel, not these values.
"""

from typing import Any, NamedTuple

import numpy


class Side(NamedTuple):
    """One face at the points of a seam: (n, 3) each; ``tensors`` (n, 3, 3) in 1/mm."""

    points: Any
    normals: Any
    tensors: Any


def side(points, first, second):
    """Return a Side from derivatives by the parameters of a surface.

    ``first``: (su, sv), ``second``: (suu, suv, svv), each (n, 3). Undefined where su and sv are
    parallel.
    """
    su, sv = first
    across = numpy.cross(su, sv)
    length = numpy.linalg.norm(across, axis=1)
    with numpy.errstate(divide="ignore", invalid="ignore"):
        normals = across / numpy.where(length > 0, length, numpy.nan)[:, None]
    jacobian = numpy.stack([su, sv], axis=2)
    metric = jacobian.transpose(0, 2, 1) @ jacobian
    bends = [(normals * each).sum(axis=1) for each in second]
    form = numpy.array([[bends[0], bends[1]], [bends[1], bends[2]]]).transpose(2, 0, 1)
    tensors = numpy.full((len(points), 3, 3), numpy.nan)
    known = numpy.isfinite(normals).all(axis=1)
    shape = numpy.linalg.solve(metric[known], jacobian[known].transpose(0, 2, 1))
    tensors[known] = shape.transpose(0, 2, 1) @ form[known] @ shape
    return Side(numpy.asarray(points), normals, tensors)


def profile(one, other, flat_radius_mm, crease_deg):
    """Return {"gap_mm", "angle_deg", "curvature_per_mm", "curvature_rel"}, each (n,), of two Sides.

    Curvatures are nan where the angle is above ``crease_deg``.
    """
    gaps = numpy.linalg.norm(other.points - one.points, axis=1)
    cosines = (one.normals * other.normals).sum(axis=1)
    signs = numpy.where(cosines < 0, -1.0, 1.0)  # the same plane for both senses of a normal
    axes = numpy.cross(other.normals, one.normals) * signs[:, None]
    sines = numpy.linalg.norm(axes, axis=1)
    angles = numpy.degrees(numpy.arctan2(sines, abs(cosines)))
    turns = _rotations(axes, abs(cosines))
    turned = turns @ other.tensors @ turns.transpose(0, 2, 1)
    differences = _norms(turned * signs[:, None, None] - one.tensors)
    largest = numpy.maximum(_norms(one.tensors), _norms(other.tensors))
    smooth = angles <= crease_deg
    with numpy.errstate(divide="ignore", invalid="ignore"):
        relative = numpy.where(largest < 1 / flat_radius_mm, 0.0, differences / largest)
    return {
        "gap_mm": gaps,
        "angle_deg": angles,
        "curvature_per_mm": numpy.where(smooth, differences, numpy.nan),
        "curvature_rel": numpy.where(smooth, relative, numpy.nan),
    }


def within(values, bound, leaves_out):
    """Return sampled values, none of them above the proven upper bound of a figure.

    ``bound``: {"upper": number or None}, or None. What is above it is rounding or, where the
    figure ``leaves_out`` a point without a normal, the value at that point, which is nan then.
    """
    upper = bound and bound["upper"]
    if upper is None:
        return values
    instead = numpy.nan if leaves_out else upper
    return numpy.where(values > upper, instead, values)


def _rotations(axes, cosines):
    """Return the rotations about axes whose lengths are the sines of the angles."""
    cross = numpy.zeros((len(axes), 3, 3))
    x, y, z = axes.T
    cross[:, 0, 1], cross[:, 0, 2], cross[:, 1, 2] = -z, y, -x
    cross -= cross.transpose(0, 2, 1)
    return numpy.eye(3) + cross + cross @ cross / (1 + cosines)[:, None, None]


def _norms(tensors):
    found = numpy.full(len(tensors), numpy.nan)
    known = numpy.isfinite(tensors).all(axis=(1, 2))
    found[known] = abs(numpy.linalg.eigvalsh(tensors[known])).max(axis=1)
    return found
