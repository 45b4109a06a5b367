// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include <seamwright/occ_adapter/repair/solve.hpp>

/// Checks that solids keep their volume. Not a public header.
namespace seamwright::occ {

/// Compares the volume of each solid before and after. The volume is the sum of the cones over its
/// faces with a common apex. It may change by the moves of the faces times their areas, by the gaps
/// between the faces beside seams, and by rounding.
/// \param after seams of the changed shape, in the order of before.
/// \returns which solid changed more, with the figures; empty if none did.
/// \throws Cancelled.
RepairReason whyNotVolumes(const RepairTask& task, const std::vector<FaceChange>& changes,
                           const TopoDS_Shape& changed, const std::vector<SeamResult>& after,
                           const Progress& progress);

}  // namespace seamwright::occ
