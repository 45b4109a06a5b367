// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
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
  SpokeEnd end{.derivative = std::nullopt,
               .c = speed / out.norm(),
               .d = speed / in.norm(),
               .smooth = std::abs(turn) <= corner.noise_rad()};
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

/// The corners of a hole, and the sides as a ring.
struct Ring {
  const std::vector<FillSide>& sides;
  std::vector<HoleCorner> corners;

  std::size_t size() const { return sides.size(); }
  std::size_t next(std::size_t k) const { return (k + 1) % size(); }
  std::size_t before(std::size_t k) const { return (k + size() - 1) % size(); }
};

/// The lengths of the spokes. They are shares of the distances from the centre to the corners.
std::vector<double> spokeLengths(const std::vector<FillSide>& sides, double spoke_scale) {
  const auto n = static_cast<double>(sides.size());
  Vector3d centre = Vector3d::Zero();
  for (const FillSide& side : sides)
    centre += (side.edge.point(0) + side.edge.point(0.5)) / (2.0 * n);
  double mean_mm = 0;
  for (const FillSide& side : sides) mean_mm += (side.edge.point(0) - centre).norm() / n;
  std::vector<double> lengths_mm;
  for (const FillSide& side : sides) {
    // The lower bound is needed because a reflex corner may lie near the centre.
    const double distance_mm = std::max((side.edge.point(0) - centre).norm(), mean_mm / 4);
    lengths_mm.push_back(spoke_scale * spoke_share * distance_mm);
  }
  return lengths_mm;
}

/// The functions of each side with a cross-boundary derivative, with which G is the derivative of
/// the spokes at the ends; the slopes are those of linear functions.
std::vector<RingScalars> linearScalars(const Ring& ring, const std::vector<SpokeEnd>& spokes) {
  std::vector<RingScalars> scalars(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (!ring.sides[k].cross) continue;
    const SideEnd &a = *ring.corners[k].after(), &b = *ring.corners[ring.next(k)].before();
    RingScalars& s = scalars[k];
    s.begin = combination(a.cross, a.edge, *spokes[k].derivative);
    s.end = combination(b.cross, b.edge, *spokes[ring.next(k)].derivative);
    s.slope_begin = s.slope_end = s.end - s.begin;
  }
  return scalars;
}

/// The functions of G with slopes that agree in the corners, and the defects that are left there.
struct MetSlopes {
  std::vector<RingScalars> scalars;
  std::vector<Vector3d> defects;
};

MetSlopes metSlopes(const Ring& ring, const std::vector<SpokeEnd>& spokes,
                    std::vector<RingScalars> scalars) {
  std::vector<Vector3d> defects(ring.size(), Vector3d::Zero());
  for (std::size_t k = 0; k < ring.size(); ++k)
    if (ring.corners[k].before() && ring.corners[k].after())
      defects[k] = meetSlopes(ring.corners[k], spokes[k], scalars[ring.before(k)], scalars[k]);
  return {.scalars = std::move(scalars), .defects = std::move(defects)};
}

Poles wantedField(const FillSide& side, const RingScalars& scalars) {
  return rows::sum<3>(rows::product<3>(cubic(scalars, 0), rows::Field<3>(*side.cross)),
                      rows::product<3>(cubic(scalars, 1), rows::derivative<3>(side.edge.poles())));
}

/// The wanted field with the spokes' derivatives at its ends, changed beside smooth corners so that
/// half of the defect there vanishes; the other side of the corner makes up for the other half.
Poles takenField(const Poles& wanted, const std::array<SpokeEnd, 2>& spokes,
                 const std::array<Vector3d, 2>& defects) {
  const Eigen::Index degree = wanted.rows() - 1;
  Poles taken = wanted;
  taken.row(0) = *spokes[0].derivative;
  taken.row(degree) = *spokes[1].derivative;
  const auto bend = [&](Eigen::Index row, int end, double weight) {
    if (!spokes[end].smooth) return;
    taken.row(row) -= defects[end].transpose() / (2 * weight * static_cast<int>(degree));
  };
  bend(1, 0, spokes[0].c);
  bend(degree - 1, 1, spokes[1].d);
  return taken;
}

/// The figures of a smooth corner with the defect of its twist.
FillCorner withTwistDefect(FillCorner figures, const HoleCorner& corner, const Vector3d& defect) {
  figures.twist_defect_mm = defect.dot(corner.up().normalized());
  // That of a derivative, with room for the factors c, d, e, p and q and for their slopes, which
  // meetSlopes() solves for.
  constexpr double room = 512;
  const double noise = room * (corner.before() ? corner.before()->noise : 0);
  figures.exact = figures.exact && std::abs(figures.twist_defect_mm) <= noise;
  return figures;
}

}  // namespace

RingFields ringFields(const std::vector<FillSide>& sides, double spoke_scale, double tolerance_rad,
                      int more_degrees) {
  const std::size_t n = sides.size();
  const std::vector<double> lengths_mm = spokeLengths(sides, spoke_scale);
  Ring ring{.sides = sides, .corners = {}};
  RingFields result;
  for (std::size_t k = 0; k < n; ++k) {
    ring.corners.emplace_back(sides, k);
    result.corners.push_back(figuresOf(ring.corners[k], k, tolerance_rad));
    result.spokes.push_back(spokeEnd(ring.corners[k], result.corners[k], lengths_mm[k]));
  }
  const MetSlopes met = metSlopes(ring, result.spokes, linearScalars(ring, result.spokes));

  result.degree = 5;  // the lowest in which the two ends of a field are independent
  std::vector<Poles> wanted(n);
  for (std::size_t k = 0; k < n; ++k) {
    result.degree = std::max(result.degree, sides[k].edge.degree());
    if (!sides[k].cross) continue;
    wanted[k] = wantedField(sides[k], met.scalars[k]);
    result.degree = std::max(result.degree, rows::degree(wanted[k]));
  }
  result.degree += more_degrees;

  for (std::size_t k = 0; k < n; ++k)
    if (result.spokes[k].smooth && (sides[k].cross || sides[ring.before(k)].cross))
      result.corners[k] = withTwistDefect(result.corners[k], ring.corners[k], met.defects[k]);
  result.fields.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    if (!sides[k].cross) continue;
    const std::size_t end = ring.next(k);
    const Poles full = rows::elevated<3>(rows::Field<3>(wanted[k]), result.degree);
    const Poles taken = takenField(full, {result.spokes[k], result.spokes[end]},
                                   {met.defects[k], met.defects[end]});
    for (const std::size_t at : {k, end})
      if (!result.corners[at].exact)
        result.corners[at].angle_bound_rad =
            std::max(result.corners[at].angle_bound_rad,
                     angleBound(full, taken - full, rows::derivative<3>(sides[k].edge.poles())));
    result.fields[k] = taken;
  }
  return result;
}

}  // namespace seamwright::fill
