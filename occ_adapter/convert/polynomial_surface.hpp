// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>

namespace seamwright::occ {

/// A B-spline surface in place of another one.
struct PolynomialSurface {
  opencascade::handle<Geom_BSplineSurface> surface;  ///< clamped, not rational, placed in space
  double error_mm = 0;  ///< largest distance of points of the same parameters
};

/// The surface of a face over the range of its parameters as a polynomial B-spline with the same
/// parameters, so that paths on it stay what they are: exactly (but for rounding) for planes and
/// for extrusions of polynomial splines, else approximated with continuous curvature. A rational
/// spline would have the shape of a cylinder, but other parameters. Sides that are one point, as
/// the poles of a sphere, stay so.
/// \param near_mm how near an approximation keeps; its error is what OpenCASCADE bounds it by.
/// \throws std::runtime_error where it can't be approximated so near; Standard_Failure.
PolynomialSurface polynomialSurface(const TopoDS_Face& face, double near_mm);

}  // namespace seamwright::occ
