// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/progress.hpp>

namespace seamwright {

/// A point of the boundary of a hole that is seen along z, with what the surface beyond has there.
struct GraphSample {
  Eigen::Vector2d at;      ///< x and y, mm
  double height_mm = 0;    ///< z
  Eigen::Vector2d slope;   ///< gradient of z
  Eigen::Vector2d across;  ///< unit vector out of the hole
  double bend_per_mm = 0;  ///< second derivative of z along \p across
  double speed_mm = 0;     ///< length of the derivative of the point in space by t
};

/// A part of the boundary over t in [0, 1]; the hole is to the left as seen from above. The parts
/// follow each other.
using GraphBoundary = std::function<GraphSample(double t)>;

struct GraphFillOptions {
  double gap_mm = 0;     ///< accepted distance along the boundary
  double angle_rad = 0;  ///< accepted angle of the normals along the boundary; 0: position only
  int most_poles = 6000;
  /// Accepted curvature jumps weigh so much beside the variation of curvature inside.
  double bend_weight = 10;
};

/// A surface z = f(x, y) over the box of a hole.
struct GraphFill {
  BSplineSurface surface;  ///< of degree 5, C^4; u = x and v = y
  double gap_mm = 0;       ///< largest distance from the boundary, at samples between the fitted
  double angle_rad = 0;    ///< largest angle to the normals there
  /// Where that angle is largest.
  Eigen::Vector3d worst_mm = Eigen::Vector3d::Zero();
};

/// The fairest spline graph that meets the boundary in position and, if angle_rad is above 0, in
/// the tangent planes. Knots are added where the boundary is missed, until both figures are
/// accepted or a further step hardly helps. Any number of parts, kinks and corners of any angle
/// are allowed. A graph is regular and does not meet itself.
///
/// Among the surfaces that meet the boundary it minimises the integral of the squared third
/// derivatives over the hole, which vanishes for quadratic functions.
/// Identities (each has a test of its number):
///   (1) A quadratic function is reproduced, up to rounding.
///   (2) The result does not depend on the sense of x and y, or on which part is the first.
///   (3) At the boundary the spline and its normals are the given ones within the reported
///       figures.
/// \throws std::invalid_argument for fewer than one part, tolerances that are not positive, and
/// samples that are not finite; Cancelled.
/// Source: docs/theory/fills.md F6.1, F6.2.
GraphFill graphFill(const std::vector<GraphBoundary>& boundary, const GraphFillOptions& options,
                    const Progress& progress = {});

/// The angle by which x and y should be turned so that lines of knots can take up what the
/// surroundings disagree about at the joints of the parts: a kink of the slopes, or another mixed
/// derivative at a corner. Lines have to run between the two parts, and the jumps of the second
/// derivatives across them are then least. Nothing if a turn gains little.
/// Source: docs/theory/fills.md F6.2.
std::optional<double> graphTurn_rad(const std::vector<GraphBoundary>& boundary);

}  // namespace seamwright
