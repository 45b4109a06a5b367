// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/differential/arc_length.hpp>
#include <seamwright/core/join/curve/beta.hpp>
#include <seamwright/core/join/curve/joint_length.hpp>
#include <seamwright/core/join/curve/nearest_curve.hpp>
#include <seamwright/core/join/curve/nearest_curve_search.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/seam/curve_joint.hpp>

namespace seamwright {

namespace {

using bernstein::text;
using nearest_curve::End;
using nearest_curve::Problem;
using nearest_curve::Side;
using Moves = NearestCurveJoinOptions::Moves;
using NearestPoles = NearestCurveJoin<HomogeneousPoles>;

/// Share of its given length above which an end's first derivative must stay.
constexpr double lost = 1e-6;
/// Defect above which rounding hides the join.
constexpr double largest_curve_rounding = 1e-6;

void requireValid(const Eigen::VectorXd& costs, const End& end, const std::string& name) {
  if (costs.size() == 0) return;
  if (costs.size() != end.poles.rows())
    throw std::invalid_argument(name + " " + std::to_string(costs.size()) + ", poles " +
                                std::to_string(end.poles.rows()) + ": the numbers must be equal");
  for (Eigen::Index i = 0; i < costs.size(); ++i)
    if (!(costs(i) > 0))
      throw std::invalid_argument(name + "[" + std::to_string(i) + "] is " + text(costs(i)) +
                                  ": costs must be positive");
}

void requireValid(const End& end, const std::string& name, int order) {
  if (end.degree < order)
    throw std::invalid_argument("degree of " + name + " is " + std::to_string(end.degree) +
                                ", the order " + std::to_string(order) + ": elevate it first");
}

void requireValid(const NearestCurveJoinOptions& options) {
  if (options.order < 1 || options.order > 10)
    throw std::invalid_argument("order is " + std::to_string(options.order) +
                                ": 1 to 10 is needed");
  if (!(options.least_beta1 > 0 && options.least_beta1 <= 1))
    throw std::invalid_argument("least_beta1 is " + text(options.least_beta1) +
                                ": a number above 0, up to 1, is needed");
  if (!(options.most_beta1 >= 1) || !std::isfinite(options.most_beta1))
    throw std::invalid_argument("most_beta1 is " + text(options.most_beta1) +
                                ": a finite number from 1 is needed");
  if (options.max_iterations < 0)
    throw std::invalid_argument("max_iterations is " + std::to_string(options.max_iterations) +
                                ": it must not be negative");
  if (!options.beta) return;
  const Eigen::VectorXd& beta = *options.beta;
  if (beta.size() != options.order)
    throw std::invalid_argument("betas " + std::to_string(beta.size()) + ", order " +
                                std::to_string(options.order) + ": the numbers must be equal");
  for (Eigen::Index i = 0; i < beta.size(); ++i)
    if (!std::isfinite(beta(i)) || (i == 0 && !(beta(i) > 0)))
      throw std::invalid_argument(
          "beta_" + std::to_string(i + 1) + " is " + text(beta(i)) +
          (i == 0 ? ": it must be positive and finite" : ": it must be finite"));
}

/// The derivatives of the arc length by the curve's parameter, first to last order.
Eigen::VectorXd speeds(const CurveDerivatives& jet) {
  const CurveDerivatives arc = arcLengthDerivatives(jet).value();
  Eigen::VectorXd result(jet.rows() - 1);
  result(0) = jet.row(1).stableNorm();
  for (Eigen::Index k = 2; k < jet.rows(); ++k) {
    result(k - 1) = 0;
    const Eigen::MatrixXd B = betaMatrix(result.head(k));
    const Eigen::RowVector3d rest =
        jet.row(k) - B.row(k).segment(2, k - 1) * arc.middleRows(2, k - 1);
    result(k - 1) = arc.row(1).dot(rest);
  }
  return result;
}

double largestCoordinate(const End& end, int order) {
  const auto poles = end.poles.middleRows(end.firstPole(order), order + 1);
  return (poles.leftCols<3>().array().colwise() / poles.col(3).array()).abs().maxCoeff();
}

CurveExtent extentOfEnd(const End& end) {
  const End other{end.degree, end.knots, end.poles, !end.last};
  const Poles poles = end.poles.leftCols<3>().array().colwise() / end.poles.col(3).array();
  return extentOf(poles, end.point().transpose(), other.point().transpose());
}

struct Defect {
  double largest = std::numeric_limits<double>::infinity();  ///< of BetaFit::defects
  double relative = largest;  ///< the same in units of the curves' own derivatives by arc length,
                              ///< where they are large
};

/// The defect; infinite if a tangent is lost.
Defect defectOf(const End& a, const End& b, int order, double length) {
  const Eigen::Vector3d origin = a.point() + (b.point() - a.point()) / 2;
  const auto derivativesOf = [&](const End& end) {
    const Side side = nearest_curve::sideOf(end, order, origin, {}, false);
    return CurveEnd{side.jet * side.points, 8 * machine_epsilon * largestCoordinate(end, 1)};
  };
  const CurveJoint joint = measureJoint(derivativesOf(a), derivativesOf(b));
  Defect defect;
  if (joint.differences.empty()) return defect;
  defect.largest = defect.relative = 0;
  double scale = 1 / length;
  for (int k = 0; k <= order; ++k) {
    if (k >= 2) scale = std::max(scale, std::pow(joint.sizes[k], 1.0 / (k - 1)));
    defect.largest = std::max(defect.largest, joint.differences[k] * std::pow(length, k - 1));
    defect.relative = std::max(defect.relative, joint.differences[k] / std::pow(scale, k - 1));
  }
  return defect;
}

/// The dimensionless problem; \p length is set to the unit of length.
Problem problemOf(const End& a, const End& b, const NearestCurveJoinOptions& options,
                  double& length) {
  const int n = options.order;
  const Eigen::Vector3d origin = a.point() + (b.point() - a.point()) / 2;
  Problem problem{nearest_curve::sideOf(a, n, origin, options.costs_a, options.moves != Moves::B),
                  nearest_curve::sideOf(b, n, origin, options.costs_b, options.moves != Moves::A),
                  {},
                  options.beta.has_value(),
                  std::log(options.least_beta1),
                  std::log(options.most_beta1),
                  0,
                  options.max_iterations};
  const double largest = std::max(largestCoordinate(a, n), largestCoordinate(b, n));
  const auto speed = [&](const Side& side, const char* name) {
    const double size = (side.jet.row(1) * side.points).stableNorm();
    if (!(size > 8 * machine_epsilon * largest))
      throw std::invalid_argument(std::string("curve ") + name +
                                  " has no tangent at the joint: its first derivative is " +
                                  text(size * side.unit));
    return size;
  };
  const double speed_a = speed(problem.a, "a"), speed_b = speed(problem.b, "b");
  length = std::sqrt(speed_a) * std::sqrt(speed_b);
  problem.a.rescale(speed_a / length);
  problem.b.rescale(speed_b / length);
  problem.a.points /= length;
  problem.b.points /= length;
  problem.rounding = machine_epsilon * largest / length;
  if (options.beta) {
    problem.beta = *options.beta;
    for (int k = 1; k <= n; ++k)
      problem.beta(k - 1) *= problem.a.unit / std::pow(problem.b.unit, k);
  } else {
    // The betas for which both arc lengths have the same speed. They are the betas of an exact
    // joint, and for other joints they are the same from either side.
    problem.beta = composedBeta(speeds(problem.b.jet * problem.b.points),
                                inverseBeta(speeds(problem.a.jet * problem.a.points)));
    problem.beta(0) = std::clamp(problem.beta(0), options.least_beta1, options.most_beta1);
  }
  return problem;
}

Eigen::VectorXd betaOf(const Problem& problem, Eigen::VectorXd beta) {
  for (Eigen::Index k = 1; k <= beta.size(); ++k)
    beta(k - 1) *= std::pow(problem.b.unit, static_cast<double>(k)) / problem.a.unit;
  return beta;
}

/// Moves poles and adds up the cost.
void place(const End& end, const Side& side, const Eigen::MatrixXd& moves, HomogeneousPoles& poles,
           NearestPoles& solution) {
  const Eigen::Index first = end.firstPole(static_cast<int>(moves.rows()) - 1);
  for (Eigen::Index i = 0; i < moves.rows(); ++i) {
    if (side.reach(i) == 0) continue;
    auto pole = poles.row(first + i);
    pole.head<3>() += pole(3) * moves.row(i);
    const double move = moves.row(i).stableNorm(), by_cost = move / side.reach(i);
    solution.cost += by_cost * by_cost / 2;
    solution.largest_move_mm = std::max(solution.largest_move_mm, move);
  }
}

/// Makes ends that are the same point up to rounding bitwise the same, if their weights are equal.
void meet(bool a_moves, Eigen::Ref<Eigen::RowVector4d> a, bool b_moves,
          Eigen::Ref<Eigen::RowVector4d> b) {
  if (a(3) != b(3)) return;
  if (b_moves)
    b = a;
  else if (a_moves)
    a = b;
}

double speedOf(const Side& side, const Eigen::MatrixXd& points) {
  return (side.jet.row(1) * points).norm();
}

NearestPoles nearestPoles(const End& a, const End& b, const NearestCurveJoinOptions& options) {
  requireValid(options);
  requireValid(a, "a", options.order);
  requireValid(b, "b", options.order);
  requireValid(options.costs_a, a, "costs_a");
  requireValid(options.costs_b, b, "costs_b");
  double unit = 1;
  const Problem problem = problemOf(a, b, options, unit);
  const double length = jointLength(extentOfEnd(a), extentOfEnd(b));
  NearestPoles result{a.poles, b.poles};
  result.beta = betaOf(problem, problem.beta);
  if (nearest_curve::holds(problem)) {
    result.status = NearestCurveStatus::Solved;
    result.residual = defectOf(a, b, options.order, length).largest;
    return result;
  }
  const nearest_curve::Found found = nearest_curve::search(problem);
  result.beta = betaOf(problem, found.beta);
  result.iterations = found.iterations;
  result.gradient = found.stationarity;

  const auto refuse = [&](const std::string& reason) {
    NearestPoles none{a.poles, b.poles};
    none.beta = result.beta;
    none.iterations = result.iterations;
    none.gradient = result.gradient;
    none.residual = defectOf(a, b, options.order, length).largest;
    none.reason = reason;
    return none;
  };
  if (!found.exact) return refuse("the poles that may move cannot make the join");
  const Eigen::Index count = options.order + 1;
  const Eigen::MatrixXd moves_a = found.moves.topRows(count),
                        moves_b = found.moves.bottomRows(count);
  for (const auto& [side, moves, name] :
       {std::tuple<const Side&, const Eigen::MatrixXd&, const char*>(problem.a, moves_a, "a"),
        {problem.b, moves_b, "b"}})
    if (!(speedOf(side, side.points + moves) > lost * speedOf(side, side.points)))
      return refuse(std::string("curve ") + name + " would lose its tangent");
  place(a, problem.a, moves_a * unit, result.a, result);
  place(b, problem.b, moves_b * unit, result.b, result);
  meet(problem.a.reach(options.order) > 0, result.a.row(result.a.rows() - 1),
       problem.b.reach(0) > 0, result.b.row(0));
  const Defect defect = defectOf({a.degree, a.knots, result.a, true},
                                 {b.degree, b.knots, result.b, false}, options.order, length);
  if (!(defect.relative <= largest_curve_rounding))
    return refuse(std::string(found.bounded ? "beta_1 is at its bound, and " : "") +
                  "rounding leaves a defect of " + text(defect.largest));
  result.residual = defect.largest;
  result.status = found.stationary ? NearestCurveStatus::Solved : NearestCurveStatus::NotConverged;
  if (found.bounded)
    result.reason = "beta_1 is at its bound";
  else if (!found.stationary)
    result.reason = "not stationary after " + std::to_string(found.iterations) + " iterations";
  return result;
}

template <typename Curve>
NearestCurveJoin<Curve> withCurves(Curve a, Curve b, NearestPoles solution) {
  return {std::move(a),
          std::move(b),
          std::move(solution.beta),
          solution.status,
          solution.cost,
          solution.largest_move_mm,
          solution.residual,
          solution.gradient,
          solution.iterations,
          std::move(solution.reason)};
}

}  // namespace

NearestCurveJoin<BSplineCurve> nearestJoin(const BSplineCurve& a, const BSplineCurve& b,
                                           const NearestCurveJoinOptions& options) {
  requireValid(a);
  requireValid(b);
  NearestPoles solution = nearestPoles({a.degree, a.knots, a.poles, true},
                                       {b.degree, b.knots, b.poles, false}, options);
  BSplineCurve moved_a{a.degree, a.knots, std::move(solution.a)},
      moved_b{b.degree, b.knots, std::move(solution.b)};
  return withCurves(std::move(moved_a), std::move(moved_b), std::move(solution));
}

NearestCurveJoin<BezierCurve> nearestJoin(const BezierCurve& a, const BezierCurve& b,
                                          const NearestCurveJoinOptions& options) {
  const auto knots = [](const BezierCurve& curve) {
    std::vector<double> result(2 * curve.homogeneousPoles().rows(), 0.0);
    std::fill(result.begin() + curve.homogeneousPoles().rows(), result.end(), 1.0);
    return result;
  };
  const std::vector<double> knots_a = knots(a), knots_b = knots(b);
  NearestPoles solution = nearestPoles({a.degree(), knots_a, a.homogeneousPoles(), true},
                                       {b.degree(), knots_b, b.homogeneousPoles(), false}, options);
  BezierCurve moved_a = BezierCurve::fromHomogeneous(std::move(solution.a));
  BezierCurve moved_b = BezierCurve::fromHomogeneous(std::move(solution.b));
  return withCurves(std::move(moved_a), std::move(moved_b), std::move(solution));
}

}  // namespace seamwright
