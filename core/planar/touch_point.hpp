// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include <seamwright/core/planar/arc.hpp>

/// Circles and lines by a point of theirs. Not a public header.
namespace seamwright {

/// A point of a circle or line with its direction and curvature.
struct TouchPoint {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  double direction_rad = 0, curvature_per_mm = 0;

  Eigen::Vector2d tangent() const { return unitVector(direction_rad); }
  Eigen::Vector2d normal() const;  ///< to the left
  TouchPoint after(double length_mm) const;
  /// How far the circle advances to the point beside another one; below 0: backwards.
  double lengthTo_mm(const Eigen::Vector2d& other) const;
  /// The point of the circle beside another one.
  TouchPoint beside(const Eigen::Vector2d& other) const;
  /// Above 0: the other point is to the left.
  double distance_mm(const Eigen::Vector2d& other) const;
  PlanarArc arc(double length_mm) const;
};

/// At the start of the arc.
TouchPoint touchPointOf(const PlanarArc& arc);

/// How far an arc advances between points of its circle.
double lengthBetween(const TouchPoint& from, const TouchPoint& to);

/// Where two circles, or a circle and a line, touch. \pre they do.
Eigen::Vector2d touchPoint(const TouchPoint& a, const TouchPoint& b);

/// Where two circles or lines cross beside a point; nothing if they do not cross there.
std::optional<Eigen::Vector2d> crossingNear(const TouchPoint& a, const TouchPoint& b,
                                            Eigen::Vector2d point);

}  // namespace seamwright
