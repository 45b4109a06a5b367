// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/match/side_piece.hpp>
#include <seamwright/occ_adapter/match/zone.hpp>

/// Moves poles of a surface so that points of it meet targets. Not a public header.
namespace seamwright::occ {

/// A point of the surface and what it has to meet.
struct Station {
  Eigen::Vector2d uv;
  Eigen::Vector2d step;  ///< of the parameters, across the side into the face, about a row of poles
  MatchTarget target;
  int order = 1;
};

/// Two points of a surface that meets itself, or both sides of a knot line. They have to move
/// alike, with their derivatives up to the order, and those of the other one are \p ratio times as
/// long.
struct ClosingPoints {
  Eigen::Vector2d uv, other_uv;
  int direction = 0;  ///< across the line: 0: u
  double into = 1;    ///< the sense of the parameter across from the line at uv
  double ratio = 1;
  int order = 1;
};

/// Both sides of the knot lines at which a surface is less smooth than the order though its
/// derivatives are continuous there, and of the line along which it closes.
/// \param order 1 or 2
std::vector<ClosingPoints> closingPoints(const Geom_BSplineSurface& surface, int order);

struct PoleMoves {
  opencascade::handle<Geom_BSplineSurface> after;
  double largest_mm = 0;  ///< of a pole, so that no point moves further
};

/// Moves the poles of the zone with the least bending of the moves: the least sum of squared second
/// differences, in mm, over neighbouring poles. Conditions of a station: X = point, n . X_s = 0 for
/// its step s, n . X_ss = II(X_s, X_s). Conditions are met to rounding if they can be, otherwise in
/// the sense of least squares; solutions are repeated, since the last one is not linear. Poles of a
/// side that is one point stay one point. Weights stay.
/// Source: docs/theory/surfaces.md S5.6.
PoleMoves movedPoles(const Zone& zone, const std::vector<Station>& stations,
                     const std::vector<ClosingPoints>& closing);

}  // namespace seamwright::occ
