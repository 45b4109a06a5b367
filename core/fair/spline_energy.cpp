// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/fair/spline_energy.hpp>
#include <seamwright/core/linear/gauss_rule.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

/// Differences that take the poles of a spline to those of its derivatives.
class PoleDifferences {
 public:
  PoleDifferences(int degree, const std::vector<double>& knots, int order) {
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

  Poles derivative(Poles poles) const {
    for (const Eigen::VectorXd& factors : factors_) {
      const Index count = factors.size();
      const Poles steps = poles.bottomRows(count) - poles.topRows(count);
      poles = factors.asDiagonal() * steps;
    }
    return poles;
  }
  /// The transposed map.
  Poles transposed(Poles poles) const {
    for (auto factors = factors_.rbegin(); factors != factors_.rend(); ++factors) {
      const Poles scaled = factors->asDiagonal() * poles;
      poles = Poles::Zero(scaled.rows() + 1, 3);
      poles.bottomRows(scaled.rows()) += scaled;
      poles.topRows(scaled.rows()) -= scaled;
    }
    return poles;
  }

 private:
  std::vector<Eigen::VectorXd> factors_;
};

}  // namespace

Eigen::SparseMatrix<double> derivativeProducts(int degree, const std::vector<double>& knots,
                                               int order) {
  const GaussRule gauss = gaussRule(degree + 1 - order);
  const Index count = static_cast<Index>(knots.size()) - degree - 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (int span = degree; span < count; ++span) {
    const double from = knots[span], to = knots[span + 1];
    if (!(from < to)) continue;
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(degree + 1, degree + 1);
    for (std::size_t k = 0; k < gauss.nodes.size(); ++k) {
      const double t = from + gauss.nodes[k] * (to - from);
      const Eigen::RowVectorXd values =
          bspline::basisDerivatives(degree, knots, span, t, order).row(order);
      products += gauss.weights[k] * (to - from) * values.transpose() * values;
    }
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; j <= degree; ++j)
        entries.emplace_back(span - degree + i, span - degree + j, products(i, j));
  }
  Eigen::SparseMatrix<double> result(count, count);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Poles derivativeGradient(int degree, const std::vector<double>& knots, int order,
                         const Poles& poles) {
  const PoleDifferences differences(degree, knots, order);
  const std::vector<double> inner(knots.begin() + order, knots.end() - order);
  return differences.transposed(derivativeProducts(degree - order, inner, 0) *
                                differences.derivative(poles));
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

}  // namespace seamwright
