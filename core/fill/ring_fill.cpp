// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/core/fill/fill_curvature.hpp>
#include <seamwright/core/fill/fill_fairing.hpp>
#include <seamwright/core/fill/hole_corner.hpp>
#include <seamwright/core/fill/regular.hpp>
#include <seamwright/core/fill/ring_fill.hpp>
#include <seamwright/core/fill/ring_space.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

RingFill attempt(const std::vector<FillSide>& sides, const RingFillOptions& options,
                 double spoke_scale) {
  fill::RingSpace ring = fill::ringSpace(sides, spoke_scale, options.corner_tolerance_rad,
                                         options.curvature_degrees.value_or(0));
  const fill::Fairest best = fill::fairest(ring.space, options.fairness_order, std::nullopt);
  RingFill result;
  result.patches = fill::ringPatches(ring.space, best.unknowns);
  result.corners = std::move(ring.corners);
  result.fairness_mm2 = best.fairness_mm2;
  result.regular =
      std::ranges::all_of(result.patches, [](const BezierPatch& p) { return provedRegular(p); });
  result.spoke_scale = spoke_scale;
  if (options.curvature_degrees) {
    fill::CurvedPatches curved = fill::leastCurvatureJump(
        ring.space, result.patches, fill::ringEdges(), sides, options.fairness_order,
        [&](const Poles& unknowns) { return fill::ringPatches(ring.space, unknowns); });
    result.patches = std::move(curved.patches);
    result.curvature_jump_per_mm = curved.curvature_jump_per_mm;
  }
  return result;
}

}  // namespace

RingFill ringFill(const std::vector<FillSide>& sides, const RingFillOptions& options) {
  if (sides.size() != 4)
    throw std::invalid_argument(std::to_string(sides.size()) + " sides: a ring fill has 4");
  fill::requireSides(sides);
  fill::requireFairness(options.fairness_order);
  fill::requireTolerance(options.corner_tolerance_rad);
  fill::requireCurvature(options.curvature_degrees);
  RingFill first = attempt(sides, options, 1);
  // Choices, as in nSidedFill(): shorter and longer spokes.
  for (const double scale : {0.7, 1.3, 0.5}) {
    if (first.regular) break;
    RingFill other = attempt(sides, options, scale);
    if (other.regular) return other;
  }
  return first;
}

}  // namespace seamwright
