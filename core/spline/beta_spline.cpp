// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/spline/beta_spline.hpp>
#include <seamwright/core/spline/slope_equations.hpp>
#include <stdexcept>
#include <utility>

namespace seamwright {

namespace {

using Eigen::Index;

void requireValid(const BetaSplineData& data) {
  requirePoints(data.points, data.ends == SplineEnds::Periodic);
  requireNumbers("bias", data.bias, data.points.rows());
  requireNumbers("tension", data.tension, data.points.rows());
  const std::size_t joints = data.bias.size() - (data.ends == SplineEnds::Periodic ? 0 : 1);
  for (std::size_t j = 1; j < joints; ++j)
    if (!(data.bias[j] > 0))
      throw std::invalid_argument("bias " + std::to_string(j) + " is " +
                                  bernstein::text(data.bias[j]) + ": it must be positive");
  for (const double nu : {data.start_nu, data.end_nu})
    if (!std::isfinite(nu))
      throw std::invalid_argument("an end's nu is " + bernstein::text(nu) + ": it must be finite");
  requireFinite("start_derivative", data.start_derivative);
  requireFinite("end_derivative", data.end_derivative);
}

/// The left derivative at point j by the right one: 1 at the ends of an open spline.
double biasAt(const BetaSplineData& data, Index j) {
  const Index n = data.points.rows() - 1;
  if (data.ends == SplineEnds::Periodic) return data.bias[j == 0 ? n : j];
  return j == 0 || j == n ? 1 : data.bias[j];
}

/// Knots whose steps are the lengths of the segments. Each length is the previous one divided by
/// the bias between them.
std::vector<double> knotsOf(const BetaSplineData& data) {
  std::vector<double> knots = {0};
  double length = 1;
  for (Index j = 1; j < data.points.rows(); ++j) {
    knots.push_back(knots.back() + length);
    length /= biasAt(data, j);
  }
  requireIncreasing(knots, "the biases before it multiply to more than knots can tell apart");
  return knots;
}

/// The unknowns are m_j / units(j). With units_j = units_(j-1) / bias_j the equations are those of
/// a nu-spline. In a closed spline each step has an additional common factor, so that the last unit
/// equals the first one. For equal biases all units are then 1.
Eigen::VectorXd unitsOf(const BetaSplineData& data) {
  const Index n = data.points.rows() - 1;
  const bool closed = data.ends == SplineEnds::Periodic;
  double turn = 0;
  for (Index j = 1; closed && j <= n; ++j)
    turn += std::log(biasAt(data, j)) / static_cast<double>(n);
  const double step = std::exp(turn);
  Eigen::VectorXd units = Eigen::VectorXd::Ones(closed ? n : n + 1);
  for (Index j = 1; j < units.size(); ++j) units(j) = units(j - 1) * (step / biasAt(data, j));
  return units;
}

SlopeEquations equationsOf(const BetaSplineData& data) {
  const Index n = data.points.rows() - 1;
  const bool closed = data.ends == SplineEnds::Periodic;
  const Eigen::VectorXd units = unitsOf(data);
  const auto edge = [&](Index j) { return data.points.row(j + 1) - data.points.row(j); };
  SlopeEquations equations(units.size(), closed);
  for (Index j = closed ? 0 : 1; j < n; ++j) {
    const Index before = j > 0 ? j - 1 : n - 1, after = j + 1 < units.size() ? j + 1 : 0;
    const double b = biasAt(data, j), tension = data.tension[j > 0 ? j : n];
    const double first = 1 / (b * (1 + b)) / units(j), second = b / (1 + b) / units(j);
    equations.set(j, first * units(before), -tension / (2 * b) / (1 + b),
                  second * biasAt(data, after) * units(after), first * edge(before),
                  second * edge(j));
  }
  if (data.ends == SplineEnds::Natural) {
    const Eigen::RowVector3d none = Eigen::RowVector3d::Zero();
    equations.set(0, 0, data.start_nu / 2, biasAt(data, 1) * units(1), none, edge(0));
    equations.set(n, units(n - 1) / units(n), data.end_nu / 2, 0, edge(n - 1) / units(n), none);
  } else if (!closed) {
    equations.give(0, data.start_derivative.transpose());
    equations.give(n, data.end_derivative.transpose() / units(n));
  }
  return equations;
}

}  // namespace

BetaSpline betaSpline(const BetaSplineData& data) {
  requireValid(data);
  const std::vector<double> knots = knotsOf(data);
  SlopeEquations::Solution solution = equationsOf(data).solve();
  const Eigen::VectorXd units = unitsOf(data);
  solution.derivatives.array().colwise() *= units.array();
  solution.noise.array() *= units.array();
  const Index n = data.points.rows() - 1;
  const bool closed = data.ends == SplineEnds::Periodic;
  BetaSpline result;
  result.derivatives = std::move(solution.derivatives);
  result.derivatives.conservativeResize(n + 1, 3);
  if (closed) result.derivatives.row(n) = result.derivatives.row(0);
  result.curve = hermiteSpline(data.points, result.derivatives, knots, closed, [&](Index i) {
    return Reach{1.0 / 3, biasAt(data, i + 1) / 3};
  });
  result.stationary = stationaryPoints(result.curve, result.derivatives, solution.noise);
  return result;
}

}  // namespace seamwright
