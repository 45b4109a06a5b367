// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/blend/match_pieces.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

struct CommonKnotsOptions {
  MatchOptions match = {};     ///< its closeness does not count
  double tolerance_mm = 1e-3;  ///< largest distance of a result from its frame
  /// Joints of a frame with larger defects (BetaFit::defects) keep their lower order, and have a
  /// knot in all frames.
  double joint_tolerance = 1e-6;
  int max_segments = 10'000;  ///< work limit; intervals are not halved beyond it
};

/// Frames of one structure near the given ones.
struct CommonKnots {
  /// Degree 5, with equal knots 0..1. They are C^2 where the frame is G^2, up to rounding.
  std::vector<BezierSpline> frames;
  /// Bound of the distance of each result from its frame, in both directions, and also as they are
  /// run. It is up to a quarter of the tolerance where the distance itself is smaller.
  std::vector<double> distance_mm;
  bool reached = false;  ///< all distances are within the tolerance
  MatchSummary summary;  ///< without merged and largest_ratio
};

/// Frames as splines over equal knots such that blending their poles linearly keeps G^2, and keeps
/// curves fair: corresponding points run along all frames with smooth speeds. matchPieces() keeps
/// curves exactly, but there the speeds jump from piece to piece if pieces have different shares of
/// the length, and a blend turns in a narrow zone at each joint.
///
/// A parameter p is a share of the length, corrected such that matched places are equal in all
/// frames. The correction is piecewise quintic, C^2 and increasing, with the slopes of monotone
/// cubic interpolation at matched places. Between knots the frames are quintic Hermite interpolants
/// of position and two derivatives by p. Knots are halved where a distance is above the tolerance.
///
/// Identities (each has a test of its number):
///   (1) The results are within distance_mm of the frames, and the frames of them.
///   (2) Joints of lower order stay: a corner has the tangents of its frame on both sides.
///   (3) Linear blends of the results are G^2 at all joints at which all frames are.
///   (4) Rigid motion and scale (of the tolerance too) act on the results in the same way.
/// \throws std::invalid_argument as matchPieces(), for a tolerance that is not finite, not positive
/// or below a billionth of a piece of a frame, and for a frame that stops: with its index.
/// Source: docs/theory/curves.md C12.3; [FritschCarlson1980].
CommonKnots commonKnots(const std::vector<BezierSpline>& frames,
                        const CommonKnotsOptions& options = {});

}  // namespace seamwright
