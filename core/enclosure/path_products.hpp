// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

#include <seamwright/core/enclosure/spline.hpp>
#include <seamwright/core/enclosure/terms.hpp>
#include <seamwright/core/numeric.hpp>

/// Sums of a polynomial's terms along a path, and the jets that follow from them. Not a public
/// header.
/// Source: docs/theory/enclosures.md E2.4.
namespace seamwright {

/// The homogeneous coordinates of a rational spline; the last one is the weight.
using HomogeneousModel = std::array<ChebyshevModel, 4>;

/// The number of nets of a jet of that order: p; u, v; uu, uv, vv; uuu, uuv, uvv, vvv.
constexpr int netCount(int order) {
  return (order + 1) * (order + 2) / 2;
}
/// How often each of them is derived by u and by v.
constexpr std::array<std::array<int, 2>, 10> net_orders = {
    {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}}};

/// The polynomials T_0(x), ..., T_degree(x).
std::vector<ChebyshevModel> chebyshevPolynomials(const ChebyshevModel& x, int degree);

/// The jet of a spline whose homogeneous coordinates have the derivatives h.
/// \param up_to_tangents the second derivatives leave out multiples of the first.
JetModel jetFrom(const std::array<HomogeneousModel, 10>& h, bool rational, int order,
                 bool up_to_tangents);

/// The products of Chebyshev polynomials along a path, column by column, with the radius and the
/// largest value of each. They are stored without allocation.
struct PathProducts {
  static constexpr int most = (max_spline_degree + 1) * (max_spline_degree + 1);
  using Terms = Eigen::Array<double, ChebyshevModel::size, 1>;

  PathProducts(const std::vector<ChebyshevModel>& tx, const std::vector<ChebyshevModel>& ty);

  /// Largest factor of the error of a coefficient.
  double outside() const { return std::max(1.0, off.row(1).maxCoeff()); }

  /// The sum of the products times the coefficients, which are known up to \p error together.
  ChebyshevModel sum(const Eigen::Ref<const Eigen::MatrixXd>& coefficients, double error) const;

  Eigen::Array<double, ChebyshevModel::size, Eigen::Dynamic, Eigen::ColMajor, ChebyshevModel::size,
               most>
      series;
  Eigen::Array<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, most> off;
  Eigen::Index count_x = 0;  ///< columns follow each other along x
  int degree = 0;
};

}  // namespace seamwright
