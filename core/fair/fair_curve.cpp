// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/fair/fair_curve.hpp>
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

FreePoles::FreePoles(Index poles, HeldEnds ends)
    : first(std::min<Index>(static_cast<Index>(ends), (poles + 1) / 2)),
      count(std::max<Index>(poles - 2 * first, 0)) {}

namespace {

using Band = Eigen::SparseMatrix<double>;
using BandCholesky = Eigen::SimplicialLDLT<Band, Eigen::Lower, Eigen::NaturalOrdering<int>>;

int energyOrder(int degree) {
  return std::min(3, degree);
}

double energyOf(const Band& products, const Poles& poles) {
  return poles.cwiseProduct(products * poles).sum();
}

/// Moves of the poles for a smoothing: (mass + smoothing energy) x = -smoothing energy poles, for
/// the free poles.
class Smoother {
 public:
  Smoother(const BSplineCurve& curve, HeldEnds ends)
      : poles_(polynomialPoles(curve)),
        free_(poles_.rows(), ends),
        energy_(derivativeProducts(curve.degree, curve.knots, energyOrder(curve.degree))),
        mass_(block(derivativeProducts(curve.degree, curve.knots, 0))),
        free_energy_(block(energy_)),
        slope_(derivativeGradient(curve.degree, curve.knots, energyOrder(curve.degree), poles_)
                   .middleRows(free_.first, free_.count)) {
    if (free_.count > 0) factor_.analyzePattern(Band(mass_ + free_energy_));
  }

  Index freeCount() const { return free_.count; }
  const Band& energy() const { return energy_; }
  /// The smoothing at which both forms have the same size.
  double middle() const { return mass_.diagonal().sum() / free_energy_.diagonal().sum(); }

  /// Nothing if the equations are singular: beside a large smoothing rounding extinguishes the
  /// mass, and the energy leaves polynomials of low degree free.
  std::optional<Poles> moves(double smoothing) {
    // Both forms are divided by the larger one, so that nothing overflows.
    const double scale = std::max(1.0, smoothing / middle());
    factor_.factorize(Band(mass_ / scale + smoothing / scale * free_energy_));
    if (factor_.info() != Eigen::Success) return std::nullopt;
    Poles moves = Poles::Zero(poles_.rows(), 3);
    moves.middleRows(free_.first, free_.count) = -factor_.solve(smoothing / scale * slope_);
    return moves;
  }

 private:
  Band block(const Band& whole) const {
    return whole.block(free_.first, free_.first, free_.count, free_.count);
  }

  Poles poles_;
  FreePoles free_;
  Band energy_, mass_, free_energy_;
  Poles slope_;
  BandCholesky factor_;
};

struct Smoothed {
  Poles moves;
  double moved_mm = 0, smoothing = 0;
  int steps = 0;
};

/// Bisection for the logarithm of the smoothing. The distance grows with the smoothing.
Smoothed largestSmoothing(Smoother& smoother, const BSplineCurve& curve, double tolerance_mm,
                          const Progress& progress) {
  // Beyond 2^40 times the middle rounding of the energy comes near to the mass, below 2^-40 the
  // moves are rounding.
  double low = -40, high = 40;
  Smoothed best{.moves = Poles::Zero(curve.poles.rows(), 3)};
  const auto attempt = [&](double exponent) {
    checkProgress(progress, shareAfter(best.steps));
    const double smoothing = smoother.middle() * std::exp2(exponent);
    ++best.steps;
    const std::optional<Poles> moves = smoother.moves(smoothing);
    if (!moves) return false;
    const double moved_mm = largestPole_mm(curve, *moves);
    if (!(moved_mm <= tolerance_mm)) return false;
    best = {.moves = *moves, .moved_mm = moved_mm, .smoothing = smoothing, .steps = best.steps};
    return true;
  };
  if (attempt(high)) return best;
  while (high - low > 0x1p-10 && best.moved_mm < 0.99 * tolerance_mm) {
    const double exponent = (low + high) / 2;
    (attempt(exponent) ? low : high) = exponent;
  }
  return best;
}

}  // namespace

CurveFairness fairnessOf(const BSplineCurve& curve, const Progress& progress) {
  requirePolynomial(curve);
  const Poles poles = polynomialPoles(curve);
  CurveFairness result{
      .energy = energyOf(derivativeProducts(curve.degree, curve.knots, energyOrder(curve.degree)),
                         poles)};
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
  constexpr double measured = 0.3, smoothed = 0.7;
  FairedCurve result;
  result.before = fairnessOf(curve, partOf(progress, 0, measured));
  requireFairingTolerance(tolerance_mm);
  result.curve = curve;
  result.after = result.before;
  Smoother smoother(curve, options.ends);
  if (tolerance_mm == 0 || smoother.freeCount() == 0) return result;
  const Smoothed found =
      largestSmoothing(smoother, curve, tolerance_mm, partOf(progress, measured, smoothed));
  result.steps = found.steps;
  const Poles poles = polynomialPoles(curve) + found.moves;
  if (!(energyOf(smoother.energy(), poles) < result.before.energy)) return result;
  result.curve = withPoles(curve, poles);
  result.moved_mm = found.moved_mm;
  result.smoothing = found.smoothing;
  result.after = fairnessOf(result.curve, partOf(progress, smoothed, 1));
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
  const Band basis = basisAt(degree, knots, parameters);
  const Band matrix =
      basis.transpose() * basis + (degree < 3 ? Band(basis.cols(), basis.cols())
                                              : smoothing * derivativeProducts(degree, knots, 3));
  Poles right = basis.transpose() * points;
  Poles poles = Poles::Zero(basis.cols(), 3);
  const FreePoles free(basis.cols(), ends_fixed ? HeldEnds::Position : HeldEnds::Nothing);
  if (ends_fixed) {
    poles.row(0) = points.row(0);
    poles.row(poles.rows() - 1) = points.row(points.rows() - 1);
    right -= matrix * poles;
  }
  BandCholesky factor(Band(matrix.block(free.first, free.first, free.count, free.count)));
  const Eigen::VectorXd pivots = factor.vectorD();
  if (factor.info() != Eigen::Success || !(pivots.minCoeff() > 1e-14 * pivots.maxCoeff()))
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
