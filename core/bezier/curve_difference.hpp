// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/curve.hpp>

/// Proven distances of curves; not a public header.
namespace seamwright {

/// Bound of |X(t) - Y(t)| over 0..1 for a polynomial Y, from (A - w Y) / w in Bernstein form with
/// X = A / w. Rounding is included.
double differenceBound(const BezierCurve& x, const BezierCurve& y);

/// Bound of the distance of two curves in both directions, also as they are run: points X(s) and
/// Y(t) are this near for an increasing t(s) that takes 0 to 0 and 1 to 1. Both are halved, X at
/// the point near the middle of Y, until the bound is at most \p enough_mm, or two such points are
/// further apart than \p allowed_mm, or eight times; the bound holds in each case.
double correspondenceBound(const BezierCurve& x, const BezierCurve& y, double enough_mm,
                           double allowed_mm);

}  // namespace seamwright
