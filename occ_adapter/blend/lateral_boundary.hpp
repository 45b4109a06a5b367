// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/blend/blend_seams.hpp>

/// Lateral boundaries of a blend as they were chosen. Not a public header.
namespace seamwright::occ {

/// The lateral boundaries between two open sides, one at most for each end of them.
/// \throws std::invalid_argument for what can't be a lateral boundary of these sides, with figures;
/// GeometryError for edges that can't be computed with. Source: docs/theory/surfaces.md S8.5.
std::vector<ChosenLateral> chosenLaterals(const TopoDS_Shape& model,
                                          const BlendSurfaceOptions& options,
                                          const std::vector<ChosenEnd>& ends);

/// The directions out of the face in which lateral boundaries leave the side \p k.
LateralDirections directionsOf(const std::vector<ChosenLateral>& laterals,
                               const std::vector<ChosenEnd>& ends, int k);

/// What the laterals ask of a surface between these sides, which leave in their directions.
std::vector<BlendLateral> lateralsOf(const std::vector<ChosenLateral>& laterals,
                                     const std::vector<ChosenEnd>& ends,
                                     const std::vector<BlendSide>& sides,
                                     const ContinuityTolerance& tolerance);

}  // namespace seamwright::occ
