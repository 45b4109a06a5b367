// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include <seamwright/core/planar/nearest_chain.hpp>
#include <seamwright/core/planar/touch_point.hpp>

namespace seamwright {

namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// The signed distance of a point from a circle, and its slopes by moves of the point of the circle
/// along the normal, its direction and its curvature.
struct CircleResidual {
  double distance = 0;
  Vector3d slopes = Vector3d::Zero();
};

std::optional<CircleResidual> residualOf(const TouchPoint& circle, const Vector2d& point) {
  const Vector2d normal = circle.normal(), away = point - circle.point;
  const double k = circle.curvature_per_mm, square = away.squaredNorm();
  const double twice = 2 * away.dot(normal) - k * square;
  const double from_centre = std::sqrt(std::max(0.0, 1 - k * twice));  // in radii
  if (!(from_centre > 0)) return std::nullopt;
  CircleResidual result{.distance = twice / (1 + from_centre)};
  result.slopes << k * away.dot(normal) - 1, -away.dot(circle.tangent()),
      (result.distance * result.distance - square) / 2;
  result.slopes /= from_centre;
  return result;
}

/// An oriented circle or line as k/2 |x|² - b·x + c = 0, with the slopes of k, b and c by moves of
/// its point along the normal, its direction and its curvature.
struct CircleForm {
  double k = 0, c = 0;
  Vector2d b = Vector2d::Zero();
  Eigen::RowVector3d k_slopes = {0, 0, 1}, c_slopes;
  Eigen::Matrix<double, 2, 3> b_slopes;
};

CircleForm formOf(const TouchPoint& circle, const Vector2d& origin) {
  const Vector2d tangent = circle.tangent(), normal = circle.normal(),
                 point = circle.point - origin;
  CircleForm form{.k = circle.curvature_per_mm, .c_slopes = {}, .b_slopes = {}};
  form.b = normal + form.k * point;
  form.c = form.k * point.squaredNorm() / 2 + normal.dot(point);
  form.b_slopes << form.k * normal, -tangent, point;
  form.c_slopes << form.k * point.dot(normal) + 1, -tangent.dot(point), point.squaredNorm() / 2;
  return form;
}

/// Circles that touch their neighbours, by the steps of Gauss and Newton. Lengths are in units of
/// the size of an arc, so that all unknowns have much the same size.
class TouchingCircles {
 public:
  TouchingCircles(const PointsOfArcs& sampled, const std::vector<PlanarArc>& arcs)
      : starts_(sampled.starts), joints_(static_cast<int>(arcs.size()) - (sampled.closed ? 0 : 1)) {
    double length_mm = 0;
    for (const PlanarArc& arc : arcs) length_mm += arc.length_mm;
    unit_mm_ = length_mm / static_cast<double>(arcs.size());
    origin_ = sampled.points.front();
    for (const Vector2d& point : sampled.points) points_.push_back((point - origin_) / unit_mm_);
    starts_.push_back(static_cast<int>(points_.size()));
    for (const PlanarArc& arc : arcs) {
      TouchPoint circle = touchPointOf(arc).after(arc.length_mm / 2);
      circle.point = (circle.point - origin_) / unit_mm_;
      circle.curvature_per_mm *= unit_mm_;
      circles_.push_back(circle);
      firsts_.push_back(unknowns_);
      unknowns_ += arc.curvature_per_mm == 0 ? 2 : 3;
    }
    firsts_.push_back(unknowns_);
  }

  /// \returns the size of the step; nothing if there is none.
  std::optional<double> step() {
    const Eigen::Index size = unknowns_ + joints_;
    matrix_ = MatrixXd::Zero(size, size);
    right_ = VectorXd::Zero(size);
    for (std::size_t i = 0; i < circles_.size(); ++i)
      if (!addPoints(i)) return std::nullopt;
    for (int joint = 0; joint < joints_; ++joint) addJoint(joint);
    const VectorXd change = matrix_.partialPivLu().solve(right_).head(unknowns_);
    if (!change.allFinite()) return std::nullopt;
    for (std::size_t i = 0; i < circles_.size(); ++i) {
      TouchPoint& circle = circles_[i];
      circle.point += change(firsts_[i]) * circle.normal();
      circle.direction_rad += change(firsts_[i] + 1);
      if (isArc(i)) circle.curvature_per_mm += change(firsts_[i] + 2);
    }
    return change.norm();
  }

