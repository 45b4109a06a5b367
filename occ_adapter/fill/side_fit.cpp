// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>

#include <seamwright/core/linear/dense.hpp>
#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/fill/side_fit.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Index, Eigen::Vector3d;

/// What a side shows at t: the point, its derivative by t, and the frame of the face.
struct SideSample {
  double t = 0;
  Vector3d point, derivative;
  Vector3d normal, beyond;  ///< unit; beyond points into the face, across the edge
};

/// The arc length of a path over its places, by Gauss quadrature on short pieces.
class ArcLength {
 public:
  explicit ArcLength(std::shared_ptr<const FaceStrip> strip) : strip_(std::move(strip)) {
    for (int k = 0; k < pieces; ++k) lengths_[k + 1] = lengths_[k] + between(at(k), at(k + 1));
  }
  double length_mm() const { return lengths_[pieces]; }

  double placeAt(double length_mm) const {
    const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length_mm);
    const int k = static_cast<int>(after - lengths_.begin()) - 1;
    const double rest = length_mm - lengths_[k];
    double place = at(k) + rest / (lengths_[k + 1] - lengths_[k]) / pieces;
    for (int step = 0; step < 4; ++step)
      place -= (between(at(k), place) - rest) / strip_->trace(std::clamp(place, 0.0, 1.0)).d.norm();
    return std::clamp(place, 0.0, 1.0);
  }

 private:
  static constexpr int pieces = 32;
  static double at(int k) { return static_cast<double>(k) / pieces; }

  double between(double from, double to) const {
    constexpr std::array<double, 3> nodes = {0, 0.5384693101056831, 0.9061798459386640};
    constexpr std::array<double, 3> weights = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const double middle = (from + to) / 2, half = (to - from) / 2;
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (const double node : {-nodes[i], nodes[i]})
        sum += (i == 0 ? 0.5 : 1) * weights[i] *
               strip_->trace(std::clamp(middle + half * node, 0.0, 1.0)).d.norm();
    return half * sum;
  }

  std::shared_ptr<const FaceStrip> strip_;
  std::array<double, pieces + 1> lengths_{};
};

enum class Speed { Own, Even };

/// The edges of a side, one after the other, over t in [0, 1].
class SidePath {
 public:
  SidePath(const HoleSide& side, double gap_mm) {
    for (const HoleEdge& edge : side.edges) {
      strips_.push_back(
          std::make_shared<const FaceStrip>(edge.use, pcurveOf(edge.use.edge, edge.use.shape, gap_mm)));
      reversed_.push_back(edge.reversed);
    }
    for (const std::shared_ptr<const FaceStrip>& strip : strips_) {
      lengths_.emplace_back(strip);
      length_mm_ += lengths_.back().length_mm();
    }
    if (!(length_mm_ > 0 && std::isfinite(length_mm_)))
      throw std::runtime_error("edge " + std::to_string(side.edges.front().edge) + " has no length");
  }

  bool isOneEdge() const { return strips_.size() == 1; }
  double length_mm() const { return length_mm_; }

  SideSample at(double t, Speed speed) const {
    std::size_t k = 0;
    double place = 0;
    if (speed == Speed::Own) {
      place = reversed_[0] ? 1 - t : t;
    } else {
      double rest = t * length_mm_;
      while (k + 1 < strips_.size() && rest > lengths_[k].length_mm()) rest -= lengths_[k++].length_mm();
      rest = std::min(rest, lengths_[k].length_mm());
      place = lengths_[k].placeAt(reversed_[k] ? lengths_[k].length_mm() - rest : rest);
    }
    return sample(t, k, place, speed);
  }

 private:
  SideSample sample(double t, std::size_t k, double place, Speed speed) const {
    const SidePoint side = strips_[k]->at(place);
    const Vector3d normal = side.jet.u.cross(side.jet.v).normalized();
    const Vector3d beyond = (side.face_on_left ? 1 : -1) * normal.cross(side.tangent).normalized();
    const Vector3d forward = (reversed_[k] ? -1 : 1) * side.tangent;
    return {t, side.jet.p, speed == Speed::Own ? forward : Vector3d(length_mm_ * forward.normalized()),
            normal, beyond};
  }

  std::vector<std::shared_ptr<const FaceStrip>> strips_;
  std::vector<ArcLength> lengths_;
  std::vector<bool> reversed_;
  double length_mm_ = 0;
};

