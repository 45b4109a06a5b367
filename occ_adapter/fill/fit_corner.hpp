// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include <seamwright/occ_adapter/fill/side_path.hpp>

/// Corners at which fitted sides meet. Not a public header.
namespace seamwright::occ {

/// The begin or end of a side, shared with the next side.
struct SideFitEnd {
  Eigen::Vector3d point;
  std::optional<Eigen::Vector3d> direction;  ///< unit; nothing: the side's own direction
  double speed_mm = 0;                       ///< mean speed of both sides; 0: the side's own speed
};

/// The derivative of a side at its end. Nearly equal speeds of both sides are made equal, because
/// the equations of a ring are ill-conditioned if they differ slightly.
Eigen::Vector3d derivativeAt(const SideFitEnd& end, const SideSample& sample);

/// The end of one side and the begin of the next, in one tangent plane.
struct FitCorner {
  SideFitEnd end, begin;
  Eigen::Vector3d normal;
};

/// A corner at which both sides have one direction.
FitCorner smoothCorner(const SideSample& in, const SideSample& out);

/// A corner with an angle. Its plane is halfway between those of both faces if each side can be
/// turned into it by at most \p most_turn_rad. Otherwise the directions of the sides span it.
FitCorner sharpCorner(const SideSample& in, const SideSample& out,
                      const std::array<double, 2>& most_turn_rad);

/// Angle between a direction and the plane with this unit normal.
double angleToPlane(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal);

/// Angle between planes with these unit normals.
double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace seamwright::occ
