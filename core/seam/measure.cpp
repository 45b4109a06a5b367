// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <seamwright/core/seam/measure.hpp>

namespace seamwright {

namespace {

/// Mean direction of the seam, not of unit length; nothing if the sides contradict each other.
std::optional<Eigen::Vector3d> seamDirection(const SidePoint& a, const SidePoint& b) {
  // Where a path is nearly stationary its direction is rounding, and the two sides may differ.
  if (a.tangent.dot(b.tangent) <= 0.5 * a.tangent.norm() * b.tangent.norm()) return std::nullopt;
  return a.tangent.normalized() + b.tangent.normalized();
}

/// Whether both faces lie to the same side of their common tangent, by the directions that point
/// into the faces.
/// Source: docs/theory/surfaces.md S1.2.
bool leaveToTheSameSide(const SidePoint& a, const Eigen::Vector3d& normal_a, const SidePoint& b,
                        const Eigen::Vector3d& normal_b, const Eigen::Vector3d& along) {
  const Eigen::Vector3d into_a = (a.face_on_left ? 1 : -1) * normal_a.cross(along);
  const Eigen::Vector3d into_b = (b.face_on_left ? 1 : -1) * normal_b.cross(along);
  return into_a.dot(into_b) > 0;
}

CurvatureDifference curvatureDifference(const SurfaceJet& a, const Eigen::Vector3d& normal_a,
                                        const SurfaceJet& b, const Eigen::Vector3d& normal_b) {
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(normal_b, normal_a).toRotationMatrix();
  const Eigen::Matrix3d tensor_a = curvatureTensor(a, normal_a);
  const Eigen::Matrix3d tensor_b = turn * curvatureTensor(b, normal_b) * turn.transpose();
  const Eigen::Vector3d x = normal_a.unitOrthogonal();
  const auto norm = [&](const Eigen::Matrix3d& tensor) {
    return restrictToPlane(tensor, normal_a, x).spectralNorm();
  };
  return {norm(tensor_b - tensor_a), norm(tensor_a), norm(tensor_b)};
}

/// The change of curvature of each side is odd in the normal N and in the direction N x T. So it
/// does not depend on the sense of the normal.
CurvatureChange changeAcross(const SurfaceJet& a, const Eigen::Vector3d& normal_a,
                             const SurfaceJet& b, const Eigen::Vector3d& normal_b,
                             const Eigen::Vector3d& along) {
  const double change_a = curvatureChange(a, normal_a, normal_a.cross(along).normalized());
  const double change_b = curvatureChange(b, normal_b, normal_b.cross(along).normalized());
  return {std::abs(change_b - change_a), std::abs(change_a), std::abs(change_b)};
}

}  // namespace

PairMeasure measurePair(const SidePoint& a, const SidePoint& b) {
  PairMeasure result;
  if (const double gap = (a.jet.p - b.jet.p).stableNorm(); std::isfinite(gap)) result.gap_mm = gap;
  result.point = a.jet.p;
  result.degenerate_a = degeneracy(a.jet, a.noise);
  result.degenerate_b = degeneracy(b.jet, b.noise);
  const std::optional<Eigen::Vector3d> natural_a = unitNormal(a.jet, a.noise);
  const std::optional<Eigen::Vector3d> natural_b = unitNormal(b.jet, b.noise);
  if (!natural_a || !natural_b) return result;

  result.angle_rad =
      std::atan2(natural_a->cross(*natural_b).norm(), std::abs(natural_a->dot(*natural_b)));
  const std::optional<Eigen::Vector3d> along = seamDirection(a, b);
  result.fold = along && leaveToTheSameSide(a, *natural_a, b, *natural_b, *along);
  const Eigen::Vector3d aligned_b =
      natural_a->dot(*natural_b) < 0 ? Eigen::Vector3d(-*natural_b) : *natural_b;
  const CurvatureDifference curvature = curvatureDifference(a.jet, *natural_a, b.jet, aligned_b);
  const bool finite = std::isfinite(curvature.difference_per_mm + curvature.norm_a_per_mm +
                                    curvature.norm_b_per_mm);
  if (!finite) return result;  // partials of 1e-160 exceed the range of a double
  result.curvature = curvature;
  if (!along || !a.third_order || !b.third_order) return result;
  const CurvatureChange change = changeAcross(a.jet, *natural_a, b.jet, *natural_b, *along);
  if (std::isfinite(change.difference_per_mm2)) result.curvature_change = change;
  return result;
}

double relativeDifference(const CurvatureDifference& curvature, double flat_radius_mm) {
  const double flat = 1 / flat_radius_mm;
  const double larger = std::max(curvature.norm_a_per_mm, curvature.norm_b_per_mm);
  return larger < flat ? 0 : curvature.difference_per_mm / larger;
}

double relativeChange(const CurvatureChange& change, const CurvatureDifference& curvature,
                      double flat_radius_mm) {
  const double norm = std::max(curvature.norm_a_per_mm, curvature.norm_b_per_mm);
  const double largest = std::max(change.change_a_per_mm2, change.change_b_per_mm2);
  if (largest < 100 / (flat_radius_mm * flat_radius_mm)) return 0;
  return change.difference_per_mm2 / std::max(largest, norm * norm);
}

}  // namespace seamwright
