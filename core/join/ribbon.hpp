// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/patch_edge.hpp>
#include <seamwright/core/bezier/triangle.hpp>

namespace seamwright {

/// Direction of the cross parameter s of a ribbon: into the patch, or out of it.
enum class Across { Into, OutOf };

/// A patch along one of its edges: the position and the derivatives by a parameter s that runs
/// across the edge. They are homogeneous polynomials of the seam's parameter t in [0, 1], each in
/// Bernstein form with a separate degree, one coefficient per row.
///
/// (s, t) is a parametrisation of the patch, so mixed derivatives are derivatives of these
/// polynomials by t. For a tensor-product patch s is the parameter across the edge. For a triangle
/// with the edge from A (t = 0) to B (t = 1) and the third corner C, s goes from A towards C at
/// constant weight of B: the barycentric coordinates of (C, A, B) are (s, 1 - s - t, t) for
/// Across::Into, (-s, 1 + s - t, t) for OutOf.
///
/// So one theory of joins holds for tensor-product patches and triangles, polynomial and rational,
/// in any pair.
/// Identities (each has a test of its number):
///   (1) The polynomials are the position and the derivatives of the patch at (s, t) = (0, t).
///   (2) The first and third derivatives for OutOf are the negatives of those for Into. Position
///       and second derivative are the same.
///   (3) Reversal replaces t by 1 - t; for a triangle s then runs at constant weight of A.
struct Ribbon {
  HomogeneousPoles position;  ///< degree n
  HomogeneousPoles first;     ///< d/ds; degree n, for a triangle n - 1
  /// D2/ds2; degree n, for a triangle max(n - 2, 0); zero if the degree across is 1.
  HomogeneousPoles second;
  /// D3/ds3; degree n, for a triangle max(n - 3, 0); zero if the degree across is below 3.
  HomogeneousPoles third;
  /// Degree of the patch across the edge, for a triangle its degree. It is the factor between
  /// differences of poles and derivatives.
  int degree_across = 1;

  int degree() const { return static_cast<int>(position.rows()) - 1; }
  /// The position and the derivatives, by their order.
  std::array<HomogeneousPoles*, 4> parts() { return {&position, &first, &second, &third}; }
  std::array<const HomogeneousPoles*, 4> parts() const {
    return {&position, &first, &second, &third};
  }
};

/// \param reversed t runs against the sense of the edge.
Ribbon ribbon(const BezierPatch& patch, PatchEdge edge, bool reversed, Across across);
/// \throws std::invalid_argument for a triangle of degree 0, which has no edges.
Ribbon ribbon(const BezierTriangle& triangle, TriangleEdge edge, bool reversed, Across across);

/// The same patch with parameters such that the edge is u = 0 and v runs along it.
BezierPatch turnedToU0(const BezierPatch& patch, PatchEdge edge, bool reversed);
/// The inverse of turnedToU0().
BezierPatch turnedFromU0(const BezierPatch& patch, PatchEdge edge, bool reversed);

/// Index in the net of pole k in the r-th row of poles behind an edge. The powers of the third
/// corner C, of the edge's end B and of its beginning A are r, k and degree - r - k.
Eigen::Index poleRow(int degree, TriangleEdge edge, bool reversed, int r, int k);

/// Two patches in common parameters: a ends at the seam u = 1, b begins there at u = 0, and v runs
/// along it on both.
struct CanonicalPair {
  BezierPatch a, b;
  bool reversed = false;  ///< the sense of b's edge was reversed
};

/// Brings two patches with given edges into common parameters. b's edge is reversed if this makes
/// the sum of distances between its ends and a's ends smaller. If the ends do not decide, as on a
/// closed seam, the points at t = 1/4 and 3/4 do.
/// Source: docs/theory/surfaces.md S1.7.
CanonicalPair orient(const BezierPatch& a, PatchEdge edge_a, const BezierPatch& b,
                     PatchEdge edge_b);

}  // namespace seamwright
