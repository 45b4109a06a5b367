// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>

namespace seamwright::occ {

/// A B-spline surface that replaces another surface.
struct PolynomialSurface {
  opencascade::handle<Geom_BSplineSurface> surface;  ///< clamped, not rational, placed in space
  double error_mm = 0;  ///< largest distance of points of the same parameters
};

/// The surface of a face, over the range of its parameters, as a polynomial B-spline with the same
/// parameters, so that pcurves stay valid. Planes and extrusions of polynomial splines are
/// converted exactly (up to rounding), other surfaces approximated with continuous curvature. (A
/// rational spline would have the shape of a cylinder, but other parameters.) Sides that are one
/// point, such as the poles of a sphere, stay one point.
/// \param near_mm accuracy of an approximation; its error is OpenCASCADE's bound.
/// \throws GeometryError if the surface can't be approximated to that accuracy;
/// Standard_Failure.
PolynomialSurface polynomialSurface(const TopoDS_Face& face, double near_mm);

}  // namespace seamwright::occ
