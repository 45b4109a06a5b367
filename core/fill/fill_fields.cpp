// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <seamwright/core/fill/fill_fields.hpp>
#include <seamwright/core/fill/hole_corner.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>

namespace seamwright::fill {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;
using rows::Field;

/// The scalar functions of G = p T + q E', linear and quadratic on either half.
struct Scalars {
  double p_begin = 0, p_middle = 0, p_end = 0;
  double q_begin = 0, q_end = 0;
  double q_slope_begin = 0, q_slope_end = 0;
};

/// Steps 1 and 2: G at the ends of a side is half the tangent of the sides next to it, p is linear
/// on each half.
Scalars scalarsOf(const HoleCorner& begin, const HoleCorner& end, SpokeLaw law, int n) {
  Scalars s;
  const Vector2d first = combination(begin.after()->cross, begin.after()->edge, begin.in() / 2);
  const Vector2d last = combination(end.before()->cross, end.before()->edge, -end.out() / 2);
  s.p_begin = first(0), s.q_begin = first(1);
  s.p_end = last(0), s.q_end = last(1);
  s.p_middle = (s.p_begin + s.p_end) / (2 + slopeAtSide(law, n));
  s.q_slope_begin = s.q_slope_end = s.q_end - s.q_begin;
  return s;
}

/// Steps 3 and 6: slopes of q such that the mixed derivatives of the fill agree except for a normal
/// part, which is returned.
Vector3d meetTwists(const HoleCorner& corner, Scalars& before, Scalars& after,
                    FillCorner& figures) {
  const SideEnd &b = *corner.before(), &a = *corner.after();
  const double p1_before = 2 * (before.p_end - before.p_middle),
               p1_after = 2 * (after.p_middle - after.p_begin);
  const Vector3d known = after.p_begin * a.cross1 + p1_after * a.cross + after.q_begin * a.edge2 +
                         before.p_end * b.cross1 + p1_before * b.cross + before.q_end * b.edge2;
  const Vector2d slopes = combination(a.edge, b.edge, -known);
  after.q_slope_begin = slopes(0), before.q_slope_end = slopes(1);
  const Vector3d normal = corner.in().cross(corner.out()).normalized();
  figures.twist_defect_mm = normal.dot(known);
  const double noise = (after.p_begin + before.p_end + std::abs(p1_after) + std::abs(p1_before)) *
                           (a.noise + b.noise) * 4 +
                       16 * (std::abs(after.q_begin) * a.noise + std::abs(before.q_end) * b.noise);
  figures.exact = figures.exact && std::abs(figures.twist_defect_mm) <= noise;
  return known + slopes(0) * a.edge + slopes(1) * b.edge;
}

/// Step 4: Bernstein coefficients of p and q on the halves; q is chosen such that the slope of G
/// jumps in the middle as the spoke requires.
struct HalfScalars {
  Eigen::VectorXd p, q;
};

std::array<HalfScalars, 2> halfScalars(const Scalars& s, SpokeLaw law, int n) {
  const double left = s.q_begin + s.q_slope_begin / 4, right = s.q_end - s.q_slope_end / 4;
  const double middle = 2 * (left + right) / (4 + slopeAtSide(law, n));
  return {HalfScalars{Eigen::Vector2d(s.p_begin, s.p_middle), Vector3d(s.q_begin, left, middle)},
          HalfScalars{Eigen::Vector2d(s.p_middle, s.p_end), Vector3d(middle, right, s.q_end)}};
}

/// One half of a side during construction: the derivative that the tangent planes require, and the
/// one used.
struct Half {
  Poles edge1, wanted, taken;
};

std::array<Half, 2> halvesOf(const FillSide& side, const std::array<HalfScalars, 2>& scalars,
                             int degree) {
  const std::array<Poles, 2> edge1 = halved(rows::derivative<3>(side.edge.poles())),
                             cross = halved(*side.cross);
  std::array<Half, 2> halves;
  for (std::size_t h = 0; h < 2; ++h) {
    const Field<3> field = rows::sum<3>(rows::product<3>(scalars[h].p, cross[h]),
                                        rows::product<3>(scalars[h].q, edge1[h]));
    const Poles raised = rows::elevated<3>(field, degree);
    halves[h] = {edge1[h], raised, raised};
  }
  return halves;
}

}  // namespace

std::array<Poles, 2> halved(const Poles& coefficients) {
  const auto [left, right] = BezierCurve(coefficients).split(0.5);
  return {left.poles(), right.poles()};
}

CrossBoundaryDerivatives crossBoundaryDerivatives(const std::vector<FillSide>& sides, SpokeLaw law,
                                                  int degree, double tolerance_rad) {
  const std::size_t n = sides.size();
  const auto next = [n](std::size_t k) { return (k + 1) % n; };
  std::vector<HoleCorner> corners;
  CrossBoundaryDerivatives result;
  for (std::size_t k = 0; k < n; ++k) {
    corners.emplace_back(sides, k);
    result.corners.push_back(corners[k].convexFigures(tolerance_rad));
  }
  std::vector<Scalars> scalars(n);
  for (std::size_t k = 0; k < n; ++k)
    if (sides[k].cross)
      scalars[k] = scalarsOf(corners[k], corners[next(k)], law, static_cast<int>(n));
  std::vector<Vector3d> defects(n, Vector3d::Zero());
  for (std::size_t k = 0; k < n; ++k)
    if (corners[k].before() && corners[k].after())
      defects[k] = meetTwists(corners[k], scalars[(k + n - 1) % n], scalars[k], result.corners[k]);

  result.sides.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    if (!sides[k].cross) continue;
    const std::array<HalfScalars, 2> functions = halfScalars(scalars[k], law, static_cast<int>(n));
    std::array<Half, 2> halves = halvesOf(sides[k], functions, degree);
    Poles &left = halves[0].taken, &right = halves[1].taken;
    left.row(0) = corners[k].in() / 2;
    right.row(degree) = -corners[next(k)].out() / 2;
    left.row(1) += (left.row(0) - halves[0].wanted.row(0)) - defects[k].transpose() / (4 * degree);
    right.row(degree - 1) += (right.row(degree) - halves[1].wanted.row(degree)) +
                             defects[next(k)].transpose() / (4 * degree);
    SideField field{{left, right}, {}};
    for (std::size_t h = 0; h < 2; ++h) {
      field.joins[h].alpha = functions[h].p;
      field.joins[h].beta = -2 * functions[h].q;
      FillCorner& corner = result.corners[h == 0 ? k : next(k)];
      if (!corner.exact)
        corner.angle_bound_rad = std::max(
            corner.angle_bound_rad,
            angleBound(halves[h].wanted, halves[h].taken - halves[h].wanted, halves[h].edge1));
    }
    result.sides[k] = std::move(field);
  }
  return result;
}

}  // namespace seamwright::fill
