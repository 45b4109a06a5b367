// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/fair/fair_curve.hpp>
#include <seamwright/core/fair/fairest_moves.hpp>
#include <seamwright/core/fair/polynomial_curve.hpp>
#include <seamwright/core/fair/profile_sum.hpp>
#include <seamwright/core/fair/spline_energy.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

using Eigen::Index;

void requirePolynomial(const BSplineCurve& curve) {
  requireValid(curve);
  if (isRational(curve.poles)) refuse("a rational curve can't be faired");
  if (curve.degree < 2) refuse("a curve of degree 1 can't be faired");
}

void requireFairingTolerance(double tolerance_mm) {
  if (!(tolerance_mm >= 0) || tolerance_mm == infinite)
    refuse(fmt::format("the tolerance is {} mm: it must be at least 0 and finite", tolerance_mm));
}

Poles polynomialPoles(const BSplineCurve& curve) {
  return curve.poles.leftCols<3>() / curve.poles(0, 3);
}

BSplineCurve withPoles(const BSplineCurve& curve, const Poles& poles) {
  BSplineCurve result = curve;
  result.poles.leftCols<3>() = poles * curve.poles(0, 3);
  return result;
}

double largestPole_mm(const BSplineCurve& knots, const Poles& poles) {
  BSplineCurve difference{knots.degree, knots.knots, HomogeneousPoles(poles.rows(), 4)};
  difference.poles << poles, Eigen::VectorXd::Ones(poles.rows());
  return bezierSpline(difference).poles.leftCols<3>().rowwise().norm().maxCoeff();
}

double boundOfMoves_mm(const BSplineCurve& given, const BSplineCurve& moved) {
  const Poles moves = polynomialPoles(moved) - polynomialPoles(given);
  // A Bézier pole is a mean that at most degree^2 insertions make, each with an error of 8 eps.
  const double rounding = 8 * given.degree * given.degree * machine_epsilon;
  return largestPole_mm(given, moves) * (1 + rounding);
}

FreePoles::FreePoles(Index poles, HeldEnds ends)
    : first(std::min<Index>(static_cast<Index>(ends), (poles + 1) / 2)),
      count(std::max<Index>(poles - 2 * first, 0)) {}

namespace {

/// The weight of the energy against the squared distance, in the mean over a curve: with the moves
/// x, the poles d and multipliers w of |A_j x|^2 the least energy has K d + sum w_j A_j' A_j x = 0,
/// so the moves are those that the squared distance with local weights makes.
double meanSmoothing(const BSplineCurve& curve, const SplineEnergy& energy, const Poles& moves,
                     const Poles& poles) {
  const Poles shifted = derivativeProducts(curve.degree, curve.knots, 0).times(moves);
  const double gain = -moves.cwiseProduct(energy.gradient(poles)).sum();
  return gain > 0 ? moves.cwiseProduct(shifted).sum() / gain : 0;
}

}  // namespace

CurveFairness fairnessOf(const BSplineCurve& curve, const Progress& progress) {
  requirePolynomial(curve);
  const Poles poles = polynomialPoles(curve);
  const SplineEnergy energy(curve.degree, curve.knots, energyOrder(curve.degree));
  CurveFairness result{.energy = energy.of(poles)};
  ProfileSum profiles{.planar = (poles.col(2).array() == 0).all()};
  const BezierSpline spline = bezierSpline(curve);
  const int count = static_cast<int>(spline.knots.size()) - 1;
  for (int i = 0; i < count; ++i) {
    checkProgress(progress, static_cast<double>(i) / count);
    profiles.add(segment(spline, i));
  }
  result.extrema = profiles.extrema;
  result.extrema_at_knots = profiles.extrema_at_joints;
  result.inflections = profiles.inflections;
  result.undecided_spans = profiles.undecided;
  return result;
}

