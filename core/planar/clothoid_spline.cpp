// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/clothoid_curvatures.hpp>
#include <seamwright/core/planar/clothoid_phase.hpp>
#include <seamwright/core/planar/clothoid_spline.hpp>
#include <seamwright/core/planar/tridiagonal.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

/// The spline with given directions.
struct Attempt {
  std::vector<Clothoid> pieces;
  std::vector<EndCurvatures> curvatures;
  Eigen::VectorXd jumps_per_mm;  ///< by point; at open ends what is missing of the condition
  /// Sum of the squared jumps times the chords beside them, which has no unit.
  double miss = 0;
};

class SplineEquations {
 public:
  SplineEquations(const PlanarPoints& points, const ClothoidSplineOptions& options)
      : points_(points), options_(options) {}

  Attempt attempt(const std::vector<double>& directions_rad) const {
    Attempt result;
    const Index count = points_.rows(), segments = count - (options_.closed ? 0 : 1);
    for (Index s = 0; s < segments; ++s) {
      const HermiteEnds ends{.start = points_.row(s).transpose(),
                             .start_direction_rad = directions_rad[s],
                             .end = points_.row((s + 1) % count).transpose(),
                             .end_direction_rad = directions_rad[(s + 1) % count]};
      result.pieces.push_back(clothoid(ends));
      result.curvatures.push_back(endCurvatures(result.pieces.back(), chordAngles(ends)));
    }
    result.jumps_per_mm = Eigen::VectorXd::Zero(count);
    for (Index s = 0; s < segments; ++s) {
      result.jumps_per_mm(s) += result.curvatures[s].value_per_mm(0);
      result.jumps_per_mm((s + 1) % count) -= result.curvatures[s].value_per_mm(1);
    }
    if (!options_.closed) {
      result.jumps_per_mm(0) -= options_.start.curvature_per_mm;
      result.jumps_per_mm(count - 1) += options_.end.curvature_per_mm;
      if (options_.start.arc) result.jumps_per_mm(0) -= result.curvatures.front().value_per_mm(1);
      if (options_.end.arc)
        result.jumps_per_mm(count - 1) += result.curvatures.back().value_per_mm(0);
      if (options_.start.direction_rad) result.jumps_per_mm(0) = 0;
      if (options_.end.direction_rad) result.jumps_per_mm(count - 1) = 0;
    }
    for (Index i = 0; i < count; ++i) {
      const double chord_mm = (points_.row((i + 1) % count) - points_.row(i)).norm();
      result.miss += std::pow(result.jumps_per_mm(i) * chord_mm, 2);
    }
    return result;
  }

  /// The change of the directions that removes the jumps to first order.
  Eigen::VectorXd step(const Attempt& now) const {
    const Index count = points_.rows();
    TridiagonalEquations equations(count, options_.closed);
    for (Index s = 0; s < std::ssize(now.curvatures); ++s) {
      const Eigen::Matrix2d& slope = now.curvatures[s].slope;
      equations.add(s, 0, slope(0, 0), slope(0, 1), 0);
      equations.add((s + 1) % count, -slope(1, 0), -slope(1, 1), 0, 0);
    }
    if (options_.start.arc) {
      const Eigen::Matrix2d& slope = now.curvatures.front().slope;
      equations.add(0, 0, -slope(1, 0), -slope(1, 1), 0);
    }
    if (options_.end.arc) {
      const Eigen::Matrix2d& slope = now.curvatures.back().slope;
      equations.add(count - 1, slope(0, 0), slope(0, 1), 0, 0);
    }
    for (Index i = 0; i < count; ++i) equations.add(i, 0, 0, 0, -now.jumps_per_mm(i));
    if (!options_.closed && options_.start.direction_rad) equations.give(0, 0);
    if (!options_.closed && options_.end.direction_rad) equations.give(count - 1, 0);
    return std::move(equations).solve();
  }

 private:
  const PlanarPoints& points_;
  const ClothoidSplineOptions& options_;
};

std::vector<double> plus(std::vector<double> directions_rad, const Eigen::VectorXd& change) {
  for (std::size_t i = 0; i < directions_rad.size(); ++i)
    directions_rad[i] += change(static_cast<Index>(i));
  return directions_rad;
}

std::vector<double> firstDirections(const PlanarPoints& points,
                                    const ClothoidSplineOptions& options) {
  TangentOptions tangents{.closed = options.closed};
  if (!options.closed) {
    tangents.start_direction_rad = options.start.direction_rad;
    tangents.end_direction_rad = options.end.direction_rad;
  }
  return tangentsAt(points, tangents).directions_rad;
}

}  // namespace

