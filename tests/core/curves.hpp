// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <complex>
#include <nlohmann/json.hpp>
#include <random>
#include <seamwright/core/bezier/curve.hpp>
#include <vector>

#include "surfaces.hpp"

/// Curves in closed form or from data files, written down by hand and not through the library's arc
/// length.
namespace seamwright::test {

inline double number(const nlohmann::json& value) {
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

/// A point or vector of space, or of the plane z = 0.
inline Vec vector(const nlohmann::json& value) {
  return {number(value[0]), number(value[1]), value.size() > 2 ? number(value[2]) : 0};
}

/// \param weights an array or null.
inline BezierCurve bezierCurve(const nlohmann::json& points, const nlohmann::json& weights) {
  Poles poles(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd w = Eigen::VectorXd::Ones(poles.rows());
  for (Eigen::Index i = 0; i < poles.rows(); ++i) {
    poles.row(i) = vector(points[i]).transpose();
    if (!weights.is_null()) w(i) = number(weights[i]);
  }
  return {poles, w};
}

/// Circle about the origin by its angle.
inline CurveDerivatives circle(double r, double angle, int order) {
  CurveDerivatives x(order + 1, 3);
  for (int k = 0; k <= order; ++k) {
    const double turned = angle + k * std::acos(0.0);
    x.row(k) << r * std::cos(turned), r * std::sin(turned), 0;
  }
  return x;
}

/// Clothoid by its arc length at the origin, along +x, of curvature kappa there that changes at a
/// constant rate: T = exp(i phi), T^(k+1) = sum_j C(k,j) (i phi')^(j) T^(k-j) with phi' = kappa +
/// rate s.
inline CurveDerivatives clothoid(double kappa, double rate, int order) {
  std::vector<std::complex<double>> T = {1};
  const std::complex<double> i(0, 1);
  for (int k = 0; k + 2 <= order; ++k)
    T.push_back(i * kappa * T[k] + (k > 0 ? i * rate * static_cast<double>(k) * T[k - 1] : 0));
  CurveDerivatives x = CurveDerivatives::Zero(order + 1, 3);
  for (int k = 1; k <= order; ++k) x.row(k) << T[k - 1].real(), T[k - 1].imag(), 0;
  return x;
}

/// Random derivatives with a speed of about 1.
inline CurveDerivatives randomDerivatives(int order, std::mt19937_64& random) {
  CurveDerivatives x(order + 1, 3);
  for (int k = 0; k <= order; ++k) x.row(k) = randomVector(random).transpose();
  x.row(1) *= logUniform(random, -0.2, 0.2) / x.row(1).norm();
  return x;
}

/// Derivatives t_1..t_n of a random parameter t(u), t_1 > 0; the first entry is not used.
inline Eigen::VectorXd randomParameter(int order, std::mt19937_64& random) {
  Eigen::VectorXd t(order + 1);
  for (int k = 0; k <= order; ++k) t(k) = 0.4 * randomVector(random).x();
  if (order > 0) t(1) = logUniform(random, -0.3, 0.3);
  return t;
}

/// Derivatives of X(t(u)) by u with the partial Bell polynomials (docs/theory/curves.md C2.1):
/// B_kj = sum_i C(k-1, i-1) t_i B_(k-i)(j-1).
inline CurveDerivatives reparametrised(const CurveDerivatives& x, const Eigen::VectorXd& t) {
  const Eigen::Index n = x.rows() - 1;
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(n + 1, n + 1);
  B(0, 0) = 1;
  for (Eigen::Index k = 1; k <= n; ++k)
    for (Eigen::Index j = 1; j <= k; ++j) {
      double binomial = 1;
      for (Eigen::Index i = 1; i <= k - j + 1; ++i) {
        B(k, j) += binomial * t(i) * B(k - i, j - 1);
        binomial *= static_cast<double>(k - i) / static_cast<double>(i);
      }
    }
  return B * x;
}

}  // namespace seamwright::test
