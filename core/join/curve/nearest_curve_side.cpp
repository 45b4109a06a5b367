// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/join/curve/nearest_curve_side.hpp>

namespace seamwright::nearest_curve {

namespace {

/// Knots in units of the span at that end, counted from the end.
std::vector<double> endKnots(const End& end, int span) {
  const double length = end.knots[span + 1] - end.knots[span];
  const double origin = end.last ? end.knots.back() : end.knots.front();
  std::vector<double> result = end.knots;
  for (double& knot : result) knot = (knot - origin) / length;
  return result;
}

/// Leibniz' rule on w X = sum_j w_j P_j N_j, for each pole separately.
void divideByWeight(Eigen::MatrixXd& jet, const Eigen::VectorXd& weights) {
  const Eigen::VectorXd w = jet * weights;
  jet *= weights.asDiagonal();
  for (Eigen::Index k = 0; k < jet.rows(); ++k) {
    double binomial = 1;
    for (Eigen::Index i = 1; i <= k; ++i) {
      binomial *= static_cast<double>(k - i + 1) / static_cast<double>(i);
      jet.row(k) -= binomial * w(i) * jet.row(k - i);
    }
    jet.row(k) /= w(0);
  }
}

}  // namespace

Eigen::Vector3d End::point() const {
  const auto pole = poles.row(last ? poles.rows() - 1 : 0);
  return pole.head<3>().transpose() / pole(3);
}

void Side::rescale(double factor) {
  double power = 1;
  for (Eigen::Index k = 0; k < jet.rows(); ++k, power /= factor) jet.row(k) *= power;
  unit *= factor;
}

Side sideOf(const End& end, int order, const Eigen::Vector3d& origin, const Eigen::VectorXd& costs,
            bool moves) {
  const auto& knots = end.knots;
  const int span = bspline::spanOf(end.degree, knots, end.last ? knots.back() : knots.front());
  const Eigen::MatrixXd basis =
      bspline::basisDerivatives(end.degree, endKnots(end, span), span, 0, order);
  const Eigen::Index first = end.firstPole(order), count = order + 1;
  const auto poles = end.poles.middleRows(first, count);

  Side side;
  side.jet = end.last ? basis.rightCols(count) : basis.leftCols(count);
  // The k-th derivative does not depend on poles beyond the k-th one from the end. Their entries
  // are only rounding.
  for (Eigen::Index k = 0; k < order; ++k)
    (end.last ? side.jet.row(k).head(order - k) : side.jet.row(k).tail(order - k)).setZero();
  side.unit = 1 / (knots[span + 1] - knots[span]);
  side.rescale(end.degree);
  const Eigen::VectorXd weights = poles.col(3) / poles(end.last ? order : 0, 3);
  if ((weights.array() != 1).any()) divideByWeight(side.jet, weights);
  side.points = (poles.leftCols<3>().array().colwise() / poles.col(3).array()).rowwise() -
                origin.transpose().array();
  side.reach = Eigen::VectorXd::Constant(count, moves ? 1 : 0);
  if (moves && costs.size() != 0) side.reach = costs.segment(first, count).array().sqrt().inverse();
  return side;
}

}  // namespace seamwright::nearest_curve
