// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <string>
#include <vector>

namespace seamwright::occ {

enum class SeamKind {
  Shared,  ///< two faces share an edge
  Closed,  ///< a face meets itself along an edge: a cylinder, a torus, a closed spline surface
  Matched  ///< free edges of two faces that lie close together over a common interval
};

/// One side of a seam: a face and the edge as it runs around it.
struct Coedge {
  int face = 0;       ///< from 1, order of TopExp::MapShapes
  TopoDS_Face shape;  ///< oriented FORWARD
  TopoDS_Edge edge;  ///< oriented so that the face lies to its left, seen from the tip of X_u x X_v
  /// At the first and the last end of the edge's curve: tolerance of the vertex if a boundary of
  /// the surface collapses to it there (the face has a degenerated edge at that vertex), else 0.
  std::array<double, 2> pole_tolerance_mm{};
  std::string fault =
      {};  ///< why face or edge can't be computed with (UnusableParts); mostly empty
};

/// \throws std::runtime_error with the fault of the side, if it has one
void requireUsable(const Coedge& use);

/// Points of the two sides of a seam that belong together: place a[i] of the first edge, 0..1 of
/// the range of its curve, and b[i] of the second, both linear in s between s[i] and s[i + 1]. s
/// runs from 0 to 1 and a increases; b increases or decreases.
struct Correspondence {
  std::vector<double> s;
  std::vector<double> a;
  std::vector<double> b;
};

struct Seam {
  int id = 0;  ///< from 1
  SeamKind kind = SeamKind::Shared;
  std::vector<int> edges;  ///< from 1, order of TopExp::MapShapes; two of a matched seam
  std::array<Coedge, 2> sides;
  Correspondence
      correspondence;  ///< empty: both sides run with the curve of their one edge, s = a = b
  std::string note;    ///< what to know of how it was found; mostly empty
};

/// An edge that bounds one face, or more than two.
struct NonSeamEdge {
  int edge = 0;
  std::vector<int> faces;
};

struct SeamGraph {
  std::vector<Seam> seams;                ///< by edge number; matched ones after the others
  std::vector<NonSeamEdge> open;          ///< one face
  std::vector<Coedge> open_uses;          ///< the one use of each free edge, in the order of open
  std::vector<NonSeamEdge> non_manifold;  ///< more than two uses, by edge number
  std::vector<std::string> notes;         ///< what could not be looked at, and why
};

/// Finds where the faces of a shape meet by shared topology (for loose faces see matchFreeEdges()),
/// in time linear in the size of the shape. Sides with numbers that can't be computed with have a
/// fault.
///
/// Left out: degenerated edges (the pole of a sphere is no seam), edges that bound no face, and
/// edges that lie inside a face without bounding it (orientation INTERNAL or EXTERNAL). Faces and
/// edges are told apart by IsSame, so a face that two solids share counts once and two instances of
/// a part count twice.
SeamGraph findSeams(const TopoDS_Shape& shape);

}  // namespace seamwright::occ
