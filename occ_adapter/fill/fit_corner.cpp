// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <seamwright/occ_adapter/fill/fit_corner.hpp>

namespace seamwright::occ {

using Eigen::Vector3d;

namespace {

/// The normal of the face, oriented so that the hole is to the left of the side as seen from above.
Vector3d upward(const SideSample& sample) {
  return sample.beyond.cross(sample.derivative).normalized();
}

}  // namespace

double angleToPlane(const Vector3d& direction, const Vector3d& normal) {
  return std::asin(std::min(1.0, std::abs(direction.normalized().dot(normal))));
}

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

Vector3d derivativeAt(const SideFitEnd& end, const SideSample& sample) {
  // A choice: speeds that agree so far count as one, so that both sides get the same derivative.
  constexpr double nearly = 1e-5;
  if (!end.direction) return sample.derivative;
  const double own_mm = sample.derivative.norm();
  return (std::abs(own_mm - end.speed_mm) <= nearly * own_mm ? end.speed_mm : own_mm) *
         *end.direction;
}

FitCorner smoothCorner(const SideSample& in, const SideSample& out) {
  const Vector3d along = (in.derivative.normalized() + out.derivative.normalized()).normalized();
  const double speed_mm = (in.derivative.norm() + out.derivative.norm()) / 2;
  const SideFitEnd end{(in.point + out.point) / 2, along, speed_mm};
  return {end, end, (in.beyond + out.beyond).cross(along).normalized()};
}

FitCorner sharpCorner(const SideSample& in, const SideSample& out,
                      const std::array<double, 2>& most_turn_rad) {
  const SideFitEnd own{(in.point + out.point) / 2, std::nullopt, 0};
  const Vector3d mean = (upward(in) + upward(out)).normalized();
  if (angleToPlane(in.derivative, mean) > most_turn_rad[0] ||
      angleToPlane(out.derivative, mean) > most_turn_rad[1])
    return {own, own, in.derivative.cross(out.derivative).normalized()};
  const auto turned = [&](const SideSample& sample) {
    return SideFitEnd{own.point,
                      (sample.derivative - sample.derivative.dot(mean) * mean).normalized(), 0};
  };
  return {turned(in), turned(out), mean};
}

}  // namespace seamwright::occ
