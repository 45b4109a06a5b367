// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/bernstein/polynomial.hpp>
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/fair/matrix_curve.hpp>
#include <seamwright/core/fair/matrix_point.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

bool inPlane(const MatrixCurve& curve) {
  return std::all_of(curve.poles.begin(), curve.poles.end(), [](const MatrixPole& pole) {
    return pole.point.z() == 0 && (pole.stiffness == 0 || pole.tangent.z() == 0);
  });
}

/// Three functions of the parameter as Bézier segments.
BezierSpline segmentsOf(const MatrixCurve& curve, const Poles& values) {
  BSplineCurve spline{curve.degree, curve.knots, HomogeneousPoles(values.rows(), 4)};
  spline.poles << values, Eigen::VectorXd::Ones(values.rows());
  return bezierSpline(spline);
}

/// The sums of M_i N_i and of M_i (P_i - origin) N_i on one segment.
struct MatrixSegment {
  BernsteinPolynomial xx, xy, xz, yy, yz, zz, x, y, z;
};

/// The homogeneous poles about the origin.
HomogeneousPoles homogeneousSegment(const MatrixSegment& s, bool in_plane) {
  const auto joined = [](const BernsteinPolynomial& x, const BernsteinPolynomial& y,
                         const BernsteinPolynomial& z, const BernsteinPolynomial& w) {
    HomogeneousPoles poles(w.degree() + 1, 4);
    poles << x.coefficients(), y.coefficients(), z.coefficients(), w.coefficients();
    return poles;
  };
  const BernsteinPolynomial minor = s.xx * s.yy - s.xy * s.xy;
  if (in_plane) {
    const BernsteinPolynomial zero(Eigen::VectorXd::Zero(minor.degree() + 1));
    return joined(s.yy * s.x - s.xy * s.y, s.xx * s.y - s.xy * s.x, zero, minor);
  }
  const BernsteinPolynomial a = s.yy * s.zz - s.yz * s.yz, b = s.xz * s.yz - s.xy * s.zz,
                            c = s.xy * s.yz - s.xz * s.yy, d = s.xx * s.zz - s.xz * s.xz,
                            e = s.xy * s.xz - s.xx * s.yz;
  return joined(a * s.x + b * s.y + c * s.z, b * s.x + d * s.y + e * s.z,
                c * s.x + e * s.y + minor * s.z, s.xx * a + s.xy * b + s.xz * c);
}

void requirePositiveWeights(const HomogeneousPoles& poles) {
  for (Index i = 0; i < poles.rows(); ++i)
    if (!(poles(i, 3) > 0))
      throw std::domain_error(
          fmt::format("weight {} of the rational curve is {}: rounding hides that it is positive; "
                      "the weights or stiffnesses differ too much",
                      i, poles(i, 3)));
}

}  // namespace

Eigen::Matrix3d MatrixPole::matrix() const {
  if (stiffness == 0) return weight * Eigen::Matrix3d::Identity();
  const Eigen::Vector3d unit = tangent.normalized();
  return weight *
         ((1 + stiffness) * Eigen::Matrix3d::Identity() - stiffness * unit * unit.transpose());
}

void requireValid(const MatrixCurve& curve) {
  BSplineCurve plain{curve.degree, curve.knots,
                     HomogeneousPoles(static_cast<Index>(curve.poles.size()), 4)};
  for (std::size_t i = 0; i < curve.poles.size(); ++i) {
    const MatrixPole& pole = curve.poles[i];
    plain.poles.row(static_cast<Index>(i)) << pole.point.transpose(), pole.weight;
    if (!(pole.stiffness >= 0 && pole.stiffness <= max_stiffness))
      refuse(fmt::format("the stiffness of pole {} is {}: it must be in [0, {}]", i, pole.stiffness,
                         max_stiffness));
    const double length = pole.tangent.stableNorm();
    if (pole.stiffness > 0 && !(length > 0 && length < infinite))
      refuse(fmt::format("pole {} has a stiffness and the tangent ({}, {}, {})", i,
                         pole.tangent.x(), pole.tangent.y(), pole.tangent.z()));
  }
  requireValid(plain);
}

CurveDerivatives pointAndTangent(const MatrixCurve& curve, double t) {
  requireValid(curve);
  if (!std::isfinite(t)) refuse(fmt::format("the parameter is {}", t));
  return pointAndTangentOfValid(curve, t);
}

