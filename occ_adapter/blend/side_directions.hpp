// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include <seamwright/occ_adapter/fill/side_path.hpp>

/// Directions in which a surface leaves a side. Not a public header.
namespace seamwright::occ {

/// The directions, into space, in which the boundary of a face goes on at the begin and the end of
/// a side: against the edges that end there. Nothing for a closed side, and where no single edge
/// ends.
using LateralDirections = std::array<std::optional<Eigen::Vector3d>, 2>;

LateralDirections lateralDirections(const HoleSide& side, bool closed);

/// A smooth field of directions along a side. Right angles to the side jump in their derivatives
/// where the curvature of the side does; means of them don't. At the ends of an open side the field
/// has the lateral directions, as far as these are within 45 degrees of the right angle; beyond
/// that it returns to the right angle, which it has at 90 degrees. It has given ones as they are.
class SideDirections {
 public:
  /// \param given take the place of the lateral ones.
  SideDirections(const SidePath& path, bool closed, const LateralDirections& lateral,
                 const LateralDirections& given = {});

  /// The unit vector at a share of the path, in the tangent plane of the sample, out of the face.
  Eigen::Vector3d at(double share, const SideSample& sample) const;

 private:
  bool isNearRightAngles(const SidePath& path) const;
  Eigen::Vector3d mean(double share) const;

  bool closed_;
  Eigen::MatrixXd right_angles_;         ///< by rows, at equal shares
  std::array<Eigen::Vector3d, 2> turn_;  ///< at the ends: lateral direction minus right angle
};

}  // namespace seamwright::occ
