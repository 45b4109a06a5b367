// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/planar/touch_point.hpp>

/// Not a public header.
namespace seamwright {

/// Neighbouring points that are near one line or circle.
struct PointPiece {
  int first = 0, last = 0;  ///< beyond the last point of a closed sequence the first one follows
  TouchPoint circle;        ///< beside the middle one, in their order
  double off_line_mm = 0;   ///< the largest distance of the points from the line nearest to them

  int count() const { return last - first + 1; }
  bool isLine() const { return circle.curvature_per_mm == 0; }
};

struct PointPieceOptions {
  bool closed = false;
  double noise_mm = 0;  ///< the points of a piece are no further from its line or circle
  double line_mm = 0;   ///< so near to a line, a piece is one
  int fewer_than = 0;
};

/// Few pieces into which points are divided. Each of them ends where the points become nearer to
/// the next one, so a closed sequence has much the same pieces from whichever point it begins.
/// Empty if they are not so few.
std::vector<PointPiece> pointPieces(const std::vector<Eigen::Vector2d>& points,
                                    const PointPieceOptions& options);

}  // namespace seamwright
