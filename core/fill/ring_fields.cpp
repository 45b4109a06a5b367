// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <seamwright/core/fill/ring_fields.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <stdexcept>
#include <string>

namespace seamwright::fill {

namespace {

using bernstein::text;
using Eigen::Vector2d, Eigen::Vector3d;

/// Corners that turn by less than this are not smooth and do not define a direction for their
/// spoke.
constexpr double least_turn_rad = 0.01;

/// If the spokes' length is two thirds of the distance to the centre, the tangents of the middle
/// patch have the same length as the spokes.
constexpr double spoke_share = 2.0 / 3;

FillCorner figuresOf(const HoleCorner& corner, std::size_t k, double tolerance_rad) {
  const FillCorner figures = corner.figures(tolerance_rad);
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument("corner " + std::to_string(k) + ": the angle of the hole is " +
                                degreesText(figures.angle_rad) + ": " + what);
  };
  const double turn = std::abs(figures.angle_rad - std::numbers::pi);
  if (std::numbers::pi - turn <= corner.noise_rad()) refuse("it must be between 0 and 360 degrees");
  if (turn > corner.noise_rad() && turn < least_turn_rad)
    refuse("it must be 180 degrees, to " + degreesText(corner.noise_rad()) +
           ", or differ from that by " + degreesText(least_turn_rad));
  return figures;
}

SpokeEnd spokeEnd(const HoleCorner& corner, const FillCorner& figures, double length_mm) {
  const Vector3d &in = corner.in(), &out = corner.out();
  const double speed = std::sqrt(in.norm() * out.norm());
  const double turn = figures.angle_rad - std::numbers::pi;
  SpokeEnd end{std::nullopt, speed / out.norm(), speed / in.norm(), 0,
               std::abs(turn) <= corner.noise_rad()};
  const Vector3d bend = end.c * out - end.d * in;
  if (!end.smooth) end.e = std::copysign(bend.norm() / length_mm, turn);
  if (corner.before() || corner.after()) {
    const Vector3d outward = end.smooth ? Vector3d((end.c * out + end.d * in).cross(corner.up()))
                                        : Vector3d(std::copysign(1.0, turn) * bend);
    end.derivative = length_mm * outward.normalized();
  }
  return end;
}

/// The scalar functions of G = p T + q E', cubics: values and slopes at the ends.
struct RingScalars {
  Vector2d begin, end, slope_begin, slope_end;  // of p and q
};

Eigen::VectorXd cubic(const RingScalars& s, int function) {
  return Eigen::Vector4d(s.begin(function), s.begin(function) + s.slope_begin(function) / 3,
                         s.end(function) - s.slope_end(function) / 3, s.end(function));
}

/// The smallest change of the slopes of p and q for which c V + d U = e S' holds to first order in
/// the corner, with S'' = 0. The remaining defect is along the normal.
Vector3d meetSlopes(const HoleCorner& corner, const SpokeEnd& spoke, RingScalars& before,
                    RingScalars& after) {
  const SideEnd &b = *corner.before(), &a = *corner.after();
  const auto slope = [](const SideEnd& end, const Vector2d& value, const Vector2d& change) {
    return Vector3d(change(0) * end.cross + value(0) * end.cross1 + change(1) * end.edge +
                    value(1) * end.edge2);
  };
  const Vector3d wanted = (spoke.e + 1) * *spoke.derivative - (spoke.c - 1) * corner.out() +
                          (spoke.d - 1) * corner.in();
  const Vector3d missed = wanted - spoke.c * slope(a, after.begin, after.slope_begin) +
                          spoke.d * slope(b, before.end, before.slope_end);
  // The equations are solved in the tangent plane, where any two of the directions are sufficient.
  // In space rounding would add a third dimension.
  const Vector3d up = corner.up().normalized(), along = corner.out().normalized();
  Eigen::Matrix<double, 2, 3> plane;
  plane << along.transpose(), up.cross(along).transpose();
  Eigen::Matrix<double, 3, 4> directions;
  directions << spoke.c * a.cross, spoke.c * a.edge, -spoke.d * b.cross, -spoke.d * b.edge;
  const Eigen::RowVector4d lengths = directions.colwise().norm();
  const Eigen::Matrix<double, 2, 4> unit =
      plane * (directions.array().rowwise() / lengths.array()).matrix();
  const Eigen::Vector4d least =
      unit.transpose() * (unit * unit.transpose()).ldlt().solve(plane * missed);
  const Eigen::Vector4d change = least.array() / lengths.transpose().array();
  after.slope_begin += change.head<2>();
  before.slope_end += change.tail<2>();
  return -up.dot(missed) * up;
}

}  // namespace

