// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/seam/piece.hpp>

namespace seamwright {

namespace {

constexpr double rounding =
    1e-14;  ///< relative, for the short computations below; far above 2^-52 times their length

/// Relative rounding of spectralNorm(): the arccosine turns a rounding of 2^-50 into 2^-50 / sqrt(2
/// nearly_double), which is 6e-14.
constexpr double norm_rounding = 1e-12;
/// Distance of the cosine from 1 below which two eigenvalues count as nearly equal. A choice: a
/// smaller value loses digits (see above), a larger one takes the slow solver more often.
constexpr double nearly_double = 1e-4;

using Tensor = Eigen::Matrix<double, 6, 1>;  ///< entries in the order of SymmetricModel

Eigen::Matrix3d matrixOf(const Tensor& k) {
  Eigen::Matrix3d matrix;
  matrix << k[0], k[3], k[5], k[3], k[1], k[4], k[5], k[4], k[2];
  return matrix;
}

/// Largest absolute eigenvalue of a symmetric matrix.
double spectralNorm(const Tensor& k) {
  const double mean = (k[0] + k[1] + k[2]) / 3;
  const double x = k[0] - mean, y = k[1] - mean, z = k[2] - mean;
  const double off = k[3] * k[3] + k[4] * k[4] + k[5] * k[5];
  const double spread = std::sqrt((x * x + y * y + z * z + 2 * off) / 6);
  if (!(spread > 0)) return std::abs(mean);
  const double determinant =
      x * (y * z - k[4] * k[4]) - k[3] * (k[3] * z - k[4] * k[5]) + k[5] * (k[3] * k[4] - y * k[5]);
  const double cosine = std::clamp(determinant / (2 * spread * spread * spread), -1.0, 1.0);
  const double angle = std::acos(cosine) / 3;
  const double largest = mean + 2 * spread * std::cos(angle);
  const double smallest = mean + 2 * spread * std::cos(angle + 2 * std::numbers::pi / 3);
  const bool is_double = std::abs(cosine) > 1 - nearly_double && cosine * (largest + smallest) < 0;
  if (std::isfinite(cosine) && !is_double) return std::max(std::abs(largest), std::abs(smallest));
  // Near a double eigenvalue the angle is known to half the digits only, and cubes may exceed the
  // range of a double.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(matrixOf(k), Eigen::EigenvaluesOnly);
  return std::max(std::abs(eigen.eigenvalues()[0]), std::abs(eigen.eigenvalues()[2]));
}

template <std::size_t Dimension>
Eigen::Matrix<double, static_cast<int>(Dimension), 1> valueAt(
    const std::array<ChebyshevModel, Dimension>& model, double x) {
  Eigen::Matrix<double, static_cast<int>(Dimension), 1> value;
  for (std::size_t d = 0; d < Dimension; ++d) value[static_cast<int>(d)] = model[d].seriesAt(x);
  return value;
}

template <std::size_t Dimension>
bool isKnown(const std::array<ChebyshevModel, Dimension>& model) {
  return std::ranges::all_of(model, [](const ChebyshevModel& m) { return m.isKnown(); });
}

/// Bounds the largest value of a convex function along the curve of a control polygon over x in
/// [-1, 1], by halving. The radius of the polygon is not included.
template <int Dimension, class Function>
class PolygonMaximum {
 public:
  using Points = std::array<Eigen::Matrix<double, Dimension, 1>, ChebyshevModel::size>;

  PolygonMaximum(const Function& function, const Slack& slack)
      : function_(function), slack_(slack) {}

  PieceBound operator()(const ControlPolygon<Dimension>& polygon) {
    bound_ = {-1, 0, 0};
    last_ = polygon.degree;
    if (last_ == 0) {
      const double value = function_(polygon.points[0]);
      return {value, value, 0};
    }
    double largest = 0;
    for (int i = 0; i <= last_; ++i) largest = std::max(largest, function_(polygon.points[i]));
    add(polygon.points, -1, 1, 5);
    bound_.lower -= rounding * largest;  // a halving rounds by < 2^-50 of the largest point
    bound_.upper += rounding * largest;
    return bound_;
  }

 private:
  void see(double value, double at) {
    if (value > bound_.lower) bound_.lower = value, bound_.at = at;
  }

