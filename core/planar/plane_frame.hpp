// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/planar/biarc_spline.hpp>

/// Planes of space with coordinates, in which curves of space become planar ones.
namespace seamwright {

/// A plane with an origin and two orthonormal axes. The coordinates of a plane parallel to two
/// coordinate axes are those of space, bitwise.
struct PlaneFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  Eigen::Vector3d y = Eigen::Vector3d::UnitY();

  Eigen::Vector3d normal() const { return x.cross(y); }
  /// Of the foot of the perpendicular from the point to the plane.
  Eigen::Vector2d coordinates(const Eigen::Vector3d& point) const {
    return directionCoordinates(point - origin);
  }
  Eigen::Vector2d directionCoordinates(const Eigen::Vector3d& vector) const {
    return {vector.dot(x), vector.dot(y)};
  }
  Eigen::Vector3d point(const Eigen::Vector2d& coordinates) const {
    return origin + direction(coordinates);
  }
  Eigen::Vector3d direction(const Eigen::Vector2d& coordinates) const {
    return coordinates.x() * x + coordinates.y() * y;
  }
  /// Signed, above 0 on the side of the normal.
  double height_mm(const Eigen::Vector3d& point) const { return (point - origin).dot(normal()); }
};

/// The plane of points, and how far they are from it.
struct FittedPlane {
  PlaneFrame frame;
  double distance_mm = 0;         ///< the largest distance of a point from the plane
  Eigen::Index most_distant = 0;  ///< the point with that distance
};

/// The plane with the least sum of squared distances from the points. Points of one line have many;
/// this is one of them. Identities (each has a test of its number):
///   (1) Points with a common coordinate, up to rounding of the largest one, have a plane with the
///       coordinates of space: z = c has the axes X and Y, y = c the axes X and Z, x = c the axes Y
///       and Z.
///   (2) A rigid motion moves the plane along, except for the choice of its axes.
///   (3) No plane through the centre of the points has a smaller sum of squared distances.
/// \param points #P by 3, at least one row.
/// \throws std::invalid_argument for no points and for numbers that are not finite.
FittedPlane fitPlane(const Eigen::Ref<const Poles>& points);

/// Coordinates of points of space in the plane, #P by 2.
PlanarPoints coordinatesIn(const PlaneFrame& frame, const Eigen::Ref<const Poles>& points);

}  // namespace seamwright
