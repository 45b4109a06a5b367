// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/planar/biarc_spline.hpp>
#include <seamwright/core/planar/conic.hpp>
#include <seamwright/core/planar/conic_pair.hpp>
#include <seamwright/core/progress.hpp>

namespace seamwright {

/// Conics through points.
struct ConicSpline {
  std::vector<PlanarConic> conics;  ///< two for each curved span, one for each line
  /// Joints that are not G2: the start of conics[i]. The curvature of a conic is nowhere 0, so it
  /// jumps at an inflection and beside a line.
  std::vector<int> g1_joints;
  /// Conics that begin at a corner: lines on both sides, which three points on a line demand.
  std::vector<int> corners;
  bool closed = false;
  /// Points inserted so that no span turns by more than 1.4 rad; inflections do not count.
  int inserted = 0;
};

/// The G2 spline of conics through points that turns as the polygon does. Identities (each has a
/// test of its number):
///   (1) The spline passes through the points. Between neighbouring spans that turn to the same
///       side, position, tangent and curvature are continuous.
///   (2) It changes the side to which it turns as often as the polygon of the points does. The
///       control polygons of the conics turn as the polygon of the points does, so points in convex
///       position give a convex curve.
///   (3) Points of a circle give the circle, those of a line the line.
///   (4) Reversed points, rigid motion and scaling keep the tangents and curvatures at the points.
///       Inside of a span the joint of a pair is the best of a grid, where rounding may decide.
///   (5) Three neighbours on a line, with turns to the same side before and after them, stay on a
///       line: no convex curve passes otherwise.
///   (6) A point at an inflection, up to a thousandth of the chord beside it or rounding, is the
///       inflection: a closed curve that crosses itself there may begin there.
/// The tangents are such that pairs of conics with monotone curvature have one curvature from both
/// sides at each point. Few extrema are an aim, not a promise.
/// \throws std::invalid_argument for fewer than 2 points (closed: 3), numbers that are not finite
/// and neighbours that are equal. Throws std::domain_error if the polygon reverses its direction at
/// a point (with its index). Throws Cancelled.
/// Source: docs/theory/planar.md P7.4, P7.5.
/// \param effort Draft finds the joints inside of spans with less care: for distances, not for
/// results.
ConicSpline conicSpline(const PlanarPoints& points, bool closed = false,
                        const Progress& progress = {}, PairEffort effort = PairEffort::Full);

}  // namespace seamwright
