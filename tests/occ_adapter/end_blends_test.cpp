// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <seamwright/occ_adapter/repair/end_blends.hpp>

namespace seamwright::test {
namespace {

using occ::Blends;
using occ::blendsAt;
using Function = double Blends::*;

constexpr std::array<Function, 5> functions = {&Blends::value, &Blends::slope, &Blends::bend,
                                               &Blends::brief_value, &Blends::brief_slope};

double at(Function function, double distance, double span) {
  return blendsAt(distance, span).*function;
}

/// Cox and de Boor, word for word.
double basis(const std::vector<double>& knots, int i, int degree, double x) {
  if (degree == 0) return knots[i] <= x && x < knots[i + 1] ? 1 : 0;
  const auto share = [&](int k, double part) {
    const double width = knots[k + degree] - knots[k];
    return width == 0 ? 0 : part / width * basis(knots, k, degree - 1, x);
  };
  return share(i, x - knots[i]) + share(i + 1, knots[i + degree + 1] - x);
}

/// Of the polynomial of degree 5 over the first span.
Eigen::Vector<double, 6> coefficients(Function function, double span) {
  Eigen::Matrix<double, 6, 6> powers;
  Eigen::Vector<double, 6> values;
  for (int k = 0; k < 6; ++k) {
    const double x = k / 6.0;
    for (int m = 0; m < 6; ++m) powers(k, m) = std::pow(x, m);
    values[k] = at(function, x * span, span);
  }
  Eigen::Vector<double, 6> of_shares = powers.fullPivLu().solve(values);
  for (int m = 0; m < 6; ++m) of_shares[m] /= std::pow(span, m);
  return of_shares;
}

TEST(EndBlends, OneConditionEachAtTheEnd) {
  for (const double span : {0.04, 1.0, 7.0}) {
    const std::array<Eigen::Vector3d, 5> taylor = {
        Eigen::Vector3d(1, 0, 0), {0, 1, 0}, {0, 0, 0.5}, {1, 0, 0}, {0, 1, 0}};
    for (std::size_t f = 0; f < functions.size(); ++f) {
      const auto found = coefficients(functions[f], span);
      const int known = f < 3 ? 3 : 2;
      for (int m = 0; m < known; ++m)
        EXPECT_NEAR(found[m] * std::pow(span, m), taylor[f][m] * std::pow(span, m),
                    1e-10 * std::max(1.0, span * span))
            << "function " << f << " power " << m;
    }
  }
}

TEST(EndBlends, AreSumsOfTheFirstSplines) {
  const std::vector<double> knots = {0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4, 4, 4};
  for (std::size_t f = 0; f < functions.size(); ++f) {
    const int count = f < 3 ? 3 : 2;
    const auto row = [&](double x) {
      Eigen::Vector3d splines = Eigen::Vector3d::Zero();
      for (int i = 0; i < count; ++i) splines[i] = basis(knots, i, 5, x);
      return splines;
    };
    Eigen::MatrixXd rows(count, count);
    Eigen::VectorXd values(count);
    for (int k = 0; k < count; ++k) {
      const double x = 0.3 + 0.4 * k;
      rows.row(k) = row(x).head(count).transpose();
      values[k] = at(functions[f], x, 1);
    }
    const Eigen::VectorXd factors = rows.fullPivLu().solve(values);
    for (double x = 0; x < 4; x += 0.07)
      EXPECT_NEAR(at(functions[f], x, 1), row(x).head(count).dot(factors), 1e-12)
          << "function " << f << " at " << x;
  }
}

TEST(EndBlends, EndAfterThreeSpansTheBriefOnesAfterTwo) {
  for (const double span : {0.1, 3.0}) {
    for (std::size_t f = 0; f < functions.size(); ++f) {
      const double end = (f < 3 ? 3 : 2) * span;
      EXPECT_NE(at(functions[f], end - 0.2 * span, span), 0);
      for (const double beyond : {0.0, 0.1 * span, 10 * span})
        EXPECT_EQ(at(functions[f], end + beyond, span), 0);
    }
  }
}

TEST(EndBlends, DerivativesAreThose) {
  constexpr double h = 1e-5;
  const std::array<Function, 3> derivatives = {&Blends::d_value, &Blends::d_slope, &Blends::d_bend};
  for (const double span : {0.5, 2.0})
    for (double x = 0.05; x < 3.5; x += 0.11)
      for (std::size_t f = 0; f < derivatives.size(); ++f)
        EXPECT_NEAR(at(derivatives[f], x * span, span),
                    (at(functions[f], x * span + h, span) - at(functions[f], x * span - h, span)) / (2 * h),
                    1e-7)
            << "function " << f << " at " << x;
}

}  // namespace
}  // namespace seamwright::test
