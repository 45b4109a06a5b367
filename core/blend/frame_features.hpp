// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <utility>
#include <vector>

#include <seamwright/core/blend/match_pieces.hpp>
#include <seamwright/core/blend/spline_places.hpp>

/// Features of a frame and their matching; not a public header.
namespace seamwright::match {

enum class FeatureKind { Corner, Maximum, Minimum };

struct Feature {
  FeatureKind kind = FeatureKind::Corner;
  Place place;
  double share = 0;  ///< of the length
};

struct Features {
  std::vector<Feature> all;  ///< by their place
  int unknown_pieces = 0;
};

struct FeatureOptions {
  double corner_rad = 0;  ///< joints that turn by more are corners
  double prominence = 0;  ///< share of the range of the curvature by which extrema stand out
};

/// Corners, and the extrema of the curvature between them, in pieces and at joints.
/// \param planar take the signed curvature. \pre then the frame lies in z = 0.
Features featuresOf(const Measured& frame, bool planar, const FeatureOptions& options);

/// Pairs of indices in order that cost least. Source: docs/theory/curves.md C12.2.
std::vector<std::pair<int, int>> matchedFeatures(const std::vector<Feature>& a,
                                                 const std::vector<Feature>& b, double reach);

}  // namespace seamwright::match
