// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <seamwright/core/fill/fill_fields.hpp>
#include <seamwright/core/fill/hole_corner.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>

namespace seamwright::fill {

namespace {

using Eigen::Vector2d, Eigen::Vector3d, Eigen::Vector4d;
using rows::Field;

/// A function on both halves of a side, Bernstein coefficients.
using OnHalves = std::array<Eigen::VectorXd, 2>;

/// The scalar functions of G = p T + q E'. For G1 p is linear and q quadratic on either half, for
/// G2 both are of one degree more.
struct Scalars {
  OnHalves p;
  double q_begin = 0, q_end = 0;
  double q_slope_begin = 0, q_slope_end = 0;
};

/// p from its ends, such that the derivatives of G jump in the middle as the spoke requires.
OnHalves functionsOfCross(double begin, double end, SpokeLaw law, int n) {
  const double middle = (begin + end) / (2 + slopeAtSide(law, n));
  if (law != SpokeLaw::G2) return {Vector2d(begin, middle), Vector2d(middle, end)};
  const double c = starFactor(n), sum = (2 - c / 2) * middle, difference = (end - begin) / (2 - c);
  return {Vector3d(begin, (sum - difference) / 2, middle),
          Vector3d(middle, (sum + difference) / 2, end)};
}

/// q likewise.
OnHalves functionsOfEdge(const Scalars& s, SpokeLaw law, int n) {
  if (law != SpokeLaw::G2) {
    const double left = s.q_begin + s.q_slope_begin / 4, right = s.q_end - s.q_slope_end / 4;
    const double middle = 2 * (left + right) / (4 + slopeAtSide(law, n));
    return {Vector3d(s.q_begin, left, middle), Vector3d(middle, right, s.q_end)};
  }
  const double c = starFactor(n), left = s.q_begin + s.q_slope_begin / 6,
               right = s.q_end - s.q_slope_end / 6;
  const double middle = (3 * (left + right) - s.q_begin - s.q_end) / (4 - c);
  const double sum = (2 - c / 3) * middle,
               difference = (6 * (right - left) + c * c / 2) / (12 - 3 * c);
  return {Vector4d(s.q_begin, left, (sum - difference) / 2, middle),
          Vector4d(middle, (sum + difference) / 2, right, s.q_end)};
}

/// Steps 1 and 2: G at the ends of a side is half the tangent of the sides next to it.
Scalars scalarsOf(const HoleCorner& begin, const HoleCorner& end, SpokeLaw law, int n) {
  Scalars s;
  const Vector2d first = combination(begin.after()->cross, begin.after()->edge, begin.in() / 2);
  const Vector2d last = combination(end.before()->cross, end.before()->edge, -end.out() / 2);
  s.p = functionsOfCross(first(0), last(0), law, n);
  s.q_begin = first(1);
  s.q_end = last(1);
  s.q_slope_begin = s.q_slope_end = s.q_end - s.q_begin;
  return s;
}

/// p and its derivative by the parameter of the side.
struct AtCorner {
  double value = 0, slope = 0;
};
AtCorner atBegin(const OnHalves& f) {
  const double degree = static_cast<double>(f[0].size() - 1);
  return {f[0](0), 2 * degree * (f[0](1) - f[0](0))};
}
AtCorner atEnd(const OnHalves& f) {
  const Eigen::Index last = f[1].size() - 1;
  return {f[1](last), 2 * static_cast<double>(last) * (f[1](last) - f[1](last - 1))};
}

/// Steps 3 and 6: slopes of q such that the mixed derivatives of the fill agree except for a normal
/// part, which is returned.
Vector3d meetTwists(const HoleCorner& corner, Scalars& before, Scalars& after,
                    FillCorner& figures) {
  const SideEnd &b = *corner.before(), &a = *corner.after();
  const AtCorner p_before = atEnd(before.p), p_after = atBegin(after.p);
  const Vector3d known = p_after.value * a.cross1 + p_after.slope * a.cross +
                         after.q_begin * a.edge2 + p_before.value * b.cross1 +
                         p_before.slope * b.cross + before.q_end * b.edge2;
  const Vector2d slopes = combination(a.edge, b.edge, -known);
  after.q_slope_begin = slopes(0), before.q_slope_end = slopes(1);
  const Vector3d normal = corner.in().cross(corner.out()).normalized();
  figures.twist_defect_mm = normal.dot(known);
  const double noise =
      (p_after.value + p_before.value + std::abs(p_after.slope) + std::abs(p_before.slope)) *
          (a.noise + b.noise) * 4 +
      16 * (std::abs(after.q_begin) * a.noise + std::abs(before.q_end) * b.noise);
  figures.exact = figures.exact && std::abs(figures.twist_defect_mm) <= noise;
  return known + slopes(0) * a.edge + slopes(1) * b.edge;
}

/// One half of a side during construction: the derivative that the tangent planes require, and the
/// one used.
struct Half {
  Poles edge1, wanted, taken;
};

std::array<Half, 2> halvesOf(const FillSide& side, const OnHalves& p, const OnHalves& q,
                             int degree) {
  const std::array<Poles, 2> edge1 = halved(rows::derivative<3>(side.edge.poles())),
                             cross = halved(*side.cross);
  std::array<Half, 2> halves;
  for (std::size_t h = 0; h < 2; ++h) {
    const Field<3> field =
        rows::sum<3>(rows::product<3>(p[h], cross[h]), rows::product<3>(q[h], edge1[h]));
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
    const OnHalves &p = scalars[k].p, q = functionsOfEdge(scalars[k], law, static_cast<int>(n));
    std::array<Half, 2> halves = halvesOf(sides[k], p, q, degree);
    Poles &left = halves[0].taken, &right = halves[1].taken;
    left.row(0) = corners[k].in() / 2;
    right.row(degree) = -corners[next(k)].out() / 2;
    left.row(1) += (left.row(0) - halves[0].wanted.row(0)) - defects[k].transpose() / (4 * degree);
    right.row(degree - 1) += (right.row(degree) - halves[1].wanted.row(degree)) +
                             defects[next(k)].transpose() / (4 * degree);
    SideField field{{left, right}, {}};
    for (std::size_t h = 0; h < 2; ++h) {
      field.joins[h].alpha = p[h];
      field.joins[h].beta = -2 * q[h];
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
