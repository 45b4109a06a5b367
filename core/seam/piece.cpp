// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/seam/model_norm.hpp>
#include <seamwright/core/seam/piece.hpp>

namespace seamwright {

namespace {

using namespace enclosure;

/// The difference of two curvature tensors, with its control polygon.
struct Difference {
  const SymmetricModel& tensor;
  ControlPolygon<6> polygon;
};

/// Upper bound of |D| / |K| over the piece, where K stays away from zero. Along a polygon a
/// quotient of a convex function by a positive linear one is at most its largest value at the
/// control points.
double largestQuotient(const Difference& difference, const ChebyshevModel& below,
                       const Slack& slack, double& at) {
  const ControlPolygon<6>& polygon = difference.polygon;
  ControlPolygon<7> joint;
  joint.degree = std::max(polygon.degree, below.degree());
  const ChebyshevModel::Coefficients divisor = below.bernstein(joint.degree);
  const double radius = below.radius() + below.bernsteinRounding();
  const auto join = [&](const ControlPolygon<6>& elevated) {
    for (int i = 0; i <= joint.degree; ++i) joint.points[i] << elevated.points[i], divisor[i];
  };
  if (joint.degree == polygon.degree)
    join(polygon);
  else
    join(controlPolygon(difference.tensor, joint.degree));
  const auto quotient = [&](const Eigen::Matrix<double, 7, 1>& point) {
    const double lowest = point[6] - radius;
    return lowest > 0 ? (spectralNorm(point.head<6>()) + 1.5 * polygon.radius) / lowest : infinite;
  };
  const PieceBound bound = maximumAlong(joint, quotient, slack);
  at = bound.at;
  return bound.upper * (1 + norm_rounding);
}

/// The norm of a tensor at points of a piece.
class NormAt {
 public:
  explicit NormAt(const SymmetricModel& tensor)
      : tensor_(tensor), radius_(1.5 * polygonRadius(tensor) + 1e-300) {}
  Interval operator()(double x) const {
    const double norm = spectralNorm(seriesValue(tensor_, x));
    const double off = radius_ + norm_rounding * norm;
    return {norm - off, norm + off};
  }

