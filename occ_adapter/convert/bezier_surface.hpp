// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TopoDS_Shell.hxx>
#include <array>
#include <optional>

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/triangle.hpp>
#include <seamwright/core/bezier/triangle_conversion.hpp>

/// Bézier curves, patches and triangles of core as OpenCASCADE's, and back.
///
/// Poles and weights are those of poles() and weights(). A polynomial that is converted and
/// converted back is bitwise the same, a rational one except for the rounding of its homogeneous
/// poles. OpenCASCADE treats weights that agree to the last digit as a polynomial and discards
/// them.
///
/// OpenCASCADE supports degrees 1 to 25. All conversions to it throw std::invalid_argument for
/// other degrees, with the degree.
namespace seamwright::occ {

/// The curve over [0, 1], with the poles and weights of the given one.
opencascade::handle<Geom_BezierCurve> toBezierCurve(const BezierCurve& curve);
/// The surface over [0, 1]^2, with the poles and weights of the given patch.
opencascade::handle<Geom_BezierSurface> toBezierSurface(const BezierPatch& patch);

/// The Bézier curve of a Geom_BezierCurve, or of a Geom_BSplineCurve of one span, over [0, 1].
/// \throws std::domain_error for other kinds, with the name, and for more spans, with their number.
BezierCurve bezierCurve(const Geom_Curve& curve);
/// The same for a Geom_BezierSurface or a Geom_BSplineSurface of one span in both parameters.
BezierPatch bezierPatch(const Geom_Surface& surface);

/// The three patches of regularPatches(). OpenCASCADE has no triangles.
std::array<opencascade::handle<Geom_BezierSurface>, 3> toBezierSurfaces(
    const BezierTriangle& triangle);

/// A shell of three faces on toBezierSurfaces(), oriented by the triangle's natural normal; they
/// share the three edges that meet at the centroid. The outer edges are cut in the middle.
/// Tolerances are OpenCASCADE's Precision::Confusion(), 1e-7; the curves lie on the surfaces to
/// rounding. An edge of the triangle whose poles lie within \p tolerance_mm of one of its points is
/// two degenerated edges and one vertex, which reaches to these poles.
/// \param tolerance_mm at least Precision::Confusion() is used.
/// \throws std::invalid_argument as requireArea(), and if an inner edge is a point to that
/// tolerance.
TopoDS_Shell toShell(const BezierTriangle& triangle, double tolerance_mm = 0);

/// recogniseTriangle() of bezierPatch().
/// \throws std::domain_error as bezierPatch().
TriangleRecognition recogniseTriangle(const Geom_Surface& surface,
                                      std::optional<double> tolerance_mm = std::nullopt);

}  // namespace seamwright::occ
