// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt2d.hxx>

#include <seamwright/core/bezier/curve.hpp>

/// Not a public header.
namespace seamwright::occ {

/// The pcurve of the curve projected onto the face, from one point of the parameter plane to
/// another, with the curve's tangents at its ends.
/// \throws CornerRefused if OpenCASCADE finds none.
opencascade::handle<Geom2d_Curve> pathOnFace(const TopoDS_Face& face, const BezierCurve& curve,
                                             const gp_Pnt2d& from, const gp_Pnt2d& to);

}  // namespace seamwright::occ
