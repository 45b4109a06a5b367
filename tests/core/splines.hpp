// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <seamwright/core/spline/bezier_spline.hpp>

#include "curves.hpp"

/// Random B-spline curves and what tests of splines share.
namespace seamwright::test {

inline std::vector<nlohmann::json> splineCases(const std::string& name) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/" + name);
  const nlohmann::json data = nlohmann::json::parse(file);
  return {data["cases"].begin(), data["cases"].end()};
}

inline std::vector<double> numbers(const nlohmann::json& values) {
  std::vector<double> result;
  for (const nlohmann::json& value : values) result.push_back(number(value));
  return result;
}

inline Poles points(const nlohmann::json& values) {
  Poles result(static_cast<Eigen::Index>(values.size()), 3);
  for (Eigen::Index i = 0; i < result.rows(); ++i) result.row(i) = vector(values[i]).transpose();
  return result;
}

inline HomogeneousPoles homogeneous(const Poles& poles) {
  HomogeneousPoles result(poles.rows(), 4);
  result << poles, Eigen::VectorXd::Ones(poles.rows());
  return result;
}

inline HomogeneousPoles randomPoles(Eigen::Index count, bool rational, std::mt19937_64& random) {
  HomogeneousPoles result(count, 4);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double w = rational ? logUniform(random, -0.3, 0.3) : 1;
    result.row(i) << w * (static_cast<double>(i) + randomVector(random).x()),
        w * randomVector(random).y(), w * randomVector(random).z(), w;
  }
  return result;
}

/// Increasing knots from a random beginning. \param spread of the decimal logarithm of the spans.
inline std::vector<double> randomBreaks(int spans, double spread, std::mt19937_64& random) {
  std::vector<double> result = {randomVector(random).x()};
  for (int i = 0; i < spans; ++i)
    result.push_back(result.back() + logUniform(random, -spread, spread));
  return result;
}

/// Clamped flat knots. \param multiplicity of the inner ones.
inline std::vector<double> flatKnots(int degree, const std::vector<double>& breaks,
                                     int multiplicity) {
  std::vector<double> result(degree + 1, breaks.front());
  for (std::size_t i = 1; i + 1 < breaks.size(); ++i)
    result.insert(result.end(), multiplicity, breaks[i]);
  result.insert(result.end(), degree + 1, breaks.back());
  return result;
}

inline BSplineCurve randomCurve(int degree, int multiplicity, int spans, bool rational,
                                std::mt19937_64& random) {
  BSplineCurve result{
      degree, flatKnots(degree, randomBreaks(spans, 0.4, random), multiplicity), {}};
  result.poles = randomPoles(result.count(), rational, random);
  return result;
}

/// The distance of rows in units of the largest entry of that order, \p b being the true ones.
inline double relativeError(const CurveDerivatives& a, const CurveDerivatives& b, int k) {
  return (a.row(k) - b.row(k)).norm() / std::max(1e-300, b.row(k).norm());
}

template <class Error = std::invalid_argument, class Action>
void expectRefused(Action action, const std::string& part) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_THAT(std::string(error.what()), testing::HasSubstr(part));
    return;
  }
  ADD_FAILURE() << "not refused: " << part;
}

}  // namespace seamwright::test
