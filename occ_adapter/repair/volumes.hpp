// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include <seamwright/occ_adapter/repair/solve.hpp>

/// Whether solids keep their volume; not a public header.
namespace seamwright::occ {

/// The volume of a solid is the sum of the cones over its faces with one tip. It may change by the
/// moves of the faces over their areas, by what the faces beside a seam are apart, and by rounding.
/// \param after the seams of the changed shape, in the order of before.
/// \returns which solid changed more, with the figures; empty: none. \throws Cancelled.
std::string whyNotVolumes(const RepairTask& task, const std::vector<FaceChange>& changes,
                          const TopoDS_Shape& changed, const std::vector<SeamResult>& after,
                          const Progress& progress);

}  // namespace seamwright::occ
