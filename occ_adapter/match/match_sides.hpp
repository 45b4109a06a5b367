// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/occ_adapter/blend/blend_surface.hpp>
#include <seamwright/occ_adapter/match/match_reason.hpp>
#include <seamwright/occ_adapter/progress.hpp>
#include <seamwright/occ_adapter/repair/repair.hpp>

namespace seamwright::occ {

/// A side of the face that changes, and what it has to join.
struct SideMatch {
  /// The edges of the side, a chain or a closed loop; its faces are not used.
  SideChoice side;
  /// The edges that it joins, which may be those of several faces; empty: all that it meets.
  std::vector<int> neighbours = {};
  int order = 1;  ///< 0 to 2: G0 to G2
  /// The part of the side that has to join, as shares of its length.
  double from = 0, to = 1;
};

/// What the other edges of the face keep.
enum class HeldEdges {
  None,
  Position,
  Tangent  ///< also the tangent planes of the face
};

struct SideMatchOptions {
  ContinuityTolerance tolerance;  ///< the seams meet it: gap, angle, curvature
  /// How far from the sides the face may change; nothing: as little as needed, see docs/match.md.
  std::optional<double> depth_mm;
  HeldEdges hold = HeldEdges::None;
  /// The neighbours move too: all meet in the mean of both sides.
  bool average = false;
  /// Faces without poles, such as planes and cylinders, become splines if they have to move.
  bool convert = false;
  double max_move_mm = std::numeric_limits<double>::infinity();  ///< of a pole
  double match_mm = 0.1;  ///< free edges no further apart than this meet
  double fairness = 1.5;  ///< a face whose variation grows more is refused, see judgeSurface()
  int jobs = 0;           ///< threads; 0: one for each processor

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

/// A seam between the face and a neighbour.
struct MatchedSeam {
  std::string side;  ///< its name
  SeamResult before, after;
  Level level = Level::G1;  ///< what it has to reach
};

struct SideMatchReport {
  bool matched = false;
  std::vector<MatchReason> remarks, failures;
  TopoDS_Shape shape;  ///< the model with the changed faces; as given if not matched
  std::vector<MatchedSeam> seams;
  /// Of the faces that moved, with the judgement of their surfaces; also of a refused move.
  std::vector<FaceMove> moves;
  double depth_mm = 0;  ///< no point farther from the sides moved

  /// Of the first failure, empty if there is none: its code, and what the user can do.
  std::string code() const;
  std::string remedy() const;
  /// The remarks and failures in one line.
  std::string text() const;
};

/// Changes a face so that sides of it join their neighbours G0, G1 or G2. A side is an edge or a
/// chain of edges of any number of neighbours, a closed loop, or a part of these; it may be
/// trimmed. Several sides of the face are joined at once, also at corners that they share.
///
///     const SideMatchReport report = matchSides(shape, 7, {{.side = {{3, 4}}, .order = 2}});
///
/// Only poles near the sides move, with the least bending of the moves; knots are inserted so that
/// the change ends where the options say. Edges keep their pcurves.
///
/// Matched means that all of these hold; otherwise the shape is the given one:
///   - The enclosed figures of all seams are within the tolerance.
///   - No moved face is less fair (judgeSurface()), folded, or moved further than allowed.
///   - No edge of a moved face lies further from its faces than twice the gap tolerance, or than
///     twice the largest before.
///   - The faces pass OpenCASCADE's checks as before.
///
/// Other seams of the face may become worse where nothing is held: a remark names them.
/// \param face from 1, in the order of TopExp::MapShapes.
/// \throws std::invalid_argument for sides as chosenSide(), invalid options and unknown faces;
/// Cancelled.
/// Source: docs/theory/surfaces.md S5.6.
SideMatchReport matchSides(const TopoDS_Shape& model, int face, const std::vector<SideMatch>& sides,
                           const SideMatchOptions& options = {}, const Progress& progress = {});

}  // namespace seamwright::occ
