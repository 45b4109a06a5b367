// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/occ_adapter/match/face_deformation.hpp>
#include <seamwright/occ_adapter/match/pole_moves.hpp>
#include <seamwright/occ_adapter/repair/change.hpp>

/// The edges of a moving face that are not matched. Not a public header.
namespace seamwright::occ {

/// The coedges of the mover that are not matched, free ones too.
std::vector<Coedge> otherEdges(const SideJoin& join, const Mover& mover, const SeamGraph& graph);

/// Points of the edges that the mover shares with other faces and that are not matched: what moves
/// there opens a gap. Edges that slide may move along the other face, between their ends. The
/// weight is 0.
KeptEdges keptEdges(const SideJoin& join, const Mover& mover, const SeamGraph& graph);

/// The largest move of a kept point that opens a gap.
double strayOf_mm(const KeptEdges& kept, const Geom_BSplineSurface& before,
                  const Geom_BSplineSurface& after);

/// The new pcurves of the edges that slide on faces that stay.
/// \throws GeometryError as pcurveOf(); Standard_Failure.
std::vector<PathChange> slidPaths(const SideJoin& join, const Mover& mover, const SeamGraph& graph,
                                  const opencascade::handle<Geom_BSplineSurface>& after);

}  // namespace seamwright::occ
