// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/blend/match_pieces.hpp>

/// The starts and directions of frames; not a public header.
namespace seamwright::match {

/// Whether all frames lie in z = 0, so that their curvature has a sign.
bool areFlat(const std::vector<BezierSpline>& frames);

/// The frames in their directions, from their starts. \param near_share a start within that share
/// of the length of a joint is at the joint. \throws FrameFault as measured().
std::vector<BezierSpline> turned(const std::vector<BezierSpline>& frames,
                                 const MatchOptions& options, double near_share,
                                 MatchSummary& summary);

}  // namespace seamwright::match
