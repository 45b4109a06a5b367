// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/core/fill/hole_corner.hpp>
#include <seamwright/core/fill/triangle_space.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>

namespace seamwright::fill {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;

/// One side: -(p T + q E') with its linear functions, and the same for the spokes at its ends.
struct Across {
  Vector2d p, q;
  Poles wanted, taken;
};

Across acrossSide(const FillSide& side, const Vector3d& begin, const Vector3d& end, int degree) {
  const Poles edge1 = rows::derivative<3>(side.edge.poles());
  const Eigen::Index last = edge1.rows() - 1, last_cross = side.cross->rows() - 1;
  const Vector2d first = combination(side.cross->row(0), edge1.row(0), begin);
  const Vector2d second = combination(side.cross->row(last_cross), edge1.row(last), end);
  Across across{-Vector2d(first(0), second(0)), -Vector2d(first(1), second(1)), {}, {}};
  const rows::Field<3> field =
      rows::sum<3>(rows::product<3>(across.p, *side.cross), rows::product<3>(across.q, edge1));
  across.wanted = -rows::elevated<3>(field, degree);
  across.taken = across.wanted;
  across.taken.row(0) = begin;
  across.taken.row(degree) = end;
  return across;
}

}  // namespace

CentreFields centreFields(const std::vector<FillSide>& sides, int degree, double tolerance_rad) {
  CentreFields result;
  result.spokes.resize(3, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const HoleCorner corner(sides, k);
    result.corners.push_back(corner.convexFigures(tolerance_rad));
    result.spokes.row(static_cast<Eigen::Index>(k)) = (corner.out() - corner.in()) / 3;
  }
  result.sides.resize(3);
  result.joins.resize(3);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!sides[k].cross) continue;
    const std::size_t next = (k + 1) % 3;
    const Vector3d end =
        result.spokes.row(static_cast<Eigen::Index>(next)).transpose() + tangentAtEnd(sides[k]);
    const Across across =
        acrossSide(sides[k], result.spokes.row(static_cast<Eigen::Index>(k)), end, degree - 1);
    result.sides[k] = across.taken;
    result.joins[k] = ConnectionFunctions{.alpha = across.p, .beta = -across.q};
    for (FillCorner* corner : {&result.corners[k], &result.corners[next]})
      if (!corner->exact)
        corner->angle_bound_rad = std::max(corner->angle_bound_rad,
                                           angleBound(across.wanted, across.taken - across.wanted,
                                                      rows::derivative<3>(sides[k].edge.poles())));
  }
  return result;
}

}  // namespace seamwright::fill
