// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <vector>

#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/repair/solve.hpp>

/// Finds changes of a shape that can be proven. Not a public header.
namespace seamwright::occ {

/// The outcome of a task: the shape with changes that are proven, and the seams that were excluded
/// so that these changes could be proven.
struct Improvement {
  TopoDS_Shape shape;  ///< the task's shape if there are no changes
  std::vector<FaceChange> changes;
  /// By changed face: its change since the given model.
  std::map<int, FaceMove> judged;
  std::vector<PathChange> paths;
  std::vector<SeamResult> after;  ///< in the order of the task
  std::vector<int> orders;        ///< by seam: what it has reached; 0: nothing
  Reasons reasons;                ///< of seams that did not reach their target
  Reasons g1_reasons;             ///< of seams that were tried with G1 instead of G2 and failed
};

/// Gives edges new pcurves, see joinPaths(). \throws Cancelled.
Improvement improveByPaths(const RepairTask& task, const Progress& progress);

/// Moves faces, see displaceFaces(). Seams that can't be met, or whose repair spoils a face or
/// another seam, are excluded, one seam of a face after the other, until the rest can be proven. A
/// seam that can't have G2 is tried with G1.
/// \throws Cancelled.
Improvement improveByMoves(const RepairTask& task, const Progress& progress);

}  // namespace seamwright::occ
