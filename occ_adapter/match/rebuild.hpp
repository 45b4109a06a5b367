// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <array>

#include <seamwright/occ_adapter/seams/find.hpp>

/// Builds two faces with a new common edge. Not a public header.
namespace seamwright::occ {

/// What a face is rebuilt from.
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
  double gap_mm = 0.01;                   ///< curves are approximated to a thousandth of it
};

struct RebuiltPair {
  TopoDS_Shell shell;  ///< the first face, then the second
  TopoDS_Edge seam;
};

/// Both faces as a shell that shares the seam. Curves and surfaces that stay are shared with the
/// old shape, which is not changed; everything else is new.
///
/// Edges keep their pcurves. If the surface under an edge moved, its curve in space is the image of
/// the pcurve: exact along a parameter line, otherwise approximated. Tolerances of edges and
/// vertices are the distances at 257 points of each pcurve plus a fifth; where nothing moved they
/// are not below those before.
/// \throws GeometryError if a curve can't be built; Standard_Failure.
RebuiltPair rebuild(const SeamPlan& plan);

/// The largest move, at 257 points each, of the edges of the face that end at the seam.
/// \throws GeometryError for an edge without a pcurve on the face.
double largestSideMove_mm(const FacePlan& plan, double gap_mm);

}  // namespace seamwright::occ
