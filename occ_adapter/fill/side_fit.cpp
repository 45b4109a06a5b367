// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>

#include <seamwright/core/linear/dense.hpp>
#include <seamwright/occ_adapter/fill/side_fit.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Index, Eigen::Vector3d;

enum class Speed { Own, Even };

/// A stretch of a side over t in [0, 1].
class StretchPath {
 public:
  StretchPath(std::shared_ptr<const SidePath> path, const SideStretch& stretch)
      : path_(std::move(path)), stretch_(stretch) {}

  bool isOneEdge() const { return path_->isOneEdge(); }
  double length_mm() const { return (stretch_.end - stretch_.begin) * path_->length_mm(); }

  SideSample at(double t, Speed speed) const {
    if (speed == Speed::Own) {
      const double first = path_->placeOf(stretch_.begin), range = path_->placeOf(stretch_.end) - first;
      return placed(path_->atPlace(first + t * range), t, range);
    }
    const double range = stretch_.end - stretch_.begin;
    return placed(path_->atShare(t == 1 ? stretch_.end : stretch_.begin + t * range, t < 1), t, range);
  }

 private:
  static SideSample placed(SideSample sample, double t, double range) {
    sample.t = t;
    sample.derivative *= range;
    return sample;
  }

  std::shared_ptr<const SidePath> path_;
  SideStretch stretch_;
};

std::vector<SideSample> samplesOf(const StretchPath& path, Speed speed, int count) {
  std::vector<SideSample> samples;
  for (int i = 0; i <= count; ++i)
    samples.push_back(path.at((1 - std::cos(std::numbers::pi * i / count)) / 2, speed));
  return samples;
}

Eigen::VectorXd basisAt(int degree, double t) {
  Eigen::VectorXd basis = Eigen::VectorXd::Zero(degree + 1);
  basis(0) = 1;
  for (int n = 1; n <= degree; ++n)
    for (int i = n; i >= 0; --i) basis(i) = (1 - t) * basis(i) + (i > 0 ? t * basis(i - 1) : 0);
  return basis;
}

double angleToPlane(const Vector3d& direction, const Vector3d& normal) {
  return std::asin(std::min(1.0, std::abs(direction.normalized().dot(normal))));
}

/// Where a side begins or ends: shared with the next side.
struct SideFitEnd {
  Vector3d point;
  std::optional<Vector3d> direction;  ///< unit; nothing: the side's own
  double speed_mm = 0;                ///< of both sides, the mean
};

/// Speeds that are nearly the same are made the same: the equations of a ring are ill-conditioned where they are not quite equal.
Vector3d derivativeAt(const SideFitEnd& end, const SideSample& sample) {
  constexpr double nearly = 1e-5;
  if (!end.direction) return sample.derivative;
  const double own_mm = sample.derivative.norm();
  return (std::abs(own_mm - end.speed_mm) <= nearly * own_mm ? end.speed_mm : own_mm) * *end.direction;
}

/// Ends and end derivatives are kept.
BezierCurve fittedEdge(const std::vector<SideSample>& samples, const std::array<SideFitEnd, 2>& ends,
                       int degree) {
  Poles poles(degree + 1, 3);
  poles.row(0) = ends[0].point;
  poles.row(1) = ends[0].point + derivativeAt(ends[0], samples.front()) / degree;
  poles.row(degree - 1) = ends[1].point - derivativeAt(ends[1], samples.back()) / degree;
  poles.row(degree) = ends[1].point;
  const Index free = degree - 3, count = static_cast<Index>(samples.size());
  if (free == 0) return BezierCurve(poles);
  Eigen::MatrixXd matrix(count, free), right(count, 3);
  for (Index i = 0; i < count; ++i) {
    const Eigen::VectorXd basis = basisAt(degree, samples[i].t);
    matrix.row(i) = basis.segment(2, free).transpose();
    right.row(i) = samples[i].point.transpose();
    for (const Index fixed : {Index{0}, Index{1}, Index{degree} - 1, Index{degree}})
      right.row(i) -= basis(fixed) * poles.row(fixed);
  }
  poles.middleRows(2, free) = linear::PivotedQr(matrix).solve(right);
  return BezierCurve(poles);
}

