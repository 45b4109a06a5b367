// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/fair/spline_energy.hpp>
#include <seamwright/core/linear/gauss_rule.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

linear::SymmetricBand emptyProducts(int degree, const std::vector<double>& knots) {
  return {static_cast<Index>(knots.size()) - degree - 1, degree};
}

/// Adds a weight times the products of the values of the basis functions from the first one on.
void addProducts(linear::SymmetricBand& matrix, Index first, const Eigen::RowVectorXd& values,
                 double weight) {
  for (Index j = 0; j < values.size(); ++j)
    for (Index i = j; i < values.size(); ++i)
      matrix(first + i, first + j) += weight * values(i) * values(j);
}

}  // namespace

linear::SymmetricBand derivativeProducts(int degree, const std::vector<double>& knots, int order) {
  const GaussRule gauss = gaussRule(degree + 1 - order);
  linear::SymmetricBand result = emptyProducts(degree, knots);
  for (int span = degree; span < result.size(); ++span) {
    const double from = knots[span], to = knots[span + 1];
    if (!(from < to)) continue;
    for (std::size_t k = 0; k < gauss.nodes.size(); ++k) {
      const double t = from + gauss.nodes[k] * (to - from);
      addProducts(result, span - degree,
                  bspline::basisDerivatives(degree, knots, span, t, order).row(order),
                  gauss.weights[k] * (to - from));
    }
  }
  return result;
}

linear::SymmetricBand valueProducts(int degree, const std::vector<double>& knots,
                                    const std::vector<double>& parameters) {
  linear::SymmetricBand result = emptyProducts(degree, knots);
  for (const double t : parameters) {
    const int span = bspline::spanOf(degree, knots, t);
    addProducts(result, span - degree, bspline::basisDerivatives(degree, knots, span, t, 0), 1);
  }
  return result;
}

Eigen::SparseMatrix<double> basisAt(int degree, const std::vector<double>& knots,
                                    const std::vector<double>& parameters) {
  const Index count = static_cast<Index>(knots.size()) - degree - 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const int span = bspline::spanOf(degree, knots, parameters[k]);
    const Eigen::MatrixXd values = bspline::basisDerivatives(degree, knots, span, parameters[k], 0);
    for (int i = 0; i <= degree; ++i)
      entries.emplace_back(static_cast<Index>(k), span - degree + i, values(0, i));
  }
  Eigen::SparseMatrix<double> result(static_cast<Index>(parameters.size()), count);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

SplineEnergy::SplineEnergy(int degree, const std::vector<double>& knots, int order)
    : products_(derivativeProducts(degree, knots, order)),
      inner_products_(derivativeProducts(
          degree - order, std::vector<double>(knots.begin() + order, knots.end() - order), 0)) {
  for (int r = 1; r <= order; ++r) {
    const int p = degree + 1 - r;
    const Index count = static_cast<Index>(knots.size()) - degree - 1 - r;
    Eigen::VectorXd factors(count);
    for (Index i = 0; i < count; ++i) {
      const double width = knots[i + degree + 1] - knots[i + r];
      factors(i) = width > 0 ? p / width : 0;  // a pole without a span
    }
    factors_.push_back(std::move(factors));
  }
}

Poles SplineEnergy::derivative(Poles poles) const {
  for (const Eigen::VectorXd& factors : factors_) {
    const Index count = factors.size();
    const Poles steps = poles.bottomRows(count) - poles.topRows(count);
    poles = factors.asDiagonal() * steps;
  }
  return poles;
}

double SplineEnergy::of(const Poles& poles) const {
  const Poles changes = derivative(poles);
  return changes.cwiseProduct(inner_products_.times(changes)).sum();
}

Poles SplineEnergy::gradient(const Poles& poles) const {
  Poles result = inner_products_.times(derivative(poles));
  for (auto factors = factors_.rbegin(); factors != factors_.rend(); ++factors) {
    const Poles scaled = factors->asDiagonal() * result;
    result = Poles::Zero(scaled.rows() + 1, 3);
    result.bottomRows(scaled.rows()) += scaled;
    result.topRows(scaled.rows()) -= scaled;
  }
  return result;
}

}  // namespace seamwright