CurveDerivatives pointAndTangentOfValid(const MatrixCurve& curve, double t) {
  const int span = bspline::spanOf(curve.degree, curve.knots, t);
  const Eigen::MatrixXd basis = bspline::basisDerivatives(curve.degree, curve.knots, span, t, 1);
  // Points are taken from one of them, so that large coordinates do not cancel.
  const Eigen::Vector3d origin = curve.poles[span - curve.degree].point;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero(), matrix_slope = matrix;
  Eigen::Vector3d vector = Eigen::Vector3d::Zero(), vector_slope = vector;
  for (int i = 0; i <= curve.degree; ++i) {
    const MatrixPole& pole = curve.poles[span - curve.degree + i];
    const Eigen::Matrix3d m = pole.matrix();
    const Eigen::Vector3d v = m * (pole.point - origin);
    matrix += basis(0, i) * m;
    vector += basis(0, i) * v;
    matrix_slope += basis(1, i) * m;
    vector_slope += basis(1, i) * v;
  }
  const Eigen::LDLT<Eigen::Matrix3d> factor(matrix);
  const Eigen::Vector3d point = factor.solve(vector);
  CurveDerivatives result(2, 3);
  result.row(0) = (origin + point).transpose();
  result.row(1) = factor.solve(vector_slope - matrix_slope * point).transpose();
  return result;
}

BezierSpline bezierSpline(const MatrixCurve& curve) {
  requireValid(curve);
  const bool in_plane = inPlane(curve);
  const int degree = curve.degree * (in_plane ? 2 : 3);
  if (degree > max_spline_degree)
    refuse(fmt::format("the rational curve would have the degree {}: at most {} is possible",
                       degree, max_spline_degree));
  const Index count = static_cast<Index>(curve.poles.size());
  Poles first(count, 3), second(count, 3), third(count, 3);
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double largest = 0;
  for (const MatrixPole& pole : curve.poles) {
    origin += pole.point / static_cast<double>(count);
    largest = std::max(largest, pole.weight * (1 + pole.stiffness));
  }
  if (in_plane) origin.z() = 0;
  for (Index i = 0; i < count; ++i) {
    const Eigen::Matrix3d m = curve.poles[i].matrix() / largest;
    first.row(i) << m(0, 0), m(0, 1), m(0, 2);
    second.row(i) << m(1, 1), m(1, 2), m(2, 2);
    third.row(i) = (m * (curve.poles[i].point - origin)).transpose();
  }
  const BezierSpline a = segmentsOf(curve, first), b = segmentsOf(curve, second),
                     c = segmentsOf(curve, third);
  BezierSpline result{.degree = degree, .knots = a.knots, .poles = {}};
  result.poles.resize(static_cast<Index>(a.segments()) * degree + 1, 4);
  for (int k = 0; k < a.segments(); ++k) {
    const auto function = [&](const BezierSpline& spline, int column) {
      return BernsteinPolynomial(Eigen::VectorXd(spline.poles.col(column).segment(
          static_cast<Index>(k) * curve.degree, curve.degree + 1)));
    };
    HomogeneousPoles poles = homogeneousSegment({.xx = function(a, 0),
                                                 .xy = function(a, 1),
                                                 .xz = function(a, 2),
                                                 .yy = function(b, 0),
                                                 .yz = function(b, 1),
                                                 .zz = function(b, 2),
                                                 .x = function(c, 0),
                                                 .y = function(c, 1),
                                                 .z = function(c, 2)},
                                                in_plane);
    requirePositiveWeights(poles);
    poles.leftCols<3>() += poles.col(3) * origin.transpose();
    result.poles.middleRows(static_cast<Index>(k) * degree, degree + 1) = poles;
  }
  return result;
}

BSplineCurve bsplineCurve(const MatrixCurve& curve) {
  const BezierSpline segments = bezierSpline(curve);
  int largest = 0, multiplicity = 0;
  for (std::size_t i = 1; i < curve.knots.size(); ++i) {
    multiplicity = curve.knots[i] == curve.knots[i - 1] ? multiplicity + 1 : 1;
    if (curve.knots[i] > curve.knots.front() && curve.knots[i] < curve.knots.back())
      largest = std::max(largest, multiplicity);
  }
  return bsplineCurve(segments, curve.degree - std::max(largest, 1));
}

}  // namespace seamwright
