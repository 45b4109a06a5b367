// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/angle.hpp>
#include <seamwright/core/planar/biarc_spline.hpp>

namespace seamwright {

struct PointCornerOptions {
  bool closed = false;
  /// Smooth curves are sampled with smaller turns, except at a nose that few points show.
  double corner_rad = 60 * radians_per_degree;
  /// By how much points may be off.
  double error_mm = 0;
};

/// Points at which a sampled curve has a corner. There the polygon turns by more than the corner
/// angle, and five times as much as at the nearest points before and after it that turn by less;
/// eight times if fewer than five points lie on each of its sides up to the next corner.
/// With errors the turns are those between points that are four errors away, so that errors make no
/// corner. If all points turn by more, none is a corner: they are few points of a smooth curve.
/// Ends of open curves do not count. Identities (each has a test of its number):
///   (1) Points of a smooth curve have no corner if the polygon turns by at most the corner angle
///       at each of them.
///   (2) The sharp end of an outline is one corner, a blunt one is two.
///   (3) Rigid motion, scaling and reversal keep the corners.
/// \returns their indices, ascending. \throws std::invalid_argument for fewer than 3 points, and
/// for equal neighbours.
std::vector<Eigen::Index> pointCorners(const PlanarPoints& points,
                                       const PointCornerOptions& options = {});

/// The points of each run from corner to corner, by index, with both ends. A closed curve with
/// corners begins at the first one; one without is a single run, without its first point at the
/// end. \param corners ascending and not the ends of an open curve.
std::vector<std::vector<Eigen::Index>> runsBetween(Eigen::Index points,
                                                   const std::vector<Eigen::Index>& corners,
                                                   bool closed);

}  // namespace seamwright
