// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/seam/model_norm.hpp>
#include <seamwright/core/seam/piece.hpp>

namespace seamwright {

namespace {

using namespace enclosure;

using Scalar = std::array<ChebyshevModel, 1>;

VectorModel unitModel(const VectorModel& vector) {
  return inverseSqrt(dot(vector, vector)) * vector;
}

VectorModel tangentOf(const ChangeSide& side) {
  return unitModel(side.direction[0] * side.fields.u + side.direction[1] * side.fields.v);
}

/// The change of curvature in the direction across the seam. It does not depend on the sense of the
/// normal, since that also reverses the direction.
ChebyshevModel changeModel(const SurfaceFields& fields, const VectorModel& along) {
  return fields.change(unitModel(cross(fields.normal, along)));
}

/// The largest absolute value over the piece.
PieceBound largestValue(const ChebyshevModel& model, const Slack& slack) {
  if (!model.isKnown()) return {0, infinite, 0};
  const ControlPolygon<1> polygon = controlPolygon(Scalar{model});
  return widened(
      maximumAlong(
          polygon, [](const Eigen::Matrix<double, 1, 1>& p) { return std::abs(p[0]); }, slack),
      polygon.radius, short_rounding);
}

/// The absolute value of a model at x, with its radius and its rounding.
Interval boundsAt(const ChebyshevModel& model, double x) {
  const double value = std::abs(model.seriesAt(x));
  const double radius = model.radius() + model.bernsteinRounding();
  return {std::max(0.0, value - radius), value + radius};
}

/// An upper bound of the larger curvature norm at x.
double normAt(const SymmetricModel& a, const SymmetricModel& b, double x) {
  const auto above = [&](const SymmetricModel& tensor) {
    // The factor as in largestNorm().
    return spectralNorm(seriesValue(tensor, x)) * (1 + norm_rounding) + 1.5 * polygonRadius(tensor);
  };
  return std::max(above(a), above(b));
}

/// Upper bound of |difference| / below over the piece, by the control points of both.
double changeQuotient(const ChebyshevModel& difference, const ChebyshevModel& below,
                      const Slack& slack, double& at) {
  ControlPolygon<2> joint = controlPolygon(std::array{difference, below});
  const double off = difference.radius() + difference.bernsteinRounding();
  const double off_below = below.radius() + below.bernsteinRounding();
  const auto quotient = [&](const Eigen::Vector2d& point) {
    const double lowest = point[1] - off_below;
    return lowest > 0 ? (std::abs(point[0]) + off) / lowest : infinite;
  };
  const PieceBound bound = maximumAlong(joint, quotient, slack);
  at = bound.at;
  return bound.upper * (1 + norm_rounding);
}

/// The changes of curvature of both sides and what they are compared with.
struct Changes {
  ChebyshevModel a, b, difference;
  const SymmetricModel &tensor_a, &tensor_b;
  double flat = 0;  ///< both changes below this count as 0, in 1/mm^2
};

/// A lower bound of the relative change at a point of the piece.
double relativeChangeAt(const Changes& changes, double x) {
  const Interval a = boundsAt(changes.a, x), b = boundsAt(changes.b, x);
  if (std::max(a.lower, b.lower) < changes.flat) return 0;
  const double norm = normAt(changes.tensor_a, changes.tensor_b, x);
  const double divisor = std::max({a.upper, b.upper, norm * norm});
  return boundsAt(changes.difference, x).lower / divisor * (1 - short_rounding);
}

/// A function that the divisor of the relative change is nowhere below: the change of a side or the
/// square of a curvature, whichever stays largest over the piece.
struct Divisor {
  ChebyshevModel below;
  double at_least = 0;

  void offer(const ChebyshevModel& model) {
    const Interval range = model.range();
    if (range.lower > at_least) below = model, at_least = range.lower;
    if (-range.upper > at_least) below = -model, at_least = -range.upper;
  }
};

PieceBound relativeChangeBound(const Changes& changes, double largest_difference,
                               const Slack& slack) {
  constexpr Slack hundredth{0.01, 0};
  const double most_a = largestValue(changes.a, hundredth).upper,
               most_b = largestValue(changes.b, hundredth).upper;
  if (std::max(most_a, most_b) < changes.flat) return {0, 0, 0};
  Divisor divisor;
  divisor.offer(changes.a);
  divisor.offer(changes.b);
  for (const SymmetricModel* tensor : {&changes.tensor_a, &changes.tensor_b}) {
    const TensorNorm norm = normOf(*tensor);
    if (norm.at_least > 0) divisor.offer(norm.below * norm.below);
  }
  // Where the figure is not 0, its divisor is at least the flat change.
  PieceBound bound{0, largest_difference / std::max(divisor.at_least, changes.flat), 0};
  const double enough = std::max(slack.absolute, slack.relative * bound.upper) / 4;
  if (divisor.at_least > 0 && bound.upper > enough)
    bound.upper =
        std::min(bound.upper, changeQuotient(changes.difference, divisor.below, slack, bound.at));
  bound.upper *= 1 + short_rounding;
  const double best = bound.at;
  bound.lower = -1;
  for (const double x : {best, -1.0, 0.0, 1.0})
    if (const double value = relativeChangeAt(changes, x); value > bound.lower)
      bound.lower = value, bound.at = x;
  return bound;
}

}  // namespace

void measureChange(const ChangeSide& a, const ChangeSide& b, double flat_radius_mm,
                   const PieceSlack& slack, PieceFigures& figures) {
  constexpr PieceBound unknown{0, infinite, 0};
  figures.curvature_change_per_mm2 = figures.curvature_change_rel = unknown;
  const VectorModel along = tangentOf(a) + tangentOf(b);
  const ChebyshevModel change_a = changeModel(a.fields, along);
  const ChebyshevModel change_b = changeModel(b.fields, along);
  const Changes changes{change_a,        change_b,        change_b - change_a,
                        a.fields.tensor, b.fields.tensor, 100 / (flat_radius_mm * flat_radius_mm)};
  if (!changes.difference.isKnown()) return;
  figures.curvature_change_per_mm2 =
      largestValue(changes.difference, slack.curvature_change_per_mm2);
  figures.curvature_change_rel = relativeChangeBound(
      changes, figures.curvature_change_per_mm2->upper, slack.curvature_change_rel);
}

}  // namespace seamwright
