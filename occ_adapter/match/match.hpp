// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <limits>
#include <string>

#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

enum class MatchMoves { First, Second, Both };

struct MatchOptions {
  int order = 1;  ///< 1: G1, 2: G2
  MatchMoves moves = MatchMoves::Second;
  double max_move_mm = std::numeric_limits<double>::infinity();  ///< no pole may move further
  bool hold_sides = false;        ///< the two other boundaries that end at the seam stay as they are
  double match_mm = 0.1;          ///< open edges no further apart than this may be the common boundary
  ContinuityTolerance tolerance;  ///< what the figures are judged by, and how near a trimmed boundary is met
};

struct MatchReport {
  bool matched = false;
  std::string reason;  ///< why not, or what the user should know; one line with numbers
  TopoDS_Shape shape;  ///< the two faces as a shell that shares the seam edge; as given where not matched
  SeamResult before, after;
  double largest_move_mm = 0;  ///< of a pole
  bool exact = false;          ///< joined in poles, to rounding; false: to the tolerance
};

/// Moves one or both of two faces so that they join along their common boundary.
/// \param face_a, face_b numbers from 1 in the order of TopExp::MapShapes.
MatchReport matchFaces(const TopoDS_Shape& model, int face_a, int face_b, const MatchOptions& options = {},
                       const Progress& progress = {});

}  // namespace seamwright::occ