FairedCurve fairCurve(const BSplineCurve& curve, double tolerance_mm,
                      const CurveFairingOptions& options, const Progress& progress) {
  // Choices: about the shares of the time that curves of many spans need.
  constexpr double measured = 0.3, moved = 0.7;
  FairedCurve result;
  result.before = fairnessOf(curve, partOf(progress, 0, measured));
  requireFairingTolerance(tolerance_mm);
  result.curve = curve;
  result.after = result.before;
  const Poles given = polynomialPoles(curve);
  if (tolerance_mm == 0 || FreePoles(given.rows(), options.ends).count == 0) return result;
  FairestMoves found =
      fairestMoves(curve, tolerance_mm, options.ends, partOf(progress, measured, moved));
  result.steps = found.steps;
  const SplineEnergy energy(curve.degree, curve.knots, energyOrder(curve.degree));
  BSplineCurve faired = withPoles(curve, given + found.moves);
  double moved_mm = boundOfMoves_mm(curve, faired);
  if (moved_mm > tolerance_mm) {
    // The rounding of poles may exceed a bound that the moves touch.
    constexpr double inside = 0.999;
    found.moves *= inside * tolerance_mm / moved_mm;
    faired = withPoles(curve, given + found.moves);
    moved_mm = boundOfMoves_mm(curve, faired);
  }
  const Poles poles = polynomialPoles(faired);
  if (!(moved_mm <= tolerance_mm) || !(energy.of(poles) < result.before.energy)) return result;
  result.smoothing = meanSmoothing(curve, energy, found.moves, poles);
  result.curve = std::move(faired);
  result.moved_mm = moved_mm;
  result.after = fairnessOf(result.curve, partOf(progress, moved, 1));
  return result;
}

BSplineCurve smoothingSpline(int degree, const std::vector<double>& knots,
                             const std::vector<double>& parameters, const Poles& points,
                             double smoothing, bool ends_fixed) {
  bspline::requireKnots(degree, knots, "");
  if (points.rows() != static_cast<Index>(parameters.size()) || points.rows() == 0)
    refuse(fmt::format("{} points for {} parameters", points.rows(), parameters.size()));
  if (!points.allFinite()) refuse("a point is not finite");
  for (std::size_t k = 0; k < parameters.size(); ++k)
    if (!(parameters[k] >= knots.front() && parameters[k] <= knots.back()))
      refuse(fmt::format("parameter {} is {}: it must be in [{}, {}]", k, parameters[k],
                         knots.front(), knots.back()));
  if (!(smoothing > 0) || smoothing == infinite)
    refuse(fmt::format("the smoothing is {}: it must be positive and finite", smoothing));
  linear::SymmetricBand matrix = valueProducts(degree, knots, parameters);
  if (degree >= 3) matrix.add(smoothing, derivativeProducts(degree, knots, 3));
  Poles right = basisAt(degree, knots, parameters).transpose() * points;
  Poles poles = Poles::Zero(matrix.size(), 3);
  const FreePoles free(matrix.size(), ends_fixed ? HeldEnds::Position : HeldEnds::Nothing);
  if (ends_fixed) {
    poles.row(0) = points.row(0);
    poles.row(poles.rows() - 1) = points.row(points.rows() - 1);
    right -= matrix.times(poles);
  }
  const linear::BandCholesky factor(matrix.block(free.first, free.count));
  constexpr double regular = 1e-14;
  if (!factor.positive() || !(factor.leastPivot() > regular * factor.largestPivot()))
    throw std::domain_error(
        fmt::format("the equations of the smoothing spline are singular: {} points for {} poles",
                    points.rows(), poles.rows()));
  poles.middleRows(free.first, free.count) = factor.solve(right.middleRows(free.first, free.count));
  if (!poles.allFinite())
    throw std::domain_error(
        fmt::format("the smoothing is {}: it is too large for these points", smoothing));
  BSplineCurve result{degree, knots, HomogeneousPoles(poles.rows(), 4)};
  result.poles << poles, Eigen::VectorXd::Ones(poles.rows());
  return result;
}

}  // namespace seamwright
