// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <seamwright/core/fill/three_sided_fill.hpp>
#include <seamwright/core/seam/triangle_side.hpp>

#include "fills.hpp"
#include "triangles.hpp"

/// What is asked of fills by triangles, from the definitions.
namespace seamwright::test {

inline SeamFigures spokeFigures(const ThreeSidedFill& fill, int k) {
  return encloseSeam(seamSide(fill.triangles[k], TriangleEdge::L1),
                     seamSide(fill.triangles[(k + 2) % 3], TriangleEdge::L0, true), fine());
}

inline SeamFigures sideFigures(const ThreeSidedFill& fill, const std::vector<FillSide>& sides,
                               int k) {
  return encloseSeam(seamSide(fill.triangles[k], TriangleEdge::L2),
                     seamSide(neighbour(sides[k]), PatchEdge::U0), fine());
}

/// Up, by the sum that defines the triangle.
inline Eigen::Vector3d exactNormal(const BezierTriangle& triangle, double l0, double l1) {
  const Eigen::Vector3d u = exactPartial(triangle, 1, 0, l0, l1).head<3>().cast<double>(),
                        v = exactPartial(triangle, 0, 1, l0, l1).head<3>().cast<double>();
  return u.cross(v).normalized();
}

/// Of oriented normals: pi for a fold.
inline double angleOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The largest angle between normals at 65 places across spoke k.
inline double spokeAngle(const ThreeSidedFill& fill, int k) {
  double worst = 0;
  for (int i = 0; i <= 64; ++i)
    worst = std::max(worst, angleOf(exactNormal(fill.triangles[k], i / 64.0, 0),
                                    exactNormal(fill.triangles[(k + 2) % 3], 0, i / 64.0)));
  return worst;
}

/// The same to the tangent planes of side k, T x E'.
inline double sideAngle(const ThreeSidedFill& fill, const std::vector<FillSide>& sides, int k) {
  double worst = 0;
  for (int i = 0; i <= 64; ++i) {
    const double t = i / 64.0;
    const Eigen::Vector3d plane =
        BezierCurve(*sides[k].cross).point(t).cross(sides[k].edge.jet(t).d1).normalized();
    worst = std::max(worst, angleOf(exactNormal(fill.triangles[k], 1 - t, t), plane));
  }
  return worst;
}

/// The sum that is made least, with the directions of all three sides of the large triangle in
/// place of an orthonormal frame: their dyads add up to 3/2 of the unit tensor.
inline double fairness(const std::vector<BezierTriangle>& triangles, int order) {
  const std::array<Eigen::Vector3i, 3> directions = {
      Eigen::Vector3i(-1, 1, 0), {-1, -2, 3}, {2, 1, -3}};
  using Net = std::map<std::array<int, 3>, Eigen::Vector3d>;
  const std::function<double(const Net&, int, int)> sum = [&](const Net& net, int degree,
                                                              int rest) {
    double total = 0;
    if (rest == 0)
      for (const auto& [index, point] : net) total += point.squaredNorm();
    else
      for (const Eigen::Vector3i& d : directions) {
        Net next;
        for (int i = 0; i < degree; ++i)
          for (int j = 0; i + j < degree; ++j) {
            const int k = degree - 1 - i - j;
            next[{i, j, k}] = d(0) * net.at({i + 1, j, k}) + d(1) * net.at({i, j + 1, k}) +
                              d(2) * net.at({i, j, k + 1});
          }
        total += 2.0 / 3 * sum(next, degree - 1, rest - 1);
      }
    return total;
  };
  double total = 0;
  for (const BezierTriangle& triangle : triangles) {
    const int n = triangle.degree();
    Net net;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) net[{i, j, n - i - j}] = triangle.pole(i, j);
    total += sum(net, n, order);
  }
  return total;
}

inline double difference(const BezierTriangle& a, const BezierTriangle& b) {
  return a.degree() == b.degree() ? (a.poles() - b.poles()).cwiseAbs().maxCoeff() : INFINITY;
}

}  // namespace seamwright::test
