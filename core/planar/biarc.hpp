// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include <seamwright/core/planar/arc.hpp>

namespace seamwright {

/// Two points of the plane with the directions of the tangents there.
struct HermiteEnds {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  double start_direction_rad = 0;
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  double end_direction_rad = 0;
};

/// The chord between two ends, and the angles of the tangents against it, in [-pi, pi]: alpha from
/// the start tangent to the chord, beta from the chord to the end tangent.
struct ChordAngles {
  double chord_mm = 0;
  double chord_direction_rad = 0;
  double alpha_rad = 0;
  double beta_rad = 0;
};

/// \throws std::invalid_argument if a number is not finite or both points are equal.
ChordAngles chordAngles(const HermiteEnds& ends);

/// Two arcs with a common tangent at their joint.
struct Biarc {
  PlanarArc first, second;

  const Eigen::Vector2d& joint() const { return second.start; }
  /// Whether both arcs turn to the same side. A straight arc turns to no side.
  bool isConvex() const { return first.curvature_per_mm * second.curvature_per_mm > 0; }
};

/// The biarcs between two ends are one family with the parameter x in (0, 1): the tangent turns by
/// t = alpha - beta + x (alpha + beta) from the start to the joint. Both arcs run forward and turn
/// by less than 2 pi. The joints lie on one circle (a line for parallel tangents), the start at x =
/// 0 and the end at x = 1. Identities (each has a test of its number):
///   (1) The biarc ends at the given point with the given direction.
///   (2) At the joint both arcs have one tangent.
///   (3) Biarcs of reversed ends with 1 - x are reversed, of mirrored ends mirrored.
///   (4) Ends on one circle give arcs of this circle.
/// \throws std::invalid_argument as chordAngles() does, and if x is not in (0, 1). Throws
/// std::domain_error if both tangents point against the chord: |alpha + beta| > 2 pi - 2e-9. Then
/// the radii have no bound.
/// Source: docs/theory/planar.md P2.1, P2.2.
Biarc biarc(const HermiteEnds& ends, double x);

/// Rules that choose one biarc of the family.
enum class BiarcRule {
  /// Parallel for ends of a C-shape (alpha beta > 0), otherwise EqualChords.
  Default,
  /// Both arcs have chords of the same length, x = 1/2. The difference of the curvatures is the
  /// smallest of the family. The biarc of a C-shape is convex if alpha and beta differ by less than
  /// the factor 3.
  EqualChords,
  /// The tangent at the joint is parallel to the chord. C-shapes only; the biarc is convex.
  Parallel,
  /// The radii differ least. C-shapes with angles within the factor 3 only; the biarc is convex.
  LeastRadiusDifference,
  /// |k1| + |k2| is the smallest of all convex biarcs, which then have one straight piece and the
  /// largest distance from the chord; of an S-shape it is the smallest of all its biarcs.
  LeastCurvature,
};

/// The parameter x that a rule chooses; nothing if the ends do not have the shape that the rule
/// needs. Ends on one circle have x = 1/2 by every rule that applies to C-shapes.
///   (5) The conditions that the rules name hold, compared with a dense search over the family.
/// \throws std::invalid_argument as chordAngles() does.
/// Source: docs/theory/planar.md P2.3.
std::optional<double> biarcParameter(const HermiteEnds& ends, BiarcRule rule);

/// The biarc that the rule chooses.
/// \throws std::domain_error if the rule does not apply to the ends, and as biarc() does.
Biarc biarc(const HermiteEnds& ends, BiarcRule rule = BiarcRule::Default);

}  // namespace seamwright
