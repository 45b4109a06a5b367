// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/occ_adapter/match/match_reason.hpp>
#include <seamwright/occ_adapter/progress.hpp>
#include <seamwright/occ_adapter/repair/repair.hpp>

namespace seamwright::occ {

enum class MatchMoves { First, Second, Both };

struct FaceMatchOptions {
  int order = 1;  ///< 1: G1, 2: G2
  MatchMoves moves = MatchMoves::Second;
  double max_move_mm =
      std::numeric_limits<double>::infinity();  ///< upper limit of MatchReport::largest_move_mm
  /// The two boundaries that end at the seam stay, to 1/100 of the gap tolerance; where the face
  /// changes up to a depth only, to that tolerance.
  bool hold_sides = false;
  double match_mm = 0.1;  ///< free edges no further apart than this may be the common boundary
  int edge = 0;  ///< of several common ones, from 1, order of TopExp::MapShapes; 0: the longest
  /// How far from the boundary the face may change; nothing: as little as needed.
  std::optional<double> depth_mm;
  bool convert = false;           ///< a face without poles that should move becomes a spline
  double fairness = 1.5;          ///< how much the variation of a face may grow, see judgeSurface()
  ContinuityTolerance tolerance;  ///< of the figures, and how near a trimmed boundary is met

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

struct MatchReport {
  bool matched = false;
  std::vector<MatchReason> remarks;   ///< how, and what the user should know
  std::vector<MatchReason> failures;  ///< why not, in the order of the attempts
  TopoDS_Shape
      shape;  ///< the two faces as a shell that shares the seam edge; as given where not matched
  SeamResult before;  ///< faces and edges by their numbers in the model
  SeamResult after;  ///< faces and edges by their numbers in the shape; as before where not matched
  double largest_move_mm =
      0;  ///< of a pole, which no point exceeds; if weights change, also of points on a grid
  std::vector<FaceMove> moves;  ///< with the judgement of the surfaces that moved
  double depth_mm = 0;  ///< no point farther from the boundary moved; 0: rows of poles moved
  bool exact = false;   ///< joined in poles, to rounding; false: to the tolerance

  /// Of the first failure; empty if there is none. That there is no exact join counts only if
  /// nothing else was tried.
  std::string code() const;
  /// What the user can do about that failure.
  std::string remedy() const;
  /// The remarks and failures in one line.
  std::string text() const;
};

/// Moves one or both of two faces so that they join G1 or G2 along their common boundary: an edge
/// that both share, or a free edge of each where these are close together over their whole length.
/// The other faces of the model are not considered. docs/match.md describes how faces move.
///
///     const MatchReport report = matchFaces(shape, 3, 7, {.order = 2, .hold_sides = true});
///     if (report.matched) use(report.shape); else show(report.reason);
///
/// A face can move if it lies on a B-spline or Bezier surface and the boundary is the whole of one
/// side of it. Only the order + 1 rows of poles behind that side move. If both faces end there with
/// a side of their spline surfaces, the join is exact to rounding (nearestJoin()). Otherwise, or
/// where that moves more than twice as far, one face fits what the other one shows at sampled
/// points.
///
/// Matched means that all of these hold; otherwise the shape is that of the faces as given:
///   - The enclosed figures of the new seam are within the tolerance.
///   - OpenCASCADE's checks pass.
///   - No edge or vertex has a tolerance above twice the largest that the faces had, or twice the
///     gap tolerance.
///   - The normal turned by less than 90 degrees at the points of a grid.
///   - No pole moved further than max_move_mm.
///
/// Special cases:
///   - A pair that has the level already is returned unchanged.
///   - A boundary that is a closed loop, or a part of a side, is refused.
///   - A moved face that ends in a point at the seam keeps that point; its curvature may grow
///     without bound towards it, and the reason says so.
///   - With hold_sides the boundaries that end at the seam must already end in the tangent plane of
///     the neighbour (G2: with its curvature); the reason says by how much they do not.
///   - Faces with numbers that are not finite, or 1e100 and more, are refused; in other faces such
///     numbers have no effect.
///
/// The model is not changed. An exact join can't be cancelled within its computation.
///
/// \param face_a, face_b numbers from 1 in the order of TopExp::MapShapes.
/// \throws std::invalid_argument for numbers that name no two faces, an edge that is not a common
/// one, and invalid options; Cancelled.
/// Source: docs/theory/surfaces.md S5.1 to S5.5 (exact joins, and to the tolerance row by row).
MatchReport matchFaces(const TopoDS_Shape& model, int face_a, int face_b,
                       const FaceMatchOptions& options = {}, const Progress& progress = {});

}  // namespace seamwright::occ