 private:
  const SymmetricModel& tensor_;
  double radius_;
};

struct SideTensor {
  const SymmetricModel& tensor;
  const TensorNorm& norm;
};

/// A lower bound of the relative difference, with a point of the piece that attains it.
PieceBound largestRelativeAt(std::initializer_list<double> points, const SideTensor& a,
                             const SideTensor& b, const Difference& difference, double flat) {
  const NormAt of_a(a.tensor), of_b(b.tensor), of_difference(difference.tensor);
  PieceBound bound{-1, infinite, 0};
  for (const double x : points) {
    const Interval norm_a = of_a(x), norm_b = of_b(x);
    const bool is_flat = std::max(norm_a.lower, norm_b.lower) < flat;
    const double value =
        is_flat ? 0 : std::max(0.0, of_difference(x).lower / std::max(norm_a.upper, norm_b.upper));
    if (value > bound.lower) bound.lower = value, bound.at = x;
  }
  return bound;
}

/// Whether the norm is below the flat curvature on the whole piece.
bool isFlat(const SideTensor& side, double flat) {
  return side.norm.at_most < flat ||
         (side.norm.at_least < flat && largestNorm(side.tensor, {0.01, 0}).upper < flat);
}

PieceBound relativeBound(const SideTensor& a, const SideTensor& b, const Difference& difference,
                         double largest_difference, double flat_radius_mm, const Slack& slack) {
  const double flat = 1 / flat_radius_mm;
  if (isFlat(a, flat) && isFlat(b, flat)) return {0, 0, 0};
  const TensorNorm& larger = a.norm.at_least > b.norm.at_least ? a.norm : b.norm;
  const double least_divisor = std::max(larger.at_least, flat);
  const double at_most_of_smaller = std::min(a.norm.at_most, b.norm.at_most);
  // |A - B| <= |A| + |B|: beside a plane the difference is 1.
  double upper = std::min(largest_difference / least_divisor,
                          (1 + at_most_of_smaller / least_divisor) * (1 + short_rounding));
  double best = 0;
  const double enough = std::max(slack.absolute, slack.relative * upper) / 4;
  if (larger.at_least > 0 && upper > enough && at_most_of_smaller > 0)
    upper = std::min(upper, largestQuotient(difference, larger.below, slack, best));
  PieceBound bound = largestRelativeAt({best, -1, 0, 1}, a, b, difference, flat);
  bound.upper = upper;
  return bound;
}

/// The tensor of b, turned by the smallest rotation that takes n_b to n_a. On the plane of n_b that
/// rotation is I - s n_a^T with s = (n_a + n_b) / (1 + mu) and mu = n_a.n_b.
SymmetricModel turned(const SymmetricModel& tensor, const VectorModel& normal_a,
                      const VectorModel& normal_b, const ChebyshevModel& mu) {
  const ChebyshevModel factor = inverse(ChebyshevModel(1) + mu);
  const VectorModel s = factor * (normal_a + normal_b);
  const VectorModel y = tensor * normal_a;
  return tensor - 2 * symmetricProduct(s, y) + dot(normal_a, y) * symmetricProduct(s, s);
}

void measureCurvature(const SurfaceFields& a, const SurfaceFields& b, const ChebyshevModel& mu,
                      double flat_radius_mm, const PieceSlack& slack, PieceFigures& figures) {
  constexpr PieceBound unknown{0, infinite, 0};
  figures.curvature_per_mm = unknown;
  figures.curvature_rel = unknown;
  if (figures.sense == 0) return;
  const double sense = figures.sense;
  // For a negligible angle K_b is not turned. In the plane of a, K_b and R K_b R^T differ by less
  // than 2 angle^2 |K_b|. So the norm of K_b - K_a is below that of the turned difference by at
  // most this. It is above that norm by at most |K_b - R K_b R^T| <= 2 angle |K_b|.
  constexpr double negligible_rad = 1e-9;
  const bool as_it_is = figures.angle_rad.upper < negligible_rad;
  const double angle = as_it_is ? figures.angle_rad.upper : 0;
  const SymmetricModel tensor_b =
      as_it_is ? sense * b.tensor
               : turned(sense * b.tensor, a.normal, sense * b.normal, sense * mu);
  const TensorNorm norm_a = normOf(a.tensor);
  const TensorNorm norm_b = normOf(tensor_b);
  SymmetricModel change = tensor_b - a.tensor;
  if (as_it_is)
    for (ChebyshevModel& entry : change) entry.widen(2 * angle * angle * norm_b.at_most);
  if (!isKnown(change) || !isKnown(a.tensor)) return;
  const Difference difference{change, controlPolygon(change)};
  figures.curvature_per_mm = largestNorm(difference.polygon, slack.curvature_per_mm);
  figures.curvature_norm_per_mm = std::max(norm_a.at_least, norm_b.at_least);
  figures.curvature_rel =
      relativeBound({a.tensor, norm_a}, {tensor_b, norm_b}, difference,
                    figures.curvature_per_mm->upper, flat_radius_mm, slack.curvature_rel);
  const auto lowered = [](PieceBound& bound, double by) {
    bound.lower = std::max(0.0, bound.lower - by);
  };
  lowered(*figures.curvature_per_mm, 2.1 * angle * norm_b.at_most);
  lowered(*figures.curvature_rel, 2.1 * angle);
}

}  // namespace

PieceFigures measurePiece(const SurfaceFields& a, const SurfaceFields& b, Detail detail,
                          double flat_radius_mm, const PieceSlack& slack) {
  PieceFigures figures;
  figures.gap_mm = largestNorm(a.point - b.point, slack.gap_mm);
  if (detail == Detail::Position) return figures;

  const PieceBound sine = largestNorm(cross(a.normal, b.normal), slack.angle_rad);
  const ChebyshevModel mu = dot(a.normal, b.normal);
  const Interval cosine = mu.isKnown() ? mu.range() : Interval{-1, 1};
  if (cosine.lower > 0) figures.sense = 1;
  if (cosine.upper < 0) figures.sense = -1;
  // The sine resolves small angles, the cosine those near 90 degrees.
  const double cosine_least = std::max({0.0, cosine.lower, -cosine.upper});
  const double cosine_most = std::min(1.0, cosine.magnitude());
  const double up = 1 + short_rounding, down = 1 - short_rounding;
  figures.angle_rad.upper = infinite;
  if (std::isfinite(sine.upper)) {
    const double by_cosine = std::acos(std::min(1.0, cosine_least));
    figures.angle_rad.upper =
        up * (sine.upper < 1 ? std::min(std::asin(sine.upper), by_cosine) : by_cosine);
  }
  figures.angle_rad.lower = down * std::asin(std::min(1.0, sine.lower));
  figures.angle_rad.at = sine.at;
  figures.smallest_angle_rad = down * std::acos(cosine_most);
  if (figures.smallest_angle_rad > figures.angle_rad.lower)
    figures.angle_rad.lower = figures.smallest_angle_rad;
  if (detail >= Detail::Curvature) measureCurvature(a, b, mu, flat_radius_mm, slack, figures);
  return figures;
}

void include(PieceFigures& sum, const PieceFigures& more) {
  const auto merge = [](PieceBound& bound, const PieceBound& other) {
    bound = {0, std::max(bound.upper, other.upper), 0};
  };
  merge(sum.gap_mm, more.gap_mm);
  merge(sum.angle_rad, more.angle_rad);
  sum.smallest_angle_rad = std::min(sum.smallest_angle_rad, more.smallest_angle_rad);
  if (sum.sense != more.sense) sum.sense = 0;
  sum.curvature_norm_per_mm = 0;
  if (!sum.curvature_per_mm) return;
  merge(*sum.curvature_per_mm, *more.curvature_per_mm);
  merge(*sum.curvature_rel, *more.curvature_rel);
  if (!sum.curvature_change_per_mm2) return;
  merge(*sum.curvature_change_per_mm2, *more.curvature_change_per_mm2);
  merge(*sum.curvature_change_rel, *more.curvature_change_rel);
}

}  // namespace seamwright
