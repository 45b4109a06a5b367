// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <seamwright/core/bezier/graded_derivatives.hpp>
#include <seamwright/core/differential/arc_length.hpp>
#include <seamwright/core/seam/curve_joint.hpp>

namespace seamwright {

namespace {

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

void requirePoint(const CurveEnd& end) {
  if (end.derivatives.rows() == 0)
    throw std::invalid_argument("an end without derivatives: at least the point is needed");
}

/// The end in a parameter that keeps the digits of curves with uneven weights. The figures do not
/// depend on the parameter.
CurveEnd curveEnd(const BezierCurve& curve, double t, int order) {
  OwnDerivatives own = ownDerivatives(curve.homogeneousPoles(), t, order);
  own.derivatives.row(0) = curve.point(t).transpose();
  return {std::move(own.derivatives), own.speed_noise};
}

}  // namespace

CurveJoint measureJoint(const CurveEnd& a, const CurveEnd& b) {
  requirePoint(a);
  requirePoint(b);
  CurveJoint joint;
  const double gap = (b.derivatives.row(0) - a.derivatives.row(0)).stableNorm();
  if (std::isfinite(gap)) joint.gap_mm = gap;
  const Eigen::Index count = std::min(a.derivatives.rows(), b.derivatives.rows());
  const auto arc_a = arcLengthDerivatives(a.derivatives.topRows(count), a.speed_noise);
  const auto arc_b = arcLengthDerivatives(b.derivatives.topRows(count), b.speed_noise);
  if (!arc_a || !arc_b) return joint;
  if (count > 1) joint.angle_rad = angleBetween(arc_a->row(1), arc_b->row(1));
  for (Eigen::Index k = 0; k < count; ++k) {
    joint.differences.push_back((arc_b->row(k) - arc_a->row(k)).stableNorm());
    joint.sizes.push_back(std::max(arc_a->row(k).stableNorm(), arc_b->row(k).stableNorm()));
  }
  return joint;
}

CurveJoint measureJoint(const BezierCurve& a, const BezierCurve& b, int order) {
  if (order < 0)
    throw std::invalid_argument("order " + std::to_string(order) + ": it must not be negative");
  return measureJoint(curveEnd(a, 1, order), curveEnd(b, 0, order));
}

double relativeDifference(const CurveJoint& joint, int k, double flat_radius_mm) {
  if (joint.sizes[k] < std::pow(100 / flat_radius_mm, k - 2) / flat_radius_mm) return 0;
  double scale = 0;
  for (int j = 2; j <= k; ++j) scale = std::max(scale, std::pow(joint.sizes[j], 1.0 / (j - 1)));
  return joint.differences[k] / std::pow(scale, k - 1);
}

int orderReached(const CurveJoint& joint, const ContinuityTolerance& tolerance) {
  tolerance.validate();
  if (!joint.gap_mm || *joint.gap_mm > tolerance.gap_mm) return -1;
  if (!joint.angle_rad || *joint.angle_rad > tolerance.angle_rad) return 0;
  int order = 1;
  while (order + 1 < static_cast<int>(joint.differences.size()) &&
         relativeDifference(joint, order + 1, tolerance.flat_radius_mm) <= tolerance.curvature_rel)
    ++order;
  return order;
}

}  // namespace seamwright
