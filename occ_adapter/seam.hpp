// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

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

/// Corresponding points of the two sides of a matched seam: parameters a[i] of the first edge and
/// b[i] of the second, 0..1 over the ranges of their curves. Both are linear in s between s[i] and
/// s[i + 1]; b may be cubic (PiecewiseMap). s runs from 0 to 1, a rises, b rises or falls.
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

}  // namespace seamwright::occ
