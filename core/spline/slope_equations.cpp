// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/spline/slope_equations.hpp>
#include <stdexcept>
#include <utility>

namespace seamwright {

namespace {

using bernstein::text;
using Eigen::Index;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
/// Of the scale of a row. The factors 2 and 3 of the equations are then still within a double,
/// whose largest exponent is 1023.
constexpr int kLargestExponent = 1020;

double largest(const Eigen::RowVector3d& v) {
  return v.cwiseAbs().maxCoeff();
}

std::string text(const Eigen::RowVector3d& v) {
  return std::string("(") + text(v(0)) + ", " + text(v(1)) + ", " + text(v(2)) + ")";
}

/// Whether the distance from the point to the pole is lost in the rounding of the point.
bool isLost(const Eigen::RowVector3d& point, const Eigen::RowVector3d& pole) {
  return ((pole - point).array().abs() <= 2 * kEpsilon * point.array().abs()).all();
}

}  // namespace

SlopeEquations::SlopeEquations(Index count, bool closed)
    : matrix_{Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count),
              Eigen::VectorXd::Zero(count), Eigen::VectorXd::Ones(count), closed},
      right_(Poles::Zero(count, 3)),
      right_size_(Eigen::VectorXd::Zero(count)) {}

void SlopeEquations::set(Index i, double lower, double tension, double upper,
                         const Eigen::RowVector3d& before, const Eigen::RowVector3d& after) {
  const int exponent = std::min(std::ilogb(1 + std::abs(tension)), kLargestExponent);
  const double scale = matrix_.scale(i) = std::ldexp(1.0, exponent);
  matrix_.lower(i) = lower / scale;
  matrix_.diagonal(i) = std::isfinite(tension) ? (2 + tension) / scale : std::copysign(1, tension);
  matrix_.upper(i) = upper / scale;
  right_.row(i) = (3 / scale) * before + (3 / scale) * after;
  right_size_(i) = (3 / scale) * (largest(before) + largest(after));
  if (std::isinf(tension)) right_.row(i).setZero();
}

void SlopeEquations::give(Index i, const Eigen::RowVector3d& derivative) {
  matrix_.diagonal(i) = 1;
  right_.row(i) = derivative;
}

SlopeEquations::Solution SlopeEquations::solve() && {
  const Index count = right_.rows();
  BandSolution solution = solveBand(matrix_, std::move(right_));
  Eigen::VectorXd noise(count);
  for (Index i = 0; i < count; ++i) {
    const double terms =
        std::abs(matrix_.lower(i)) * largest(solution.x.row((i + count - 1) % count)) +
        std::abs(matrix_.diagonal(i)) * largest(solution.x.row(i)) +
        std::abs(matrix_.upper(i)) * largest(solution.x.row((i + 1) % count));
    noise(i) = 8 * kEpsilon * std::max(1.0, solution.inverse_norm) * (terms + right_size_(i));
  }
  return {std::move(solution.x), std::move(noise)};
}

void requireFinite(const std::string& name, const Eigen::Vector3d& vector) {
  if (!vector.allFinite())
    throw std::invalid_argument(name + " is " + text(Eigen::RowVector3d(vector)) +
                                ": it must be finite");
}

void requireFiniteRows(const char* name,
                       const Eigen::Ref<const Poles, 0, Eigen::OuterStride<>>& rows) {
  for (Index i = 0; i < rows.rows(); ++i)
    if (!rows.row(i).allFinite())
      requireFinite(std::string(name) + " " + std::to_string(i), rows.row(i));
}

void requirePoints(const Poles& points, bool periodic) {
  const Index least = periodic ? 3 : 2, count = points.rows();
  if (count < least)
    throw std::invalid_argument("points " + std::to_string(count) + ": at least " +
                                std::to_string(least) + " are needed");
  requireFiniteRows("point", points);
  for (Index i = 1; i < count; ++i) {
    const Eigen::RowVector3d step = points.row(i) - points.row(i - 1);
    if (step.allFinite() && !step.isZero(0)) continue;
    throw std::invalid_argument("points " + std::to_string(i - 1) + " and " + std::to_string(i) +
                                ", " + text(Eigen::RowVector3d(points.row(i - 1))) + " and " +
                                text(Eigen::RowVector3d(points.row(i))) +
                                (step.allFinite() ? ", are the same" : ", are too far apart"));
  }
  if (periodic && points.row(count - 1) != points.row(0))
    throw std::invalid_argument("point " + std::to_string(count - 1) + " is " +
                                text(Eigen::RowVector3d(points.row(count - 1))) +
                                ": of a periodic spline it must be point 0, " +
                                text(Eigen::RowVector3d(points.row(0))));
}

void requireNumbers(const char* name, const std::vector<double>& values, Index count) {
  if (static_cast<Index>(values.size()) != count)
    throw std::invalid_argument(std::string(name) + " has " + std::to_string(values.size()) +
                                " numbers for " + std::to_string(count) + " points");
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw std::invalid_argument(std::string(name) + " " + std::to_string(i) + " is " +
                                  text(values[i]) + ": it must be finite");
}

void requireIncreasing(const std::vector<double>& knots, const char* reason) {
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (!(knots[i - 1] < knots[i] && std::isfinite(knots[i])))
      throw std::invalid_argument("knot " + std::to_string(i) + " is " + text(knots[i]) +
                                  " after " + text(knots[i - 1]) + ": " + reason);
  if (const double range = knots.back() - knots.front(); knots.size() > 1 && !std::isnormal(range))
    throw std::invalid_argument("the knots range over " + text(range) +
                                ": that must not overflow, nor underflow");
}

std::vector<int> stationaryPoints(const BezierSpline& spline, const Poles& derivatives,
                                  const Eigen::VectorXd& noise) {
  std::vector<int> result;
  const Index last = spline.poles.rows() - 1, points = last / 3 + 1;
  for (Index i = 0; i < points; ++i) {
    const auto pole = [&](Index k) { return Eigen::RowVector3d(spline.poles.row(k).head<3>()); };
    const bool before = i > 0 || spline.closed, after = i + 1 < points || spline.closed;
    if (largest(derivatives.row(i)) <= noise(i % noise.size()) ||
        (before && isLost(pole(3 * i), pole(i > 0 ? 3 * i - 1 : last - 1))) ||
        (after && isLost(pole(3 * i), pole(i + 1 < points ? 3 * i + 1 : 1))))
      result.push_back(static_cast<int>(i));
  }
  return result;
}

}  // namespace seamwright
