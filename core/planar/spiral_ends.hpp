// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <seamwright/core/bernstein/interval.hpp>
#include <seamwright/core/planar/biarc.hpp>

/// Which spirals (curves of monotone curvature) exist between two ends.
///
/// A spiral is called short if its tangent is nowhere opposite to its chord. All statements are
/// about short spirals.
namespace seamwright {

/// Two points of the plane with the tangents and the signed curvatures there.
struct CurvedEnds {
  HermiteEnds ends;
  double start_curvature_per_mm = 0;  ///< above 0: turns to the left
  double end_curvature_per_mm = 0;
};

/// The short spirals between two ends.
enum class SpiralKind {
  Undecided,  ///< rounding hides a sign
  Nothing,    ///< there is no short spiral
  Arc,        ///< up to rounding, an arc of a circle is the only one
  Biarc,      ///< up to rounding, a biarc is the only one
  Rising,     ///< spirals exist; the curvature of all of them grows
  Falling,    ///< spirals exist; the curvature of all of them falls
};

/// A computed number without a unit, and a bound of its rounding.
struct SignedFigure {
  double value = 0;
  double rounding = 0;

  /// 1 or -1 if the sign is certain, otherwise 0.
  int sign() const { return value > rounding ? 1 : value < -rounding ? -1 : 0; }
};

/// The figures that decide about spirals, with l the length of the chord and a, b the angles of the
/// tangents against it (to the left above 0).
struct SpiralCertificate {
  SpiralKind kind = SpiralKind::Undecided;
  double start_angle_rad = 0;  ///< a
  double end_angle_rad = 0;    ///< b
  /// a + b. It has the sign of the change of the curvature (Vogt).
  SignedFigure turn_rad = {};
  /// k_A l / 2 + sin a: how far the curvature at the start is above that of the arc which begins
  /// with the tangent there and ends at the end point.
  SignedFigure start_excess = {};
  /// k_B l / 2 - sin b, likewise for the end.
  SignedFigure end_excess = {};
  /// The product of both plus sin^2((a + b) / 2). For k_A, k_B other than 0 it is k_A k_B / 4 times
  /// the squared distance of the centres of curvature less (1 / k_A - 1 / k_B)^2. Below 0 the
  /// circles of curvature are nested, or apart if they turn to opposite sides (Kneser).
  SignedFigure separation = {};
};

/// Decides which short spirals exist. A rising one exists if and only if turn_rad > 0, start_excess
/// < 0, end_excess > 0 and separation <= 0; a falling one with the opposite signs of the first
/// three. With separation = 0 it is a biarc. Identities (each has a test of its number):
///   (1) The ends of clothoids and logarithmic spirals have the kind of the curve.
///   (2) The ends of arcs, lines and biarcs give Arc and Biarc, or Nothing if the biarc is not
///       short; a biarc whose curvature at one end is moved towards that at the other gives
///       Nothing.
///   (3) Where the kind is Rising, a chain of three arcs with rising curvatures joins the ends.
///   (4) Mirrored ends exchange Rising and Falling; reversal, rigid motion and scaling keep the
///       kind.
/// The bounds of rounding count the given numbers as exact.
/// \throws std::invalid_argument as chordAngles() does, and if a curvature or its product with the
/// chord is not finite. Source: docs/theory/planar.md P8.4, P8.5; [Kurnosenko2010].
SpiralCertificate spiralCertificate(const CurvedEnds& ends);

/// The turn from the direction A to X to the direction X to B, in [-pi, pi], for the ends A and B:
/// the angle under which an arc through A, X and B turns in all is twice as large.
/// \throws std::invalid_argument as chordAngles() does, and if the point is not finite or is an
/// end.
double turnThrough_rad(const HermiteEnds& ends, const Eigen::Vector2d& point);

/// The bilens: the values of turnThrough_rad() between -a and b. The points with the bounds lie on
/// the arcs from end to end that share one tangent with the ends.
///   (5) Every point of a short spiral between the ends has a turn in this interval.
/// \throws std::invalid_argument as chordAngles() does. Source: docs/theory/planar.md P8.6.
Interval bilens_rad(const HermiteEnds& ends);

}  // namespace seamwright
