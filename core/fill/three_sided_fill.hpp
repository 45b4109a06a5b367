// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/bezier/triangle.hpp>
#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/core/join/condition/connection.hpp>

namespace seamwright {

struct ThreeSidedFillOptions {
  int fairness_order = 3;           ///< of the derivatives whose squares are summed, 2 or 3
  double corner_tolerance_rad = 0;  ///< as in FillOptions
};

/// A hole of three sides filled by three triangles around a centre.
struct ThreeSidedFill {
  /// Triangle k has side k as its edge L2, corner k, where side k begins, as P0, the next one as
  /// P1, and the centre as P2. Its edge L1 is spoke k, from the centre to corner k; edge L0 is
  /// spoke k + 1 run backwards.
  std::vector<BezierTriangle> triangles;
  /// The connection of the fill to each neighbour, whose derivative out of the hole is T; the
  /// cross-boundary direction is the direction to the centre. It holds if both corners of the side
  /// are exact. Nothing: position alone.
  std::vector<std::optional<ConnectionFunctions>> sides;
  /// exact and angle_bound_rad are for both sides of the corner. twist_defect_mm is 0, because the
  /// neighbours need not agree.
  std::vector<FillCorner> corners;
  double fairness_mm2 = 0;  ///< the sum that was made least
  bool regular = false;     ///< as in NSidedFill
};

/// Fills a hole of three sides with Bezier triangles. They meet each other, and the tangent planes
/// of the surroundings, exactly with G1.
///
/// The triangles are one C^1 surface over a triangle cut at its centroid. Their degree is max(3, d
/// + 1, e + 2), d and e the largest degrees of edges and cross-boundary derivatives; for position
/// alone max(3, d). The free poles minimise the sum of squared derivatives of one order; if the
/// triangles are not proven regular, the other order is tried. docs/n_sided_fill.md shows the
/// construction.
///
/// **Corners.** The edges and cross-boundary derivatives of the two sides of a corner have to be in
/// one plane, and the angle of the hole there has to be between 0 and pi. A spoke ends in the
/// corner. So the mixed derivatives that the two neighbours prescribe belong to two triangles and,
/// unlike in nSidedFill(), need not agree; the curvature along the spoke follows from them. If the
/// planes differ, by up to the tolerance, the fill takes the edges' tangents in the corner. It then
/// deviates from the planes of both sides by at most FillCorner::angle_bound_rad.
///
/// Identities (each has a test of its number):
///   (1) Edges L2 are the sides; neighbours share the poles of their spoke bitwise.
///   (2) encloseSeam(): the angle across spokes, and to neighbours between exact corners, is
///       rounding; else within the bound.
///   (3) Rigid motion, scale, and the numbering of the sides act on the fill in the same way;
///       reversing all sides exchanges P0 and P1.
///   (4) The fill of planar sides is planar; a symmetric hole has a symmetric fill.
///   (5) No other choice of the free poles is fairer.
///   (6) A triangle of degree 2 is reproduced, cut at its centroid, if T on its sides are its
///       derivatives in constant directions.
///
/// \throws std::invalid_argument as nSidedFill() does for sides, corners, order and tolerance, with
/// side or corner and number; for a number of sides other than 3.
/// Source: docs/theory/fills.md F4.1; [CloughTocher1965].
ThreeSidedFill threeSidedFill(const std::vector<FillSide>& sides,
                              const ThreeSidedFillOptions& options = {});

}  // namespace seamwright
