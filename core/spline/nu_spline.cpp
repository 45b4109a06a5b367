// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/spline/nu_spline.hpp>
#include <seamwright/core/spline/slope_equations.hpp>
#include <stdexcept>
#include <utility>

namespace seamwright {

namespace {

using Eigen::Index;

void requireValid(const NuSplineData& data) {
  requirePoints(data.points, data.ends == SplineEnds::Periodic);
  requireNumbers("knot", data.knots, data.points.rows());
  requireIncreasing(data.knots, "knots must increase");
  requireNumbers("nu", data.nu, data.points.rows());
  if (data.ends != SplineEnds::Clamped) return;
  requireFinite("start_derivative", data.start_derivative);
  requireFinite("end_derivative", data.end_derivative);
}

/// The polygon's edges by the parameter.
class Edges {
 public:
  explicit Edges(const NuSplineData& data) : data_(data) {}

  double length(Index i) const { return data_.knots[i + 1] - data_.knots[i]; }
  Eigen::RowVector3d slope(Index i) const {
    return (data_.points.row(i + 1) - data_.points.row(i)) / length(i);
  }

 private:
  const NuSplineData& data_;
};

/// \param a, b the edges before and after the point.
void setJoint(SlopeEquations& equations, Index i, const Edges& edges, Index a, Index b, double nu) {
  const double before = edges.length(a), after = edges.length(b);
  const double lower = 1 / (1 + before / after), upper = 1 / (1 + after / before);
  equations.set(i, lower, nu * (before * lower / 2), upper, lower * edges.slope(a),
                upper * edges.slope(b));
}

SlopeEquations equationsOf(const NuSplineData& data) {
  const Edges edges(data);
  const Index n = data.points.rows() - 1;
  const bool closed = data.ends == SplineEnds::Periodic;
  SlopeEquations equations(closed ? n : n + 1, closed);
  for (Index i = 1; i < n; ++i) setJoint(equations, i, edges, i - 1, i, data.nu[i]);
  if (closed) {
    setJoint(equations, 0, edges, n - 1, 0, data.nu.front() + data.nu.back());
  } else if (data.ends == SplineEnds::Clamped) {
    equations.give(0, data.start_derivative.transpose());
    equations.give(n, data.end_derivative.transpose());
  } else {
    const Eigen::RowVector3d none = Eigen::RowVector3d::Zero();
    equations.set(0, 0, data.nu.front() * (edges.length(0) / 2), 1, none, edges.slope(0));
    equations.set(n, 1, data.nu.back() * (edges.length(n - 1) / 2), 0, edges.slope(n - 1), none);
  }
  return equations;
}

}  // namespace

NuSpline nuSpline(const NuSplineData& data) {
  requireValid(data);
  SlopeEquations::Solution solution = equationsOf(data).solve();
  const Index n = data.points.rows() - 1;
  NuSpline result;
  result.derivatives = std::move(solution.derivatives);
  result.derivatives.conservativeResize(n + 1, 3);
  if (data.ends == SplineEnds::Periodic) result.derivatives.row(n) = result.derivatives.row(0);
  const Edges edges(data);
  result.curve = hermiteSpline(data.points, result.derivatives, data.knots,
                               data.ends == SplineEnds::Periodic, [&](Index i) {
                                 const double reach = edges.length(i) / 3;
                                 return Reach{reach, reach};
                               });
  result.stationary = stationaryPoints(result.curve, result.derivatives, solution.noise);
  return result;
}

std::vector<double> knotsOf(const Poles& points, double exponent) {
  if (!(exponent >= 0 && exponent <= 1))
    throw std::invalid_argument("exponent is " + bernstein::text(exponent) +
                                ": it must be within 0 to 1");
  requireFiniteRows("point", points);
  std::vector<double> knots(static_cast<std::size_t>(points.rows()), 0.0);
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const auto row = static_cast<Index>(i);
    const double chord = (points.row(row) - points.row(row - 1)).stableNorm();
    if (chord == 0 && exponent > 0)
      throw std::invalid_argument("points " + std::to_string(i - 1) + " and " + std::to_string(i) +
                                  " are the same: exponent is " + bernstein::text(exponent) +
                                  ", not 0");
    knots[i] = knots[i - 1] + std::pow(chord, exponent);
  }
  requireIncreasing(knots, "the points' distances are too different, or too large");
  return knots;
}

}  // namespace seamwright
