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
  Matched  ///< free edges that lie side by side over a common interval
};

/// One side of a seam: a face and the use of an edge by it.
struct Coedge {
  int face = 0;       ///< from 1, order of TopExp::MapShapes
  TopoDS_Face shape;  ///< oriented FORWARD
  TopoDS_Edge edge;  ///< oriented so that the face lies to its left, seen from the tip of X_u x X_v
  /// At the first and the last end of the edge's curve: the tolerance of the vertex if a boundary
  /// of the surface collapses there (the face has a degenerated edge at that vertex), otherwise 0.
  std::array<double, 2> pole_tolerance_mm{};
  std::string fault =
      {};  ///< why face or edge can't be computed with (UnusableParts); empty if they can
};

/// \throws GeometryError with the fault of the side, if it has one.
void requireUsable(const Coedge& use);

/// Corresponding points of the two sides of a matched seam: parameters a[i] of the first edge and
/// b[i] of the second, 0..1 over the ranges of their curves. Both are linear in s between s[i] and
/// s[i + 1]. s runs from 0 to 1, a increases, and b increases or decreases.
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
  Correspondence correspondence;  ///< empty: one edge, s = a = b
  std::string note;               ///< what a user should know of how it was found; may be empty
};

/// An edge that bounds one face, or more than two.
struct NonSeamEdge {
  int edge = 0;
  std::vector<int> faces;
};

/// The seams of a shape, and the edges that are in none.
struct SeamGraph {
  std::vector<Seam> seams;                ///< by edge number; matched ones after the others
  std::vector<NonSeamEdge> open;          ///< one face
  std::vector<Coedge> open_uses;          ///< the coedge of each free edge, in the order of open
  std::vector<NonSeamEdge> non_manifold;  ///< more than two uses, by edge number
  std::vector<std::string> notes;         ///< what could not be examined, and why
};

/// Finds the seams of a shape by shared topology, in time linear in its size. For faces that share
/// no edges see matchFreeEdges(). Sides that can't be computed with have a fault. The shape is not
/// changed.
///
/// Not included are degenerated edges (the pole of a sphere is no seam), edges that bound no face,
/// and edges inside a face that do not bound it (orientation INTERNAL or EXTERNAL). IsSame
/// distinguishes faces and edges: a face that two solids share counts once, and two instances of a
/// part count twice.
SeamGraph findSeams(const TopoDS_Shape& shape);

}  // namespace seamwright::occ
