// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/bspline/curve.hpp>
#include <seamwright/core/progress.hpp>

/// Fairing of polynomial B-spline curves, planar and spatial. Knots and parametrisation stay.
namespace seamwright {

/// What stays at both ends of a curve. Poles are held, so position, first and second derivative
/// stay bitwise.
enum class HeldEnds { Nothing, Position, Tangent, Curvature };

/// How fair a curve is.
struct CurveFairness {
  /// Integral of the squared derivative of order min(3, degree) by the parameter.
  double energy = 0;
  /// Extrema of the curvature and its changes of sign inside of the spans (planar curves, see
  /// planarCurvatureProfile()); extrema at knots, where the slope of the curvature changes its
  /// sign.
  int extrema = 0, extrema_at_knots = 0, inflections = 0;
  /// Spans in which rounding hides a sign, or the curve may stop.
  int undecided_spans = 0;
};

/// \param curve polynomial; in space the profile is that of spaceCurvatureProfile().
/// \throws std::invalid_argument as requireValid(BSplineCurve) does, for a rational curve and for a
/// degree of 1. Throws Cancelled, see Progress; it is called before each span.
CurveFairness fairnessOf(const BSplineCurve& curve, const Progress& progress = {});

struct FairedCurve {
  BSplineCurve curve;
  double moved_mm = 0;  ///< bound of the distance of points of the same parameter
  /// Weight of the energy against the squared distance, in the mean over the curve; fairCurve()
  /// only.
  double smoothing = 0;
  CurveFairness before, after;
  int steps = 0;
};

struct CurveFairingOptions {
  HeldEnds ends = HeldEnds::Position;
};

/// The curve D with the knots of the curve C whose energy is least while no Bézier pole of D - C is
/// further than the tolerance from 0, so that each place may move as far. With local weights of the
/// squared distance in place of the bounds the same curve is a smoothing spline. Identities (each
/// has a test of its number):
///   (1) No point moves by more than moved_mm <= tolerance_mm; the bound is the one of the Bézier
///       poles of D - C.
///   (2) The energy does not grow. A tolerance of 0 returns the curve bitwise.
///   (3) A curve that is one polynomial of degree below min(3, degree) stays up to rounding.
///   (4) Rigid motion and scaling of poles and tolerance move the result along.
///   (5) A curve with a larger tolerance has an energy that is at most as large.
///   (9) No curve within the bounds has an energy that is smaller by more than 0.01 % (the test, in
///       Python, compares with a general solver).
/// The cost of a step is O(poles); 10 to 30 steps are usual. No more than 60 are taken, after which
/// (5) and (9) may fail. None of 20000 random noisy curves needs more than 50, with tolerances from
/// 1/150 to 20 times their noise, and distances of knots that differ up to 8000 times.
/// Where the energy does not decide, as between parabolas within the tolerance, D is near to C.
/// \throws std::invalid_argument as fairnessOf() does, and for a tolerance that is negative or not
/// finite. Throws Cancelled, see Progress; it is called before each step and each span.
/// Source: docs/theory/planar.md P11.1, P11.4.
FairedCurve fairCurve(const BSplineCurve& curve, double tolerance_mm,
                      const CurveFairingOptions& options = {}, const Progress& progress = {});

/// The spline that makes half the sum of |P(t_k) - Q_k|^2 plus half of \p smoothing times the
/// integral of |P'''|^2 least.
///   (6) The gradient by each free pole is 0 up to rounding.
/// \param points #P by 3, one for each parameter.
/// \param ends_fixed the first and the last pole are the first and the last point.
/// \throws std::invalid_argument for knots and degree that make no spline, numbers that are not
/// finite or do not match, parameters outside of the knots, and a smoothing that is not positive.
/// Throws std::domain_error if the equations are singular: fewer than 3 different parameters.
/// Source: docs/theory/planar.md P11.1.
BSplineCurve smoothingSpline(int degree, const std::vector<double>& knots,
                             const std::vector<double>& parameters, const Poles& points,
                             double smoothing, bool ends_fixed = false);

/// Removes the jump of the third derivative at an inner knot of a cubic curve by a move of one
/// pole: the knot is removed and inserted again.
///   (7) P''' is continuous at the knot unless the move was limited; poles other than index - 2
///       stay bitwise.
/// \param index of the knot in the flat knots; a simple knot with three knots on each side.
/// \param limit_mm largest move of the pole.
/// \throws std::invalid_argument as fairnessOf() does, for another degree, an index without such a
/// knot, and a limit that is negative. Source: docs/theory/planar.md P11.2; [Farin2002].
BSplineCurve fairedAtKnot(const BSplineCurve& curve, int index, double limit_mm = HUGE_VAL);

/// Fairs a cubic curve at the knots with the largest jumps of |P'''| / |P'|^3, one after the other,
/// as long as the sum of the jumps at the knots that a pole influences falls.
///   (8) No pole moves by more than the tolerance, so neither does a point of the curve.
/// \throws as fairedAtKnot() and fairCurve() do; the progress is called before each knot.
/// Source: docs/theory/planar.md P11.2.
FairedCurve fairKnots(const BSplineCurve& curve, double tolerance_mm,
                      const CurveFairingOptions& options = {}, const Progress& progress = {});

}  // namespace seamwright
