// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/fair/polish_curve.hpp>
#include <seamwright/core/fair/polynomial_curve.hpp>
#include <seamwright/core/fair/spline_energy.hpp>
#include <seamwright/core/linear/gauss_rule.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

using Normal = Eigen::SparseMatrix<double>;

void requireContinuousCurvature(const BSplineCurve& curve) {
  if (curve.degree < 3)
    refuse(
        fmt::format("the degree is {}: the curvature varies continuously from 3 on", curve.degree));
  const std::vector<double>& u = curve.knots;
  const std::size_t degree = curve.degree, last = u.size() - degree - 1;
  for (std::size_t i = degree + 1; i + degree - 2 < last; ++i)
    if (u[i] == u[i + degree - 2])
      refuse(fmt::format("the curvature may jump at the knot {}, of a multiplicity above {}", u[i],
                         degree - 2));
}

/// The root of the variation at a point, r with |r|^2 = |d(k N)/ds|^2 |a| across the tangent, and
/// its Jacobians by the derivatives a, b and c. Source: docs/theory/planar.md P11.3.
struct VariationRoot {
  Vector3d root;
  Matrix3d by_first, by_second, by_third;
};

Vector3d variationRoot(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double s = a.squaredNorm();
  const Vector3d u = c - 3 * a.dot(b) / s * b;
  return std::pow(s, -1.25) * (u - a.dot(u) / s * a);
}

VariationRoot linearisedRoot(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double s = a.squaredNorm(), m = a.dot(b), factor = std::pow(s, -1.25);
  const Matrix3d identity = Matrix3d::Identity();
  const Vector3d u = c - 3 * m / s * b;
  const Vector3d w = u - a.dot(u) / s * a;
  const Matrix3d across = identity - a * a.transpose() / s;
  const Matrix3d u_by_first = -3 / s * b * b.transpose() + 6 * m / (s * s) * b * a.transpose();
  const Matrix3d u_by_second = -3 / s * (b * a.transpose() + m * identity);
  const Matrix3d w_by_first = across * u_by_first - (a * u.transpose() + a.dot(u) * identity) / s +
                              2 * a.dot(u) / (s * s) * a * a.transpose();
  return {.root = factor * w,
          .by_first = factor * (w_by_first - 2.5 / s * w * a.transpose()),
          .by_second = factor * across * u_by_second,
          .by_third = factor * across};
}

/// The variation of curves with given knots as a sum of squares, and the squared distance from the
/// curve that is given.
class VariationProblem {
 public:
  VariationProblem(const BSplineCurve& curve, HeldEnds ends)
      : degree_(curve.degree),
        given_(polynomialPoles(curve)),
        free_(given_.rows(), ends),
        dimensions_((given_.col(2).array() == 0).all() ? 2 : 3),
        mass_(derivativeProducts(curve.degree, curve.knots, 0)) {
    const GaussRule gauss = gaussRule(8);
    for (int span = degree_; span < curve.count(); ++span) {
      const double from = curve.knots[span], length = curve.knots[span + 1] - from;
      for (std::size_t k = 0; length > 0 && k < gauss.nodes.size(); ++k)
        nodes_.push_back({.first = span - degree_,
                          .weight = gauss.weights[k] * length,
                          .basis = bspline::basisDerivatives(degree_, curve.knots, span,
                                                             from + gauss.nodes[k] * length, 3)});
    }
  }

  Index freeCount() const { return free_.count; }
  const Poles& given() const { return given_; }

  double variation(const Poles& poles) const {
    double sum = 0;
    for (const Node& node : nodes_) {
      const Eigen::MatrixXd d = derivativesAt(node, poles);
      sum += node.weight * variationRoot(d.row(1), d.row(2), d.row(3)).squaredNorm();
    }
    return sum;
  }
  double squaredDistance(const Poles& poles) const {
    const Poles moves = poles - given_;
    return moves.cwiseProduct(mass_ * moves).sum();
  }

  /// Half of the second derivatives of Gauss-Newton and of the gradient of the variation.
  struct Equations {
    Normal matrix;
    Eigen::VectorXd gradient;
  };

