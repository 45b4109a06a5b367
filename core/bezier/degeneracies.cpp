// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/frenet.hpp>
#include <seamwright/core/bezier/velocity_form.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

/// Finds where a form is not proved free of zeros, as intervals that do not touch.
class ZeroSearch {
 public:
  explicit ZeroSearch(double resolution) : resolution_(resolution) {}

  std::vector<Interval> operator()(const VectorForm& form) {
    found_.clear();
    search(form, {0, 1});
    return found_;
  }

 private:
  void search(const VectorForm& form, const Interval& domain) {
    if (lowerNorm(form) > 0) return;
    // A form below twice its padding gains nothing from a smaller piece.
    if (domain.width() <= resolution_ || largestNorm(form) <= 2 * padding(form)) return add(domain);
    const auto [left, right] = halves(form);
    search(left, {domain.lower, domain.middle()});
    search(right, {domain.middle(), domain.upper});
  }

  void add(const Interval& domain) {
    if (!found_.empty() && found_.back().upper == domain.lower)
      found_.back().upper = domain.upper;
    else
      found_.push_back(domain);
  }

  double resolution_;
  std::vector<Interval> found_;
};

/// A lower bound of |X'|, as a rule at least half of the minimum.
/// \pre There are no cusps.
class SpeedBound {
 public:
  explicit SpeedBound(double resolution) : resolution_(resolution) {}

  double operator()(const VelocityForm& form) {
    search(form, 1);
    return form.unit_mm * bound_;
  }

 private:
  void search(const VelocityForm& form, double width) {
    attained_ = std::min({attained_, endSpeed(form, 0), endSpeed(form, form.velocity[0].degree())});
    const double bound =
        lowerNorm(form.velocity) / form.divisor.range().upper * (1 - 4 * rounding::kUnit);
    if (bound >= 0.5 * attained_ || width <= resolution_) {
      bound_ = std::min(bound_, bound);
      return;
    }
    const auto [left, right] = form.halves();
    search(left, 0.5 * width);
    search(right, 0.5 * width);
  }

  static double endSpeed(const VelocityForm& form, int i) {
    const Eigen::Vector3d v(form.velocity[0].coefficients()(i), form.velocity[1].coefficients()(i),
                            form.velocity[2].coefficients()(i));
    return v.norm() / form.divisor.coefficients()(i == 0 ? 0 : form.divisor.degree());
  }

  double resolution_;
  double attained_ = std::numeric_limits<double>::infinity();
  double bound_ = std::numeric_limits<double>::infinity();
};

/// The line on which the poles lie within their rounding.
struct Line {
  bool exists = false;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< zero if all poles are one point
};

/// The poles are up to r from the origin and each is off by 2 roundings of r / 2^53. An offset of
/// two poles is then off by 6 of these, and so is the direction times any offset. The product of
/// both, up to 2 r in size, adds 5 times 2. That makes 22 in all, or 11 machine epsilons of r.
Line lineOf(const BezierCurve& curve) {
  const Poles poles = curve.poles();
  const double rounding = 11 * machine_epsilon * poles.rowwise().stableNorm().maxCoeff();
  const Eigen::Matrix3Xd offsets = (poles.rowwise() - poles.row(0)).transpose();
  Eigen::Index farthest = 0;
  const double length = offsets.colwise().stableNorm().maxCoeff(&farthest);
  if (length <= rounding) return {true};
  const Eigen::Vector3d direction = offsets.col(farthest) / length;
  for (Eigen::Index i = 0; i < offsets.cols(); ++i)
    if (direction.cross(offsets.col(i)).stableNorm() > rounding) return {};
  return {true, direction};
}

/// The component along a direction.
VectorForm along(const VectorForm& form, const Eigen::Vector3d& direction) {
  const BernsteinPolynomial zero(Eigen::VectorXd::Zero(form[0].degree() + 1));
  return {direction(0) * form[0] + direction(1) * form[1] + direction(2) * form[2], zero, zero};
}

/// On a line everything except the cusps is without curvature.
std::vector<CurveDegeneracies::Interval> intervalsOnLine(const std::vector<Interval>& cusps) {
  std::vector<CurveDegeneracies::Interval> intervals;
  double last = 0;
  for (const Interval& cusp : cusps) {
    if (last < cusp.lower) intervals.push_back({CurvePoint::Inflection, last, cusp.lower});
    intervals.push_back({CurvePoint::Cusp, cusp.lower, cusp.upper});
    last = cusp.upper;
  }
  if (last < 1) intervals.push_back({CurvePoint::Inflection, last, 1});
  return intervals;
}

/// X' = 0 makes X' x X'' = 0, so each cusp is part of an interval without curvature.
/// \pre Both lists are in increasing order.
std::vector<CurveDegeneracies::Interval> intervalsOf(const std::vector<Interval>& without_curvature,
                                                     const std::vector<Interval>& cusps) {
  std::vector<Interval> all = without_curvature;
  all.insert(all.end(), cusps.begin(), cusps.end());
  std::sort(all.begin(), all.end(),
            [](const Interval& a, const Interval& b) { return a.lower < b.lower; });
  std::vector<CurveDegeneracies::Interval> intervals;
  for (const Interval& piece : all) {
    if (!intervals.empty() && piece.lower <= intervals.back().last)
      intervals.back().last = std::max(intervals.back().last, piece.upper);
    else
      intervals.push_back({CurvePoint::Inflection, piece.lower, piece.upper});
  }
  for (CurveDegeneracies::Interval& interval : intervals)
    for (const Interval& cusp : cusps)
      if (cusp.lower <= interval.last && cusp.upper >= interval.first)
        interval.kind = CurvePoint::Cusp;
  return intervals;
}

}  // namespace

CurveDegeneracies findDegeneracies(const BezierCurve& curve, double resolution) {
  if (!(resolution >= 1e-12 && resolution <= 1))
    throw std::invalid_argument("resolution is " + bernstein::text(resolution) +
                                ": 1e-12..1 is needed");
  const Line line = lineOf(curve);
  CurveDegeneracies result;
  result.straight = line.exists;
  if (line.exists && line.direction.isZero(0)) {
    result.intervals = {{CurvePoint::Point, 0, 1}};
    return result;
  }
  VelocityForm form = velocityForm(curve);
  if (line.exists) form.velocity = along(form.velocity, line.direction);
  ZeroSearch zeros(resolution);
  const std::vector<Interval> cusps = zeros(form.velocity);
  result.intervals =
      line.exists ? intervalsOnLine(cusps) : intervalsOf(zeros(curvatureForm(curve)), cusps);
  if (cusps.empty()) result.speed_lower = SpeedBound(resolution)(form);
  return result;
}

}  // namespace seamwright
