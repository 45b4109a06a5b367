// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/conic_distance.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Polynomial = BernsteinPolynomial;

/// The coordinates along and across the chord.
struct ChordFrame {
  Vector2d origin, along;

  Vector2d operator()(const Vector2d& point) const {
    const Vector2d from = point - origin;
    return {along.dot(from), cross(along, from)};
  }
};

/// A conic in the frame: f = b1^2 - 4 w^2 b0 b2 with the barycentric coordinates of its triangle,
/// each a form (x, y, 1). f is 0 on the conic.
struct ImplicitConic {
  Eigen::Matrix3d barycentric;  ///< a row for each
  double weight = 1;
  double start = 0, end = 0;  ///< x
  double height = 0;          ///< the largest distance of its triangle from the chord
  Vector3d slope;             ///< the derivative of f by y, as a form
  Interval slope_inside;      ///< its values in the triangle
  bool is_flat = false;       ///< its triangle has no area that rounding leaves: there is no f
};

ImplicitConic implicitConic(const PlanarConic& conic, const ChordFrame& frame) {
  Eigen::Matrix3d corners;
  const std::array<Vector2d, 3> points = {frame(conic.start), frame(conic.corner),
                                          frame(conic.end)};
  for (int i = 0; i < 3; ++i) corners.col(i) << points[i].x(), points[i].y(), 1;
  ImplicitConic result;
  result.weight = conic.weight;
  result.start = points[0].x();
  result.end = points[2].x();
  for (const Vector2d& point : points) result.height = std::max(result.height, std::abs(point.y()));
  result.barycentric = corners.inverse();
  result.is_flat = !result.barycentric.allFinite();
  if (result.is_flat) return result;
  const Eigen::Matrix3d& b = result.barycentric;
  const double factor = 4 * conic.weight * conic.weight;
  result.slope = 2 * b(1, 1) * b.row(1) - factor * (b(0, 1) * b.row(2) + b(2, 1) * b.row(0));
  const Vector3d values = corners.transpose() * result.slope;
  result.slope_inside = {values.minCoeff(), values.maxCoeff()};
  return result;
}

/// Whether the corner of a conic is on its chord, up to rounding.
bool isLine(const PlanarConic& conic) {
  const Vector2d chord = conic.end - conic.start;
  const double size_mm =
      std::max({conic.start.cwiseAbs().maxCoeff(), conic.end.cwiseAbs().maxCoeff(), chord.norm()});
  return std::abs(cross(chord, conic.corner - conic.start)) <=
         4 * machine_epsilon * size_mm * chord.norm();
}

/// A piece of the curve in the frame, homogeneous.
struct FramedPiece {
  Polynomial x, y, weight, velocity;  ///< the velocity along the chord

  Polynomial form(const Vector3d& f) const { return f[0] * x + f[1] * y + f[2] * weight; }
  FramedPiece restricted(const Interval& domain) const {
    return {x.restricted(domain), y.restricted(domain), weight.restricted(domain),
            velocity.restricted(domain)};
  }
};

FramedPiece framedPiece(const CurvePiece& piece, const ChordFrame& frame) {
  const CurvePolynomials& curve = piece.polynomials;
  const Vector2d shift = piece.origin - frame.origin;
  const auto moved = [&](int axis) {
    return curve.point[axis] + Polynomial(Eigen::VectorXd::Constant(1, shift[axis]),
                                          machine_epsilon * std::abs(shift[axis])) *
                                   curve.weight;
  };
  const Polynomial x = moved(0), y = moved(1);
  const Vector2d& u = frame.along;
  return FramedPiece{.x = u.x() * x + u.y() * y,
                     .y = u.x() * y - u.y() * x,
                     .weight = curve.weight,
                     .velocity = u.x() * curve.velocity[0] + u.y() * curve.velocity[1]}
      .restricted(piece.domain);
}

/// Upper bound of the distance of anything in the triangles of the conics from any point of the
/// part: the diagonal of their box.
double extentOf(const std::vector<FramedPiece>& part, const std::vector<PlanarConic>& conics,
                const ChordFrame& frame) {
  Eigen::AlignedBox2d box;
  for (const PlanarConic& conic : conics)
    for (const Vector2d& point : {conic.start, conic.corner, conic.end}) box.extend(frame(point));
  for (const FramedPiece& piece : part) {
    const double least_weight = piece.weight.range().lower;
    if (!(least_weight > 0)) return infinite;
    // A quotient by a larger weight is nearer to the origin, which is in the box.
    const Interval x = piece.x.range(), y = piece.y.range();
    box.extend(Vector2d(x.lower, y.lower) / least_weight);
    box.extend(Vector2d(x.upper, y.upper) / least_weight);
  }
  return box.diagonal().norm();
}

