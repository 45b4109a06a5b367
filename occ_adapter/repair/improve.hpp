// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <vector>

#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/repair/solve.hpp>

/// Changes of a shape that were proven; not a public header.
namespace seamwright::occ {

/// What a task came to: its shape with changes that hold, and the seams that were left for them to
/// hold.
struct Improvement {
  TopoDS_Shape shape;  ///< that of the task where there are no changes
  std::vector<FaceChange> changes;
  std::map<int, FaceMove>
      judged;  ///< by face that changes: what became of it since the model was given
  std::vector<PathChange> paths;
  std::vector<SeamResult> after;  ///< in the order of the task
  std::vector<int> orders;        ///< by seam: what it has got, 0: nothing
  Reasons reasons;                ///< of seams that did not get all that was asked for
  Reasons g1_reasons;  ///< of those that were tried with G1 instead of G2: why they did not get it
};

/// Edges get other paths, see joinPaths(). \throws Cancelled.
Improvement improveByPaths(const RepairTask& task, const Progress& progress);

/// Faces move, see displaceFaces(). What can't be met, or spoils a face or another seam, is
/// excluded, one seam of a face after the other, until what is left can be proven; a seam that
/// can't have G2 is tried with G1. \throws Cancelled.
Improvement improveByMoves(const RepairTask& task, const Progress& progress);

}  // namespace seamwright::occ
