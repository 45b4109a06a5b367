// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include <seamwright/core/enclosure/surface.hpp>
#include <seamwright/core/seam/tolerance.hpp>

namespace seamwright {

/// The largest possible relative difference: |A - B| <= |A| + |B| <= 2 max(|A|, |B|).
constexpr double largest_relative_difference = 2;

/// Bounds of the largest value of a quantity over a piece of a seam.
struct PieceBound {
  double lower = 0;  ///< at most the value that is attained at \p at
  double upper = 0;  ///< infinite if nothing is known
  double at = 0;     ///< position on the piece, -1..1
};

/// The figures of two sides over a piece of a seam.
struct PieceFigures {
  PieceBound gap_mm;
  PieceBound angle_rad;
  double smallest_angle_rad = 0;  ///< no angle on the piece is smaller
  /// 1: the normals of both sides, as parametrised, agree in direction; -1: they are opposed; 0:
  /// both occur, or the direction is not known.
  int sense = 0;
  /// A lower bound of the larger curvature norm of both sides.
  double curvature_norm_per_mm = 0;
  /// Nothing if it was not asked for.
  std::optional<PieceBound> curvature_per_mm;
  /// The upper bound may exceed largest_relative_difference: it then states how far the figure is
  /// from being known.
  std::optional<PieceBound> curvature_rel;
  /// Nothing if they were not asked for. The bound of the second is as that of curvature_rel.
  std::optional<PieceBound> curvature_change_per_mm2;
  std::optional<PieceBound> curvature_change_rel;
};

/// The slack that a bound may keep without further work: upper - lower <= max(relative * lower,
/// absolute).
struct Slack {
  double relative = 0;
  double absolute = 0;
};

struct PieceSlack {
  Slack gap_mm, angle_rad, curvature_per_mm, curvature_rel;
  Slack curvature_change_per_mm2 = {}, curvature_change_rel = {};
};

/// Bounds gap, angle and curvature difference over a piece, from the fields of both sides there.
///
/// \param detail Curvature and above: with the curvature figures, but not with the change of
/// curvature; TangentPlane: without them; Position: only the gap.
/// Source: docs/theory/enclosures.md E3.2 to E3.4.
PieceFigures measurePiece(const SurfaceFields& a, const SurfaceFields& b, Detail detail,
                          double flat_radius_mm, const PieceSlack& slack);

/// One side of a piece with what the change of curvature across the seam needs.
struct ChangeSide {
  const SurfaceFields& fields;
  /// Derivative of (u, v) along the seam, of any length; the third coordinate is 0.
  const VectorModel& direction;
};

/// Bounds the difference of the change of curvature over a piece. The fields have
/// Detail::CurvatureChange.
/// Source: docs/theory/enclosures.md E3.6.
void measureChange(const ChangeSide& a, const ChangeSide& b, double flat_radius_mm,
                   const PieceSlack& slack, PieceFigures& figures);

/// Adds the bounds of another pair of sides over the same piece.
/// On a piece across knot lines every combination of sides is possible, so no value is known to be
/// attained.
void include(PieceFigures& sum, const PieceFigures& more);

}  // namespace seamwright
