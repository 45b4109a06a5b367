// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <limits>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/fill/fill_fairing.hpp>
#include <seamwright/core/linear/dense.hpp>

namespace seamwright::fill {

namespace {

/// Binomial weights of a difference of that order.
Eigen::RowVectorXd differenceWeights(int order) {
  Eigen::RowVectorXd weights = bernstein::binomials(order).transpose();
  for (int i = order - 1; i >= 0; i -= 2) weights(i) *= -1;
  return weights;
}

/// One row for each difference of poles, in both directions.
template <class Values>
Values differences(const FillSpace& space, const Values& poles, int order) {
  const Eigen::RowVectorXd weights = differenceWeights(order);
  const int last = space.degree - order;
  Values result = Values::Zero(2 * space.patches * (last + 1) * (space.degree + 1), poles.cols());
  Eigen::Index row = 0;
  for (int k = 0; k < space.patches; ++k)
    for (int i = 0; i <= last; ++i)
      for (int j = 0; j <= space.degree; ++j, row += 2)
        for (int d = 0; d <= order; ++d) {
          result.row(row) += weights(d) * poles.row(space.row(k, i + d, j));
          result.row(row + 1) += weights(d) * poles.row(space.row(k, j, i + d));
        }
  return result;
}

/// unknowns = basis * rest + offset, where rest excludes the tangents of the spokes if they are
/// prescribed.
struct Substitution {
  Eigen::MatrixXd basis;
  Poles offset;
};

Substitution substitution(const FillSpace& space, std::optional<double> spoke_scale) {
  const Eigen::Index count = space.coefficients.cols();
  if (!spoke_scale) return {Eigen::MatrixXd::Identity(count, count), Poles::Zero(count, 3)};
  Substitution result{Eigen::MatrixXd::Zero(count, count - 2), Poles::Zero(count, 3)};
  // The first of the two unknowns that span the tangents of the spokes.
  const Eigen::Index tangents = *space.centre + 1;
  result.basis.topLeftCorner(tangents, tangents).setIdentity();
  result.basis.bottomRightCorner(count - tangents - 2, count - tangents - 2).setIdentity();
  // The centre has no influence on the tangents, because the cosines, and the sines, add up to
  // zero.
  for (int k = 0; k < space.patches; ++k) {
    const double angle = 2 * std::numbers::pi * k / space.patches,
                 weight = 2 * *spoke_scale / space.patches;
    result.offset.row(tangents) += weight * std::cos(angle) * space.middles.row(k);
    result.offset.row(tangents + 1) += weight * std::sin(angle) * space.middles.row(k);
  }
  return result;
}

}  // namespace

Eigen::MatrixXd differencesOf(const FillSpace& space, const Eigen::MatrixXd& poles, int order) {
  return differences<Eigen::MatrixXd>(space, poles, order);
}

Fairest fairest(const FillSpace& space, int order, std::optional<double> spoke_scale) {
  const Substitution rest = substitution(space, spoke_scale);
  const Poles offset = space.coefficients * rest.offset + space.constants;
  const Eigen::MatrixXd coefficients = space.coefficients * rest.basis;
  const Eigen::MatrixXd matrix = differences<Eigen::MatrixXd>(space, coefficients, order);
  const Poles fixed = differences<Poles>(space, offset, order);
  Poles solution = linear::LeastSquares(matrix).solve(-fixed);
  const double rounding =
      16 * std::numeric_limits<double>::epsilon() * static_cast<double>(matrix.rows());
  const Eigen::MatrixXd idle = linear::nullSpace(matrix, rounding);
  if (idle.cols() > 0) {
    const Poles poles = coefficients * solution + offset;
    solution +=
        idle * linear::LeastSquares(differences<Eigen::MatrixXd>(space, coefficients * idle, 2))
                   .solve(-differences<Poles>(space, poles, 2));
  }
  return {rest.basis * solution + rest.offset, (matrix * solution + fixed).squaredNorm()};
}

}  // namespace seamwright::fill
