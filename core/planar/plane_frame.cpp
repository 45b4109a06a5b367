// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <optional>
#include <string>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/plane_frame.hpp>

namespace seamwright {

namespace {

using Eigen::Vector3d;

/// The plane of points that have one coordinate in common, up to a few roundings of the largest.
std::optional<PlaneFrame> coordinatePlane(const Eigen::Ref<const Poles>& points) {
  const double rounding = 8 * machine_epsilon * points.cwiseAbs().maxCoeff();
  const auto isCommon = [&](int axis) {
    return ((points.col(axis).array() - points(0, axis)).abs() <= rounding).all();
  };
  if (isCommon(2)) return PlaneFrame{{0, 0, points(0, 2)}, Vector3d::UnitX(), Vector3d::UnitY()};
  if (isCommon(1)) return PlaneFrame{{0, points(0, 1), 0}, Vector3d::UnitX(), Vector3d::UnitZ()};
  if (isCommon(0)) return PlaneFrame{{points(0, 0), 0, 0}, Vector3d::UnitY(), Vector3d::UnitZ()};
  return std::nullopt;
}

/// Axes across a normal: the first is the coordinate axis that is most across it, projected.
PlaneFrame frameAcross(const Vector3d& origin, const Vector3d& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  const Vector3d unit = Vector3d::Unit(axis);
  const Vector3d x = (unit - unit.dot(normal) * normal).normalized();
  return {.origin = origin, .x = x, .y = normal.cross(x).normalized()};
}

/// The direction in which the points spread least, with its largest component above 0.
Vector3d leastSpread(const Poles& centred) {
  const double size = centred.cwiseAbs().maxCoeff();
  const Poles scaled = size > 0 ? Poles(centred / size) : centred;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scaled.transpose() * scaled);
  const Vector3d direction = solver.eigenvectors().col(0);
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return direction[largest] < 0 ? Vector3d(-direction) : direction;
}

}  // namespace

FittedPlane fitPlane(const Eigen::Ref<const Poles>& points) {
  if (points.rows() == 0) refuse("no points: a plane needs at least one");
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (!points.row(i).allFinite()) refuse("point " + std::to_string(i) + " is not finite");
  const Eigen::RowVector3d centre = points.colwise().mean();
  FittedPlane result;
  const std::optional<PlaneFrame> plane = coordinatePlane(points);
  result.frame =
      plane ? *plane : frameAcross(centre.transpose(), leastSpread(points.rowwise() - centre));
  const Vector3d normal = result.frame.normal();
  result.distance_mm = ((points.rowwise() - result.frame.origin.transpose()) * normal)
                           .cwiseAbs()
                           .maxCoeff(&result.most_distant);
  return result;
}

PlanarPoints coordinatesIn(const PlaneFrame& frame, const Eigen::Ref<const Poles>& points) {
  PlanarPoints result(points.rows(), 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    result.row(i) = frame.coordinates(points.row(i).transpose()).transpose();
  return result;
}

}  // namespace seamwright
