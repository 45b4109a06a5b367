// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <set>
#include <string>

#include <seamwright/occ_adapter/repair/solve.hpp>

/// All faces of a repair moved together; not a public header.
namespace seamwright::occ {

/// Places of seams, 0..1, that samples missed, by seam.
using MissedPlaces = std::map<std::size_t, std::set<double>>;

struct FairSolution {
  RepairSolution solution;
  /// By treated seam: how much more its samples had to count than those of others.
  std::map<std::size_t, double> effort;
};

/// Components that were solved before, by all that was asked of them.
using SolvedComponents = std::map<std::string, FairSolution>;

/// The displacement of the faces beside treated seams with the least bending energy that brings these seams within the tolerance and keeps
/// what the other edges of the faces show. Sampled; prove() decides.
/// \throws Cancelled; Standard_Failure.
FairSolution displaceFaces(const RepairTask& task, const MissedPlaces& missed, SolvedComponents& known, const Progress& progress);

}  // namespace seamwright::occ
