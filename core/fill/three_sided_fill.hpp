// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/bezier/triangle.hpp>
#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/core/join/connection.hpp>

namespace seamwright {

struct ThreeSidedFillOptions {
  int fairness_order = 3;           ///< of the derivatives whose squares are summed, 2 or 3
  double corner_tolerance_rad = 0;  ///< as of FillOptions
};

/// A hole of three sides filled by three triangles around a centre.
struct ThreeSidedFill {
  /// Triangle k has side k as its edge L2, corner k, where side k begins, as P0, the next one as
  /// P1, and the centre as P2. Its edge L1 is spoke k, from the centre to corner k; edge L0 is
  /// spoke k + 1 run backwards.
  std::vector<BezierTriangle> triangles;
  /// Of the fill to each neighbour, of which T is the derivative out of the hole: across is the
  /// direction to the centre. It holds where both corners of the side are exact. Nothing: position
  /// alone.
  std::vector<std::optional<Connection>> sides;
  /// exact and angle_bound_rad are of both sides of the corner. twist_defect_mm is 0: the
  /// neighbours need not agree.
  std::vector<FillCorner> corners;
  double fairness_mm2 = 0;  ///< the sum that was made least
  bool regular = false;     ///< as of NSidedFill
};

/// Fills a hole of three sides with Bezier triangles that meet each other, and the tangent planes
/// of the surroundings, with G1, exactly.
///
/// The triangle over the three corners is cut at its centroid. Across spoke k the derivatives to
/// the three corners add up to zero,
///   D_(k-1) + D_k + D_(k+1) = 0,  D_j the derivative from the centre to corner j,
/// in the triangles on either side. In poles: each pole of a spoke is the mean of the three before
/// it, one on the spoke and one beside it in either triangle. So the triangles are one C^1 surface
/// over the cut triangle, whose spoke leaves corner k along (E_k' - E_(k-1)') / 3.
///
/// The derivative from a side to the centre is -(p T + q E'), p > 0 and q linear and given by their
/// values in the corners. The degree of the triangles is N = max(3, d + 1, e + 2), d and e the
/// largest degrees of edges and cross fields; for position alone max(3, d). What is free, (N - 2)(N
/// - 3) / 2 poles in each triangle and N - 2 beside each side of position alone, makes fairness
/// least: the sum, over all poles of the derivatives of that order (without the factors of
/// differentiation), of their squares as tensors in the plane where the corners are an equilateral
/// triangle of side 1. That is one linear least-squares problem with one solution. Where its
/// triangles are not proved regular the other order is tried.
///
/// **Corners.** The edges and cross fields of the two sides of a corner are in one plane, and the
/// angle of the hole there is between 0 and pi. As a spoke ends in the corner, the mixed
/// derivatives that the two neighbours ask for belong to two triangles, and need not agree as for
/// nSidedFill(): its curvature along the spoke follows from them. Where planes differ, by up to the
/// tolerance, the fill takes the edges' tangents in the corner, and leaves the planes of both sides
/// by at most FillCorner::angle_bound_rad.
///
/// Identities (each has a test of its number):
///   (1) Edges L2 are the sides, neighbours share the poles of their spoke bitwise.
///   (2) encloseSeam(): the angle across spokes, and to neighbours between exact corners, is
///       rounding; else within the bound.
///   (3) Rigid motion, scale, and the numbering of the sides move the fill likewise; reversing all
///       sides exchanges P0 and P1.
///   (4) The fill of planar sides is planar; a symmetric hole has a symmetric fill.
///   (5) No choice of what is free is fairer.
///   (6) A triangle of degree 2 comes back, cut at its centroid, where its sides have as T
///       derivatives in constant directions.
///
/// \throws std::invalid_argument as nSidedFill() for sides, corners, order and tolerance, with side
/// or corner and number; for another number of sides than 3.
/// Source: docs/theory/fills.md F4.1; [CloughTocher1965].
ThreeSidedFill threeSidedFill(const std::vector<FillSide>& sides,
                              const ThreeSidedFillOptions& options = {});

}  // namespace seamwright