/// T with the least sum of (T - L beyond)^2 and, by that weight, of its normal parts; at the ends these are zero.
Poles fittedCross(const std::vector<SideSample>& samples, const std::array<Vector3d, 2>& corner_normals,
                  double length_mm, int degree, double weight) {
  constexpr double weight_at_ends = 1e6;
  const Index unknowns = 3 * (degree + 1), count = static_cast<Index>(samples.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(4 * count, unknowns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(4 * count);
  for (Index i = 0; i < count; ++i) {
    const SideSample& sample = samples[i];
    const bool is_end = i == 0 || i + 1 == count;
    const Vector3d& normal = is_end ? corner_normals[i == 0 ? 0 : 1] : sample.normal;
    const Eigen::VectorXd basis = basisAt(degree, sample.t);
    for (int c = 0; c < 3; ++c) {
      for (int j = 0; j <= degree; ++j) {
        matrix(4 * i, 3 * j + c) = (is_end ? weight_at_ends : weight) * basis(j) * normal(c);
        matrix(4 * i + 1 + c, 3 * j + c) = basis(j);
      }
      right(4 * i + 1 + c) = sample.beyond(c);
    }
  }
  const Eigen::VectorXd solution = length_mm * linear::PivotedQr(matrix).solve(right);
  Poles cross = Eigen::Map<const Poles>(solution.data(), degree + 1, 3);
  for (const int end : {0, 1}) {
    const Vector3d& normal = corner_normals[end];
    auto last = cross.row(end == 0 ? 0 : degree);
    last -= (last * normal) * normal.transpose();
  }
  return cross;
}

/// II(T, T) of the face, T in its tangent plane.
double bendAlong(const SideSample& sample, const Vector3d& direction) {
  Eigen::Matrix<double, 3, 2> plane;
  plane << sample.jet.u, sample.jet.v;
  const Eigen::Vector2d c = plane.colPivHouseholderQr().solve(direction);
  return sample.normal.dot(c(0) * c(0) * sample.jet.uu + 2 * c(0) * c(1) * sample.jet.uv +
                           c(1) * c(1) * sample.jet.vv);
}

/// The polynomial nearest to II(T, T) N, which does not depend on how the face is turned.
Poles fittedBend(const std::vector<SideSample>& samples, const Eigen::VectorXd& wanted, int degree) {
  const Index count = static_cast<Index>(samples.size());
  Eigen::MatrixXd matrix(count, degree + 1), right(count, 3);
  for (Index i = 0; i < count; ++i) {
    matrix.row(i) = basisAt(degree, samples[i].t).transpose();
    right.row(i) = wanted(i) * samples[i].normal.transpose();
  }
  return linear::PivotedQr(matrix).solve(right);
}

/// One side while it is fitted.
class SideFit {
 public:
  SideFit(std::shared_ptr<const SidePath> path, const SideStretch& stretch, const SideFitOptions& options)
      : path_(std::move(path), stretch),
        options_(options),
        speed_(path_.isOneEdge() ? Speed::Own : Speed::Even) {}

  SideSample end(bool last) const { return path_.at(last ? 1 : 0, speed_); }

  void fitEdge(const std::array<SideFitEnd, 2>& ends) {
    fitEdgeAt(speed_, ends);
    if (speed_ == Speed::Even || isNear()) return;
    const SideFit own = *this;
    fitEdgeAt(Speed::Even, ends);
    if (own.miss() < miss()) *this = own;
  }

  const BezierCurve& edge() const { return edge_; }

  FittedSide finished(const std::array<Vector3d, 2>& corner_normals) const {
    FittedSide fitted{{edge_, std::nullopt}, gap_mm_, 0, {}};
    for (const int end : {0, 1})
      fitted.corner_rad[end] = std::acos(std::min(
          1.0, std::abs(corner_normals[end].dot((end == 0 ? checks_.front() : checks_.back()).normal))));
    if (std::ranges::max(fitted.corner_rad) > options_.planar_rad) return fitted;
    fitCross(corner_normals, fitted);
    if (options_.curvature) fitBend(fitted);
    return fitted;
  }

 private:
  /// What is reached over what is asked for.
  double miss() const { return std::max(gap_mm_ / options_.gap_mm, tilt_rad_ / options_.angle_rad); }
  bool isNear() const { return miss() <= 1; }

  void fitEdgeAt(Speed speed, const std::array<SideFitEnd, 2>& ends) {
    speed_ = speed;
    const int count = 6 * options_.most_degree;
    samples_ = samplesOf(path_, speed, count);
    checks_ = samplesOf(path_, speed, 4 * count);
    for (const SideSample* sample : {&samples_.front(), &samples_.back()})
      if (!(sample->derivative.norm() > 1e-9 * path_.length_mm()))
        throw std::runtime_error("an edge has no tangent where it ends");
    for (int degree = 3; degree <= options_.most_degree; ++degree) {
      edge_ = fittedEdge(samples_, ends, degree);
      measureEdge();
      if (isNear()) return;
    }
  }

  void measureEdge() {
    gap_mm_ = tilt_rad_ = 0;
    for (const SideSample& check : checks_) {
      const CurveJet jet = edge_.jet(check.t);
      gap_mm_ = std::max(gap_mm_, (jet.p - check.point).norm());
      tilt_rad_ = std::max(tilt_rad_, angleToPlane(jet.d1, check.normal));
    }
  }

  /// A field that is nearly zero somewhere, beside its largest, has the planes but makes folds.
  void fitCross(const std::array<Vector3d, 2>& corner_normals, FittedSide& fitted) const {
    constexpr double even_enough = 0.7, rounding = 1.01;
    constexpr std::array<double, 4> weights_of_normal_part = {1e6, 1e5, 1e4, 1e3};
    const double floor_rad = std::max(tilt_rad_, std::ranges::max(fitted.corner_rad));
    const double enough_rad = std::max(options_.angle_rad, rounding * floor_rad);
    bool is_even = false;
    for (int degree = 2; degree <= options_.most_degree; ++degree)
      for (const double weight : weights_of_normal_part) {
        const Poles cross = fittedCross(samples_, corner_normals, path_.length_mm(), degree, weight);
        const auto [angle, evenness] = formOf(cross);
        const bool even = evenness >= even_enough;
        if (fitted.side.cross && (even != is_even ? is_even : !(angle < fitted.angle_rad))) continue;
        fitted.side.cross = cross;
        fitted.angle_rad = angle;
        is_even = even;
        if (even && angle <= enough_rad) return;
      }
  }

  struct CrossForm {
    double angle_rad = 0;
    double evenness = 0;  ///< the smallest part out of the hole, across the edge, over the largest
  };

  CrossForm formOf(const Poles& cross) const {
    const BezierCurve field(cross);
    double angle = 0, least = HUGE_VAL, most = 0;
    for (const SideSample& check : checks_) {
      const Vector3d area = field.point(check.t).cross(edge_.jet(check.t).d1.normalized());
      const double across = field.point(check.t).dot(check.beyond);
      angle = std::max(angle, std::atan2(area.cross(check.normal).norm(), std::abs(area.dot(check.normal))));
      least = std::min(least, across);
      most = std::max(most, across);
    }
    return {angle, least / most};
  }

  void fitBend(FittedSide& fitted) const {
    constexpr double near_enough = 1e-3;  // of the largest curvature, or of one over the length
    const BezierCurve cross(*fitted.side.cross);
    const auto bends = [&](const std::vector<SideSample>& samples) {
      Eigen::VectorXd along(static_cast<Index>(samples.size()));
      for (Index i = 0; i < along.size(); ++i) along(i) = bendAlong(samples[i], cross.point(samples[i].t));
      return along;
    };
    const Eigen::VectorXd wanted = bends(samples_), checked = bends(checks_);
    Eigen::VectorXd squares(checked.size());
    for (Index i = 0; i < checked.size(); ++i) squares(i) = cross.point(checks_[i].t).squaredNorm();
    const double largest_per_mm =
        std::max(1 / path_.length_mm(), checked.cwiseQuotient(squares).cwiseAbs().maxCoeff());
    for (int degree = 0; degree <= options_.most_degree; ++degree) {
      const BezierCurve bend(fittedBend(samples_, wanted, degree));
      double missed_per_mm = 0;
      for (Index i = 0; i < checked.size(); ++i)
        missed_per_mm =
            std::max(missed_per_mm,
                     std::abs(checks_[i].normal.dot(bend.point(checks_[i].t)) - checked(i)) / squares(i));
      if (fitted.side.bend && !(missed_per_mm < fitted.curvature_per_mm)) continue;
      fitted.side.bend = bend.poles();
      fitted.curvature_per_mm = missed_per_mm;
      if (missed_per_mm <= near_enough * largest_per_mm) return;
    }
  }

  StretchPath path_;
  SideFitOptions options_;
  Speed speed_;
  std::vector<SideSample> samples_, checks_;
  BezierCurve edge_{Poles(Poles::Zero(1, 3))};
  double gap_mm_ = 0, tilt_rad_ = 0;
};

}  // namespace

std::vector<FittedSide> fitSides(const std::vector<HoleSide>& sides,
                                 const std::vector<SideStretch>& stretches, const SideFitOptions& options) {
  const std::size_t n = stretches.size();
  const auto before = [n](std::size_t k) { return (k + n - 1) % n; };
  const auto next = [n](std::size_t k) { return (k + 1) % n; };
  std::vector<std::shared_ptr<const SidePath>> paths;
  for (const HoleSide& side : sides) paths.push_back(std::make_shared<const SidePath>(side, options.gap_mm));
  std::vector<SideFit> fits;
  for (const SideStretch& stretch : stretches) fits.emplace_back(paths.at(stretch.side), stretch, options);
  std::vector<SideFitEnd> corners(n);  // where side k begins
  std::vector<Vector3d> normals(n);
  for (std::size_t k = 0; k < n; ++k) {
    const SideSample in = fits[before(k)].end(true), out = fits[k].end(false);
    corners[k].point = (in.point + out.point) / 2;
    if (!stretches[k].begins_smoothly) continue;
    const Vector3d along = (in.derivative.normalized() + out.derivative.normalized()).normalized();
    const Vector3d beyond = in.beyond + out.beyond;
    corners[k].direction = along;
    corners[k].speed_mm = (in.derivative.norm() + out.derivative.norm()) / 2;
    normals[k] = beyond.cross(along).normalized();
  }
  for (std::size_t k = 0; k < n; ++k) fits[k].fitEdge({corners[k], corners[next(k)]});
  for (std::size_t k = 0; k < n; ++k) {
    if (stretches[k].begins_smoothly) continue;
    const Vector3d in = fits[before(k)].edge().jet(1).d1, out = fits[k].edge().jet(0).d1;
    normals[k] = in.normalized().cross(out.normalized()).normalized();
  }
  std::vector<FittedSide> fitted;
  for (std::size_t k = 0; k < n; ++k) fitted.push_back(fits[k].finished({normals[k], normals[next(k)]}));
  return fitted;
}

}  // namespace seamwright::occ
