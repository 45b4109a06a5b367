// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include <seamwright/core/planar/biarc.hpp>
#include <seamwright/core/planar/conic.hpp>

namespace seamwright {

/// What a fair pair of conics has to meet: points, directions and curvatures of a C-shape.
struct ConicPairEnds {
  HermiteEnds ends;
  double start_curvature_per_mm = 0;  ///< with the sign of the turn
  double end_curvature_per_mm = 0;
};

/// Two conics that join G2, and the extrema of the curvature inside of the pair.
struct ConicPair {
  std::array<PlanarConic, 2> conics;
  int extrema = 0;
};

/// How many tangents are tried.
enum class PairEffort { Draft, Full };

/// Of the pairs that twoConics() gives for 483 tangents at the joint (for 49 others if none of
/// these cuts both edges, as with angles that differ by 120 times), one with the fewest extrema of
/// the curvature; of these, the one whose curvature is nearest to linear by length. Identities
/// (each has a test of its number):
///   (1) The pair has the points, directions and curvatures given, and joins G2. Its control
///       polygon is convex, so it has no inflection.
///   (2) Ends with the curvature of one circle give this circle.
///   (3) With the curvatures of pairCurvature_per_mm() and a turn of at most 1.4 rad, and angles
///   that
///       differ by at most the factor 10, the curvature is monotone.
///   (4) Mirrored, reversed, moved and scaled ends give the mirrored, reversed, moved and scaled
///       pair.
/// \throws std::invalid_argument as chordAngles() and twoConics() do; std::domain_error for ends
/// that are no C-shape or turn by pi or more.
/// Source: docs/theory/planar.md P7.1, P7.4.
/// \param effort Draft tries 23 of the tangents: for distances, not for results.
ConicPair fairConics(const ConicPairEnds& ends, PairEffort effort = PairEffort::Full);

/// The size of the curvature at an end of a C-shape with the chord \p chord_mm: the circle through
/// both points with the tangent there has this curvature if both angles are equal. The end with the
/// larger angle has the larger curvature, as that of a spiral has to.
/// Source: docs/theory/planar.md P7.4.
struct PairAngles {
  double chord_mm = 0;
  double own_rad = 0;    ///< of the tangent at the end against the chord, in (0, pi)
  double other_rad = 0;  ///< at the other end
};
double pairCurvature_per_mm(const PairAngles& angles);

/// The power of the ratio of the sines in pairCurvature_per_mm().
inline constexpr double pair_power = 1.1;

/// Turns up to this one have pairs of monotone curvature.
inline constexpr double most_pair_turn_rad = 1.4;

}  // namespace seamwright
