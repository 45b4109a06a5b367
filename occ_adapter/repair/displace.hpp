// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/repair/fair_solve.hpp>
#include <seamwright/occ_adapter/repair/solve.hpp>

/// All faces of a repair moved together; not a public header.
namespace seamwright::occ {

/// Places of seams, 0..1, where samples missed something, by seam.
using MissedPlaces = std::map<std::size_t, std::set<double>>;

/// What is asked of a face after it came out unfair, moved too far, or was trimmed badly: see
/// MovingFace.
struct Restraint {
  double stiffness = 1;
  double move_mm = std::numeric_limits<double>::infinity();
  bool keeps_edges = false;  ///< a face that stays: no edge slides on it

  bool operator==(const Restraint&) const = default;
};
using Restraints = std::map<int, Restraint>;  ///< by face; of others none

/// Faces that joints connect, and how they move.
struct FairComponent {
  std::string asked;  ///< all that was asked of it, as a key
  MovingFaces movers;
  std::map<std::size_t, SampleWeights> weights;  ///< by seam
  std::map<std::size_t, int> orders;             ///< by treated seam: what was asked for
  std::map<std::size_t, double> effort;  ///< by treated seam: the largest weight of its samples
  std::map<std::size_t, std::string> failures;  ///< treated seams that miss their tolerance: why
  std::vector<FaceChange> changes;
  std::vector<PathChange> paths;  ///< on faces that stay, of edges that slide on them
  bool diverged = false;          ///< it is no place to start from
};

/// The displacement of the faces beside treated seams with the least bending energy that brings
/// these seams within the tolerance and keeps what the other edges of the faces have. It is
/// sampled; prove() decides.
/// \param open uses of open edges in the task's shape. \param before components of a task that
/// asked for more; they are where the solution starts.
/// \throws Cancelled; Standard_Failure.
std::vector<FairComponent> displaceFaces(const RepairTask& task, const std::vector<Coedge>& open,
                                         const MissedPlaces& missed, const Restraints& restraints,
                                         const std::vector<FairComponent>& before,
                                         const Progress& progress);

}  // namespace seamwright::occ
