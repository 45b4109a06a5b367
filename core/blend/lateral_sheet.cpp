// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include <seamwright/core/blend/lateral_sheet.hpp>
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/bspline/collocation.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

bool isUnit(const std::vector<double>& knots) {
  return knots.front() == 0 && knots.back() == 1;
}

/// The poles along of a polynomial of u.
template <typename Polynomial>
Eigen::VectorXd polesAlong(const BSplineSurface& sheet, const Polynomial& polynomial) {
  const GrevilleInterpolation interpolation(sheet.degree_u, sheet.knots_u);
  Eigen::MatrixXd values(sheet.countU(), 1);
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    values(i, 0) = polynomial(interpolation.parameters()[i]);
  return interpolation.poles(values);
}

template <typename Polynomial>
BSplineSurface withProduct(const BSplineSurface& sheet, const Eigen::MatrixXd& displacement,
                           int degree, const Polynomial& polynomial) {
  if (!isUnit(sheet.knots_u) || !isUnit(sheet.knots_v))
    refuse("the parameters of the sheet are not 0 to 1");
  if (sheet.degree_u < degree)
    refuse(fmt::format("the degree along is {}: at least {} is needed", sheet.degree_u, degree));
  if (displacement.rows() != sheet.countV() || displacement.cols() != 3)
    refuse(fmt::format("the displacement is {} by {}: {} by 3 is needed", displacement.rows(),
                       displacement.cols(), sheet.countV()));
  const Eigen::VectorXd along = polesAlong(sheet, polynomial);
  BSplineSurface result = sheet;
  for (Eigen::Index i = 0; i < along.size(); ++i)
    result.poles.middleRows(i * sheet.countV(), sheet.countV()).leftCols<3>() +=
        along(i) * displacement;
  return result;
}

}  // namespace

ZeroEndInterpolation::ZeroEndInterpolation(int degree, std::vector<double> knots, int zeros_first,
                                           int zeros_last)
    : degree_(degree),
      knots_(std::move(knots)),
      zeros_first_(zeros_first),
      zeros_last_(zeros_last) {
  const std::vector<double> all = GrevilleInterpolation(degree_, knots_).parameters();
  const int count = static_cast<int>(all.size());
  if (zeros_first < 0 || zeros_last < 0 || zeros_first + zeros_last >= count)
    refuse(fmt::format("{} and {} of {} poles are zero: no pole is left", zeros_first, zeros_last,
                       count));
  parameters_.assign(all.begin() + zeros_first, all.end() - zeros_last);
}

Eigen::MatrixXd ZeroEndInterpolation::poles(const Eigen::MatrixXd& values) const {
  const auto given = static_cast<Eigen::Index>(parameters_.size());
  if (values.rows() != given)
    refuse(fmt::format("{} values for {} parameters", values.rows(), given));
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(given, given);
  for (Eigen::Index i = 0; i < given; ++i) {
    const int span = bspline::spanOf(degree_, knots_, parameters_[i]);
    const Eigen::RowVectorXd basis =
        bspline::basisDerivatives(degree_, knots_, span, parameters_[i], 0).row(0);
    for (int k = 0; k <= degree_; ++k) {
      const Eigen::Index column = span - degree_ + k - zeros_first_;
      if (column >= 0 && column < given) matrix(i, column) = basis(k);
    }
  }
  // A principal minor of the matrix of Greville interpolation, so regular by the theorem of
  // Schoenberg and Whitney too.
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(given + zeros_first_ + zeros_last_, values.cols());
  result.middleRows(zeros_first_, given) = matrix.partialPivLu().solve(values);
  return result;
}

BSplineSurface withKnotsAcross(const BSplineSurface& sheet, int degree,
                               const std::vector<double>& knots) {
  if (degree < sheet.degree_v)
    refuse(fmt::format("the degree across is {}, that of the sheet {}", degree, sheet.degree_v));
  bspline::requireKnots(degree, knots, "_v");
  BSplineSurface result = sheet;
  while (result.degree_v < degree) result = elevated(result, SurfaceDirection::V);
  return withKnots(result, SurfaceDirection::V,
                   {knots.begin() + degree + 1, knots.end() - degree - 1});
}

BSplineSurface displacedBoundary(const BSplineSurface& sheet, LateralSide side,
                                 const Eigen::MatrixXd& displacement) {
  constexpr int degree = 3;
  return withProduct(sheet, displacement, degree, [&](double u) {
    return std::pow(side == LateralSide::First ? 1 - u : u, degree);
  });
}

BSplineSurface turnedBoundary(const BSplineSurface& sheet, LateralSide side,
                              const Eigen::MatrixXd& displacement) {
  constexpr int degree = 4;
  return withProduct(sheet, displacement, degree, [&](double u) {
    return side == LateralSide::First ? u * std::pow(1 - u, 3) : (u - 1) * std::pow(u, 3);
  });
}

BSplineSurface bentBoundary(const BSplineSurface& sheet, LateralSide side,
                            const Eigen::MatrixXd& displacement) {
  constexpr int degree = 5;
  return withProduct(sheet, displacement, degree, [&](double u) {
    const double from = side == LateralSide::First ? u : 1 - u;
    return 0.5 * from * from * std::pow(1 - from, 3);
  });
}

}  // namespace seamwright
