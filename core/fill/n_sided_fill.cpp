// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/core/fill/fill_curvature.hpp>
#include <seamwright/core/fill/fill_fairing.hpp>
#include <seamwright/core/fill/hole_corner.hpp>
#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/core/fill/regular.hpp>
#include <seamwright/core/fill/spoke_curvature.hpp>
#include <seamwright/core/join/ribbon.hpp>
#include <stdexcept>
#include <string>
#include <utility>

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

int leastDegree(SpokeLaw law) {
  switch (law) {
    case SpokeLaw::Linear:
      return 4;
    case SpokeLaw::Quadratic:
      return 5;
    default:
      return 6;
  }
}

int degreeOf(const std::vector<FillSide>& sides, const FillOptions& options) {
  const int raise = options.law == SpokeLaw::G2 ? 2 : 1;
  int degree = leastDegree(options.law);
  for (const FillSide& side : sides) {
    degree = std::max(degree, side.edge.degree() + raise);
    if (side.cross) degree = std::max(degree, static_cast<int>(side.cross->rows()) - 1 + raise);
  }
  return degree + options.curvature_degrees.value_or(0);
}

ConnectionFunctions acrossSpokes(SpokeLaw law, int n) {
  ConnectionFunctions connection;
  connection.beta = Eigen::VectorXd::Zero(law == SpokeLaw::Quadratic ? 3 : 2);
  connection.beta(0) = fill::starFactor(n);
  return connection;
}

/// Which sum of squares is least, and with which length of the spokes.
struct Fairness {
  int order = 3;
  std::optional<double> spoke_scale = std::nullopt;
};

/// In this order until the patches are regular.
std::vector<Fairness> fairnessChoices(const fill::FillSpace& space, int order) {
  const int other = 5 - order;
  std::vector<Fairness> choices = {{order}};
  if (!space.centre) {
    choices.push_back({other});
    return choices;
  }
  for (const int differences : {order, other})
    // Choices: the relative length of the spokes, from the expected one to ever further ones.
    for (const double scale : {1.0, 0.7, 1.4, 0.5, 2.0}) choices.push_back({differences, scale});
  return choices;
}

/// Sets \p result to the fairest fill whose patches are regular.
/// \returns its unknowns.
Poles chooseFairest(NSidedFill& result, const fill::FillSpace& space, int order) {
  std::optional<std::pair<NSidedFill, Poles>> first;
  for (const Fairness& choice : fairnessChoices(space, order)) {
    const fill::Fairest best = fill::fairest(space, choice.order, choice.spoke_scale);
    result.patches = fill::patchesOf(space, best.unknowns);
    result.fairness_mm2 = best.fairness_mm2;
    result.spoke_scale = choice.spoke_scale;
    result.regular =
        std::ranges::all_of(result.patches, [](const BezierPatch& p) { return provedRegular(p); });
    if (result.regular) return best.unknowns;
    if (!first) first = {result, best.unknowns};
  }
  result = std::move(first->first);
  return std::move(first->second);
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
  fill::FillSpace space = fill::fillSpace(sides, fields, options.law, degree);
  if (options.law == SpokeLaw::G2) space = fill::withG2Spokes(space);
  NSidedFill result;
  result.spoke = acrossSpokes(options.law, static_cast<int>(sides.size()));
  for (const std::optional<fill::SideField>& field : fields.sides)
    result.sides.push_back(field ? std::optional(field->joins) : std::nullopt);
  result.corners = std::move(fields.corners);
  const Poles fairest = chooseFairest(result, space, options.fairness_order);
  if (options.curvature_degrees) {
    // The unknowns of G2 are no points: what neither jumps nor fairness decide stays as it is.
    if (options.law == SpokeLaw::G2) space.constants += space.coefficients * fairest;
    fill::CurvedPatches curved = fill::leastCurvatureJump(
        space, result.patches, fill::starEdges(space.patches), sides, options.fairness_order,
        [&](const Poles& unknowns) { return fill::patchesOf(space, unknowns); });
    result.patches = std::move(curved.patches);
    result.curvature_jump_per_mm = curved.curvature_jump_per_mm;
  }
  return result;
}

}  // namespace seamwright
