// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <fstream>
#include <random>
#include <seamwright/core/seam/curve_joint.hpp>
#include <seamwright/core/spline/alpha_curve.hpp>
#include <seamwright/core/spline/alpha_surface.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "curves.hpp"
#include "joins.hpp"

/// Random alpha-curves, and what their equations say of a joint.
namespace seamwright::test {

inline std::vector<nlohmann::json> casesOf(const std::string& name) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/" + name);
  const nlohmann::json data = nlohmann::json::parse(file);
  return {data["cases"].begin(), data["cases"].end()};
}

inline AlphaCurve randomAlphaCurve(std::mt19937_64& random, double size = 1) {
  AlphaCurve curve;
  for (int i = 0; i < 4; ++i)
    curve.poles.row(i) = size * (randomVector(random) + Vec(i, 0, 0)).transpose();
  curve.a = uniform(0.1, 1, random);
  return curve;
}

/// Derivatives by the common parameter, of a segment of that length.
inline CurveDerivatives byCommon(const BezierCurve& curve, double t, double length, int order) {
  CurveDerivatives x = curve.derivatives(t, order);
  for (int k = 1; k <= order; ++k) x.row(k) /= std::pow(length, k);
  return x;
}

/// What the equations of G^order leave, by the largest term of each: R' = b1 R', R'' = b1^2 R'' +
/// b2 R' and R''' = b1^3 R''' + 3 b1 b2 R'' + b3 R'.
inline double misfit(const CurveDerivatives& x, const CurveDerivatives& y, const Vec& b) {
  double worst = (y.row(0) - x.row(0)).norm();
  const auto add = [&](int k, const Eigen::RowVector3d& wanted) {
    worst = std::max(worst, (y.row(k) - wanted).norm() / std::max(1.0, y.row(k).norm()));
  };
  if (y.rows() > 1) add(1, b(0) * x.row(1));
  if (y.rows() > 2) add(2, b(0) * b(0) * x.row(2) + b(1) * x.row(1));
  if (y.rows() > 3)
    add(3, std::pow(b(0), 3) * x.row(3) + 3 * b(0) * b(1) * x.row(2) + b(2) * x.row(1));
  return worst;
}

/// The betas with which a G2 joint of alpha-curves is G3, of beta1 and the lengths.
inline Vec thirdOrderBetas(double beta1, double h, double k) {
  return {beta1, -2 * beta1 * (beta1 / h + 1 / k), 12 * beta1 * beta1 / h * (beta1 / h + 1 / k)};
}

template <class Call>
std::string complaint(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing was refused";
}

/// How often the signs of numbers change, zeros left out.
inline int signChanges(const Eigen::VectorXd& values) {
  int changes = 0;
  double last = 0;
  for (const double value : values) {
    if (value == 0) continue;
    changes += last * value < 0;
    last = value;
  }
  return changes;
}

inline AlphaSurface randomSurface(std::mt19937_64& random) {
  AlphaSurface surface;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      surface.poles.row(4 * i + j) =
          Eigen::RowVector3d(3 * i, 3 * j, 0) + randomVector(random).transpose();
  surface.a_u = uniform(0.2, 1, random);
  surface.a_v = uniform(0.2, 1, random);
  return surface;
}

/// Rows 3 .. 3 - order with X_0 + X_3 = X_1 + X_2.
inline void balance(AlphaSurface& surface, int order) {
  for (int i = 3; i >= 3 - order; --i)
    surface.poles.row(4 * i + 3) =
        surface.poles.row(4 * i + 1) + surface.poles.row(4 * i + 2) - surface.poles.row(4 * i);
}

}  // namespace seamwright::test
