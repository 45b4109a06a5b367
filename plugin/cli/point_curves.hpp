// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/planar/biarc_spline.hpp>
#include <seamwright/core/planar/clothoid_spline.hpp>
#include <seamwright/plugin/cli/curve_methods.hpp>
#include <string>
#include <vector>

/// Curves through points whose ends are not known: they begin and end as an arc, so that points of
/// one arc give this arc.
namespace seamwright::cli {

/// The tangents at open ends are those of the circle through three points. \throws as
/// biarcSpline().
BiarcSpline biarcsOf(const PlanarPoints& points, bool closed);

/// The outer pieces are arcs. \throws as clothoidSpline().
ClothoidSpline clothoidsOf(const PlanarPoints& points, bool closed, const Progress& progress);

/// A point that repeats a neighbour.
struct PointTwin {
  Eigen::Index left_out = 0, kept = 0;
};

/// Points of which one of two neighbours can be left out: they are at most half their tolerance
/// apart, and far nearer to each other than to the next ones. Curves through both would wind.
std::vector<PointTwin> pointTwins(const PlanarPoints& points, const Eigen::VectorXd& tolerances_mm,
                                  bool closed);

/// Names two neighbours that are far nearer to each other than to the next ones; empty if there are
/// none.
std::string crowdedPoints(const GivenCurve& given);

}  // namespace seamwright::cli
