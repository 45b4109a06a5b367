// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/repair/change.hpp>
#include <seamwright/occ_adapter/repair/choose.hpp>
#include <seamwright/occ_adapter/repair/face_follow.hpp>
#include <seamwright/occ_adapter/repair/seam_target.hpp>

/// How faces have to move for seams to flow; not a public header.
namespace seamwright::occ {

/// What has to flow, and what has to stay as it is.
struct RepairTask {
  const TopoDS_Shape& shape;
  const std::vector<Seam>& seams;          ///< of the shape, in the order of the report before
  const std::vector<SeamResult>& to_keep;  ///< in the model given, or when repaired; none may get worse
  const std::vector<SeamResult>& before;   ///< in the shape
  const std::vector<FaceChoice>& faces;    ///< from 1
  const std::vector<bool>& sharp;          ///< by seam, see Choice
  std::vector<bool> treated;               ///< by seam; the others may not become worse
  const RepairOptions& options;
  Level asked = options.level();  ///< by the user, where the options ask for less
};

/// No difference of curvature is beyond the tolerance, as relativeDifference() is at most 2: G2 is G1.
inline bool anyCurvatureDoes(const ContinuityTolerance& tolerance) {
  return tolerance.curvature_rel >= 2;
}

/// Surfaces that make seams flow, as far as the solver can tell.
struct RepairSolution {
  std::vector<FaceChange> changes;
  std::vector<PathChange> paths;
  std::map<std::size_t, std::string> failures;  ///< seams that were to be treated and are not: why
  bool complete = true;                         ///< false: to be asked again without the failures
};

/// The same seams in a shape that withChanges() made of theirs.
std::vector<Seam> seamsIn(const TopoDS_Shape& shape, std::vector<Seam> seams);

/// Seams of which the gap alone is too large and the surfaces meet near the edge: its paths in the parameter planes are made to run together,
/// between the same ends, along the image of one of them or where the surfaces cut one another. No surface moves. (Paths that stray are
/// mostly approximations of exact curves in files of other programs.)
/// \throws Cancelled.
RepairSolution joinPaths(const RepairTask& task, const Progress& progress);

/// Seams that can be joined exactly, but by moves much larger than what they lack.
using DearSeams = std::set<std::size_t>;

/// All seams whose sides are natural sides of polynomial surfaces at once, exactly, with the smallest move. Poles beside other boundaries stay.
/// Sharp seams are left to followTargets(), also by joinPairs().
/// \param dear grows by the seams of what hangs together if its largest move exceeds twice the largest gap, and angle times distance of
/// the first rows of poles, which are left then; null: none is.
/// \throws Cancelled.
RepairSolution joinNetwork(const RepairTask& task, DearSeams* dear, const Progress& progress);

/// A pair that was joined before, or was not.
struct JoinedPair {
  std::vector<FaceChange> changes;
  std::string why_not;    ///< empty: it was
  std::size_t state = 0;  ///< number of what its faces are then
};

/// In one shape by the seam and the states of its two faces, 0: as they are in the shape.
using JoinedPairs = std::map<std::array<std::size_t, 3>, JoinedPair>;

/// Joins one pair after the other in poles where both faces end with a side of their surfaces, else one face follows the other; what ends at
/// the seam stays. What one pair gains the next may spoil.
/// \throws Cancelled.
RepairSolution joinPairs(const RepairTask& task, JoinedPairs& known, const Progress& progress);

/// Faces that followed before, by all that was asked of them, in one shape.
using FollowedFaces = std::map<std::string, FaceFollow>;

/// All faces at once follow common targets of their seams, which agree at vertices. A boundary that is not treated keeps its shape, or, where
/// a vertex has to move, stays as smooth as it is.
/// \throws Cancelled.
RepairSolution followTargets(const RepairTask& task, LeadReach reach, FollowedFaces& known,
                             const Progress& progress);

}  // namespace seamwright::occ
