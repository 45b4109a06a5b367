// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/spline/bezier_spline.hpp>

/// Rational curves whose weights are matrices: poles draw the curve to a point, and to the line
/// through it along a tangent.
namespace seamwright {

/// The conversion into a rational curve loses as many digits as this number has.
inline constexpr double max_stiffness = 1e8;

struct MatrixPole {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = Eigen::Vector3d::Zero();  ///< of any length; 0 if the stiffness is 0
  double weight = 1;                                  ///< w, above 0
  double stiffness = 0;                               ///< m, 0 to max_stiffness

  /// w (I + m (I - T T')) with the unit tangent T.
  Eigen::Matrix3d matrix() const;

  bool operator==(const MatrixPole& other) const = default;
};

/// A matrix-weighted B-spline curve Q(t) = (sum of M_i N_i(t))^-1 (sum of M_i P_i N_i(t)), where
/// M_i = matrix() of pole i. Knots are flat and clamped as in BSplineCurve. Q(t) is the point X
/// that makes the sum of N_i w_i (|X - P_i|^2 + m_i (distance from the tangent line i)^2) least.
struct MatrixCurve {
  int degree = 0;
  std::vector<double> knots;
  std::vector<MatrixPole> poles;

  bool operator==(const MatrixCurve& other) const = default;
};

/// \throws std::invalid_argument, with the index and the value, as requireValid(BSplineCurve) does,
/// for a weight that is not positive, a stiffness out of range, and a tangent that is 0 or not
/// finite although the stiffness is above 0.
void requireValid(const MatrixCurve& curve);

/// The point and the derivative by the parameter, 2 by 3. Identities (each has a test of its
/// number):
///   (1) With stiffness 0 it is the rational B-spline curve of the weights.
///   (2) The point is the least of the sum above: its gradient is 0.
///   (3) Points on a line with tangents along it give points of the line. Rigid motion and scaling
///       move the curve along; a common factor of the weights does not change it.
/// \throws std::invalid_argument as requireValid() does, and for a parameter that is not finite.
/// Source: docs/theory/planar.md P13.1; [Yang2016].
CurveDerivatives pointAndTangent(const MatrixCurve& curve, double t);

/// The same curve as rational Bézier segments of degree 3 n, or 2 n if points and tangents have z =
/// 0.
///   (4) Points of equal parameters are equal up to rounding, and all weights are positive.
/// \throws std::invalid_argument as requireValid() does, and if the degree exceeds 25. Throws
/// std::domain_error if rounding makes a weight negative: weights that differ by many orders of
/// magnitude. Source: docs/theory/planar.md P13.2.
BezierSpline bezierSpline(const MatrixCurve& curve);

/// The same curve as a rational B-spline. Its derivatives are continuous up to the order that the
/// knots of all poles have: degree less the largest multiplicity of an inner knot.
/// \throws as bezierSpline() and bsplineCurve(BezierSpline) do.
/// Source: docs/theory/planar.md P13.2.
BSplineCurve bsplineCurve(const MatrixCurve& curve);

}  // namespace seamwright
