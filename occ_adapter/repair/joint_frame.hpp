// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include <seamwright/occ_adapter/repair/joint.hpp>

/// Normals, frames and differences of the sides of a sample. Not a public header.
namespace seamwright::occ {

/// An orthonormal frame: the normal, a direction along the seam, and one across it.
struct JointFrame {
  Eigen::Vector3d normal, tangent, cross;
};

/// The present jet of a side: that of the moved surface.
SurfaceJet jetOf(const JointSide& side);

/// Nothing where the surface has no tangent plane.
std::optional<Eigen::Vector3d> normalOf(const JointSide& side, const SurfaceJet& jet);

/// The normal of the side on which the edge slides; nothing if there is none.
std::optional<Eigen::Vector3d> slideNormal(const JointSample& sample);

JointFrame frameOf(const JointSample& sample, const Eigen::Vector3d& normal);

/// Whether the sample is at an end of the joint.
bool isEnd(const JointSample& sample);

/// The differences of two jets of the sides.
Differences differencesOf(const Joint& joint, const JointSample& sample, const SurfaceJet& a,
                          const SurfaceJet& b);

}  // namespace seamwright::occ
