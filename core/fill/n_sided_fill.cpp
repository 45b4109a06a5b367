// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/core/fill/fill_curvature.hpp>
#include <seamwright/core/fill/fill_fairing.hpp>
#include <seamwright/core/fill/hole_corner.hpp>
#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/core/fill/regular.hpp>
#include <seamwright/core/join/ribbon.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

void requireInput(const std::vector<FillSide>& sides, const FillOptions& options) {
  if (sides.size() < 3 || sides.size() > 12)
    throw std::invalid_argument(std::to_string(sides.size()) + " sides: a fill has 3 to 12");
  fill::requireSides(sides);
  fill::requireFairness(options.fairness_order);
  fill::requireTolerance(options.corner_tolerance_rad);
  fill::requireCurvature(options.curvature_degrees);
}

int degreeOf(const std::vector<FillSide>& sides, const FillOptions& options) {
  int degree = options.law == SpokeLaw::Linear ? 4 : 5;
  for (const FillSide& side : sides) {
    degree = std::max(degree, side.edge.degree() + 1);
    if (side.cross) degree = std::max(degree, static_cast<int>(side.cross->rows()));
  }
  return degree + options.curvature_degrees.value_or(0);
}

ConnectionFunctions acrossSpokes(SpokeLaw law, int n) {
  ConnectionFunctions connection;
  connection.beta = Eigen::VectorXd::Zero(law == SpokeLaw::Linear ? 2 : 3);
  connection.beta(0) = fill::starFactor(n);
  return connection;
}

/// Sets \p result to the fairest fill whose patches are regular.
void chooseFairest(NSidedFill& result, const fill::FillSpace& space, int order) {
  const auto attempt = [&](int differences, std::optional<double> scale) {
    const fill::Fairest best = fill::fairest(space, differences, scale);
    NSidedFill tried = result;
    tried.patches = fill::patchesOf(space, best.unknowns);
    tried.fairness_mm2 = best.fairness_mm2;
    tried.spoke_scale = scale;
    tried.regular =
        std::ranges::all_of(tried.patches, [](const BezierPatch& p) { return provedRegular(p); });
    return tried;
  };
  const NSidedFill first = attempt(order, std::nullopt);
  result = first;
  for (const int differences : {order, 5 - order})
    // Choices: the relative length of the spokes, from the expected one to ever further ones.
    for (const double scale : {1.0, 0.7, 1.4, 0.5, 2.0}) {
      if (result.regular) return;
      result = attempt(differences, scale);
    }
  if (!result.regular) result = first;
}

}  // namespace

FillSide fillSide(const BezierPatch& neighbour, PatchEdge edge, bool reversed) {
  if (neighbour.isRational())
    throw std::invalid_argument("the neighbour is rational, fills are built from polynomials");
  const Ribbon beyond = ribbon(neighbour, edge, reversed, Across::Into);
  return {BezierCurve(Poles(beyond.position.leftCols<3>())), Poles(beyond.first.leftCols<3>()),
          Poles(beyond.second.leftCols<3>())};
}

NSidedFill nSidedFill(const std::vector<FillSide>& sides, const FillOptions& options) {
  requireInput(sides, options);
  const int degree = degreeOf(sides, options);
  fill::CrossBoundaryDerivatives fields =
      fill::crossBoundaryDerivatives(sides, options.law, degree, options.corner_tolerance_rad);
  const fill::FillSpace space = fill::fillSpace(sides, fields, options.law, degree);
  NSidedFill result;
  result.spoke = acrossSpokes(options.law, static_cast<int>(sides.size()));
  for (const std::optional<fill::SideField>& field : fields.sides)
    result.sides.push_back(field ? std::optional(field->joins) : std::nullopt);
  result.corners = std::move(fields.corners);
  chooseFairest(result, space, options.fairness_order);
  if (options.curvature_degrees) {
    fill::CurvedPatches curved = fill::leastCurvatureJump(
        space, result.patches, fill::starEdges(space.patches), sides, options.fairness_order,
        [&](const Poles& unknowns) { return fill::patchesOf(space, unknowns); });
    result.patches = std::move(curved.patches);
    result.curvature_jump_per_mm = curved.curvature_jump_per_mm;
  }
  return result;
}

}  // namespace seamwright
