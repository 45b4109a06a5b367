// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <random>
#include <seamwright/core/join/nearest/nearest.hpp>
#include <vector>

#include "seam_sides.hpp"

/// Random spline surfaces that nearly meet along an edge of each.
namespace seamwright::test {

/// 0 and 1 degree + 1 times, the inner knots between.
inline std::vector<double> clampedKnots(int degree, const std::vector<double>& inner = {}) {
  std::vector<double> knots(degree + 1, 0.0);
  knots.insert(knots.end(), inner.begin(), inner.end());
  knots.insert(knots.end(), degree + 1, 1.0);
  return knots;
}

struct StripShape {
  int across = 3;  ///< degrees
  int along = 3;
  std::vector<double> inner = {};  ///< knots along the seam
  bool rational = false;
};

/// A surface whose edge u = 0 lies near x = 0, y = 0..10, with the rows at x = 3 sense, 6 sense,
/// ...
inline BSplineSurface strip(const StripShape& shape, double sense, double noise,
                            std::mt19937_64& random) {
  BSplineSurface surface;
  surface.degree_u = shape.across;
  surface.degree_v = shape.along;
  surface.knots_u = clampedKnots(shape.across);
  surface.knots_v = clampedKnots(shape.along, shape.inner);
  const int columns = surface.countV();
  surface.poles.resize(static_cast<Eigen::Index>(shape.across + 1) * columns, 4);
  for (int i = 0; i <= shape.across; ++i)
    for (int j = 0; j < columns; ++j) {
      double y = 0;  // the Greville point, so that parameters run evenly
      for (int k = 1; k <= shape.along; ++k) y += 10 * surface.knots_v[j + k] / shape.along;
      const double x = sense * 3 * i, z = 0.05 * x * x + 0.03 * y * y - 0.04 * x * y;
      const double weight =
          shape.rational ? std::uniform_real_distribution<double>(0.7, 1.4)(random) : 1;
      const Vec pole = Vec(x, y, z) + noise * randomVector(random);
      surface.poles.row(static_cast<Eigen::Index>(i) * columns + j) << weight * pole.transpose(),
          weight;
    }
  return surface;
}

/// The same surface with u, v exchanged or run backwards, so that the edge u = 0 becomes that edge.
inline BSplineSurface turned(const BSplineSurface& surface, PatchEdge edge) {
  const bool at_end = edge == PatchEdge::U1 || edge == PatchEdge::V1;
  const bool exchanged = edge == PatchEdge::V0 || edge == PatchEdge::V1;
  BSplineSurface result = surface;
  const int rows = surface.countU(), columns = surface.countV();
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const Eigen::Index to = at_end ? rows - 1 - i : i;
      result.poles.row(exchanged ? j * rows + to : to * columns + j) =
          surface.poles.row(static_cast<Eigen::Index>(i) * columns + j);
    }
  if (at_end)
    for (std::size_t k = 0; k < surface.knots_u.size(); ++k)
      result.knots_u[k] = surface.knots_u.front() + surface.knots_u.back() -
                          surface.knots_u[surface.knots_u.size() - 1 - k];
  if (exchanged) {
    std::swap(result.degree_u, result.degree_v);
    std::swap(result.knots_u, result.knots_v);
  }
  return result;
}

/// Every pole through x -> scale R x + translation.
inline BSplineSurface mapped(const BSplineSurface& surface, const Eigen::Matrix3d& R,
                             const Vec& translation) {
  BSplineSurface result = surface;
  for (Eigen::Index i = 0; i < surface.poles.rows(); ++i) {
    const Eigen::Vector4d h = surface.poles.row(i);
    result.poles.row(i).head<3>() = (R * h.head<3>() + h(3) * translation).transpose();
  }
  return result;
}

inline double largestDifference(const BSplineSurface& a, const BSplineSurface& b) {
  return (a.poles - b.poles).cwiseAbs().maxCoeff();
}

}  // namespace seamwright::test
