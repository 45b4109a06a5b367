// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/bspline/collocation.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

/// Means of degree neighbouring knots, one for each basis function.
std::vector<double> openAbscissae(int degree, const std::vector<double>& knots) {
  std::vector<double> result;
  for (std::size_t i = 1; i + degree < knots.size(); ++i) {
    const auto from = knots.begin() + static_cast<std::ptrdiff_t>(i);
    result.push_back(std::accumulate(from, from + degree, 0.0) / degree);
  }
  result.back() = knots.back();  // without the rounding of the sum
  return result;
}

/// The same for knots that go on periodically, with the end as a single knot.
std::vector<double> periodicAbscissae(int degree, const std::vector<double>& knots) {
  const std::vector<double> period(knots.begin() + degree, knots.end() - degree - 1);
  const double range = knots.back() - knots.front();
  const auto count = static_cast<int>(period.size());
  std::vector<double> result;
  for (int i = 0; i < count; ++i) {
    double sum = 0;
    for (int k = 0; k < degree; ++k) {
      const int j = i + k - degree / 2, turns = (j + degree * count) / count - degree;
      sum += period[j - turns * count] + turns * range;
    }
    double mean = sum / degree;
    if (mean < knots.front()) mean += range;
    if (mean >= knots.back()) mean -= range;
    result.push_back(mean);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

GrevilleInterpolation::GrevilleInterpolation(int degree, std::vector<double> knots,
                                             SplineClosure closure)
    : degree_(degree), knots_(std::move(knots)), closure_(closure) {
  bspline::requireDegree(degree_, "");
  bspline::requireKnots(degree_, knots_, "");
  parameters_ = closure_ == SplineClosure::Open ? openAbscissae(degree_, knots_)
                                                : periodicAbscissae(degree_, knots_);
}

Eigen::MatrixXd GrevilleInterpolation::poles(const Eigen::MatrixXd& values) const {
  const auto given = static_cast<Eigen::Index>(parameters_.size());
  const auto count = static_cast<Eigen::Index>(knots_.size()) - degree_ - 1;
  if (values.rows() != given)
    refuse(fmt::format("{} values for {} parameters", values.rows(), given));
  std::vector<Eigen::Triplet<double>> entries;
  const auto addRow = [&](Eigen::Index row, double t, int order, double factor) {
    const int span = bspline::spanOf(degree_, knots_, t);
    const Eigen::RowVectorXd basis =
        bspline::basisDerivatives(degree_, knots_, span, t, order).row(order);
    for (int k = 0; k <= degree_; ++k)
      entries.emplace_back(row, span - degree_ + k, factor * basis(k));
  };
  for (Eigen::Index i = 0; i < given; ++i) addRow(i, parameters_[i], 0, 1);
  // Derivatives at the beginning minus those at the end, scaled to the size of values.
  for (int order = 0; given + order < count; ++order) {
    const double scale =
        std::pow((knots_.back() - knots_.front()) / static_cast<double>(given), order);
    addRow(given + order, knots_.front(), order, scale);
    addRow(given + order, knots_.back(), order, -scale);
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, values.cols());
  right.topRows(given) = values;
  // Regular by the theorem of Schoenberg and Whitney: each parameter is inside of the support of
  // its basis function.
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
  return factors.solve(right);
}

}  // namespace seamwright
