// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include <seamwright/occ_adapter/repair/repair.hpp>
#include <seamwright/occ_adapter/repair/repair_reason.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// Chooses the seams to repair and the faces that may move. Not a public header.
namespace seamwright::occ {

/// What repair may do with a face. Faces are numbered from 1: entry 0 of a vector is unused.
struct FaceChoice {
  bool may_move = false;
  bool may_be_trimmed = false;  ///< its edges may get new pcurves on it
  RepairReason cannot_move;     ///< its text follows "face 3 "
  /// It could move as a spline: its only obstacle is that it has no poles.
  bool convertible = false;
};

struct Choice {
  std::vector<bool> treated;  ///< by seam, in the order of the report
  std::vector<bool> sharp;    ///< by seam: only the gap of a treated seam is to be closed
  /// By seam: why a seam that was meant is not treated; otherwise empty.
  std::vector<RepairReason> reasons;
  /// By seam: it misses its level, and its faces can move only as splines.
  std::vector<bool> wants_conversion;
  std::vector<FaceChoice> faces;
};

/// Chooses the seams of class defect, or, where edges are picked, the seams of these edges that do
/// not have the level yet. A seam is treated only if one of its faces can move, or if only its edge
/// strays (isOfGapAlone()) and one of its faces may be trimmed differently.
///
/// A face can move if it lies on a B-spline or Bezier surface, is not fixed, occurs in the model
/// once, and has no non-manifold edge. A face that can't be computed with (UnusableParts) does not
/// move, nor does a face that shares an edge with one.
///
/// A defect that would be a crease if its gap were closed is sharp by design and stays sharp. Seams
/// whose faces fold back on one another below the crease angle are not treated, because no small
/// move turns a normal over.
/// \throws std::invalid_argument for edges and faces that the model does not have, and for a picked
/// edge that is not a seam.
Choice choose(const Model& model, const Report& before, const RepairOptions& options);

/// Why no face of a seam can move; empty if one can.
RepairReason whyNoneMoves(const std::array<int, 2>& faces, const std::vector<FaceChoice>& choices);

/// Whether two faces share the edge and only the gap keeps the seam from its target.
bool isOfGapAlone(const SeamResult& seam, bool sharp, const ContinuityTolerance& tolerance,
                  Level level);

/// Why no smooth displacement gives the sides of a seam one tangent plane within the tolerance;
/// empty if one may. This happens where the surface of one side has a kink across the seam and the
/// other side does not turn with it: then one side of the kink misses the tolerance.
/// \throws Standard_Failure.
RepairReason whyKinked(const Seam& seam, const ContinuityTolerance& tolerance);

/// 1: G1, 2: G2.
inline Level levelOf(int order) {
  return order == 1 ? Level::G1 : Level::G2;
}

/// Whether the seam certainly has what is asked for. \param sharp see Choice.
bool isRepaired(const SeamResult& after, bool sharp, const ContinuityTolerance& tolerance,
                Level level);

}  // namespace seamwright::occ
