// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bernstein/interval.hpp>
#include <seamwright/core/bezier/curve.hpp>

namespace seamwright {

/// An interval in which the curvature has an extremum.
struct CurvatureExtremum {
  Interval parameters;  ///< hold exactly one zero of the derivative of the curvature
  bool maximum = false;
  double curvature_per_mm = 0;  ///< in the middle of the interval
};

/// Where the curvature of a curve grows, falls and changes its sign, with certainty: between the
/// intervals below the derivative of the curvature, and the curvature itself, are certainly not 0.
struct CurvatureProfile {
  std::vector<CurvatureExtremum> extrema;  ///< inside of (0, 1), in the order of the parameter
  std::vector<Interval> inflections;       ///< the curvature changes its sign once in each
  /// Intervals in which rounding hides the sign: of the derivative of the curvature, and of the
  /// curvature. Zeros at the ends of the curve and zeros without a change of sign lie here. For an
  /// arc of a circle the first is [0, 1], for a line both are.
  std::vector<Interval> undecided_extrema, undecided_inflections;

  /// Whether the curve is certainly a spiral: its curvature is strictly monotone.
  bool monotone() const { return extrema.empty() && undecided_extrema.empty(); }
};

/// The profile of the signed curvature of a curve in the plane z = 0, polynomial or rational.
/// Curvature above 0 turns to the left. Where poles beside an end are equal to its end pole, the
/// curve stops there, but it has a tangent; its curvature may be infinite at that end. Identities
/// (each has a test of its number):
///   (1) The extrema of a parabola and of an ellipse are their vertices.
///   (2) A reversed curve has the mirrored intervals and the opposite curvature. Rigid motions and
///       scaling by powers of two do not change the numbers of extrema and inflections.
///   (3) Between two intervals, curvatures on a dense sample grow or fall throughout.
///   (4) A cubic with control edges that turn by the same angle and grow by the same factor
///       s >= 1 / cos(angle) is monotone.
///   (6) (t^2, t^3) on [0, 1] is monotone: its curvature falls from infinity.
/// \throws std::invalid_argument if a pole is outside of the plane, or if the degree is 0.
/// \throws std::domain_error if the curve may stop inside, or is a point: |r'| is not certainly
/// above 0 (with the parameter). Source: docs/theory/planar.md P8.1, P8.2, P8.7.
CurvatureProfile planarCurvatureProfile(const BezierCurve& curve);

/// The profile of the curvature of a curve in space, which is not negative. A point of zero
/// curvature is in undecided_inflections and in undecided_extrema.
///   (5) For planar curves without inflections it is that of the planar profile.
/// \throws as planarCurvatureProfile() for degree and zero speed. Source: docs/theory/planar.md
/// P8.3.
CurvatureProfile spaceCurvatureProfile(const BezierCurve& curve);

/// How a planar curve begins or ends.
struct EndCurvature {
  double curvature_per_mm = 0;  ///< signed; infinite with its sign where the curve winds up
  bool finite_energy = true;    ///< the integral of the squared curvature up to this end is finite
};

/// The signed curvature of a curve in the plane z = 0 at its start and end, also where it stops.
///   (7) Where the speed is above 0, it is the curvature by the derivatives.
///   (8) t^2 a + t^3 b has at t = 0 an infinite curvature with the sign of a x b, and an infinite
///       energy; t^2 a + t^4 b has 2 a x b / |a|^3, the curvature of t a + t^2 b.
/// \throws as planarCurvatureProfile(). Source: docs/theory/planar.md P8.7.
EndCurvature startCurvature(const BezierCurve& curve);
EndCurvature endCurvature(const BezierCurve& curve);

}  // namespace seamwright