/// Upper bound of the distance across the chord of a piece from one conic.
double boundFrom(const FramedPiece& piece, double least_weight, const ImplicitConic& conic) {
  if (conic.is_flat) return infinite;
  const Eigen::Matrix3d& b = conic.barycentric;
  const Polynomial b0 = piece.form(b.row(0)), b1 = piece.form(b.row(1)), b2 = piece.form(b.row(2));
  const double value =
      (b1 * b1 - (4 * conic.weight * conic.weight) * (b0 * b2)).range().magnitude() /
      (least_weight * least_weight);
  // Between the piece and the conic the slope has values between those at both.
  const Interval slope = piece.form(conic.slope).range();
  const double most_weight = piece.weight.range().upper;
  const double sign = conic.slope_inside.lower > 0 ? 1 : -1;
  const double inside = std::min(sign * conic.slope_inside.lower, sign * conic.slope_inside.upper);
  const double outside = std::min(sign * slope.lower, sign * slope.upper) / most_weight;
  const double least = std::min(inside, outside);
  return least > 0 ? value / least : infinite;
}

/// Upper bound of the distance across the chord of a piece from the conics that lie beside it; from
/// the chord itself if there are none.
double boundOf(const FramedPiece& piece, const std::vector<ImplicitConic>& conics) {
  const Interval weight = piece.weight.range();
  if (!(weight.lower > 0 && piece.velocity.range().lower > 0)) return infinite;
  // Both are within their distances from the chord. Near inflections, where conics are flatter than
  // the distance, this bound alone is finite.
  double flat = piece.y.range().magnitude() / weight.lower, height = 0;
  for (const ImplicitConic& conic : conics) height = std::max(height, conic.height);
  flat += height;
  if (conics.empty()) return flat;
  const double from = piece.x.evaluate(0).lower / piece.weight.evaluate(0).upper,
               to = piece.x.evaluate(1).upper / piece.weight.evaluate(1).lower;
  double bound = 0;
  for (const ImplicitConic& conic : conics) {
    const bool first = &conic == &conics.front(), last = &conic == &conics.back();
    if ((!first && to < conic.start) || (!last && from > conic.end)) continue;
    bound = std::max(bound, boundFrom(piece, weight.lower, conic));
  }
  return std::min(bound, small_part * flat);
}

bool isGraph(const std::vector<PlanarConic>& conics, const ChordFrame& frame) {
  return std::ranges::all_of(conics, [&](const PlanarConic& conic) {
    return frame(conic.start).x() < frame(conic.corner).x() &&
           frame(conic.corner).x() < frame(conic.end).x();
  });
}

}  // namespace

std::optional<double> distanceFromConics(const std::vector<CurvePiece>& part,
                                         const std::vector<PlanarConic>& conics,
                                         double tolerance_mm) {
  const Vector2d start = conics.front().start, chord = conics.back().end - start;
  const ChordFrame frame{.origin = start, .along = chord.normalized()};
  std::vector<FramedPiece> pieces;
  for (const CurvePiece& piece : part) pieces.push_back(framedPiece(piece, frame));
  // Rounding of the points of the conics and of their forms.
  const double size =
      start.cwiseAbs().maxCoeff() + conics.back().end.cwiseAbs().maxCoeff() + chord.norm();
  const double rounding_mm = 16 * machine_epsilon * size;
  if (!isGraph(conics, frame)) return std::nullopt;
  const double extent_mm = extentOf(pieces, conics, frame) + rounding_mm;
  if (small_part * extent_mm <= tolerance_mm) return extent_mm;
  std::vector<ImplicitConic> implicit;
  const bool is_line = conics.size() == 1 && isLine(conics.front());
  for (const PlanarConic& conic : conics)
    if (!is_line) implicit.push_back(implicitConic(conic, frame));
  // The bound approaches the distance by a factor of 4 with each halving: few are needed.
  constexpr int most_halvings = 6;
  struct Open {
    FramedPiece piece;
    int halvings = 0;
  };
  double distance_mm = 0;
  for (const FramedPiece& piece : pieces) {
    std::vector<Open> open = {{piece}};
    while (!open.empty()) {
      const Open next = std::move(open.back());
      open.pop_back();
      const double bound_mm = boundOf(next.piece, implicit);
      if (bound_mm <= tolerance_mm) {
        distance_mm = std::max(distance_mm, bound_mm);
        continue;
      }
      if (next.halvings == most_halvings) return std::nullopt;
      open.push_back({next.piece.restricted({0, 0.5}), next.halvings + 1});
      open.push_back({next.piece.restricted({0.5, 1}), next.halvings + 1});
    }
  }
  distance_mm += rounding_mm;
  if (distance_mm > tolerance_mm) return std::nullopt;
  return distance_mm;
}

}  // namespace seamwright
