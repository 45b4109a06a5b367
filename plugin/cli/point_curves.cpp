// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <seamwright/plugin/cli/point_curves.hpp>

namespace seamwright::cli {

namespace {

using Eigen::Vector2d;

/// The tangent at the first point of the circle through three points; nothing if they turn too far
/// to be of one circle.
std::optional<double> circleDirection_rad(const Vector2d& first, const Vector2d& second,
                                          const Vector2d& third) {
  // A choice: 115 degrees between equal chords, more than samples of a curve turn.
  constexpr double largest_rad = 1;
  const double angle_rad = angleFromTo(first - third, second - third);
  if (std::abs(angle_rad) > largest_rad) return std::nullopt;
  return directionOf(second - first) - angle_rad;
}

/// A choice: samples of a curve do not become that much denser from one chord to the next.
constexpr double least_ratio = 0.05;

/// Looks for points that repeat the one before them.
class TwinSearch {
 public:
  TwinSearch(const PlanarPoints& points, const Eigen::VectorXd& tolerances_mm, bool closed)
      : points_(points), tolerances_mm_(tolerances_mm), closed_(closed) {}

  std::vector<PointTwin> twins() {
    const Eigen::Index n = points_.rows();
    kept_ = {0};
    for (Eigen::Index i = 1; i < n; ++i) {
      if (!isTwin(i)) {
        kept_.push_back(i);
      } else if (closed_ || i + 1 < n || kept_.size() == 1) {
        twins_.push_back({.left_out = i, .kept = kept_.back()});
      } else {  // an end stays
        keepInstead(i);
      }
    }
    return twins_;
  }

 private:
  double apart_mm(Eigen::Index i, Eigen::Index j) const {
    return (points_.row(i) - points_.row(j)).norm();
  }
  /// So that half of the tolerance is left for moves.
  bool isTwin(Eigen::Index i) const {
    const Eigen::Index last = kept_.back();
    const double gap_mm = apart_mm(i, last);
    if (gap_mm > std::min(tolerances_mm_(i), tolerances_mm_(last)) / 2) return false;
    const double least_mm = gap_mm / least_ratio;
    if (kept_.size() > 1 && apart_mm(kept_[kept_.size() - 2], last) < least_mm) return false;
    const Eigen::Index n = points_.rows();
    Eigen::Index next = i + 1;
    while (next < n && apart_mm(next, last) <= 2 * gap_mm) ++next;  // more of them
    if (next == n) return kept_.size() > 1 || closed_;
    return apart_mm(next, last) >= least_mm;
  }
  void keepInstead(Eigen::Index i) {
    for (PointTwin& twin : twins_)
      if (twin.kept == kept_.back()) twin.kept = i;
    twins_.push_back({.left_out = kept_.back(), .kept = i});
    kept_.back() = i;
  }

  const PlanarPoints& points_;
  const Eigen::VectorXd& tolerances_mm_;
  bool closed_;
  std::vector<Eigen::Index> kept_ = {};
  std::vector<PointTwin> twins_ = {};
};

}  // namespace

BiarcSpline biarcsOf(const PlanarPoints& points, bool closed) {
  TangentOptions options;
  options.closed = closed;
  const Eigen::Index n = points.rows();
  if (!closed && n > 2) {
    const auto at = [&](Eigen::Index i) -> Vector2d { return points.row(i).transpose(); };
    options.start_direction_rad = circleDirection_rad(at(0), at(1), at(2));
    options.end_direction_rad = circleDirection_rad(at(n - 1), at(n - 2), at(n - 3));
    if (options.end_direction_rad) *options.end_direction_rad += std::numbers::pi;
  }
  return biarcSpline(points, options);
}

ClothoidSpline clothoidsOf(const PlanarPoints& points, bool closed, const Progress& progress) {
  ClothoidSplineOptions options;
  options.closed = closed;
  options.start.arc = options.end.arc = !closed && points.rows() > 2;
  return clothoidSpline(points, options, progress);
}

std::vector<PointTwin> pointTwins(const PlanarPoints& points, const Eigen::VectorXd& tolerances_mm,
                                  bool closed) {
  return TwinSearch(points, tolerances_mm, closed).twins();
}

std::string crowdedPoints(const GivenCurve& given) {
  const Eigen::Index n = given.points.rows(), chords = given.record.closed ? n : n - 1;
  const auto chord_mm = [&](Eigen::Index i) {
    const Eigen::Index from = (i + chords) % chords;
    return (given.points.row((from + 1) % n) - given.points.row(from)).norm();
  };
  for (Eigen::Index i = 0; chords > 1 && i < chords; ++i) {
    const double length_mm = chord_mm(i);
    const bool has_before = given.record.closed || i > 0,
               has_after = given.record.closed || i + 1 < chords;
    if ((!has_before || length_mm < least_ratio * chord_mm(i - 1)) &&
        (!has_after || length_mm < least_ratio * chord_mm(i + 1)))
      return fmt::format("the points of lines {} and {} are only {:.3g} mm apart: remove one",
                         given.lines[static_cast<std::size_t>(i)],
                         given.lines[static_cast<std::size_t>((i + 1) % n)], length_mm);
  }
  return "";
}

}  // namespace seamwright::cli
