// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineCurve.hxx>
#include <Geom_Curve.hxx>

#include <seamwright/core/bspline/curve.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

/// Splines of core as OpenCASCADE's B-spline curves, and back. Bézier curves: bezier_surface.hpp.
namespace seamwright::occ {

/// Poles, weights, knots and multiplicities are taken over as they are: there and back a polynomial
/// is the same bit by bit, but for equal weights, which OpenCASCADE does not keep: they come back
/// as 1 and the poles divided by them.
/// \throws std::invalid_argument as requireValid(), and for inner knots nearer to each other than
/// OpenCASCADE tells apart.
opencascade::handle<Geom_BSplineCurve> toBSplineCurve(const BSplineCurve& curve);

/// With the highest continuity in its knots, up to degree - 1, that every joint has (continuity()):
/// nu-, beta-, gamma- and direct G2 splines get multiplicity 2, C2 ones 1, those whose knots lost
/// digits of their lengths 3.
/// \param periodic a closed spline that is as smooth at its seam as at its knots becomes a periodic
/// one.
/// \throws std::invalid_argument as requireValid(), for a degree above 25, and if periodic is asked
/// of what is not, with both orders.
opencascade::handle<Geom_BSplineCurve> toBSplineCurve(const BezierSpline& spline,
                                                      bool periodic = false);

/// The numbers of a Geom_BSplineCurve or Geom_BezierCurve, trimmed or not: clamped, not periodic,
/// over its range, by clampedCurve(): spans may be as short as knots can tell apart. Bit by bit
/// where nothing has to be trimmed, clamped or cut open.
/// \throws std::domain_error for another kind, with its name; std::invalid_argument as
/// clampedCurve().
BSplineCurve coreCurve(const Geom_Curve& curve);

}  // namespace seamwright::occ