RingFields ringFields(const std::vector<FillSide>& sides, double spoke_scale, double tolerance_rad,
                      int more_degrees) {
  const std::size_t n = sides.size();
  const auto next = [n](std::size_t k) { return (k + 1) % n; };
  const auto before = [n](std::size_t k) { return (k + n - 1) % n; };
  Vector3d centre = Vector3d::Zero();
  for (const FillSide& side : sides)
    centre += (side.edge.point(0) + side.edge.point(0.5)) / (2.0 * static_cast<double>(n));
  double mean_mm = 0;
  for (const FillSide& side : sides)
    mean_mm += (side.edge.point(0) - centre).norm() / static_cast<double>(n);
  RingFields result;
  std::vector<HoleCorner> corners;
  for (std::size_t k = 0; k < n; ++k) {
    corners.emplace_back(sides, k);
    result.corners.push_back(figuresOf(corners[k], k, tolerance_rad));
    // The lower bound is needed because a reflex corner may lie near the centre.
    const double way_mm = std::max((sides[k].edge.point(0) - centre).norm(), mean_mm / 4);
    const double length_mm = spoke_scale * spoke_share * way_mm;
    result.spokes.push_back(spokeEnd(corners[k], result.corners[k], length_mm));
  }

  std::vector<RingScalars> scalars(n);
  for (std::size_t k = 0; k < n; ++k) {
    if (!sides[k].cross) continue;
    const SideEnd &a = *corners[k].after(), &b = *corners[next(k)].before();
    RingScalars& s = scalars[k];
    s.begin = combination(a.cross, a.edge, *result.spokes[k].derivative);
    s.end = combination(b.cross, b.edge, *result.spokes[next(k)].derivative);
    s.slope_begin = s.slope_end = s.end - s.begin;
  }
  std::vector<Vector3d> defects(n, Vector3d::Zero());
  for (std::size_t k = 0; k < n; ++k)
    if (corners[k].before() && corners[k].after())
      defects[k] = meetSlopes(corners[k], result.spokes[k], scalars[before(k)], scalars[k]);

  result.degree = 5;
  std::vector<Poles> wanted(n);
  for (std::size_t k = 0; k < n; ++k) {
    result.degree = std::max(result.degree, sides[k].edge.degree());
    if (!sides[k].cross) continue;
    wanted[k] = rows::sum<3>(
        rows::product<3>(cubic(scalars[k], 0), rows::Field<3>(*sides[k].cross)),
        rows::product<3>(cubic(scalars[k], 1), rows::derivative<3>(sides[k].edge.poles())));
    result.degree = std::max(result.degree, rows::degree(wanted[k]));
  }
  result.degree += more_degrees;
  result.fields.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    if (!sides[k].cross) continue;
    const Poles full = rows::elevated<3>(rows::Field<3>(wanted[k]), result.degree);
    Poles taken = full;
    taken.row(0) = *result.spokes[k].derivative;
    taken.row(result.degree) = *result.spokes[next(k)].derivative;
    const auto bend = [&](Eigen::Index row, std::size_t at, double weight) {
      if (!result.spokes[at].smooth) return;
      taken.row(row) -= defects[at].transpose() / (2 * weight * result.degree);
    };
    bend(1, k, result.spokes[k].c);
    bend(result.degree - 1, next(k), result.spokes[next(k)].d);
    for (const std::size_t at : {k, next(k)}) {
      FillCorner& corner = result.corners[at];
      if (!result.spokes[at].smooth) continue;
      corner.twist_defect_mm = defects[at].dot(corners[at].up().normalized());
      const double noise = 64 * (corners[at].before() ? corners[at].before()->noise : 0) * 8;
      corner.exact = corner.exact && std::abs(corner.twist_defect_mm) <= noise;
    }
    for (const std::size_t at : {k, next(k)})
      if (!result.corners[at].exact)
        result.corners[at].angle_bound_rad =
            std::max(result.corners[at].angle_bound_rad,
                     angleBound(full, taken - full, rows::derivative<3>(sides[k].edge.poles())));
    result.fields[k] = std::move(taken);
  }
  return result;
}

}  // namespace seamwright::fill
