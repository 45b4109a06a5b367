// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include <seamwright/core/fair/curve_polynomials.hpp>
#include <seamwright/core/planar/arc.hpp>

namespace seamwright {

/// A part of a planar Bézier curve.
struct CurvePiece {
  const CurvePolynomials& polynomials;
  Eigen::Vector2d origin;  ///< from which the polynomials count
  Interval domain;         ///< within [0, 1]
};

/// How a piece of a curve runs beside the circle of an arc.
struct AlongCircle {
  double distance_mm = 0;  ///< upper bound of the distance from the circle (or line)
  /// Arc length by which the projection on the circle advances from the start of the piece to its
  /// end, for a line the length of the projection.
  double advance_mm = 0;
};

/// A piece of a curve beside the circle of an arc. There is a result only if the projection of the
/// piece on the circle certainly moves forward throughout, and the distance is certainly not above
/// the tolerance. Then every point of the circle between the projections of the two ends is the
/// projection of a point of the piece, so the bound holds in both directions.
/// Source: docs/theory/planar.md P9.1.
std::optional<AlongCircle> alongCircle(const CurvePiece& piece, const PlanarArc& arc,
                                       double tolerance_mm);

/// The same for a piece whose projection may turn back. The projection of its start is at the arc
/// length \p begin_mm; where the projection is beyond an end of the arc, the distance is that from
/// this end. Every point of the circle between the projections of the two ends is again the
/// projection of a point of the piece.
/// Source: docs/theory/planar.md P9.1.
std::optional<AlongCircle> besideArc(const CurvePiece& piece, const PlanarArc& arc,
                                     double tolerance_mm, double begin_mm);

}  // namespace seamwright