std::vector<SideSample> samplesOf(const SidePath& path, Speed speed, int count) {
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

/// Ends and end derivatives are kept.
BezierCurve fittedEdge(const std::vector<SideSample>& samples, const std::array<Vector3d, 2>& ends,
                       int degree) {
  Poles poles(degree + 1, 3);
  poles.row(0) = ends[0];
  poles.row(1) = ends[0] + samples.front().derivative / degree;
  poles.row(degree - 1) = ends[1] - samples.back().derivative / degree;
  poles.row(degree) = ends[1];
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

/// T with the least sum of (T - L beyond)^2 among those with normal parts as small as they can be.
Poles fittedCross(const std::vector<SideSample>& samples, const std::array<Vector3d, 2>& corner_normals,
                  double length_mm, int degree) {
  constexpr double weight_of_normal_part = 1e6;
  const Index unknowns = 3 * (degree + 1), count = static_cast<Index>(samples.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(4 * count, unknowns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(4 * count);
  for (Index i = 0; i < count; ++i) {
    const SideSample& sample = samples[i];
    const Vector3d& normal = i == 0 ? corner_normals[0] : i + 1 == count ? corner_normals[1] : sample.normal;
    const Eigen::VectorXd basis = basisAt(degree, sample.t);
    for (int c = 0; c < 3; ++c) {
      for (int j = 0; j <= degree; ++j) {
        matrix(4 * i, 3 * j + c) = weight_of_normal_part * basis(j) * normal(c);
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

/// One side while it is fitted.
class SideFit {
 public:
  SideFit(const HoleSide& side, const SideFitOptions& options)
      : path_(side, options.gap_mm),
        options_(options),
        speed_(path_.isOneEdge() ? Speed::Own : Speed::Even) {}

  SideSample end(bool last) const { return path_.at(last ? 1 : 0, speed_); }

  void fitEdge(const std::array<Vector3d, 2>& ends) {
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
    for (int degree = 2; degree <= options_.most_degree; ++degree) {
      const Poles cross = fittedCross(samples_, corner_normals, path_.length_mm(), degree);
      const double angle = angleOf(cross);
      if (fitted.side.cross && !(angle < fitted.angle_rad)) continue;
      fitted.side.cross = cross;
      fitted.angle_rad = angle;
      if (angle <= options_.angle_rad) break;
    }
    return fitted;
  }

 private:
  /// What is reached over what is asked for.
  double miss() const { return std::max(gap_mm_ / options_.gap_mm, tilt_rad_ / options_.angle_rad); }
  bool isNear() const { return miss() <= 1; }

  void fitEdgeAt(Speed speed, const std::array<Vector3d, 2>& ends) {
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

  double angleOf(const Poles& cross) const {
    const BezierCurve field(cross);
    double angle = 0;
    for (const SideSample& check : checks_) {
      const Vector3d normal = field.point(check.t).cross(edge_.jet(check.t).d1).normalized();
      angle =
          std::max(angle, std::atan2(normal.cross(check.normal).norm(), std::abs(normal.dot(check.normal))));
    }
    return angle;
  }

  SidePath path_;
  SideFitOptions options_;
  Speed speed_;
  std::vector<SideSample> samples_, checks_;
  BezierCurve edge_{Poles(Poles::Zero(1, 3))};
  double gap_mm_ = 0, tilt_rad_ = 0;
};

}  // namespace

std::vector<FittedSide> fitSides(const std::vector<HoleSide>& sides, const SideFitOptions& options) {
  const std::size_t n = sides.size();
  std::vector<SideFit> fits;
  for (const HoleSide& side : sides) fits.emplace_back(side, options);
  std::vector<Vector3d> places(n), normals(n);  // of corner k, where side k begins
  for (std::size_t k = 0; k < n; ++k)
    places[k] = (fits[(k + n - 1) % n].end(true).point + fits[k].end(false).point) / 2;
  for (std::size_t k = 0; k < n; ++k) fits[k].fitEdge({places[k], places[(k + 1) % n]});
  for (std::size_t k = 0; k < n; ++k) {
    const Vector3d in = fits[(k + n - 1) % n].edge().jet(1).d1, out = fits[k].edge().jet(0).d1;
    normals[k] = in.normalized().cross(out.normalized()).normalized();
  }
  std::vector<FittedSide> fitted;
  for (std::size_t k = 0; k < n; ++k) fitted.push_back(fits[k].finished({normals[k], normals[(k + 1) % n]}));
  return fitted;
}

}  // namespace seamwright::occ
