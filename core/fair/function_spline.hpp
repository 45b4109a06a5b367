// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include <seamwright/core/fair/fair_curve.hpp>

/// Cubic splines y(x) through points, and the classical methods that make them fair. Each method is
/// linear in the number of points.
namespace seamwright {

/// Points (x, y), one per row, with increasing x.
using FunctionPoints = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// dy/dx at both ends.
struct EndSlopes {
  double start = 0, end = 0;

  bool operator==(const EndSlopes& other) const = default;
};

/// A C2 function that is a cubic between neighbouring points.
struct FunctionSpline {
  FunctionPoints points;
  std::optional<EndSlopes> slopes;  ///< without: natural ends, S'' = 0
  Eigen::VectorXd second_per_mm;    ///< S'' at the points
};

/// The spline through points. Identities (each has a test of its number):
///   (1) S'' and S' are continuous at the points; at the ends S' has the given slopes or S'' is 0.
/// \throws std::invalid_argument for fewer than 2 points, numbers that are not finite, and x that
/// does not increase (with the index). Source: docs/theory/planar.md P12.1; [deBoor2001].
FunctionSpline functionSpline(const FunctionPoints& points,
                              const std::optional<EndSlopes>& slopes = {});

/// S, S', S'' and S''' at x. At a point S''' is that of the piece after it; beyond the ends the
/// outermost cubics continue.
Eigen::Vector4d derivatives(const FunctionSpline& spline, double x_mm);

/// The jumps of S''' at the points between the ends.
Eigen::VectorXd thirdJumps_per_mm2(const FunctionSpline& spline);

/// The spline as a curve (x, S(x), 0) with x as its parameter.
///   (2) Its points are those of the spline up to rounding.
/// Source: docs/theory/planar.md P12.1.
BSplineCurve bsplineCurve(const FunctionSpline& spline);

struct FunctionFairness {
  double bending_per_mm = 0;  ///< integral of S''^2
  double jumps_per_mm2 = 0;   ///< sum of the sizes of the jumps of S'''
  /// Of the curve of the spline: the integral of S'''^2, extrema of the curvature, inflections.
  CurveFairness curve;
};

FunctionFairness fairnessOf(const FunctionSpline& spline);

/// A spline that was made fair. Every method keeps the ends with their slopes, and x.
struct FairedFunction {
  FunctionSpline spline;
  /// Upper bound of |S* - S| for all x, rounding included; at most the tolerance.
  double moved_mm = 0;
  FunctionFairness before, after;
  int steps = 0;  ///< corrections that were tried; rebounds; iterations

  /// By how much the numbers of extrema of the curvature (with those at knots) and of inflections
  /// grew. Fairing is meant to lower them, but no method guarantees that.
  int addedExtrema() const;
  int addedInflections() const;
};

/// The spline that omits a point between the ends; its value there becomes the ordinate.
///   (3) The jump of S''' at the point is 0 unless the move was limited; other ordinates stay
///       bitwise.
/// \throws std::invalid_argument for another index, and a limit that is negative.
/// Source: docs/theory/planar.md P12.2.
FunctionSpline correctedAt(const FunctionSpline& spline, Eigen::Index point,
                           double limit_mm = HUGE_VAL);

/// A round of correctFunction() corrects the points whose jump is above half of the threshold of
/// the round before. After the last one the threshold is 1/4096 of the largest jump.
inline constexpr int max_correction_rounds = 12;

/// Corrects points with base splines, those with the largest jumps of S''' first. Each correction
/// is the move of one ordinate that makes the bending least.
///   (4) The bending does not grow. For tolerance 0 the result is the input bitwise.
///   (5) There are at most max_correction_rounds steps for each point, and each changes at most 121
///       jumps.
/// \throws std::invalid_argument for a tolerance that is negative or not finite.
/// Source: docs/theory/planar.md P12.2.
FairedFunction correctFunction(const FunctionSpline& spline, double tolerance_mm);

/// One rebound: the spline through the values in the middle of each piece, and the spline through
/// the values of that one at the points.
/// Source: docs/theory/planar.md P12.3.
FunctionSpline rebounded(const FunctionSpline& spline);

struct ReboundOptions {
  /// Many rebounds make the spline a single cubic (with slopes) or a line (natural ends).
  int most_rebounds = 3;
};

/// Rebounds until their number or the tolerance is reached. The last one is shortened.
///   (6) The bending does not grow. For tolerance 0 the result is the input bitwise.
/// \throws std::invalid_argument for a tolerance that is negative or not finite, and a negative
/// number of rebounds. Source: docs/theory/planar.md P12.3.
FairedFunction reboundFunction(const FunctionSpline& spline, double tolerance_mm,
                               const ReboundOptions& options = {});

/// The ordinates of the poles of a uniform cubic B-spline after iterations that add what it misses
/// of the given ordinates. The first and the last one stay.
///   (7) The values at points between the ends are those of (I - (I - B)^(steps + 1)) y, where B
///       takes the mean of a number and its neighbours with the weights 4/6, 1/6 and 1/6.
/// \throws std::invalid_argument for fewer than 2 ordinates, and a negative number of steps.
/// Source: docs/theory/planar.md P12.4.
Eigen::VectorXd polishedPoles(const Eigen::VectorXd& ordinates_mm, int steps);

/// A spline with natural ends through equally spaced points becomes the one of polishedPoles() with
/// the fewest iterations that stay within the tolerance; the fewer, the smoother.
///   (8) The bending does not grow. For tolerance 0 the result is the input bitwise.
/// \throws std::invalid_argument for a tolerance that is negative or not finite, given slopes, and
/// distances of points that differ by more than 1e-9 of them. Source: docs/theory/planar.md P12.4.
FairedFunction polishFunction(const FunctionSpline& spline, double tolerance_mm);

}  // namespace seamwright