  std::vector<TouchPoint> circles() const {
    std::vector<TouchPoint> result = circles_;
    for (TouchPoint& circle : result) {
      circle.point = origin_ + unit_mm_ * circle.point;
      circle.curvature_per_mm /= unit_mm_;
    }
    return result;
  }

 private:
  bool isArc(std::size_t i) const { return firsts_[i + 1] - firsts_[i] == 3; }

  bool addPoints(std::size_t i) {
    Matrix3d squares = Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (int v = starts_[i]; v < starts_[i + 1]; ++v) {
      const auto residual = residualOf(circles_[i], points_[static_cast<std::size_t>(v)]);
      if (!residual) return false;
      squares += residual->slopes * residual->slopes.transpose();
      right -= residual->slopes * residual->distance;
    }
    const int count = isArc(i) ? 3 : 2;
    matrix_.block(firsts_[i], firsts_[i], count, count) = squares.topLeftCorner(count, count);
    right_.segment(firsts_[i], count) = right.head(count);
    return true;
  }
  /// Circles touch in one sense if b·b' - k c' - k' c = 1.
  void addJoint(int joint) {
    const auto i = static_cast<std::size_t>(joint), next = (i + 1) % circles_.size();
    const Vector2d& between = points_[static_cast<std::size_t>(starts_[i + 1] - 1)];
    const CircleForm one = formOf(circles_[i], between), other = formOf(circles_[next], between);
    const auto slopes = [](const CircleForm& of, const CircleForm& to) -> Eigen::RowVector3d {
      return to.b.transpose() * of.b_slopes - to.c * of.k_slopes - to.k * of.c_slopes;
    };
    const int row = unknowns_ + joint;
    right_(row) = 1 - one.b.dot(other.b) + one.k * other.c + other.k * one.c;
    for (const auto& [at, by] : {std::pair{i, slopes(one, other)}, {next, slopes(other, one)}}) {
      const int count = isArc(at) ? 3 : 2;
      matrix_.block(row, firsts_[at], 1, count) = by.head(count);
      matrix_.block(firsts_[at], row, count, 1) = by.head(count).transpose();
    }
  }

  std::vector<int> starts_;
  int joints_;
  double unit_mm_ = 1;
  Vector2d origin_ = Vector2d::Zero();
  std::vector<Vector2d> points_;
  std::vector<TouchPoint> circles_;
  int unknowns_ = 0;
  std::vector<int> firsts_;  ///< the first unknown of each circle
  MatrixXd matrix_;
  VectorXd right_;
};

/// From joint to joint of circles that touch.
std::vector<PlanarArc> arcsAlong(const std::vector<TouchPoint>& circles,
                                 const PointsOfArcs& sampled) {
  const std::size_t m = circles.size();
  std::vector<PlanarArc> arcs;
  for (std::size_t i = 0; i < m; ++i) {
    const bool is_first = !sampled.closed && i == 0, is_last = !sampled.closed && i + 1 == m;
    const Vector2d begin =
        is_first ? sampled.points.front() : touchPoint(circles[(i + m - 1) % m], circles[i]);
    const Vector2d end =
        is_last ? sampled.points.back() : touchPoint(circles[i], circles[(i + 1) % m]);
    const TouchPoint start = circles[i].beside(begin);
    arcs.push_back(start.arc(lengthBetween(start, start.beside(end))));
  }
  return arcs;
}

}  // namespace

std::optional<std::vector<PlanarArc>> nearestChain(const PointsOfArcs& sampled,
                                                   const std::vector<PlanarArc>& near) {
  const std::size_t m = near.size();
  // Two lines do not touch, and two circles do so once.
  if (sampled.closed && m < 3) return std::nullopt;
  for (std::size_t i = sampled.closed ? 0 : 1; i < m; ++i)
    if (near[i].curvature_per_mm == 0 && near[(i + m - 1) % m].curvature_per_mm == 0)
      return std::nullopt;
  TouchingCircles circles(sampled, near);
  // The circles touch up to the square of the last step.
  constexpr int most_steps = 20;
  constexpr double small = 1e-8;
  bool is_found = false;
  for (int i = 0; i < most_steps && !is_found; ++i) {
    const auto size = circles.step();
    if (!size) return std::nullopt;
    is_found = *size <= small;
  }
  if (!is_found) return std::nullopt;
  std::vector<PlanarArc> chain = arcsAlong(circles.circles(), sampled);
  const auto isNone = [](const PlanarArc& arc) { return !(arc.length_mm > 0); };
  if (std::ranges::any_of(chain, isNone)) return std::nullopt;
  return chain;
}

}  // namespace seamwright
