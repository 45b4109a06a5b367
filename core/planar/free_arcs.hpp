// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include <seamwright/core/numeric.hpp>

/// How few arcs of any kind are near points. Not a public header.
namespace seamwright {

/// The circle or line with the least largest distance from four points.
struct FourPointCircle {
  double distance_mm = 0;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< of the line; 0 for a circle
  /// Of the circle, or of the line from the origin along its normal.
  double radius_mm = 0;
};

/// Identity (it has a test of its number):
///   (1) No circle and no line has a smaller largest distance from the four points.
/// Source: docs/theory/planar.md P9.4.
FourPointCircle circleOfFour(const std::array<Eigen::Vector2d, 4>& points);

/// The last point of each arc if the points are divided into arcs from the first one on, each as
/// long as possible: an arc ends where the next point certainly is too much, because four of the
/// points are further from every circle and line than the tolerance.
///   (2) Chains of arcs, whether they touch or not, that are within the tolerance of the points in
///       their order have at least so many arcs.
std::vector<int> freeArcEnds(const std::vector<Eigen::Vector2d>& points, double tolerance_mm);

/// Curvatures of arcs from a given start that are within a tolerance of points.
struct CurvatureRange {
  double lower = -infinite, upper = infinite;
  bool isEmpty() const { return !(lower <= upper); }
};

/// A point from the start of an arc, along its tangent and to its left.
struct LocalPoint {
  double along = 0, left = 0;
};

LocalPoint localPoint(const Eigen::Vector2d& point, const Eigen::Vector2d& start,
                      const Eigen::Vector2d& tangent);

/// The curvatures with which the circle is within the tolerance of the point.
/// Source: docs/theory/planar.md P9.5.
CurvatureRange curvaturesNear(const LocalPoint& point, double tolerance_mm);

/// The start of an arc.
struct ArcStart {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  double direction_rad = 0;
};

/// The point next to another one on a circle or line near points in order, with the direction
/// there: the circle of four of them that are furthest from it.
ArcStart nearestCircle(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& beside);

/// How many of the points, from the first one on, can be within the tolerance of one arc from this
/// start. Certainly no arc is within the tolerance of more.
int pointsBeside(const std::vector<Eigen::Vector2d>& points, const ArcStart& start,
                 double tolerance_mm);

}  // namespace seamwright
