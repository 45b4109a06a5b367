// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/local_origin.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// So many sizes away from 0 a curve has lost ten of the 53 binary digits of its coordinates.
constexpr double far_away = 1024;

/// \param size_mm of the curve, if it is larger than the distances of the points.
Vector2d originOf(const PlanarPoints& points, double size_mm) {
  const Eigen::RowVector2d low = points.colwise().minCoeff(), high = points.colwise().maxCoeff();
  size_mm = std::max(size_mm, (high - low).maxCoeff());
  Vector2d origin = Vector2d::Zero();
  for (int axis = 0; axis < 2; ++axis)
    if (std::min(std::abs(low[axis]), std::abs(high[axis])) > far_away * size_mm)
      origin[axis] = points(0, axis);
  return origin;
}

}  // namespace

Vector2d localOrigin(const PlanarPoints& points) {
  return points.rows() > 0 ? originOf(points, 0) : Vector2d::Zero();
}

Vector2d localOrigin(const PlanarChain& chain) {
  std::vector<Vector2d> found;
  double size_mm = 0;
  for (const ChainCurve& curve : chain.curves) {
    found.push_back(startOf(curve));
    found.push_back(endOf(curve));
    if (const auto* arc = std::get_if<PlanarArc>(&curve))
      size_mm = std::max(size_mm, std::abs(arc->length_mm));
    if (const auto* conic = std::get_if<PlanarConic>(&curve)) found.push_back(conic->corner);
    if (const auto* spline = std::get_if<BSplineCurve>(&curve))
      for (Eigen::Index i = 0; i < spline->poles.rows(); ++i)
        found.emplace_back(spline->poles.row(i).head<2>() / spline->poles(i, 3));
  }
  if (found.empty()) return Vector2d::Zero();
  PlanarPoints points(static_cast<Eigen::Index>(found.size()), 2);
  for (std::size_t i = 0; i < found.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) = found[i].transpose();
  return originOf(points, size_mm);
}

PlanarChain moved(const PlanarChain& chain, const Vector2d& by) {
  PlanarChain result = chain;
  for (ChainCurve& curve : result.curves) {
    if (auto* arc = std::get_if<PlanarArc>(&curve)) arc->start += by;
    if (auto* conic = std::get_if<PlanarConic>(&curve))
      for (Vector2d* point : {&conic->start, &conic->corner, &conic->end}) *point += by;
    if (auto* spline = std::get_if<BSplineCurve>(&curve))
      spline->poles.leftCols<2>() += spline->poles.col(3) * by.transpose();
  }
  return result;
}

double roundingAt_mm(const Vector2d& origin) {
  // Half of the last digit of each coordinate, which may have twice the size of the origin.
  return machine_epsilon * origin.lpNorm<1>();
}

}  // namespace seamwright
