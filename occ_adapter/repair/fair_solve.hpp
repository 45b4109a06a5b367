// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include <seamwright/occ_adapter/progress.hpp>
#include <seamwright/occ_adapter/repair/joint.hpp>

/// Solves for the displacements of faces that joints connect. Not a public header.
namespace seamwright::occ {

/// Weights of the samples of a seam: (parameter in 0..1, weight).
using SampleWeights = std::vector<std::pair<double, double>>;

/// The state from which a solution starts.
struct FairStart {
  bool is_new = true;                            ///< nothing was solved before
  std::map<std::size_t, SampleWeights> weights;  ///< by seam
  std::set<int> relaxed;  ///< faces of which something different is asked than before
};

struct FairResult {
  std::vector<double> missed = {};  ///< by joint: the miss of its worst sample over its tolerance
  std::map<std::size_t, SampleWeights> weights = {};
  int refinements = 0;  ///< how often knots were inserted
  int passes = 0;       ///< least-squares solutions, over all refinements
};

/// Minimises the fairness objective over the displacements of all movers at once: the sum over
/// faces of their bending energy, relative to the energy that spends the face's budget. It holds
/// what joints miss within the tolerance by iteratively reweighted least squares: the weight of a
/// sample grows while it is missed. Where weights are not enough, knots are inserted.
/// Source: docs/theory/repair.md.
/// \param movers in: displacements from which the solution starts; out: the solution.
/// \throws Cancelled; Standard_Failure.
FairResult fairSolve(const std::vector<Joint>& joints, const ContinuityTolerance& tolerance,
                     const FairStart& start, MovingFaces& movers, const Progress& progress);

}  // namespace seamwright::occ
