// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/nearest_chain.hpp>
#include <seamwright/core/planar/touch_point.hpp>

namespace seamwright {

namespace {

using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector4d;
using Eigen::VectorXd;

/// The signed distance of a point from the circle of an arc, and its slopes by the start of the
/// arc, its direction there and its curvature.
struct ArcResidual {
  double distance = 0;
  Vector4d slopes = Vector4d::Zero();
};

std::optional<ArcResidual> residualOf(const PlanarArc& arc, const Vector2d& point) {
  const Vector2d tangent = unitVector(arc.direction_rad), normal(-tangent.y(), tangent.x());
  const Vector2d away = point - arc.start;
  const double k = arc.curvature_per_mm, twice = 2 * away.dot(normal) - k * away.squaredNorm();
  const double from_centre = std::sqrt(std::max(0.0, 1 - k * twice));  // in radii
  if (!(from_centre > 0)) return std::nullopt;
  ArcResidual result{.distance = twice / (1 + from_centre)};
  result.slopes << (k * away - normal) / from_centre, -away.dot(tangent) / from_centre,
      (result.distance * result.distance - away.squaredNorm()) / (2 * from_centre);
  return result;
}

/// How the end of an arc moves with its curvature.
Vector2d endSlope(const PlanarArc& arc) {
  const double half_rad = arc.sweep_rad() / 2;
  const Vector2d middle = unitVector(arc.direction_rad + half_rad);
  return arc.length_mm * arc.length_mm / 2 *
         (sincSlope(half_rad) * middle + sinc(half_rad) * Vector2d(-middle.y(), middle.x()));
}

/// The steps of Gauss and Newton. Lengths are in units of the size of an arc, so that all unknowns
/// have much the same size.
class ChainSteps {
 public:
  ChainSteps(const PointsOfArcs& sampled, std::vector<PlanarArc> chain)
      : starts_(sampled.starts), closed_(sampled.closed), chain_(std::move(chain)) {
    double length_mm = 0;
    for (const PlanarArc& arc : chain_) length_mm += arc.length_mm;
    unit_mm_ = length_mm / static_cast<double>(chain_.size());
    origin_ = sampled.points.front();
    for (const Vector2d& point : sampled.points) points_.push_back((point - origin_) / unit_mm_);
    starts_.push_back(static_cast<int>(points_.size()));
    unknowns_ = closed_ ? 3 : 2;
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      PlanarArc& arc = chain_[i];
      arc.start = (arc.start - origin_) / unit_mm_;
      arc.curvature_per_mm *= unit_mm_;
      arc.length_mm /= unit_mm_;
      // Nothing depends on where the last arc of an open chain ends.
      lengths_.push_back(closed_ || i + 1 < chain_.size() ? unknowns_++ : -1);
      curvatures_.push_back(arc.curvature_per_mm != 0 ? unknowns_++ : -1);
    }
    join();
  }

  /// \returns the size of the step; nothing if there is none.
  std::optional<double> step() {
    normal_ = MatrixXd::Zero(unknowns_ + 3, unknowns_ + 3);
    right_ = VectorXd::Zero(unknowns_ + 3);
    MatrixXd slopes = MatrixXd::Zero(4, unknowns_);
    const PlanarArc first = chain_.front();
    if (closed_) {
      slopes.topLeftCorner<3, 3>().setIdentity();
    } else {
      slopes.block<2, 1>(0, 0) = touchPointOf(first).normal();
      slopes(2, 1) = 1;
    }
    const MatrixXd begin = slopes;
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      slopes.row(3).setZero();
      if (curvatures_[i] >= 0) slopes(3, curvatures_[i]) = 1;
      if (!addPoints(i, slopes)) return std::nullopt;
      advance(i, slopes);
    }
    if (closed_) addClosure(slopes - begin);
    const Eigen::Index count = unknowns_ + (closed_ ? 3 : 0);
    const VectorXd change = normal_.topLeftCorner(count, count)
                                .completeOrthogonalDecomposition()
                                .solve(right_.head(count));
    if (!change.allFinite()) return std::nullopt;
    apply(change.head(unknowns_));
    return change.head(unknowns_).norm();
  }

