// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineCurve.hxx>
#include <Geom_Curve.hxx>

#include <seamwright/core/bspline/curve.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

/// Splines of core as OpenCASCADE's B-spline curves, and back. Bézier curves: bezier_surface.hpp.
namespace seamwright::occ {

/// Poles, weights, knots and multiplicities stay the same. A polynomial that is converted and
/// converted back is bitwise the same, except that OpenCASCADE discards equal weights: they become
/// 1, and the poles are divided by them.
/// \throws std::invalid_argument as requireValid(), and for inner knots that are too near to each
/// other for OpenCASCADE.
opencascade::handle<Geom_BSplineCurve> toBSplineCurve(const BSplineCurve& curve);

/// The spline as a B-spline with the highest continuity at its knots, up to degree - 1, that every
/// joint has (continuity()): nu-, beta-, gamma- and direct G2 splines get multiplicity 2, C2
/// splines 1, and splines whose knots lost digits of their lengths 3.
/// \param periodic the spline is closed, as smooth at its seam as at its knots, and becomes
/// periodic.
/// \throws std::invalid_argument as requireValid(), for a degree above 25, and for \p periodic if
/// the spline can't be, with both orders.
opencascade::handle<Geom_BSplineCurve> toBSplineCurve(const BezierSpline& spline,
                                                      bool periodic = false);

/// A Geom_BSplineCurve or Geom_BezierCurve, trimmed or not, over its range, clamped and not
/// periodic (clampedCurve()). Bitwise the same if nothing has to be trimmed, clamped or cut open.
/// \throws std::domain_error for another kind, with its name; std::invalid_argument as
/// clampedCurve().
BSplineCurve coreCurve(const Geom_Curve& curve);

}  // namespace seamwright::occ