  Equations equations(const Poles& poles) const {
    const Index size = dimensions_ * free_.count;
    Equations result{.matrix = Normal(size, size), .gradient = Eigen::VectorXd::Zero(size)};
    std::vector<Eigen::Triplet<double>> entries;
    const Index width = dimensions_ * (degree_ + 1);
    for (auto node = nodes_.begin(); node != nodes_.end();) {
      const Index first = node->first;
      Eigen::MatrixXd products = Eigen::MatrixXd::Zero(width, width);
      Eigen::VectorXd slope = Eigen::VectorXd::Zero(width);
      for (; node != nodes_.end() && node->first == first; ++node) {
        const auto [root, rows] = rowsAt(*node, poles);
        products += node->weight * rows.transpose() * rows;
        slope += node->weight * rows.transpose() * root;
      }
      for (Index i = 0; i < width; ++i) {
        const Index row = unknown(first, i);
        if (row < 0 || row >= size) continue;
        result.gradient(row) += slope(i);
        for (Index j = 0; j < width; ++j) {
          const Index column = unknown(first, j);
          if (column >= 0 && column < size) entries.emplace_back(row, column, products(i, j));
        }
      }
    }
    result.matrix.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  /// The form of the squared distance for all coordinates of the free poles.
  Normal distanceForm() const {
    const Index size = dimensions_ * free_.count;
    std::vector<Eigen::Triplet<double>> entries;
    for (Index j = 0; j < free_.count; ++j)
      for (Normal::InnerIterator at(mass_, free_.first + j); at; ++at) {
        const Index i = at.row() - free_.first;
        if (i < 0 || i >= free_.count) continue;
        for (Index k = 0; k < dimensions_; ++k)
          entries.emplace_back(dimensions_ * i + k, dimensions_ * j + k, at.value());
      }
    Normal form(size, size);
    form.setFromTriplets(entries.begin(), entries.end());
    return form;
  }

  /// The moves of the free poles, one coordinate after the other, and back.
  Eigen::VectorXd unknowns(const Poles& poles) const {
    const Poles moves = (poles - given_).middleRows(free_.first, free_.count);
    Eigen::VectorXd result(dimensions_ * free_.count);
    for (Index i = 0; i < free_.count; ++i)
      result.segment(dimensions_ * i, dimensions_) = moves.row(i).head(dimensions_).transpose();
    return result;
  }
  Poles moved(Poles poles, const Eigen::VectorXd& step) const {
    for (Index i = 0; i < free_.count; ++i)
      poles.row(free_.first + i).head(dimensions_) +=
          step.segment(dimensions_ * i, dimensions_).transpose();
    return poles;
  }

 private:
  struct Node {
    Index first = 0;  ///< pole of the first basis function
    double weight = 0;
    Eigen::MatrixXd basis;  ///< 4 by degree + 1
  };

  struct Rows {
    Vector3d root;
    Eigen::MatrixXd jacobian;  ///< 3 by dimensions (degree + 1)
  };

  Index unknown(Index first, Index i) const { return dimensions_ * (first - free_.first) + i; }

  Eigen::MatrixXd derivativesAt(const Node& node, const Poles& poles) const {
    return node.basis * poles.middleRows(node.first, degree_ + 1);
  }

  Rows rowsAt(const Node& node, const Poles& poles) const {
    const Eigen::MatrixXd d = derivativesAt(node, poles);
    const VariationRoot at = linearisedRoot(d.row(1), d.row(2), d.row(3));
    Rows rows{.root = at.root, .jacobian = Eigen::MatrixXd(3, dimensions_ * (degree_ + 1))};
    for (Index i = 0; i <= degree_; ++i)
      rows.jacobian.middleCols(dimensions_ * i, dimensions_) =
          (node.basis(1, i) * at.by_first + node.basis(2, i) * at.by_second +
           node.basis(3, i) * at.by_third)
              .leftCols(dimensions_);
    return rows;
  }

  int degree_;
  Poles given_;
  FreePoles free_;
  Index dimensions_;
  Normal mass_;
  std::vector<Node> nodes_;
};

/// Minimises the variation plus a weight times the squared distance, for one weight after another.
class VariationDescent {
 public:
  explicit VariationDescent(const VariationProblem& problem)
      : problem_(problem), distance_(problem.distanceForm()) {
    const VariationProblem::Equations start = problem.equations(problem.given());
    // Both forms have the same size for this weight.
    middle_ = start.matrix.diagonal().sum() / distance_.diagonal().sum();
    factor_.analyzePattern(Normal(start.matrix + distance_));
  }

  double middle() const { return middle_; }
  int steps() const { return steps_; }

  Poles least(Poles poles, double weight) {
    double objective = objectiveOf(poles, weight);
    // Steps converge quadratically near a minimum without residual, linearly elsewhere; what twelve
    // leave is removed for the next weight.
    for (int i = 0; i < 12; ++i) {
      const Eigen::VectorXd step = stepFrom(poles, weight);
      if (!step.allFinite()) return poles;
      ++steps_;
      const double before = objective;
      if (!descend(poles, objective, step, weight) || before - objective < 1e-6 * before)
        return poles;
    }
    return poles;
  }

 private:
  double objectiveOf(const Poles& poles, double weight) const {
    return problem_.variation(poles) + weight * problem_.squaredDistance(poles);
  }

