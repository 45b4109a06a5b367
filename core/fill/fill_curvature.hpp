// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <seamwright/core/bezier/patch_edge.hpp>
#include <seamwright/core/fill/fill_space.hpp>

/// The fill of a space with the smallest curvature jumps; not a public header.
namespace seamwright::fill {

/// An edge of a patch along a side. In its own sense it covers the side's parameters from \p from
/// to \p to.
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
  bool reversed = false;  ///< its sense is opposite to that of the other edge
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
  /// The largest difference of normal curvatures across the edges, at sampled parameters of each.
  /// Sides without second derivatives are left out.
  double curvature_jump_per_mm = 0;
};

/// Patches of a space near given ones, with smaller curvature jumps. The minimised sum consists of
/// the squared jumps at sampled parameters of all edges and, with a small weight, the squared
/// differences of poles of order \p order. Across the outer edges the jump is linear in the poles,
/// because position and first derivatives are fixed there. Across inner edges it is linearised at
/// the given patches, and this is repeated. A result that is not proven regular, or whose largest
/// jump is larger by a fiftieth, is rejected. If there is no better result, the given patches are
/// returned.
/// \param patchesOf returns the patches of unknowns.
/// Source: docs/theory/fills.md F2.7.
CurvedPatches leastCurvatureJump(
    const FillSpace& space, const std::vector<BezierPatch>& given, const FillEdges& edges,
    const std::vector<FillSide>& sides, int order,
    const std::function<std::vector<BezierPatch>(const Poles& unknowns)>& patchesOf);

}  // namespace seamwright::fill
