// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/occ_adapter/repair/repair_state.hpp>
#include <seamwright/occ_adapter/repair/time_limit.hpp>

/// The stages of a repair in which edges get new pcurves and faces move. Not a public header.
namespace seamwright::occ {

/// What all stages read.
struct RepairContext {
  const Model& model;  ///< the given one
  const RepairOptions& options;
  const UnusableParts& unusable;  ///< of the model
  const TimeLimit& time;
  const std::vector<FaceChoice>& faces;  ///< from 1, see Choice
  const std::vector<bool>& sharp;        ///< by seam, see Choice
  NeededVariation needed = {};           ///< by face
  MoveLimits limits_mm = {};             ///< of the faces beside treated seams
};

/// Repairs seams in five stages, each of which keeps what it can prove:
/// 1. Edges that stray get new pcurves.
/// 2. All faces beside the seams that are left move together.
/// 3. With target G2: seams that were left are tried with G1.
/// 4. Seams that were left are tried one by one.
/// 5. With target G2: seams that have only G1 are tried one by one again.
///
/// A stage that exceeds its share of the time limit is stopped, without effect.
/// \param wanted by seam: it is to be repaired.
/// \throws Cancelled.
RepairState repairInStages(const RepairContext& context, RepairState state,
                           const std::vector<bool>& wanted, const Progress& progress);

}  // namespace seamwright::occ
