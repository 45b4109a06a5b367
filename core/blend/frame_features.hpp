// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include <seamwright/core/blend/match_pieces.hpp>
#include <seamwright/core/blend/spline_places.hpp>

/// Features of a frame and their matching; not a public header.
namespace seamwright::match {

/// Rise and Fall are joints at which the curvature jumps.
enum class FeatureKind { Corner, Rise, Fall, Maximum, Minimum };

struct Feature {
  FeatureKind kind = FeatureKind::Corner;
  Place place;
  double share = 0;  ///< of the length
  /// Of a corner: from the middle of the frame, in units of its radius (extentOf()).
  Eigen::Vector3d from_middle = Eigen::Vector3d::Zero();
  /// Of a corner of a closed frame: 1 if it turns the way round of the frame, -1 if the other way;
  /// 0 unless that is known.
  int side = 0;
  /// Of a corner: about what it turns, the product of its tangents.
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
};

struct Features {
  std::vector<Feature> all;        ///< by their place
  std::optional<Feature> closing;  ///< the joint that closes a frame
  int unknown_pieces = 0;
};

struct FeatureOptions {
  double corner_rad = 0;  ///< joints that turn by more are corners
  double prominence = 0;  ///< share of the range of the curvature by which extrema stand out,
                          ///< and by which jumps are jumps
};

/// Corners, and between them the jumps and the extrema of the curvature, in pieces and at joints.
/// An extremum that is a plateau, as the curvature of an arc, is in the middle of it. \param planar
/// take the signed curvature. \pre then the frame lies in z = 0.
Features featuresOf(const Measured& frame, bool planar, const FeatureOptions& options);

/// Whether it is a corner or a jump of the curvature.
bool isSharp(const Feature& feature);

/// The corners and jumps, with the joint that closes a frame as the first one.
std::vector<Feature> sharpFeatures(const Features& features);

/// Whether two features are of one kind; two corners also if they turn to the same side, or, where
/// that is not known, about directions that differ by less than a right angle.
bool areAlike(const Feature& a, const Feature& b);

/// Whether equally many features are alike in their order.
bool areAlike(const std::vector<Feature>& a, const std::vector<Feature>& b);

/// What it costs that two features correspond; infinite if they cannot. Source:
/// docs/theory/curves.md C12.2.
double pairCost(const Feature& a, const Feature& b, double reach);

/// The least cost of features in order. Source:
/// docs/theory/curves.md C12.2.
double matchingCost(const std::vector<Feature>& a, const std::vector<Feature>& b, double reach);

/// Pairs of indices in order that cost least. Source:
/// docs/theory/curves.md C12.2.
std::vector<std::pair<int, int>> matchedFeatures(const std::vector<Feature>& a,
                                                 const std::vector<Feature>& b, double reach);

/// Pairs of indices in order: all corners if they are alike, between them all jumps if these are,
/// whatever their places; the others at least cost, by their places between those. Source:
/// docs/theory/curves.md C12.2.
std::vector<std::pair<int, int>> correspondingFeatures(const std::vector<Feature>& a,
                                                       const std::vector<Feature>& b, double reach);

}  // namespace seamwright::match
