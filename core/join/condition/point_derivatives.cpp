// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <seamwright/core/join/condition/point_derivatives.hpp>

namespace seamwright {

namespace {

using rows::derivative;
using rows::Field;
using rows::Sum;
using rows::times;

Field<3> space(const HomogeneousPoles& part) {
  return part.leftCols<3>();
}
Eigen::VectorXd weight(const HomogeneousPoles& part) {
  return rows::trimmed(part.col(3));
}

/// The derivatives of a side by s (first index) and t (second index), up to a total order of 3.
template <class Value>
using ByOrders = std::array<std::array<Value, 4>, 4>;

ByOrders<HomogeneousPoles> homogeneousDerivatives(const Ribbon& ribbon) {
  ByOrders<HomogeneousPoles> h;
  for (std::size_t i = 0; i < 4; ++i) {
    h[i][0] = *ribbon.parts()[i];
    for (std::size_t j = 1; i + j < 4; ++j) h[i][j] = derivative<4>(h[i][j - 1]);
  }
  return h;
}

/// w^(i+j+1) X_ij of the points X, by the quotient rule for w X: from w^(i+j) (w X)_ij the products
/// of lower derivatives of X with those of w are subtracted.
ByOrders<Field<3>> pointDerivatives(const ByOrders<HomogeneousPoles>& h) {
  const Eigen::VectorXd w = weight(h[0][0]), one = Eigen::VectorXd::Ones(1);
  const std::array powers = {one, w, times(w, w), times(w, times(w, w))};
  ByOrders<Field<3>> x;
  for (std::size_t order = 0; order < 4; ++order)
    for (std::size_t j = 0; j <= order; ++j) {
      const std::size_t i = order - j;
      Sum<3> sum;
      sum.add(powers[order], space(h[i][j]));
      for (std::size_t a = 0; a <= i; ++a)
        for (std::size_t b = 0; b <= j; ++b) {
          if (a + b == order) continue;
          const double count = bernstein::binomials(static_cast<int>(i))(a) *
                               bernstein::binomials(static_cast<int>(j))(b);
          sum.add(-count * times(powers[order - a - b - 1], weight(h[i - a][j - b])), x[a][b]);
        }
      x[i][j] = sum.total();
    }
  return x;
}

}  // namespace

PointDerivatives pointDerivativesOf(const Ribbon& ribbon, double rounding) {
  const ByOrders<Field<3>> x = pointDerivatives(homogeneousDerivatives(ribbon));
  const double weights = ribbon.position.col(3).maxCoeff();
  const double m = std::max(ribbon.degree_across, 1), n = std::max(ribbon.degree(), 1);
  const double unit = 16 * rounding * std::max(1.0, std::pow(weights, 3));
  const auto rounded = [&](int i, int j) {
    const double differences = std::pow(m, i) * std::pow(n, j) * (i + j < 2 ? 1 : 4 * (i + j - 1));
    return RoundedField<3>{x[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)],
                           unit * differences};
  };
  return {.w = weight(ribbon.position),
          .p = rounded(0, 0),
          .s = rounded(1, 0),
          .t = rounded(0, 1),
          .ss = rounded(2, 0),
          .st = rounded(1, 1),
          .tt = rounded(0, 2),
          .sss = rounded(3, 0),
          .sst = rounded(2, 1),
          .stt = rounded(1, 2),
          .ttt = rounded(0, 3)};
}

}  // namespace seamwright
