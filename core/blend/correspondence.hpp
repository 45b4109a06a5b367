// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/blend/match_pieces.hpp>
#include <seamwright/core/blend/spline_places.hpp>

/// Which places of frames correspond; not a public header.
namespace seamwright::match {

/// A place that is the same in all frames.
struct Anchor {
  std::vector<Place> places;   ///< one for each frame
  std::vector<double> shares;  ///< likewise
  MatchedKind kind = MatchedKind::Given;
  /// The speeds along the frames may jump here: at a corner, and where the curvature jumps in all
  /// frames, with one tangent; at given places, too.
  bool may_kink = false;
};

struct Correspondence {
  std::vector<Measured> frames;  ///< in their directions, from their starts
  std::vector<Anchor> anchors;   ///< increasing
  /// Where closed frames begin, if that is given or a feature of the same kind in all of them.
  std::optional<Anchor> start;
};

/// A share of the length by which starts and extrema are moved to joints in any case, so that no
/// joint has to be that near to another. A turn of a circle by it moves no circle between by a
/// billionth of the radius.
constexpr double same_place = 1e-5;

/// \param near_share places within that share of the length of a joint are at the joint.
/// \throws as matchPieces().
Correspondence corresponding(const std::vector<BezierSpline>& frames, const MatchOptions& options,
                             double near_share, MatchSummary& summary);

/// \throws FrameFault for a piece without length, with the index of the frame.
Measured measured(const BezierSpline& frame, std::size_t index);

/// The common places of anchors, with those of both ends, and in each frame.
struct Scale {
  std::vector<double> common;
  std::vector<std::vector<double>> of_frame;
};

Scale scaleOf(const std::vector<Anchor>& anchors, std::size_t frames);

}  // namespace seamwright::match
