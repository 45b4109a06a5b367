// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <seamwright/core/spline/bezier_spline.hpp>
#include <vector>

/// The variation of the curvature by many samples, with Frenet's formulas.
namespace seamwright::test {

/// (dk/ds)^2 + (k t)^2 with the torsion t, times the speed.
inline double frenetDensity(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& c) {
  const Eigen::Vector3d turn = a.cross(b);
  const double speed = a.norm(), size = turn.norm();
  if (!(size > 0)) return a.cross(c).squaredNorm() / std::pow(speed, 7);
  const double slope =
      turn.dot(a.cross(c)) / (size * std::pow(speed, 4)) - 3 * size * a.dot(b) / std::pow(speed, 6);
  const double twist = turn.dot(c) / (size * std::pow(speed, 3));
  return (slope * slope + twist * twist) * speed;
}

/// The derivative of a polynomial by its coefficients, the constant one first.
inline std::vector<Eigen::Vector3d> derivativeOf(const std::vector<Eigen::Vector3d>& polynomial) {
  std::vector<Eigen::Vector3d> result;
  for (std::size_t i = 1; i < polynomial.size(); ++i)
    result.push_back(static_cast<double>(i) * polynomial[i]);
  return result;
}

inline Eigen::Vector3d valueOf(const std::vector<Eigen::Vector3d>& polynomial, double t) {
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  for (auto it = polynomial.rbegin(); it != polynomial.rend(); ++it) value = value * t + *it;
  return value;
}

/// Of a polynomial segment, by the midpoint rule.
inline double denseVariation(const BezierCurve& segment, int samples) {
  std::vector<Eigen::Vector3d> polynomial;
  Poles differences = segment.poles();
  double binomial = 1;
  for (int k = 0; k <= segment.degree(); ++k) {
    polynomial.push_back(binomial * differences.row(0).transpose());
    binomial *= static_cast<double>(segment.degree() - k) / (k + 1);
    const Eigen::Index last = differences.rows() - 1;
    differences = (differences.bottomRows(last) - differences.topRows(last)).eval();
  }
  const auto first = derivativeOf(polynomial), second = derivativeOf(first),
             third = derivativeOf(second);
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const double t = (i + 0.5) / samples;
    sum += frenetDensity(valueOf(first, t), valueOf(second, t), valueOf(third, t)) / samples;
  }
  return sum;
}

inline double denseVariation(const BezierSpline& spline, int samples_of_segment) {
  double sum = 0;
  for (int i = 0; i < spline.segments(); ++i)
    sum += denseVariation(segment(spline, i), samples_of_segment);
  return sum;
}

}  // namespace seamwright::test
