// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include <seamwright/core/enclosure/vector_model.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/seam/piece.hpp>

/// Bounds of the norms of models over a piece of a seam. Not a public header.
/// Source: docs/theory/enclosures.md E3.2.
namespace seamwright::enclosure {

/// Relative, for computations of a few dozen operations; far above 2^-52 times their length.
constexpr double short_rounding = 1e-14;
/// Relative rounding of spectralNorm(): the arccosine of its cosine turns a rounding of 2^-50 into
/// at most 6e-14.
constexpr double norm_rounding = 1e-12;

using Tensor = Eigen::Matrix<double, 6, 1>;  ///< entries in the order of SymmetricModel

Eigen::Matrix3d matrixOf(const Tensor& k);

/// Largest absolute eigenvalue of a symmetric matrix.
double spectralNorm(const Tensor& k);

template <std::size_t Dimension>
Eigen::Matrix<double, static_cast<int>(Dimension), 1> seriesValue(
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
    const double largest = add(
        polygon.points, {-1, 1, function_(polygon.points[0]), function_(polygon.points[last_])}, 5);
    bound_.lower -= short_rounding * largest;  // a halving rounds by < 2^-50 of the largest point
    bound_.upper += short_rounding * largest;
    return bound_;
  }

 private:
  /// A part of the curve, with the values at its ends.
  struct Part {
    double from, to;
    double at_from, at_to;
  };

  void see(double value, double at) {
    if (value > bound_.lower) bound_.lower = value, bound_.at = at;
  }

  /// \returns the largest value at the points.
  double add(const Points& points, const Part& part, int halvings) {
    see(part.at_from, part.from);
    see(part.at_to, part.to);
    double upper = std::max({0.0, part.at_from, part.at_to});
    for (int i = 1; i < last_; ++i) upper = std::max(upper, function_(points[i]));
    const double enough =
        bound_.lower + std::max(slack_.relative * bound_.lower, slack_.absolute) / 4;
    if (upper <= enough || halvings == 0 || !std::isfinite(upper)) {
      bound_.upper = std::max(bound_.upper, upper);
      return upper;
    }
    Points left, right = points;
    for (int level = 0; level <= last_; ++level) {
      left[level] = right[0];
      for (int i = 0; i < last_ - level; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
    }
    // right now holds the last point of every level: these are the points of the right half, from
    // the apex outward.
    const double middle = 0.5 * (part.from + part.to), at_middle = function_(right[0]);
    add(left, {part.from, middle, part.at_from, at_middle}, halvings - 1);
    add(right, {middle, part.to, at_middle, part.at_to}, halvings - 1);
    return upper;
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
inline PieceBound widened(PieceBound bound, double radius, double relative) {
  bound.lower = std::max(0.0, bound.lower * (1 - relative) - radius);
  bound.upper = bound.upper * (1 + relative) + radius;
  if (!std::isfinite(bound.upper)) bound.upper = infinite;
  return bound;
}

template <int Dimension>
PieceBound largestNorm(const ControlPolygon<Dimension>& polygon, const Slack& slack) {
  if constexpr (Dimension == 6)
    return widened(maximumAlong(polygon, spectralNorm, slack),
                   1.5 * polygon.radius,  // off-diagonal entries occur twice
                   norm_rounding);
  else
    return widened(maximumAlong(
                       polygon, [](const Eigen::Vector3d& p) { return p.norm(); }, slack),
                   polygon.radius, short_rounding);
}

template <std::size_t Dimension>
PieceBound largestNorm(const std::array<ChebyshevModel, Dimension>& model, const Slack& slack) {
  return isKnown(model) ? largestNorm(controlPolygon(model), slack) : PieceBound{0, infinite, 0};
}

/// A curvature tensor over a piece, with bounds of its norm.
struct TensorNorm {
  double at_least = 0;
  double at_most = 0;    ///< up to sqrt(2) times the largest norm, where the entries are constant
  ChebyshevModel below;  ///< a function that is nowhere above the norm and touches it at the middle
};

TensorNorm normOf(const SymmetricModel& tensor);

}  // namespace seamwright::enclosure
