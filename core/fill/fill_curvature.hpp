// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <seamwright/core/bezier/patch_edge.hpp>
#include <seamwright/core/fill/fill_space.hpp>

/// The fills of a space with the least jumps of curvature; not a public header.
namespace seamwright::fill {

/// An edge of a patch along a side, whose parameter it covers from \p from to \p to in the edge's
/// own sense.
struct OuterEdge {
  int patch = 0;
  PatchEdge edge = PatchEdge::U0;
  std::size_t side = 0;
  double from = 0, to = 1;
};

/// A common edge of two patches.
struct InnerEdge {
  int before = 0;
  PatchEdge before_edge = PatchEdge::U0;
  bool reversed = false;  ///< its own sense runs against that of the other
  int after = 0;
  PatchEdge after_edge = PatchEdge::U0;
};

struct FillEdges {
  std::vector<OuterEdge> outer;
  std::vector<InnerEdge> inner;
};

FillEdges starEdges(int sides);
FillEdges ringEdges();

struct CurvedPatches {
  std::vector<BezierPatch> patches;
  /// The largest difference of normal curvatures across the edges, at some places of each; sides
  /// without second derivatives are left out.
  double curvature_jump_per_mm = 0;
};

/// Patches of a space near to given ones of it, with less of a curvature jump: its squares at
/// places along all edges, and little of the squared differences of poles of that order, are made
/// least. Across the outer edges the jump is linear in the poles, as position and first derivatives
/// there are fixed; across inner ones it is linearised at the patches given, and this is repeated.
/// What is not proved regular, or has a larger jump by a fiftieth, is not taken: where nothing
/// better comes out, the patches come back.
/// \param patchesOf the patches of unknowns.
/// Source: docs/theory/fills.md F2.7.
CurvedPatches leastCurvatureJump(
    const FillSpace& space, const std::vector<BezierPatch>& given, const FillEdges& edges,
    const std::vector<FillSide>& sides, int order,
    const std::function<std::vector<BezierPatch>(const Poles& unknowns)>& patchesOf);

}  // namespace seamwright::fill
