// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include <seamwright/occ_adapter/progress.hpp>
#include <seamwright/occ_adapter/repair/joint.hpp>

/// Displacements of faces that joints connect; not a public header.
namespace seamwright::occ {

/// How much the samples of a seam have to count, by place 0..1.
using SampleWeights = std::vector<std::pair<double, double>>;

/// Where a solution starts from.
struct FairStart {
  bool is_new = true;                            ///< nothing was solved before
  std::map<std::size_t, SampleWeights> weights;  ///< by seam
  std::set<int> relaxed;  ///< faces of which something else is asked than before
};

struct FairResult {
  std::vector<double> missed;  ///< by joint: of what its worst sample misses to the tolerance
  std::map<std::size_t, SampleWeights> weights;
};

/// Minimises, over the displacements of all movers at once, the sum over faces of bending energy
/// over that which spends the face's budget, with what joints miss held within the tolerance: by
/// least squares whose samples count the more the longer they are missed, and knots inserted where
/// that is not enough. Source: docs/theory/repair.md.
/// \param movers their displacements are where the solution starts and what it finds. \throws
/// Cancelled; Standard_Failure.
FairResult fairSolve(const std::vector<Joint>& joints, const ContinuityTolerance& tolerance,
                     const FairStart& start, MovingFaces& movers, const Progress& progress);

}  // namespace seamwright::occ
