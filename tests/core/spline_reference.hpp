// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <seamwright/core/spline/beta_spline.hpp>

#include "splines.hpp"

/// Interpolating splines from the conditions of their joints: dense, in extended precision.
namespace seamwright::test {

using Real = long double;
using RealPoints = Eigen::Matrix<Real, Eigen::Dynamic, 3>;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// X'(-) = bias X'(+), X''(-) = square X''(+) + tension X'(+).
struct JointCondition {
  Real bias = 1, square = 1, tension = 0;
};

/// Segments of these lengths through the points; X'(+) at each, and X'(-) at the last one of an
/// open spline.
struct Conditions {
  RealPoints points;
  std::vector<Real> lengths;
  std::vector<JointCondition> joints;  ///< of each point; a closed spline's first and last are one
  SplineEnds ends = SplineEnds::Natural;
  Real start_nu = 0, end_nu = 0;
  Vec start_derivative = Vec::Zero(), end_derivative = Vec::Zero();
};

/// Second derivatives at a segment's ends are -(4 p + 2 q) / h + 6 s / h and (2 p + 4 q) / h - 6 s
/// / h, with p, q the first ones and s the slope. \param condition that of the equations, whose
/// rows have size 1.
inline RealPoints referenceDerivatives(const Conditions& c, double* condition = nullptr) {
  using Eigen::Index;
  const Index n = c.points.rows() - 1;
  const bool closed = c.ends == SplineEnds::Periodic;
  const auto at = [&](Index i) { return closed ? i % n : i; };
  RealMatrix a = RealMatrix::Zero(n + 1, n + 1);
  RealPoints b = RealPoints::Zero(n + 1, 3);
  const auto leftOf = [&](Index i) { return (i == n && !closed) ? Real(1) : c.joints[i].bias; };
  const auto secondAtStart = [&](Index row, Index segment, Real factor) {
    const Real h = c.lengths[segment];
    a(row, at(segment)) += factor * -4 / h;
    a(row, at(segment + 1)) += factor * -2 / h * leftOf(segment + 1);
    b.row(row) -= factor * 6 / h / h * (c.points.row(segment + 1) - c.points.row(segment));
  };
  const auto secondAtEnd = [&](Index row, Index segment, Real factor) {
    const Real h = c.lengths[segment];
    a(row, at(segment)) += factor * 2 / h;
    a(row, at(segment + 1)) += factor * 4 / h * leftOf(segment + 1);
    b.row(row) += factor * 6 / h / h * (c.points.row(segment + 1) - c.points.row(segment));
  };
  for (Index j = closed ? 0 : 1; j < n; ++j) {
    const JointCondition& joint = c.joints[j == 0 ? n : j];
    secondAtEnd(j, j == 0 ? n - 1 : j - 1, 1);
    secondAtStart(j, j, -joint.square);
    a(j, j) -= joint.tension;
  }
  if (closed) {
    a(n, n) = 1;
  } else if (c.ends == SplineEnds::Clamped) {
    a(0, 0) = a(n, n) = 1;
    b.row(0) = c.start_derivative.transpose().cast<Real>();
    b.row(n) = c.end_derivative.transpose().cast<Real>();
  } else {
    secondAtStart(0, 0, 1);
    a(0, 0) -= c.start_nu;
    secondAtEnd(n, n - 1, 1);
    a(n, n) += c.end_nu;
  }
  // Largest entries first, whatever is left: rows of large tensions, whose unknowns are small, keep
  // their digits.
  Eigen::FullPivLU<RealMatrix> lu(a);
  lu.setThreshold(0);
  RealPoints m = lu.solve(b);
  if (condition) {
    const RealMatrix scaled = a.cwiseAbs().rowwise().maxCoeff().cwiseInverse().asDiagonal() * a;
    *condition =
        static_cast<double>(scaled.cwiseAbs().rowwise().sum().maxCoeff() *
                            scaled.fullPivLu().inverse().cwiseAbs().rowwise().sum().maxCoeff());
  }
  if (closed) m.row(n) = m.row(0);
  return m;
}

inline Conditions conditionsOf(const NuSplineData& data) {
  Conditions c{data.points.cast<Real>(),
               {},
               {},
               data.ends,
               data.nu.front(),
               data.nu.back(),
               data.start_derivative,
               data.end_derivative};
  for (std::size_t i = 0; i < data.knots.size(); ++i) {
    if (i > 0) c.lengths.push_back(static_cast<Real>(data.knots[i]) - data.knots[i - 1]);
    c.joints.push_back({1, 1, -static_cast<Real>(data.nu[i])});
  }
  if (data.ends == SplineEnds::Periodic) c.joints.back().tension -= data.nu.front();
  return c;
}

inline Conditions conditionsOf(const BetaSplineData& data) {
  Conditions c{data.points.cast<Real>(),
               {},
               {},
               data.ends,
               data.start_nu,
               data.end_nu,
               data.start_derivative,
               data.end_derivative};
  c.lengths.assign(data.bias.size() - 1, 1);
  for (std::size_t i = 0; i < data.bias.size(); ++i)
    c.joints.push_back(
        {data.bias[i], static_cast<Real>(data.bias[i]) * data.bias[i], data.tension[i]});
  return c;
}

inline SplineEnds endsOf(const nlohmann::json& name) {
  return name == "periodic"  ? SplineEnds::Periodic
         : name == "clamped" ? SplineEnds::Clamped
                             : SplineEnds::Natural;
}

inline Poles randomPoints(Eigen::Index count, double size, bool closed, std::mt19937_64& random) {
  Poles points(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) points.row(i) = size * randomVector(random).transpose();
  if (closed) points.row(count - 1) = points.row(0);
  return points;
}

constexpr SplineEnds all_ends[] = {SplineEnds::Natural, SplineEnds::Clamped, SplineEnds::Periodic};

/// X, X', X'' at an end of a cubic segment from its poles by hand, by the segment's parameter.
struct EndDerivatives {
  Vec first, second;
};
inline EndDerivatives startOf(const BezierSpline& spline, Eigen::Index segment) {
  const auto p = [&](Eigen::Index k) { return Vec(spline.poles.row(3 * segment + k).head<3>()); };
  return {3 * (p(1) - p(0)), 6 * (p(0) - 2 * p(1) + p(2))};
}
inline EndDerivatives endOf(const BezierSpline& spline, Eigen::Index segment) {
  const auto p = [&](Eigen::Index k) { return Vec(spline.poles.row(3 * segment + k).head<3>()); };
  return {3 * (p(3) - p(2)), 6 * (p(1) - 2 * p(2) + p(3))};
}

inline std::string complaint(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return std::string("invalid: ") + error.what();
  } catch (const std::domain_error& error) {
    return std::string("domain: ") + error.what();
  }
  return "accepted";
}

}  // namespace seamwright::test
