// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include <seamwright/core/blend/joint_path.hpp>
#include <seamwright/core/blend/plain_blend.hpp>
#include <seamwright/core/join/curve/beta.hpp>

/// Checks and parts of a joint in a key frame; not a public header.
namespace seamwright::blending {

/// Both curves raised to these degrees at least.
JointFrame raised(const JointFrame& frame, int degree_a, int degree_b);

/// Checks that the homogeneous poles at the joint agree up to rounding. \throws
/// std::invalid_argument that begins with \p name, with the gap or the weights.
void requireMeeting(const JointFrame& frame, const std::string& name);

/// Rows -n..n, the pole of a between them. \pre both degrees are at least n.
HomogeneousPoles polesBeside(const JointFrame& frame, int order);

/// The poles beside the joint with these betas, of which there are n.
JointKey keyOf(const JointFrame& frame, const BetaFit& fit);

}  // namespace seamwright::blending
