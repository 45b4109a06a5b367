// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <limits>
#include <string>

#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

enum class MatchMoves { First, Second, Both };

struct FaceMatchOptions {
  int order = 1;  ///< 1: G1, 2: G2
  MatchMoves moves = MatchMoves::Second;
  double max_move_mm =
      std::numeric_limits<double>::infinity();  ///< largest_move_mm may not be larger
  bool hold_sides = false;  ///< the two other boundaries that end at the seam stay as they are
  double match_mm = 0.1;    ///< free edges no further apart than this may be the common boundary
  int edge = 0;  ///< of several common ones, from 1, order of TopExp::MapShapes; 0: the longest
  ContinuityTolerance
      tolerance;  ///< what the figures are judged by, and how near a trimmed boundary is met

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

struct MatchReport {
  bool matched = false;
  std::string reason;  ///< why not, or what the user should know; one line with numbers
  TopoDS_Shape
      shape;  ///< the two faces as a shell that shares the seam edge; as given where not matched
  SeamResult before;  ///< faces and edges by their numbers in the model
  SeamResult after;  ///< faces and edges by their numbers in the shape; as before where not matched
  double largest_move_mm =
      0;  ///< of a pole; where weights change too, also of points of the surface, see below
  bool exact = false;  ///< joined in poles, to rounding; false: to the tolerance
};

/// Moves one or both of two faces so that they join G1 or G2 along their common boundary: an edge
/// that both share, or a free edge of each where these are close together over their whole length.
/// The other faces of the model are not looked at.
///
/// A face can move if it lies on a B-spline or Bezier surface and the boundary is the whole of one
/// side of it (u or v is constant there, and the face ends with it). Only the order + 1 rows of
/// poles behind that side move; where there are too few of them for the opposite side to stay, the
/// degree across is raised and knots are inserted, which changes no shape. Trimmed edges keep their
/// paths in the parameter plane.
///
/// Where both faces end there with a side of their spline surfaces, the join is one of poles and
/// exact to rounding: the smallest move (core/join/nearest/nearest.hpp), with the knots along the
/// seam as they are or, where at most 300 poles move, with inner ones repeated up to \p order times
/// more, whichever moves less. Otherwise, or where that cannot be or moves more than twice as far,
/// one face follows what the other one shows along the boundary at several points a knot span
/// (position, tangent plane, curvature), row by row, each by the smallest move that meets it; knot
/// spans where the tolerance is not met are halved, at most 6 times.
///
/// Matched means: the figures of the new seam are enclosed and within the tolerance, OpenCASCADE's
/// checks pass, no edge or vertex has a tolerance above twice the largest that the faces had (or
/// twice the gap tolerance), and the moved surface's normal nowhere turned by 90 degrees or more at
/// the points of a grid (9 a knot span along the seam, 5 across the moved rows). Where any of this
/// fails, or a pole would move further than \p max_move_mm, the shape is that of the two faces as
/// given. A pair that has the level already comes back unchanged.
///
/// A moved face that ends in a point at the seam keeps that point. If its tangent plane had to turn
/// there, its curvature grows without bound towards it; the reason then says that it may.
///
/// A boundary that is a closed loop is refused, and one that is a part of a side. Work can be
/// stopped between its steps, not within an exact join.
///
/// hold_sides: the first and the last pole of each moved row stay. That needs boundaries that
/// already end in the neighbour, in its tangent plane (G2: with its curvature); the reason says by
/// how much they do not. A boundary that ends at the seam and is trimmed away from the sides of the
/// surface is refused where it would move (by more than a hundredth of the gap tolerance).
///
/// Points of a surface move no further than its poles where weights stay. An exact join of rational
/// surfaces changes weights; then the largest move is also that of points at the same parameters,
/// on a grid over the moved rows (9 a knot span along the seam, 17 across).
///
/// \param face_a, face_b numbers from 1 in the order of TopExp::MapShapes.
/// \throws std::invalid_argument for numbers that name no two faces, an edge that is none of their
/// common ones, or bad options; Cancelled. A face with numbers that are not finite, or 1e100 and
/// more, in its surface or one of its edges is refused with that reason; in other faces they do no
/// harm.
/// Source: docs/theory/surfaces.md S5.1 to S5.5 (exact joins, and to the tolerance row by row).
MatchReport matchFaces(const TopoDS_Shape& model, int face_a, int face_b,
                       const FaceMatchOptions& options = {}, const Progress& progress = {});

}  // namespace seamwright::occ