  /// Not finite if the equations are singular.
  Eigen::VectorXd stepFrom(const Poles& poles, double weight) {
    const auto [matrix, gradient] = problem_.equations(poles);
    factor_.factorize(Normal(matrix + weight * distance_));
    if (factor_.info() != Eigen::Success)
      return Eigen::VectorXd::Constant(gradient.size(), infinite);
    return -factor_.solve(gradient + weight * (distance_ * problem_.unknowns(poles)));
  }

  /// Shortens the step until the objective falls. \returns whether it does.
  bool descend(Poles& poles, double& objective, const Eigen::VectorXd& step, double weight) const {
    for (double share = 1; share > 1e-3; share /= 2) {
      const Poles trial = problem_.moved(poles, share * step);
      const double value = objectiveOf(trial, weight);
      if (!(value < objective)) continue;
      poles = trial;
      objective = value;
      return true;
    }
    return false;
  }

  const VariationProblem& problem_;
  Normal distance_;
  double middle_ = 0;
  int steps_ = 0;
  Eigen::SimplicialLDLT<Normal, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
};

struct Polished {
  Poles poles;
  double moved_mm = 0, weight_per_mm5 = 0, variation_per_mm3 = 0;
};

/// The bound of the distance, for poles as they are stored.
double boundOfMoves_mm(const BSplineCurve& curve, const Poles& poles) {
  const Poles moves = polynomialPoles(withPoles(curve, poles)) - polynomialPoles(curve);
  // A Bézier pole is a mean that at most degree^2 insertions make, each with an error of 8 eps.
  const double rounding = 8 * curve.degree * curve.degree * 0x1p-52;
  return largestPole_mm(curve, moves) * (1 + rounding);
}

/// Lowers the weight until the tolerance stops it, then bisects.
Polished smallestWeight(const BSplineCurve& curve, const VariationProblem& problem,
                        VariationDescent& descent, double tolerance_mm) {
  Polished best{.poles = problem.given(), .variation_per_mm3 = problem.variation(problem.given())};
  const auto attempt = [&](double exponent) {
    const double weight = descent.middle() * std::exp2(exponent);
    const Poles poles = descent.least(best.poles, weight);
    const double moved_mm = boundOfMoves_mm(curve, poles);
    if (!(moved_mm <= tolerance_mm)) return false;
    const double variation = problem.variation(poles);
    if (variation < best.variation_per_mm3)
      best = {.poles = poles,
              .moved_mm = moved_mm,
              .weight_per_mm5 = weight,
              .variation_per_mm3 = variation};
    return true;
  };
  // Waves of the lowest frequency in n poles have n^-6 of the energy of the highest: 2^-80 for
  // 10000 poles. Above 2^8 the moves are small beside the waves of the highest frequency, and above
  // 2^64 they are rounding.
  constexpr double least = -80, first = 8, most = 64;
  constexpr double stride = 4;  // weights whose minima are near enough for a warm start
  double high = first;
  while (!attempt(high))
    if ((high += stride) > most) return best;
  double low = high - stride;
  for (; low >= least && attempt(low); low -= stride) high = low;
  if (low < least) return best;
  while (high - low > 0x1p-6 && best.moved_mm < 0.99 * tolerance_mm) {
    const double middle = (low + high) / 2;
    (attempt(middle) ? high : low) = middle;
  }
  return best;
}

}  // namespace

PolishedCurve polishCurve(const BSplineCurve& curve, double tolerance_mm,
                          const CurveFairingOptions& options) {
  PolishedCurve result;
  result.before = fairnessOf(curve);
  requireContinuousCurvature(curve);
  requireFairingTolerance(tolerance_mm);
  result.curve = curve;
  result.after = result.before;
  const VariationProblem problem(curve, options.ends);
  const double variation = problem.variation(problem.given());
  if (!std::isfinite(variation))
    throw std::domain_error(fmt::format(
        "the curve stops, so the variation of its curvature is {}: it can't be polished",
        variation));
  result.variation_before_per_mm3 = result.variation_after_per_mm3 = variation;
  if (tolerance_mm == 0 || problem.freeCount() == 0 || variation == 0) return result;
  VariationDescent descent(problem);
  const Polished found = smallestWeight(curve, problem, descent, tolerance_mm);
  result.steps = descent.steps();
  if (!(found.variation_per_mm3 < variation)) return result;
  result.curve = withPoles(curve, found.poles);
  result.moved_mm = found.moved_mm;
  result.weight_per_mm5 = found.weight_per_mm5;
  result.variation_after_per_mm3 = found.variation_per_mm3;
  result.after = fairnessOf(result.curve);
  return result;
}

}  // namespace seamwright
