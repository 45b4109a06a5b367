// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/blend/joint_path.hpp>

/// Blends of joints whose tangents turn far; not a public header.
/// Source: docs/theory/curves.md C11.7.
namespace seamwright::blending {

/// The turn that takes the tangent direction of one joint to that of another.
struct Turn {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double angle_rad = 0;  ///< 0..pi
};

/// About the common normal of both tangents. Opposite tangents have many; then it is the normal of
/// the plane through the joint nearest to the poles beside it and the far ends, its sense chosen
/// such that the tangent half turned points along the mean of the chords from far end to far end.
Turn turnBetween(const JointKey& first, const JointKey& second);

/// Half of both joints, each turned about its own pole by half the angle: tangents are parallel.
HomogeneousPoles halfTurned(const JointKey& first, const JointKey& second);

/// Linear blend of the edges' lengths and of the turning vectors from edge to edge, outwards from
/// the joint: the vector along the axis of the turn from one edge to the next, as long as the
/// angle. Points at the joint and weights are blended linearly. The tangents turn at a constant
/// rate. In a plane these are the lengths and turning angles of the polygon.
HomogeneousPoles intrinsicPoles(const JointKey& first, const JointKey& second, double share);

}  // namespace seamwright::blending