/// With the phase of clothoid() and h = integral of cos(phase), the curvatures are (d - a) h /
/// chord and (d + a) h / chord. a follows from integral of sin(phase) = 0 by implicit
/// differentiation.
EndCurvatures endCurvatures(const Clothoid& piece, const ChordAngles& angles) {
  const double change = angles.alpha_rad + angles.beta_rad;
  const double a = piece.curvature_slope_per_mm2 * piece.length_mm * piece.length_mm / 2;
  const Phase phase{.start = -angles.alpha_rad, .change = change};
  // Integrals of t^k cos(phase) and t^k sin(phase).
  using Moments = Eigen::Array<double, 6, 1>;
  const Moments moments = integral(
      [&](double t) {
        const double c = std::cos(phase.at(a, t)), s = std::sin(phase.at(a, t));
        Moments values;
        values << c, t * c, t * t * c, s, t * s, t * t * s;
        return values;
      },
      phase.turn(a));
  const double height_by_a = moments(2) - moments(1), width = moments(0);
  // The phase changes by 1 - t for the direction at the start, and by t for that at the end.
  const Eigen::RowVector2d height_slope(moments(0) - moments(1), moments(1));
  const Eigen::RowVector2d a_slope = -height_slope / height_by_a;
  const Eigen::RowVector2d width_slope = -(moments(5) - moments(4)) * a_slope -
                                         Eigen::RowVector2d(moments(3) - moments(4), moments(4));
  const Eigen::RowVector2d change_slope(-1, 1);
  EndCurvatures result;
  result.value_per_mm << (change - a) * width, (change + a) * width;
  result.slope.row(0) = (change_slope - a_slope) * width + (change - a) * width_slope;
  result.slope.row(1) = (change_slope + a_slope) * width + (change + a) * width_slope;
  result.value_per_mm /= angles.chord_mm;
  result.slope /= angles.chord_mm;
  return result;
}

ClothoidSpline clothoidSpline(const PlanarPoints& points, const ClothoidSplineOptions& options,
                              const Progress& progress) {
  for (const ClothoidEnd& end : {options.start, options.end}) {
    if (!std::isfinite(end.curvature_per_mm))
      refuse(fmt::format("the curvature at an end is {} per mm", end.curvature_per_mm));
    if (options.closed && (end.direction_rad || end.curvature_per_mm != 0 || end.arc))
      refuse("a closed curve has no conditions at its ends");
    if (end.arc && (end.direction_rad || end.curvature_per_mm != 0))
      refuse("an end has an arc, or a direction, or a curvature");
    if (end.arc && points.rows() < 3)
      refuse(fmt::format("{} points: arcs at the ends need at least 3", points.rows()));
  }
  ClothoidSpline spline;
  spline.closed = options.closed;
  spline.directions_rad = firstDirections(points, options);
  const SplineEquations equations(points, options);
  checkProgress(progress, 0);
  Attempt now = equations.attempt(spline.directions_rad);
  // Bounds against endless loops: Newton's method doubles the digits near the solution, and a step
  // that must be halved more than ten times makes no progress.
  constexpr int most_steps = 30, most_halvings = 10;
  // Jumps times chords are differences of angles, which have a rounding of some eps each.
  const double rounding = std::pow(64 * machine_epsilon, 2) * static_cast<double>(points.rows());
  while (now.miss > rounding && spline.steps < most_steps) {
    checkProgress(progress, shareAfter(spline.steps));
    Eigen::VectorXd change = equations.step(now);
    std::vector<double> next = plus(spline.directions_rad, change);
    Attempt tried = equations.attempt(next);
    for (int halvings = 0; tried.miss >= now.miss && halvings < most_halvings; ++halvings) {
      checkProgress(progress, shareAfter(spline.steps));
      change /= 2;
      next = plus(spline.directions_rad, change);
      tried = equations.attempt(next);
    }
    if (tried.miss >= now.miss) break;
    ++spline.steps;
    spline.directions_rad = std::move(next);
    now = std::move(tried);
  }
  Index roughest = 0;
  spline.curvature_jump_per_mm = now.jumps_per_mm.cwiseAbs().maxCoeff(&roughest);
  // Far above the rounding of the angles, so that long polygons pass; far below any angle that a
  // tolerance of G2 notices.
  constexpr double accepted_rad = 1e-9;
  if (!(now.miss <= accepted_rad * accepted_rad))
    throw std::domain_error(fmt::format(
        "no G2 spline of clothoids was found: a curvature jump of "
        "{:.3g} per mm is left at ({:.6g}, {:.6g}) after {} steps; insert points there",
        spline.curvature_jump_per_mm, points(roughest, 0), points(roughest, 1), spline.steps));
  for (double& direction_rad : spline.directions_rad) direction_rad = wrapped(direction_rad);
  spline.pieces = std::move(now.pieces);
  return spline;
}

}  // namespace seamwright