  std::vector<PlanarArc> chain() const {
    std::vector<PlanarArc> result = chain_;
    for (PlanarArc& arc : result) {
      arc.curvature_per_mm /= unit_mm_;
      arc.length_mm *= unit_mm_;
    }
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i].start =
          i == 0 ? Vector2d(origin_ + unit_mm_ * chain_[0].start) : result[i - 1].end();
    return result;
  }

 private:
  /// Each arc begins where and in the direction in which the one before ends.
  void join() {
    for (std::size_t i = 1; i < chain_.size(); ++i) {
      chain_[i].start = chain_[i - 1].end();
      chain_[i].direction_rad = chain_[i - 1].endDirection_rad();
    }
  }
  bool addPoints(std::size_t i, const MatrixXd& slopes) {
    Matrix4d squares = Matrix4d::Zero();
    Vector4d right = Vector4d::Zero();
    for (int v = starts_[i]; v < starts_[i + 1]; ++v) {
      const auto residual = residualOf(chain_[i], points_[static_cast<std::size_t>(v)]);
      if (!residual) return false;
      squares += residual->slopes * residual->slopes.transpose();
      right += residual->slopes * residual->distance;
    }
    normal_.topLeftCorner(unknowns_, unknowns_) += slopes.transpose() * squares * slopes;
    right_.head(unknowns_) -= slopes.transpose() * right;
    return true;
  }
  /// From the slopes of the start of an arc to those of its end.
  void advance(std::size_t i, MatrixXd& slopes) const {
    const PlanarArc& arc = chain_[i];
    const Vector2d away = arc.end() - arc.start;
    slopes.topRows<2>() += Vector2d(-away.y(), away.x()) * slopes.row(2);
    if (lengths_[i] >= 0) {
      slopes.block<2, 1>(0, lengths_[i]) += unitVector(arc.endDirection_rad());
      slopes(2, lengths_[i]) += arc.curvature_per_mm;
    }
    if (curvatures_[i] < 0) return;
    slopes.block<2, 1>(0, curvatures_[i]) += endSlope(arc);
    slopes(2, curvatures_[i]) += arc.length_mm;
  }
  void addClosure(const MatrixXd& slopes) {
    const PlanarArc &first = chain_.front(), &last = chain_.back();
    normal_.block(unknowns_, 0, 3, unknowns_) = slopes.topRows<3>();
    normal_.block(0, unknowns_, unknowns_, 3) = slopes.topRows<3>().transpose();
    right_.segment<2>(unknowns_) = first.start - last.end();
    right_(unknowns_ + 2) = wrapped(first.direction_rad - last.endDirection_rad());
  }
  void apply(const VectorXd& change) {
    PlanarArc& first = chain_.front();
    first.start +=
        closed_ ? Vector2d(change.head<2>()) : Vector2d(change(0) * touchPointOf(first).normal());
    first.direction_rad += change(closed_ ? 2 : 1);
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      if (lengths_[i] >= 0) chain_[i].length_mm += change(lengths_[i]);
      if (curvatures_[i] >= 0) chain_[i].curvature_per_mm += change(curvatures_[i]);
    }
    join();
  }

  std::vector<int> starts_;
  bool closed_;
  std::vector<PlanarArc> chain_;
  double unit_mm_ = 1;
  Vector2d origin_ = Vector2d::Zero();
  std::vector<Vector2d> points_;
  int unknowns_ = 0;
  std::vector<int> lengths_, curvatures_;  ///< the unknowns of each arc; -1 if it has none
  MatrixXd normal_;
  VectorXd right_;
};

/// An open chain begins and ends beside the first and the last point.
void takeEnds(std::vector<PlanarArc>& chain, const std::vector<Vector2d>& points) {
  TouchPoint begin = touchPointOf(chain.front());
  const double ahead_mm = begin.lengthTo_mm(points.front());
  chain.front() = begin.after(ahead_mm).arc(chain.front().length_mm - ahead_mm);
  const TouchPoint last = touchPointOf(chain.back());
  chain.back().length_mm = lengthBetween(last, last.beside(points.back()));
}

}  // namespace

std::optional<std::vector<PlanarArc>> nearestChain(const PointsOfArcs& sampled,
                                                   std::vector<PlanarArc> chain) {
  ChainSteps steps(sampled, std::move(chain));
  // Residuals are small, so that each step adds digits; the last ones bring those of rounding.
  constexpr int most_steps = 40;
  constexpr double rounding = 1e-12;
  bool is_found = false;
  for (int i = 0; i < most_steps && !is_found; ++i) {
    const auto size = steps.step();
    if (!size) return std::nullopt;
    is_found = *size <= rounding;
  }
  std::vector<PlanarArc> result = steps.chain();
  if (!sampled.closed) takeEnds(result, sampled.points);
  const auto isNone = [](const PlanarArc& arc) { return !(arc.length_mm > 0); };
  if (!is_found || std::ranges::any_of(result, isNone)) return std::nullopt;
  return result;
}

}  // namespace seamwright
