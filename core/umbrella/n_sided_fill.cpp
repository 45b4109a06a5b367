// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/join/ribbon.hpp>
#include <seamwright/core/umbrella/fill_fairing.hpp>
#include <seamwright/core/umbrella/n_sided_fill.hpp>
#include <seamwright/core/umbrella/regular.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

using bernstein::text;

constexpr int max_side_degree = 12;

std::string sideName(std::size_t k) {
  return "side " + std::to_string(k);
}

void requireDegree(int degree, int lowest, const std::string& what) {
  if (degree < lowest || degree > max_side_degree)
    throw std::invalid_argument(what + " has degree " + std::to_string(degree) + ": it must be within " +
                                std::to_string(lowest) + " to " + std::to_string(max_side_degree));
}

void requireSide(const FillSide& side, std::size_t k) {
  if (side.edge.isRational())
    throw std::invalid_argument(sideName(k) + ": the edge is rational, fills are built from polynomials");
  requireDegree(side.edge.degree(), 1, sideName(k) + ": the edge");
  if (!side.cross) return;
  requireDegree(static_cast<int>(side.cross->rows()) - 1, 0, sideName(k) + ": the cross field");
  for (Eigen::Index i = 0; i < side.cross->rows(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!std::isfinite((*side.cross)(i, c)))
        throw std::invalid_argument(sideName(k) + ": coefficient " + std::to_string(i) +
                                    " of the cross field is " + text((*side.cross)(i, c)));
}

void requireClosed(const std::vector<FillSide>& sides) {
  double size = 0;
  for (const FillSide& side : sides) size = std::max(size, rows::size(side.edge.poles()));
  const double noise = 64 * std::numeric_limits<double>::epsilon() * size;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const std::size_t before = (k + sides.size() - 1) % sides.size();
    const double gap = (sides[before].edge.point(1) - sides[k].edge.point(0)).norm();
    if (gap > noise)
      throw std::invalid_argument(sideName(k) + " begins " + text(gap) + " mm from where " +
                                  sideName(before) + " ends, rounding is " + text(noise));
    if (fill::tangentAtBegin(sides[k]).norm() <= noise || fill::tangentAtEnd(sides[k]).norm() <= noise)
      throw std::invalid_argument(sideName(k) + ": the edge has no tangent at one of its ends");
  }
}

void requireInput(const std::vector<FillSide>& sides, const FillOptions& options) {
  if (sides.size() < 3 || sides.size() > 12)
    throw std::invalid_argument(std::to_string(sides.size()) + " sides: a fill has 3 to 12");
  for (std::size_t k = 0; k < sides.size(); ++k) requireSide(sides[k], k);
  if (options.fairness_order != 2 && options.fairness_order != 3)
    throw std::invalid_argument("fairness order " + std::to_string(options.fairness_order) +
                                ": known are 2 and 3");
  if (!(options.corner_tolerance_rad >= 0 && options.corner_tolerance_rad <= 0.1))
    throw std::invalid_argument("corner tolerance " + text(options.corner_tolerance_rad) +
                                " rad is not within 0 to 0.1");
  requireClosed(sides);
}

int degreeOf(const std::vector<FillSide>& sides, SpokeLaw law) {
  int degree = law == SpokeLaw::Linear ? 4 : 5;
  for (const FillSide& side : sides) {
    degree = std::max(degree, side.edge.degree() + 1);
    if (side.cross) degree = std::max(degree, static_cast<int>(side.cross->rows()));
  }
  return degree;
}

Connection acrossSpokes(SpokeLaw law, int n) {
  Connection connection;
  connection.beta = Eigen::VectorXd::Zero(law == SpokeLaw::Linear ? 2 : 3);
  connection.beta(0) = fill::starFactor(n);
  return connection;
}

/// Fills \p result as fairly as its patches stay regular.
void chooseFairest(NSidedFill& result, const fill::FillSpace& space, int order) {
  const auto attempt = [&](int differences, std::optional<double> scale) {
    const fill::Fairest best = fill::fairest(space, differences, scale);
    NSidedFill tried = result;
    tried.patches = fill::patchesOf(space, best.unknowns);
    tried.fairness_mm2 = best.fairness_mm2;
    tried.spoke_scale = scale;
    tried.regular = std::ranges::all_of(tried.patches, [](const BezierPatch& p) { return provedRegular(p); });
    return tried;
  };
  const NSidedFill first = attempt(order, std::nullopt);
  result = first;
  for (const int differences : {order, 5 - order})
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
  return {BezierCurve(Poles(beyond.position.leftCols<3>())), Poles(beyond.first.leftCols<3>())};
}

NSidedFill nSidedFill(const std::vector<FillSide>& sides, const FillOptions& options) {
  requireInput(sides, options);
  const int degree = degreeOf(sides, options.law);
  fill::CrossFields fields = fill::crossFields(sides, options.law, degree, options.corner_tolerance_rad);
  const fill::FillSpace space = fill::fillSpace(sides, fields, options.law, degree);
  NSidedFill result;
  result.spoke = acrossSpokes(options.law, static_cast<int>(sides.size()));
  for (const std::optional<fill::SideField>& field : fields.sides)
    result.sides.push_back(field ? std::optional(field->joins) : std::nullopt);
  result.corners = std::move(fields.corners);
  chooseFairest(result, space, options.fairness_order);
  return result;
}

}  // namespace seamwright
