// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/patch_edge.hpp>
#include <seamwright/core/bezier/triangle.hpp>

namespace seamwright {

/// Which way the cross parameter s of a ribbon runs: into the patch, or out of it.
enum class Across { Into, OutOf };

/// A patch along one of its edges: position and derivatives by a parameter s that runs across the
/// edge, as homogeneous polynomials of the seam's parameter t in [0, 1], each in Bernstein form
/// with a degree of its own, one coefficient a row.
///
/// (s, t) is a parametrisation of the patch, so mixed derivatives are those of these polynomials by
/// t. For a tensor-product patch s is the parameter across the edge. For a triangle with the edge
/// from A (t = 0) to B (t = 1) and the third corner C, s goes from A towards C at constant weight
/// of B: the barycentric coordinates of (C, A, B) are (s, 1 - s - t, t) for Across::Into, (-s, 1 +
/// s - t, t) for OutOf.
///
/// So everything about joins is said once, for tensor-product patches and triangles, polynomial and
/// rational, in any pairing.
/// Identities (each has a test of its number):
///   (1) The polynomials take the derivatives of the patch at (s, t) = (0, t).
///   (2) OutOf has the first derivative of Into with the other sign, and the same position and
///       second one.
///   (3) Reversing turns t into 1 - t; for a triangle s then keeps the weight of A.
struct Ribbon {
  HomogeneousPoles position;  ///< degree n
  HomogeneousPoles first;     ///< d/ds; degree n, of a triangle n - 1
  HomogeneousPoles
      second;  ///< d2/ds2; degree n, of a triangle max(n - 2, 0); zero where the degree across is 1
  int degree_across =
      1;  ///< of the patch, of a triangle its degree: poles are differenced and multiplied by it

  int degree() const { return static_cast<int>(position.rows()) - 1; }
};

/// \param reversed t runs against the edge's own sense.
Ribbon ribbon(const BezierPatch& patch, PatchEdge edge, bool reversed, Across across);
/// \throws std::invalid_argument for a triangle of degree 0, which has no edges.
Ribbon ribbon(const BezierTriangle& triangle, TriangleEdge edge, bool reversed, Across across);

/// The same patch in parameters in which the edge is u = 0 and v runs along it.
BezierPatch turnedToU0(const BezierPatch& patch, PatchEdge edge, bool reversed);
/// What turnedToU0() is undone by.
BezierPatch turnedFromU0(const BezierPatch& patch, PatchEdge edge, bool reversed);

/// The row of the net that holds the pole k of the r-th row of poles behind an edge: the powers of
/// the third corner C, of the edge's end B and of its beginning A are r, k and degree - r - k.
Eigen::Index poleRow(int degree, TriangleEdge edge, bool reversed, int r, int k);

/// Two patches in common parameters: a ends at the seam u = 1, b begins there at u = 0, and v runs
/// along it on both.
struct CanonicalPair {
  BezierPatch a, b;
  bool reversed = false;  ///< b's edge had to be run against its own sense
};

/// Brings two patches with named edges into common parameters. b's edge is run against its own
/// sense if its ends are nearer to a's ends that way, in the sum of distances; where the ends do
/// not decide, as on a closed seam, those at t = 1/4 and 3/4 do.
/// Source: docs/theory/surfaces.md S1.7.
CanonicalPair orient(const BezierPatch& a, PatchEdge edge_a, const BezierPatch& b,
                     PatchEdge edge_b);

}  // namespace seamwright
