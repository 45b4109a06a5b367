// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/repair/fair_solve.hpp>
#include <seamwright/occ_adapter/repair/solve.hpp>

/// Moves all faces of a repair together. Not a public header.
namespace seamwright::occ {

/// By seam: parameters in 0..1 at which samples missed their tolerance.
using MissedParameters = std::map<std::size_t, std::set<double>>;

/// What is asked of a face after it became less fair, moved too far, or was trimmed badly; see
/// MovingFace.
struct Restraint {
  double stiffness = 1;
  double move_mm = std::numeric_limits<double>::infinity();
  bool keeps_edges = false;  ///< no edge slides on this face, which stays

  bool operator==(const Restraint&) const = default;
};
using Restraints = std::map<int, Restraint>;  ///< by face; a face without an entry has none

/// Faces that joints connect, with their displacements.
struct FairComponent {
  std::string asked;  ///< key made of all that was asked of the component
  MovingFaces movers;
  std::map<std::size_t, SampleWeights> weights;  ///< by seam
  std::map<std::size_t, int> orders;             ///< by treated seam: 1: G1, 2: G2
  std::map<std::size_t, double> effort;  ///< by treated seam: the largest weight of its samples
  /// By treated seam that misses its tolerance: the reason.
  Reasons failures;
  std::vector<FaceChange> changes;
  std::vector<PathChange> paths;  ///< of edges that slide on faces that stay
  bool diverged = false;          ///< the solution diverged: no later solution may start from it
};

/// Finds the displacements of least bending energy of the faces beside treated seams that bring
/// these seams within the tolerance and keep the figures of the other edges of these faces. The
/// conditions are sampled; prove() decides.
/// \param open coedges of free edges in the task's shape.
/// \param before components of a task that asked for more; the solution starts from them.
/// \throws Cancelled; Standard_Failure.
std::vector<FairComponent> displaceFaces(const RepairTask& task, const std::vector<Coedge>& open,
                                         const MissedParameters& missed,
                                         const Restraints& restraints,
                                         const std::vector<FairComponent>& before,
                                         const Progress& progress);

}  // namespace seamwright::occ
