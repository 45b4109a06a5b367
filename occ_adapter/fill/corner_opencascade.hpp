// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/fill/corner.hpp>
#include <seamwright/occ_adapter/fill/rounded_corner.hpp>

/// The corner as OpenCASCADE rounds it. Not a public header.
namespace seamwright::occ {

/// Rounds all edges of the corner by BRepFilletAPI_MakeFillet, which closes the corner too: at
/// once, or one edge before the others. Edges that OpenCASCADE takes for smooth stay, if their
/// faces meet at less than the angle of a crease. All new seams are named: also those of fillets
/// that run on along smooth chains of edges, and of two fillets that meet without a face between
/// them. \throws CornerRefused if OpenCASCADE makes no valid solid of the corner's shell, divides a
/// face, or can't give each edge its radius; std::invalid_argument as cornerFillet().
RoundedCorner openCascadeCorner(const Corner& corner, const CornerFilletOptions& options);

}  // namespace seamwright::occ
