// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Precision.hxx>
#include <string>
#include <variant>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/triangle.hpp>
#include <seamwright/core/bspline/curve.hpp>
#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>
#include <seamwright/occ_adapter/model/model.hpp>

/// Models made of surfaces and curves of core, and back.
namespace seamwright::occ {

using BuiltGeometry = std::variant<BezierPatch, BezierTriangle, BSplineSurface, BezierCurve,
                                   BSplineCurve, BezierSpline>;

struct BuiltItem {
  BuiltGeometry geometry;
  std::string name = {};   ///< of its faces or its edge; may be empty
  std::string label = {};  ///< in errors; empty: "item 3", counted from 0
};

/// A model of the items in their order, in one compound.
///
/// A patch becomes a shell of one face on a Bézier surface, a B-spline surface a shell of one face
/// on that surface, both as naturalFace() does it; a triangle becomes the shell of toShell(). A
/// curve becomes one edge, with one vertex if its ends lie within \p tolerance_mm of each other.
/// Items share no edges: see sewnModel().
///
/// Identities (each has a test of its number):
///   (1) faceSurface() of a face of a patch or a B-spline surface has the poles, weights and knots
///   of
///       the item: bitwise for a polynomial, except for the rounding of homogeneous poles for a
///       rational surface. The same holds for edgeCurve() of an edge of a curve.
///   (2) Every face passes OpenCASCADE's BRepCheck, also if sides are points or coincide.
///   (3) A triangle and its three faces are the same points.
/// \param tolerance_mm positive: below it a side is a point, sides coincide, a curve is closed.
/// \throws std::invalid_argument for no items and for a tolerance that is not positive, and with
/// the label of the item for a degree above 25, knots that OpenCASCADE can't distinguish, a face
/// without area and a curve without length.
Model builtModel(const std::vector<BuiltItem>& items, double tolerance_mm = Precision::Confusion());

/// The Bézier or B-spline surface under a face, placed in space, clamped and not periodic. A
/// trimmed face has the whole surface. \param face from 1. \throws std::invalid_argument for a face
/// that the model does not have; std::domain_error for a surface of another kind, with the face and
/// the kind.
BSplineSurface faceSurface(const Model& model, int face);

/// The Bézier or B-spline curve of an edge over the range of the edge, placed in space.
/// \param edge from 1. \throws std::invalid_argument for an edge that the model does not have;
/// std::domain_error for a curve of another kind and for an edge without a curve, with the edge.
BSplineCurve edgeCurve(const Model& model, int edge);

}  // namespace seamwright::occ
