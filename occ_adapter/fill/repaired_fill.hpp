// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/occ_adapter/fill/fill.hpp>

namespace seamwright::occ {

/// fillHole() after a repair of the seams that end at the hole, between the faces around it. Where
/// these seams are not smooth the faces have two tangent planes at one point of the hole, and every
/// fill misses one of them. The seams are repaired for the target and the tolerances of the fill;
/// those above the crease angle, and those of a target of G0, stay. FillHoleReport::around tells
/// what was done and which seams are left. If only the fill of the given model reaches the target,
/// it is taken. If the hole is not filled, the model of the report is the given one.
/// \param hole of findHoles() for the model, with the corner angle and the gap of the options
/// \throws as fillHole() and repair().
FillHoleReport repairedAndFilledHole(const Model& model, const Hole& hole,
                                     const FillHoleOptions& options = {},
                                     const Progress& progress = {});

/// replaceFaces() after such a repair around the faces.
/// \throws as replaceFaces() and repair().
FillHoleReport repairedAndReplacedFaces(const Model& model, const std::vector<int>& faces,
                                        const FillHoleOptions& options = {},
                                        const Progress& progress = {});

}  // namespace seamwright::occ
