// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <seamwright/core/differential/fundamental_forms.hpp>
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
  fill::RingSpace ring =
      fill::ringSpace(sides, options.law, spoke_scale, options.corner_tolerance_rad,
                      options.curvature_degrees.value_or(0));
  const fill::Fairest best = fill::fairest(ring.space, options.fairness_order, std::nullopt);
  RingFill result;
  result.patches = fill::ringPatches(ring.space, best.unknowns);
  result.corners = std::move(ring.corners);
  result.fairness_mm2 = best.fairness_mm2;
  result.regular =
      std::ranges::all_of(result.patches, [](const BezierPatch& p) { return provedRegular(p); });
  result.spoke_scale = spoke_scale;
  result.spoke_jump_per_mm = ring.spoke_jump_per_mm;
  if (options.curvature_degrees) {
    // As in nSidedFill().
    if (options.law == SpokeLaw::G2)
      ring.space.constants += ring.space.coefficients * best.unknowns;
    fill::CurvedPatches curved = fill::leastCurvatureJump(
        ring.space, result.patches, fill::ringEdges(), sides, options.fairness_order,
        [&](const Poles& unknowns) { return fill::ringPatches(ring.space, unknowns); });
    result.patches = std::move(curved.patches);
    result.curvature_jump_per_mm = curved.curvature_jump_per_mm;
  }
  return result;
}

/// The integral of (k1^2 + k2^2)^2, which weighs peaks of curvature, from values on a grid.
double roughness_per_mm2(const std::vector<BezierPatch>& patches) {
  constexpr int cells = 12;
  double sum = 0;
  for (const BezierPatch& patch : patches)
    for (int i = 0; i <= cells; ++i)
      for (int j = 0; j <= cells; ++j) {
        const SurfaceJet jet = patch.jet(1.0 * i / cells, 1.0 * j / cells);
        const std::optional<Eigen::Vector3d> normal = unitNormal(jet);
        if (!normal) return HUGE_VAL;
        const double squares = curvatureTensor(jet, *normal).squaredNorm();
        sum += squares * squares * std::sqrt(firstForm(jet).determinant());
      }
  return sum / (cells * cells);
}

/// The first regular fill of several lengths of the spokes.
RingFill firstRegular(const std::vector<FillSide>& sides, const RingFillOptions& options) {
  RingFill first = attempt(sides, options, 1);
  // Choices, as in nSidedFill(): shorter and longer spokes.
  for (const double scale : {0.7, 1.3, 0.5}) {
    if (first.regular) break;
    RingFill other = attempt(sides, options, scale);
    if (other.regular) return other;
  }
  return first;
}

/// The regular fill of least roughness. With G2 inside less is free, so the lengths of the spokes
/// matter more.
RingFill leastRough(const std::vector<FillSide>& sides, const RingFillOptions& options) {
  std::optional<RingFill> best;
  double least_per_mm2 = HUGE_VAL;
  for (const double scale : {1.0, 0.85, 0.7, 1.15, 1.3}) {
    RingFill fill = attempt(sides, options, scale);
    const double roughness = fill.regular ? roughness_per_mm2(fill.patches) : HUGE_VAL;
    if (best && !(roughness < least_per_mm2)) continue;
    best = std::move(fill);
    least_per_mm2 = roughness;
  }
  if (best->regular) return *best;
  RingFill other = attempt(sides, options, 0.5);
  return other.regular ? other : *best;
}

}  // namespace

RingFill ringFill(const std::vector<FillSide>& sides, const RingFillOptions& options) {
  if (sides.size() != 4)
    throw std::invalid_argument(std::to_string(sides.size()) + " sides: a ring fill has 4");
  if (options.law == SpokeLaw::Quadratic)
    throw std::invalid_argument("a ring fill has no quadratic law: linear and G2 are known");
  fill::requireSides(sides);
  fill::requireFairness(options.fairness_order);
  fill::requireTolerance(options.corner_tolerance_rad);
  fill::requireCurvature(options.curvature_degrees);
  return options.law == SpokeLaw::G2 ? leastRough(sides, options) : firstRegular(sides, options);
}

}  // namespace seamwright
