// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <array>

#include <seamwright/occ_adapter/seams/find.hpp>

/// The topology of two faces with a new seam; not a public header.
namespace seamwright::occ {

/// A face that is built again.
struct FacePlan {
  TopoDS_Face face;  ///< as it was
  Coedge use;        ///< the edge that becomes the seam
  /// The new surface, placed in space, with the parameters of the old one; null: the old one stays.
  opencascade::handle<Geom_Surface> surface;
  opencascade::handle<Geom2d_Curve> path;  ///< of the seam
  bool with_old_edge = true;               ///< the seam runs with the curve of the old edge
};

struct SeamPlan {
  std::array<FacePlan, 2> faces;
  double first = 0, last = 1;             ///< parameters of both paths and of the curve
  opencascade::handle<Geom_Curve> curve;  ///< in space
  double gap_mm = 0.01;  ///< curves that have to be approximated keep within a thousandth of it
};

struct RebuiltPair {
  TopoDS_Shell shell;  ///< the first face, then the second
  TopoDS_Edge seam;
};

/// Both faces as a shell that shares the seam. Everything is new but the curves and surfaces that
/// stay; the old shape is not touched.
///
/// Edges keep their paths in the parameter plane. Where a surface moved below an edge, its curve in
/// space is the image of the path: exact along a parameter line, else approximated. Tolerances of
/// edges and vertices are what 257 points of each path show and a fifth more, and not below those
/// they had where nothing moved.
/// \throws std::runtime_error where a curve can't be built; Standard_Failure.
RebuiltPair rebuild(const SeamPlan& plan);

/// How far the new surface takes the edges of the face that end at the seam from where they were;
/// of 257 points each.
/// \throws std::runtime_error for an edge without a path on the face.
double largestSideMove_mm(const FacePlan& plan, double gap_mm);

}  // namespace seamwright::occ
