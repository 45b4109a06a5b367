// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/core/fill/hole_corner.hpp>
#include <seamwright/core/fill/regular.hpp>
#include <seamwright/core/fill/three_sided_fill.hpp>
#include <seamwright/core/fill/triangle_space.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

int degreeOf(const std::vector<FillSide>& sides) {
  int degree = 3;
  for (const FillSide& side : sides) {
    degree = std::max(degree, side.edge.degree() + (side.cross ? 1 : 0));
    if (side.cross) degree = std::max(degree, static_cast<int>(side.cross->rows()) + 1);
  }
  return degree;
}

void fillFairest(ThreeSidedFill& result, const fill::TriangleSpace& space, int order) {
  const Eigen::MatrixXd matrix = fill::tensorsOf(space, space.coefficients, order);
  const Poles fixed = fill::tensorsOf(space, space.constants, order);
  const Poles unknowns =
      matrix.cols() == 0 ? Poles(0, 3) : Poles(linear::LeastSquares(matrix).solve(-fixed));
  result.triangles = fill::trianglesOf(space, unknowns);
  result.fairness_mm2 = (matrix * unknowns + fixed).squaredNorm();
  result.regular = std::ranges::all_of(result.triangles,
                                       [](const BezierTriangle& t) { return provedRegular(t); });
}

}  // namespace

ThreeSidedFill threeSidedFill(const std::vector<FillSide>& sides,
                              const ThreeSidedFillOptions& options) {
  if (sides.size() != 3)
    throw std::invalid_argument(std::to_string(sides.size()) + " sides: a fill by triangles has 3");
  fill::requireSides(sides);
  fill::requireFairness(options.fairness_order);
  fill::requireTolerance(options.corner_tolerance_rad);
  const int degree = degreeOf(sides);
  fill::CentreFields fields = fill::centreFields(sides, degree, options.corner_tolerance_rad);
  const fill::TriangleSpace space = fill::triangleSpace(sides, fields, degree);
  ThreeSidedFill result;
  result.sides = std::move(fields.joins);
  result.corners = std::move(fields.corners);
  fillFairest(result, space, options.fairness_order);
  if (!result.regular) {
    ThreeSidedFill other = result;
    fillFairest(other, space, 5 - options.fairness_order);
    if (other.regular) return other;
  }
  return result;
}

}  // namespace seamwright
