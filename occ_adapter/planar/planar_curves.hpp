// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <vector>

#include <seamwright/core/planar/planar_chain.hpp>
#include <seamwright/core/planar/plane_frame.hpp>

/// OpenCASCADE's curves of the plane, and of planes in space, as planar values of core, and back.
/// Nothing is fitted: each curve becomes the value that is exact for its kind, up to rounding.
///
/// | OpenCASCADE | core |
/// |---|---|
/// | line, circle | PlanarArc |
/// | ellipse, hyperbola, parabola | PlanarConic, several if it turns by 2 pi / 3 or more |
/// | Bézier curve, B-spline | BSplineCurve, with the same poles, weights and knots |
///
/// Trimmed curves are those of their basis over their range. Rounding is at most 1e-14 of the size
/// of the numbers that describe the curve: radii, distances from the origin, poles. Poles and knots
/// of a spline that is neither periodic nor cut stay bitwise; a circle stays a circle.
namespace seamwright::occ {

/// The curve over [first, last] as planar values end to end. Identities (each has a test of its
/// number):
///   (1) Points of the values are points of the curve, compared with OpenCASCADE's evaluation.
///   (2) The values start at the point of \p first and end at that of \p last.
/// \throws std::invalid_argument if first is not below last or not finite, and as clampedCurve().
/// Throws std::domain_error for another kind (an offset curve), with its name.
std::vector<ChainCurve> planarCurves(const Geom2d_Curve& curve, double first, double last);
/// Over the whole range of the curve. \throws std::domain_error also if it is infinite.
std::vector<ChainCurve> planarCurves(const Geom2d_Curve& curve);

/// The same of a curve of space in the coordinates of a plane. A curve outside of the plane is
/// projected orthogonally; heightOf() returns its distance from the plane.
///   (3) For curves of the plane it is identity (1). The coordinates of poles in a plane parallel
///       to two coordinate axes are bitwise those of space.
/// \throws as the others, and std::domain_error for a circle or conic whose own plane is not
/// parallel to the plane up to 1e-6: it would become another kind of curve.
std::vector<ChainCurve> planarCurves(const Geom_Curve& curve, double first, double last,
                                     const PlaneFrame& frame);

/// Points that span the curve over [first, last]: it lies in their convex hull. They are the poles
/// of a spline; for lines its ends; for circles and conics poles of their Bézier form.
/// \throws as planarCurves().
Poles hullOf(const Geom_Curve& curve, double first, double last);

/// Upper bound of the distance of a curve from the plane: that of hullOf().
double heightOf(const Geom_Curve& curve, double first, double last, const PlaneFrame& frame);

/// The value as a curve of OpenCASCADE: a trimmed line or circle (a full circle is not trimmed), or
/// a B-spline; a conic is a rational quadratic Bézier curve. An arc with a radius above 1e5 lengths
/// is one too, because the centre would lose as many digits. A curve runs from its first parameter
/// to its last one.
///   (4) Points of the result are points of the value; planarCurves() brings the value back.
/// \throws std::invalid_argument for an arc without length, and as toBSplineCurve().
opencascade::handle<Geom2d_Curve> toGeom2d(const ChainCurve& curve);
opencascade::handle<Geom_Curve> toGeom(const ChainCurve& curve, const PlaneFrame& frame);

}  // namespace seamwright::occ
