// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/blend/match_pieces.hpp>
#include <seamwright/core/blend/spline_places.hpp>

/// Which places of frames correspond; not a public header.
namespace seamwright::match {

/// A place that is the same in all frames.
struct Anchor {
  std::vector<Place> places;   ///< one for each frame
  std::vector<double> shares;  ///< likewise
};

struct Correspondence {
  std::vector<Measured> frames;  ///< in their directions, from their starts
  std::vector<Anchor> anchors;   ///< increasing
};

/// \throws as matchPieces().
Correspondence corresponding(const std::vector<BezierSpline>& frames, const MatchOptions& options,
                             MatchSummary& summary);

/// The common places of anchors, with those of both ends, and in each frame.
struct Scale {
  std::vector<double> common;
  std::vector<std::vector<double>> of_frame;
};

Scale scaleOf(const std::vector<Anchor>& anchors, std::size_t frames);

}  // namespace seamwright::match
