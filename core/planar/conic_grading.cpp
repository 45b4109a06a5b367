// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include <seamwright/core/planar/conic_grading.hpp>

namespace seamwright {

namespace {

/// A part of a span with the length that conics are to have there.
struct GradedCell {
  double u = 0, width = 0;  ///< of the parameter
  double length_mm = 0, wished_mm = 0;
};

/// Lengths that change gradually: jumps of the length make waves of the curvature.
void grade(std::vector<GradedCell>& cells) {
  // A choice: neighbours differ by about a quarter.
  constexpr double growth = 0.25;
  for (std::size_t i = 1; i < cells.size(); ++i)
    cells[i].wished_mm =
        std::min(cells[i].wished_mm, cells[i - 1].wished_mm + growth * cells[i].length_mm);
  for (std::size_t i = cells.size() - 1; i > 0; --i)
    cells[i - 1].wished_mm =
        std::min(cells[i - 1].wished_mm, cells[i].wished_mm + growth * cells[i - 1].length_mm);
}

/// Points between two that stay, such that each span has its share.
void appendGraded(const PlanarCurve& curve, std::vector<GradedCell> cells,
                  std::vector<ConicPoint>& points) {
  grade(cells);
  double spans = 0;
  for (const GradedCell& cell : cells) spans += cell.length_mm / cell.wished_mm;
  const int count = std::max(1, static_cast<int>(std::ceil(spans)));
  double passed = 0;
  int next = 1;
  for (const GradedCell& cell : cells) {
    const double share = cell.length_mm / cell.wished_mm / spans * count;
    for (; next < count && next <= passed + share; ++next) {
      const double u = cell.u + cell.width * (next - passed) / share;
      points.push_back({.u = u, .point = curve.point(u)});
    }
    passed += share;
  }
}

}  // namespace

std::vector<ConicPoint> regraded(const PlanarCurve& curve, const std::vector<ConicPoint>& points,
                                 const std::vector<double>& distances_mm, double tolerance_mm) {
  // Choices: the rest of the tolerance is for what the order does not tell; far from it, it tells
  // little.
  constexpr double aim = 0.6, most_change = 4;
  constexpr int cells_per_span = 16;
  std::vector<ConicPoint> result = {points.front()};
  std::vector<GradedCell> cells;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const ConicPoint &from = points[i], &to = points[i + 1];
    if (!from.line_after) {
      const double length_mm = (to.point - from.point).norm();
      const double parts = std::clamp(std::sqrt(std::sqrt(distances_mm[i] / (aim * tolerance_mm))),
                                      1 / most_change, most_change);
      for (int k = 0; k < cells_per_span; ++k)
        cells.push_back({.u = std::lerp(from.u, to.u, static_cast<double>(k) / cells_per_span),
                         .width = (to.u - from.u) / cells_per_span,
                         .length_mm = length_mm / cells_per_span,
                         .wished_mm = length_mm / parts});
    }
    if (i + 2 < points.size() && !from.line_after && !to.line_after) continue;
    if (!cells.empty()) appendGraded(curve, std::move(cells), result);
    cells.clear();
    result.push_back(to);
  }
  return result;
}

}  // namespace seamwright
