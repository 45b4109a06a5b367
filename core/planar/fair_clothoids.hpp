// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <seamwright/core/planar/biarc_spline.hpp>
#include <seamwright/core/planar/clothoid.hpp>
#include <seamwright/core/planar/point_corners.hpp>
#include <seamwright/core/progress.hpp>

/// Fairing of the curve through points: the clothoids are judged, not the points.
namespace seamwright {

/// The shape of a chain of clothoids.
struct ClothoidFigures {
  double length_mm = 0;
  double energy_per_mm = 0;      ///< integral of the squared curvature by arc length
  double variation_per_mm3 = 0;  ///< integral of the squared derivative of the curvature
  /// Local extrema of the curvature and changes of its sign. Differences below a billionth of the
  /// largest curvature, or of one over the length, do not count.
  int extrema = 0, inflections = 0;
};

/// The figures of clothoids that join G2. In closed form.
///   (1) They agree with those of a dense sample.
ClothoidFigures figuresOf(const std::vector<Clothoid>& chain, bool closed = false);

/// A G2 spline of clothoids between corners, through points that were moved to make it fair.
struct FairedClothoids {
  PlanarPoints points;
  std::vector<Clothoid> pieces;       ///< one for each segment of the polygon
  std::vector<Eigen::Index> corners;  ///< points where the curve has no common tangent
  /// Of the spline through the given points, if there is one, and of the result. Runs between
  /// corners are summed up: a corner is no extremum and no inflection.
  std::optional<ClothoidFigures> before;
  ClothoidFigures after;
  /// Inflections of the points that fairPoints() finds: those that are no errors.
  int point_inflections = 0;
  double moved_mm = 0;  ///< the largest distance of a point from where it was
  int steps = 0;
};

struct ClothoidFairingOptions {
  bool closed = false;
  /// Points in whose middle the curve is cut; these stay.
  std::vector<Eigen::Index> corners = {};
  /// Whether the first and the last point of an open curve stay. An end with an error that stays
  /// makes a hook: the curve bends within its last pieces to reach it.
  bool ends_fixed = true;
};

/// The spline of clothoids with the least variation of the curvature that moves of the points
/// within the tolerances allow, each point along the normal of the chord of its neighbours. Where
/// the circles through three points of fairPoints() turn to one side, so does the spline, if the
/// tolerances allow it. Fewer inflections and extrema may cost up to twice the least variation.
/// Parts of the tolerances, down to a twentieth, are tried as well: the search can miss the fairest
/// curve where points may move by about their distances. Pieces at ends and corners are arcs
/// (ClothoidEnd::arc). Each step linearises the curvatures, exactly. Identities (each has a test of
/// its number):
///   (2) No point moves by more than its tolerance, and a tolerance of 0 fixes a point bitwise.
///   (3) Neither variation nor inflections grow. Points of a circle stay.
///   (4) Corners stay bitwise, and the curve has one there. So do ends that are fixed.
///   (5) Free ends move across the curve like other points, each by itself: ends that coincide may
///       part. Fewer points are held, so the variation is in general smaller.
/// \param tolerances_mm one for each point; at least 0 and finite.
/// \param progress called once for each step.
/// \throws as fairPoints() and clothoidSpline() do; Cancelled; std::invalid_argument for corners
/// that are not ascending or not inside. Source: docs/theory/planar.md P10.5.
FairedClothoids fairClothoids(const PlanarPoints& points, const Eigen::VectorXd& tolerances_mm,
                              const ClothoidFairingOptions& options = {},
                              const Progress& progress = {});

}  // namespace seamwright