  void add(const Points& points, double from, double to, int halvings) {
    see(function_(points[0]), from);
    see(function_(points[last_]), to);
    double upper = 0;
    for (int i = 0; i <= last_; ++i) upper = std::max(upper, function_(points[i]));
    const double enough =
        bound_.lower + std::max(slack_.relative * bound_.lower, slack_.absolute) / 4;
    if (upper <= enough || halvings == 0 || !std::isfinite(upper)) {
      bound_.upper = std::max(bound_.upper, upper);
      return;
    }
    Points left, right = points;
    for (int level = 0; level <= last_; ++level) {
      left[level] = right[0];
      for (int i = 0; i < last_ - level; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
    }
    // right now holds the last point of every level: these are the points of the right half, from
    // the apex outward.
    add(left, from, 0.5 * (from + to), halvings - 1);
    add(right, 0.5 * (from + to), to, halvings - 1);
  }

  const Function& function_;
  Slack slack_;
  int last_ = 0;
  PieceBound bound_;
};

template <int Dimension, class Function>
PieceBound maximumAlong(const ControlPolygon<Dimension>& polygon, const Function& function,
                        const Slack& slack) {
  return PolygonMaximum<Dimension, Function>(function, slack)(polygon);
}

/// Widens a bound of a norm by the radius and by its own rounding.
PieceBound widened(PieceBound bound, double radius, double relative) {
  bound.lower = std::max(0.0, bound.lower * (1 - relative) - radius);
  bound.upper = bound.upper * (1 + relative) + radius;
  if (!std::isfinite(bound.upper)) bound.upper = infinite;
  return bound;
}

template <std::size_t Dimension>
PieceBound largestNorm(const std::array<ChebyshevModel, Dimension>& model, const Slack& slack) {
  if (!isKnown(model)) return {0, infinite, 0};
  const auto polygon = controlPolygon(model);
  if constexpr (Dimension == 6)
    return widened(maximumAlong(polygon, spectralNorm, slack),
                   1.5 * polygon.radius,  // off-diagonal entries occur twice
                   norm_rounding);
  else
    return widened(maximumAlong(
                       polygon, [](const Eigen::Vector3d& p) { return p.norm(); }, slack),
                   polygon.radius, rounding);
}

/// A curvature tensor over a piece, with bounds of its norm.
struct TensorNorm {
  double at_least = 0;
  double at_most = 0;
  ChebyshevModel below;  ///< a function that is nowhere above the norm and touches it at the middle
};

TensorNorm normOf(const SymmetricModel& tensor) {
  TensorNorm norm;
  norm.at_most = largestNorm(tensor, {0.01, 0}).upper;
  // The function is v.K v. v is the principal direction of largest absolute curvature at the
  // middle.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(matrixOf(valueAt(tensor, 0)));
  const int which = std::abs(eigen.eigenvalues()[0]) > std::abs(eigen.eigenvalues()[2]) ? 0 : 2;
  const Eigen::Vector3d v = eigen.eigenvectors().col(which);
  const double sign = (eigen.eigenvalues()[which] < 0 ? -1 : 1) * (1 - rounding);
  norm.below = (sign * v[0] * v[0]) * tensor[0] + (sign * v[1] * v[1]) * tensor[1] +
               (sign * v[2] * v[2]) * tensor[2] + (2 * sign * v[0] * v[1]) * tensor[3] +
               (2 * sign * v[1] * v[2]) * tensor[4] + (2 * sign * v[2] * v[0]) * tensor[5];
  norm.at_least = std::max(0.0, norm.below.range().lower);
  return norm;
}

/// Upper bound of |D| / |K| over the piece, where K stays away from zero. Along a polygon a
/// quotient of a convex function by a positive linear one is at most its largest value at the
/// control points.
double largestQuotient(const SymmetricModel& difference, const ChebyshevModel& below,
                       const Slack& slack, double& at) {
  const ControlPolygon<6> polygon = controlPolygon(difference);
  ControlPolygon<7> joint;
  joint.degree = std::max(polygon.degree, below.degree());
  const ChebyshevModel::Coefficients divisor = below.bernstein(joint.degree);
  const double radius = below.radius() + below.bernsteinRounding();
  for (std::size_t d = 0; d < difference.size(); ++d) {
    const ChebyshevModel::Coefficients control = difference[d].bernstein(joint.degree);
    for (int i = 0; i <= joint.degree; ++i) joint.points[i][static_cast<int>(d)] = control[i];
  }
  for (int i = 0; i <= joint.degree; ++i) joint.points[i][6] = divisor[i];
  const auto quotient = [&](const Eigen::Matrix<double, 7, 1>& point) {
    const double lowest = point[6] - radius;
    return lowest > 0 ? (spectralNorm(point.head<6>()) + 1.5 * polygon.radius) / lowest : infinite;
  };
  const PieceBound bound = maximumAlong(joint, quotient, slack);
  at = bound.at;
  return bound.upper * (1 + norm_rounding);
}

/// A lower bound of the relative difference at a point of the piece.
double relativeAt(const SymmetricModel& a, const SymmetricModel& b,
                  const SymmetricModel& difference, double flat, double x) {
  const auto radius = [](const SymmetricModel& model) {
    return 1.5 * controlPolygon(model).radius + 1e-300;
  };
  const double norm_a = spectralNorm(valueAt(a, x)), radius_a = radius(a) + norm_rounding * norm_a;
  const double norm_b = spectralNorm(valueAt(b, x)), radius_b = radius(b) + norm_rounding * norm_b;
  const bool curved_a = norm_a - radius_a >= flat, flat_a = norm_a + radius_a < flat;
  const bool curved_b = norm_b - radius_b >= flat, flat_b = norm_b + radius_b < flat;
  if ((curved_a && flat_b) || (curved_b && flat_a)) return 1;
  if (!curved_a || !curved_b) return 0;
  const double norm = spectralNorm(valueAt(difference, x));
  const double largest = std::max(norm_a + radius_a, norm_b + radius_b);
  return std::max(0.0, (norm * (1 - norm_rounding) - radius(difference)) / largest);
}

struct SideTensor {
  const SymmetricModel& tensor;
  const TensorNorm& norm;
};

PieceBound relativeBound(const SideTensor& a, const SideTensor& b, const SymmetricModel& difference,
                         double largest_difference, double flat_radius_mm, const Slack& slack) {
  const double flat = 1 / flat_radius_mm;
  const auto& [tensor_a, norm_a] = a;
  const auto& [tensor_b, norm_b] = b;
  if (norm_a.at_most < flat && norm_b.at_most < flat) return {0, 0, 0};
  if ((norm_a.at_least >= flat && norm_b.at_most < flat) ||
      (norm_b.at_least >= flat && norm_a.at_most < flat))
    return {1, 1, 0};
  const TensorNorm& larger = norm_a.at_least > norm_b.at_least ? norm_a : norm_b;
  PieceBound bound;
  if (larger.at_least > 0) {
    bound.upper = largest_difference / larger.at_least;
    const double enough = std::max(slack.absolute, slack.relative * bound.upper) / 4;
    if (bound.upper > enough)
      bound.upper = largestQuotient(difference, larger.below, slack, bound.at);
  } else {
    bound.upper = largest_relative_difference + std::max(norm_a.at_most, norm_b.at_most) / flat;
  }
  if (norm_a.at_most < flat || norm_b.at_most < flat)
    bound.upper = 1;
  else if (!(norm_a.at_least >= flat && norm_b.at_least >= flat))
    bound.upper = std::max(bound.upper, 1.0);
  const double best = bound.at;
  bound.lower = -1;
  for (const double x : {best, -1.0, 0.0, 1.0})
    if (const double value = relativeAt(tensor_a, tensor_b, difference, flat, x);
        value > bound.lower)
      bound.lower = value, bound.at = x;
  return bound;
}

/// The tensor of b, turned by the smallest rotation that takes n_b to n_a. On the plane of n_b that
/// rotation is I - s n_a^T / (1 + mu) with s = n_a + n_b and mu = n_a.n_b.
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
  SymmetricModel difference = tensor_b - a.tensor;
  if (as_it_is)
    for (ChebyshevModel& entry : difference) entry.widen(2 * angle * angle * norm_b.at_most);
  if (!isKnown(difference) || !isKnown(a.tensor)) return;
  figures.curvature_per_mm = largestNorm(difference, slack.curvature_per_mm);
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
  const double up = 1 + rounding, down = 1 - rounding;
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
  if (detail == Detail::Curvature) measureCurvature(a, b, mu, flat_radius_mm, slack, figures);
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
}

}  // namespace seamwright
