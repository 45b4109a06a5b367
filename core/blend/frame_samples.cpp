// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <cmath>

#include <seamwright/core/blend/frame_samples.hpp>

namespace seamwright::match {

Poles samplesOf(const Measured& frame, int count) {
  const int steps = frame.spline().closed ? count : count - 1;
  Poles result(count, 3);
  for (int i = 0; i < count; ++i)
    result.row(i) = frame.point(frame.placeAt(static_cast<double>(i) / steps, 1e-3)).transpose();
  return result;
}

std::optional<Eigen::Vector3d> roundOf(const Poles& points) {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    result += points.row(i).transpose().cross(points.row((i + 1) % points.rows()).transpose());
  // A choice: figures of eight say nothing.
  constexpr double least_area = 1e-4;
  if (!(result.norm() > least_area * points.squaredNorm())) return std::nullopt;
  return result;
}

FrameExtent extentOf(const Measured& frame) {
  constexpr int count = 128;  // the middle of an outline of a few dozen features to some 1 %
  const Poles points = samplesOf(frame, count);
  const Eigen::RowVector3d middle = points.colwise().mean();
  const Poles about = points.rowwise() - middle;
  FrameExtent result{middle.transpose(), std::sqrt(about.squaredNorm() / count)};
  if (frame.spline().closed) result.round = roundOf(about);
  return result;
}

}  // namespace seamwright::match
