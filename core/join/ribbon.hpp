// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/patch_edge.hpp>
#include <seamwright/core/bezier/triangle.hpp>

namespace seamwright {

/// Which way the cross parameter s of a ribbon runs: into the patch, or out of it.
enum class Across { Into, OutOf };

/// A patch along one of its edges: position and derivatives by a parameter s that runs across the edge, as homogeneous polynomials of the
/// seam's parameter t in [0, 1], each in Bernstein form with a degree of its own, one coefficient a row.
///
/// (s, t) is a parametrisation of the patch, so mixed derivatives are those of these polynomials by t. For a tensor-product patch s is the
/// parameter across the edge. For a triangle with the edge from A (t = 0) to B (t = 1) and the third corner C, s goes from A towards C at
/// constant weight of B: the barycentric coordinates of (C, A, B) are (s, 1 - s - t, t) for Across::Into, (-s, 1 + s - t, t) for OutOf.
struct Ribbon {
  HomogeneousPoles position;  ///< degree n
  HomogeneousPoles first;     ///< d/ds; degree n, of a triangle n - 1
  HomogeneousPoles
      second;  ///< d2/ds2; degree n, of a triangle max(n - 2, 0); zero where the degree across is 1

  int degree() const { return static_cast<int>(position.rows()) - 1; }
};

/// \param reversed t runs against the edge's own sense.
Ribbon ribbon(const BezierPatch& patch, PatchEdge edge, bool reversed, Across across);
Ribbon ribbon(const BezierTriangle& triangle, TriangleEdge edge, bool reversed, Across across);

}  // namespace seamwright
