// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <utility>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>

/// The Bezier patches of a spline surface beside one of its boundaries, for functions that take
/// patches.
namespace seamwright {

/// The inner knots along a boundary as shares of its parameter range, increasing, each once.
std::vector<double> edgeBreaks(const BSplineSurface& surface, PatchEdge edge);

/// The patches beside a boundary, in the order of increasing parameter along it. Each has the
/// directions of the surface, its range along the boundary from one break to the next, and across
/// it the span at the boundary, both mapped to 0..1: the given edge of each patch is its part of
/// the boundary.
///   (1) At corresponding parameters the points of a patch are those of the surface, to rounding.
/// \param more further breaks, as shares of the parameter range; those within rounding of a knot
/// are that knot.
/// \throws std::invalid_argument as requireValid(), and for a break that is not strictly between 0
/// and 1.
std::vector<BezierPatch> edgePatches(const BSplineSurface& surface, PatchEdge edge,
                                     const std::vector<double>& more = {});

/// The patches beside two boundaries over spans that both have, in the order of the first one:
/// equal shares of both parameter ranges correspond.
///   (2) Corresponding parameters of a pair of patches are equal shares of both boundaries.
/// \param reversed the second boundary runs the other way; the patches keep their directions.
/// \throws std::invalid_argument as requireValid(), and for knots of one surface that are nearer to
/// each other than rounding where the other has a knot.
std::vector<std::pair<BezierPatch, BezierPatch>> edgePairs(const BSplineSurface& a,
                                                           PatchEdge edge_a,
                                                           const BSplineSurface& b,
                                                           PatchEdge edge_b, bool reversed);

}  // namespace seamwright
