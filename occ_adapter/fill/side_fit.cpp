// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
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

/// The parametrisation of an interval:
/// - Own: that of its edge.
/// - ArcLength.
/// - Centripetal: between arc length and the centripetal one, in which each edge has the square
///   root of its length. Short edges get more of the freedom of a polynomial.
/// - AffineArcLength: nearly affine arc length, in which ellipses and parabolas have their standard
///   parametrisation.
enum class Parametrisation { Own, ArcLength, Centripetal, AffineArcLength };

/// The share of an interval as a function of t, with dt / ds proportional to the cube root of the
/// geodesic curvature. Geodesic curvature is smooth where the path passes from one surface to
/// another that is tangent to it. Straight parts get a small least rate.
class AffineArcLengthShare {
 public:
  /// \param at the path at shares of the interval. Its normals may change sign between edges, as
  /// the orientation of faces may.
  explicit AffineArcLengthShare(const std::function<SideSample(double)>& at) {
    std::vector<SideSample> samples;
    for (int k = 0; k <= 2 * pieces; ++k) samples.push_back(at(k / (2.0 * pieces)));
    std::vector<double> bending(samples.size());  // turning per interval
    for (std::size_t k = 1; k + 1 < samples.size(); ++k)
      bending[k] =
          pieces * (samples[k + 1].derivative.normalized() - samples[k - 1].derivative.normalized())
                       .dot(samples[k].beyond);
    bending.front() = 2 * bending[1] - bending[2];
    bending.back() = 2 * bending[2 * pieces - 1] - bending[2 * pieces - 2];
    double mean = 0;
    for (const double one : bending) mean += std::abs(one) / static_cast<double>(bending.size());
    const double least = straight_rad + straight_share * mean;
    const auto rate = [&](int k) { return std::cbrt(std::hypot(bending[k], least)); };
    for (int k = 0; k <= pieces; ++k) rate_[k] = rate(2 * k);
    for (int k = 0; k < pieces; ++k)
      come_[k + 1] =
          come_[k] + (rate(2 * k) + 4 * rate(2 * k + 1) + rate(2 * k + 2)) / (6 * pieces);
  }

  /// The share at t and its derivative.
  std::array<double, 2> at(double t) const {
    const double come = t * come_[pieces];
    const auto after = std::upper_bound(come_.begin() + 1, come_.end() - 1, come);
    const int k = static_cast<int>(after - come_.begin()) - 1;
    double x = (come - come_[k]) / (come_[k + 1] - come_[k]);
    for (int step = 0; step < 4; ++step) x -= (within(k, x)[0] - come) / within(k, x)[1];
    return {(k + x) / pieces, come_[pieces] / (pieces * within(k, x)[1])};
  }

 private:
  static constexpr int pieces = 128;
  /// Least turning per interval: an absolute part and a share of the mean turning.
  static constexpr double straight_rad = 0.02, straight_share = 0.03;

  /// The cubic Hermite interpolant on a piece, and its derivative by x.
  std::array<double, 2> within(int k, double x) const {
    const double rise = come_[k + 1] - come_[k], a = rate_[k] / pieces, b = rate_[k + 1] / pieces;
    const double square = 3 * rise - 2 * a - b, cube = a + b - 2 * rise;
    return {come_[k] + x * (a + x * (square + x * cube)), a + x * (2 * square + 3 * x * cube)};
  }

  std::array<double, pieces + 1> rate_{}, come_{};
};

/// An interval of a side over t in [0, 1].
class IntervalPath {
 public:
  IntervalPath(std::shared_ptr<const SidePath> path, const SideInterval& interval)
      : path_(std::move(path)), interval_(interval), slope_(centripetalSlope()) {}

  bool isOneEdge() const { return path_->isOneEdge(); }
  double length_mm() const { return (interval_.end - interval_.begin) * path_->length_mm(); }

  SideSample at(double t, Parametrisation parametrisation) const {
    if (parametrisation == Parametrisation::Own) {
      const double first = path_->placeOf(interval_.begin),
                   range = placeAround(interval_.end) - first;
      const double place = first + t * range;
      return placed(path_->atPlace(place > 1 ? place - 1 : place), t, range);
    }
    if (parametrisation == Parametrisation::AffineArcLength) {
      const auto [share, rate] = affineShare().at(t);
      return placed(atShare(t == 1 ? 1 : share), t, rate * range());
    }
    const double slope = parametrisation == Parametrisation::ArcLength ? 1 : slope_;
    return placed(atShare(t == 1 ? 1 : t * (slope + (1 - slope) * t)), t,
                  (slope + 2 * (1 - slope) * t) * range());
  }

 private:
  double range() const { return interval_.end - interval_.begin; }

  /// The sample at a share of the interval.
  SideSample atShare(double part) const {
    const double share = part == 1 ? interval_.end : interval_.begin + part * range();
    return share > 1 ? path_->atShare(share - 1, part < 1) : path_->atShare(share, part < 1);
  }

  double placeAround(double share) const {
    return share > 1 ? 1 + path_->placeOf(share - 1) : path_->placeOf(share);
  }

  const AffineArcLengthShare& affineShare() const {
    if (!affine_)
      affine_ = std::make_shared<const AffineArcLengthShare>(
          [this](double part) { return atShare(part); });
    return *affine_;
  }

  static SideSample placed(SideSample sample, double t, double range) {
    sample.t = t;
    sample.derivative *= range;
    return sample;
  }

  /// The slope at 0 of the parabola from (0, 0) to (1, 1) that best fits the centripetal parameters
  /// of the joints.
  double centripetalSlope() const {
    constexpr double least = 0.25;
    std::vector<double> ends;
    for (const double joint : path_->joints())
      for (const double share : {joint, joint + 1})
        if (share > interval_.begin && share < interval_.end)
          ends.push_back((share - interval_.begin) / range());
    ends.push_back(1);
    std::ranges::sort(ends);
    std::vector<double> roots;
    for (std::size_t k = 0; k < ends.size(); ++k)
      roots.push_back((k == 0 ? 0 : roots.back()) +
                      std::sqrt(ends[k] - (k == 0 ? 0 : ends[k - 1])));
    double product = 0, square = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const double t = roots[k] / roots.back(), bulge = t - t * t;
      product += (ends[k] - t * t) * bulge;
      square += bulge * bulge;
    }
    return square > 0 ? std::clamp(product / square, least, 2 - least) : 1;
  }

  std::shared_ptr<const SidePath> path_;
  SideInterval interval_;
  double slope_;  ///< slope of Parametrisation::Centripetal at the begin of the interval
  mutable std::shared_ptr<const AffineArcLengthShare> affine_;  ///< computed when needed
};

std::vector<SideSample> samplesOf(const IntervalPath& path, Parametrisation parametrisation,
                                  int count) {
  std::vector<SideSample> samples;
  for (int i = 0; i <= count; ++i)
    samples.push_back(path.at((1 - std::cos(std::numbers::pi * i / count)) / 2, parametrisation));
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

/// Angle between planes with these unit normals.
double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

/// The begin or end of a side, shared with the next side.
struct SideFitEnd {
  Vector3d point;
  std::optional<Vector3d> direction;  ///< unit; nothing: the side's own direction
  double speed_mm = 0;                ///< mean speed of both sides; 0: the side's own speed
};

/// The derivative of a side at its end. Nearly equal speeds of both sides are made equal, because
/// the equations of a ring are ill-conditioned if they differ slightly.
Vector3d derivativeAt(const SideFitEnd& end, const SideSample& sample) {
  constexpr double nearly = 1e-5;
  if (!end.direction) return sample.derivative;
  const double own_mm = sample.derivative.norm();
  return (std::abs(own_mm - end.speed_mm) <= nearly * own_mm ? end.speed_mm : own_mm) *
         *end.direction;
}

/// The end of one side and the begin of the next, in one tangent plane.
struct FitCorner {
  SideFitEnd end, begin;
  Vector3d normal;
};

/// The normal of the face, oriented so that the hole is to the left of the side as seen from above.
Vector3d upward(const SideSample& sample) {
  return sample.beyond.cross(sample.derivative).normalized();
}

/// A corner at which both sides have one direction.
FitCorner smoothCorner(const SideSample& in, const SideSample& out) {
  const Vector3d along = (in.derivative.normalized() + out.derivative.normalized()).normalized();
  const double speed_mm = (in.derivative.norm() + out.derivative.norm()) / 2;
  const SideFitEnd end{(in.point + out.point) / 2, along, speed_mm};
  return {end, end, (in.beyond + out.beyond).cross(along).normalized()};
}

/// A corner with an angle. Its plane is halfway between those of both faces if each side can be
/// turned into it by at most \p most_turn_rad. Otherwise the directions of the sides span it.
FitCorner sharpCorner(const SideSample& in, const SideSample& out,
                      const std::array<double, 2>& most_turn_rad) {
  const SideFitEnd own{(in.point + out.point) / 2, std::nullopt, 0};
  const Vector3d mean = (upward(in) + upward(out)).normalized();
  if (angleToPlane(in.derivative, mean) > most_turn_rad[0] ||
      angleToPlane(out.derivative, mean) > most_turn_rad[1])
    return {own, own, in.derivative.cross(out.derivative).normalized()};
  const auto turned = [&](const SideSample& sample) {
    return SideFitEnd{own.point,
                      (sample.derivative - sample.derivative.dot(mean) * mean).normalized(), 0};
  };
  return {turned(in), turned(out), mean};
}

/// Fits the edge by least squares with fixed ends and end derivatives.
BezierCurve fittedEdge(const std::vector<SideSample>& samples,
                       const std::array<SideFitEnd, 2>& ends, int degree) {
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

/// The T that minimises the sum of (T - L beyond)^2 plus the weighted squares of its normal parts.
/// The normal parts at the ends are zero.
Poles fittedCross(const std::vector<SideSample>& samples,
                  const std::array<Vector3d, 2>& corner_normals, double length_mm, int degree,
                  const Eigen::VectorXd& weights) {
  // Large enough that the normal parts at the ends vanish.
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
        matrix(4 * i, 3 * j + c) = (is_end ? weight_at_ends : weights(i)) * basis(j) * normal(c);
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

/// II(T, T) of the face, for T in its tangent plane.
double bendAlong(const SideSample& sample, const Vector3d& direction) {
  Eigen::Matrix<double, 3, 2> plane;
  plane << sample.jet.u, sample.jet.v;
  const Eigen::Vector2d c = plane.colPivHouseholderQr().solve(direction);
  return sample.normal.dot(c(0) * c(0) * sample.jet.uu + 2 * c(0) * c(1) * sample.jet.uv +
                           c(1) * c(1) * sample.jet.vv);
}

/// The polynomial nearest to II(T, T) N. This product does not depend on the orientation of the
/// face.
Poles fittedBend(const std::vector<SideSample>& samples, const Eigen::VectorXd& wanted,
                 int degree) {
  const Index count = static_cast<Index>(samples.size());
  Eigen::MatrixXd matrix(count, degree + 1), right(count, 3);
  for (Index i = 0; i < count; ++i) {
    matrix.row(i) = basisAt(degree, samples[i].t).transpose();
    right.row(i) = wanted(i) * samples[i].normal.transpose();
  }
  return linear::PivotedQr(matrix).solve(right);
}

/// Fits one side.
class SideFit {
 public:
  SideFit(std::shared_ptr<const SidePath> path, const SideInterval& interval,
          const SideFitOptions& options)
      : path_(std::move(path), interval), options_(options) {}

  SideSample end(bool last) const { return path_.at(last ? 1 : 0, parametrisations()[0]); }

  /// The largest turn of an end. A turn by θ moves a cubic edge of length L by at most 4 θ L / 27
  /// (docs/theory/repair.md R1). The move may be five times the gap of the fit, which is itself a
  /// small share of the tolerance.
  double mostTurn_rad() const {
    constexpr double gap_of_turn = 4.0 / 27, share = 5;
    return share * options_.gap_mm / (gap_of_turn * path_.length_mm());
  }

  /// The fit in the first parametrisation that is near enough, or else in the one that comes
  /// nearest.
  FittedSide fitted(const FitCorner& begin, const FitCorner& end) {
    corner_rad_ = {angleBetween(begin.normal, this->end(false).normal),
                   angleBetween(end.normal, this->end(true).normal)};
    enough_rad_ = std::max(options_.angle_rad, rounding * std::ranges::max(corner_rad_));
    const std::array<SideFitEnd, 2> ends = {begin.begin, end.end};
    const std::array<Vector3d, 2> normals = {begin.normal, end.normal};
    std::optional<FittedSide> best;
    std::vector<EdgeFit> edges;
    const auto all = parametrisations();
    for (const Parametrisation parametrisation : all) {
      edges.push_back(nearestEdge(parametrisation, ends));
      if (edges.back().miss > 1 && parametrisation != all.back()) continue;
      std::ranges::stable_sort(edges, {}, &EdgeFit::miss);
      for (const EdgeFit& edge : edges) {
        if (best && edge.miss >= missOf(*best)) continue;
        FittedSide side = sideOf(edge, normals);
        if (!best || missOf(side) < missOf(*best)) best = std::move(side);
      }
      if (missOf(*best) <= 1) break;
      edges.clear();
    }
    return std::move(*best);
  }

 private:
  static constexpr double rounding = 1.01;

  struct Samples {
    std::vector<SideSample> checked, fitted;  ///< every fourth checked sample is fitted
  };

  struct EdgeFit {
    std::shared_ptr<const Samples> samples;
    BezierCurve edge{Poles(Poles::Zero(1, 3))};
    std::vector<Vector3d> directions;  ///< directions at the checked samples
    double gap_mm = 0, tilt_rad = 0;
    double miss = HUGE_VAL;  ///< error over accepted error
  };

  std::array<Parametrisation, 3> parametrisations() const {
    return path_.isOneEdge() ? std::array{Parametrisation::Own, Parametrisation::ArcLength,
                                          Parametrisation::AffineArcLength}
                             : std::array{Parametrisation::ArcLength, Parametrisation::Centripetal,
                                          Parametrisation::AffineArcLength};
  }

  std::shared_ptr<const Samples> samplesAt(Parametrisation parametrisation) const {
    constexpr int finer = 4;
    const auto samples = std::make_shared<Samples>();
    samples->checked = samplesOf(path_, parametrisation, finer * 6 * options_.most_degree);
    for (std::size_t i = 0; i < samples->checked.size(); i += finer)
      samples->fitted.push_back(samples->checked[i]);
    for (const SideSample* sample : {&samples->fitted.front(), &samples->fitted.back()})
      if (!(sample->derivative.norm() > 1e-9 * path_.length_mm()))
        throw std::runtime_error("an edge has no tangent where it ends");
    return samples;
  }

  FittedSide sideOf(const EdgeFit& edge, const std::array<Vector3d, 2>& corner_normals) const {
    FittedSide side{{edge.edge, std::nullopt}, edge.gap_mm, 0, corner_rad_};
    if (std::ranges::max(corner_rad_) > options_.planar_rad) return side;
    fitCross(edge, corner_normals, side);
    if (options_.curvature) fitBend(*edge.samples, side);
    return side;
  }

  double missOf(const FittedSide& side) const {
    return std::max(side.gap_mm / options_.gap_mm, side.angle_rad / enough_rad_);
  }

  /// The fit of the lowest degree that is near enough, or that higher degrees hardly improve. Ends
  /// may lie a little off the path because neighbours share them. A higher degree corrects this
  /// offset on a shorter interval, and so tilts the edge more.
  EdgeFit nearestEdge(Parametrisation parametrisation,
                      const std::array<SideFitEnd, 2>& ends) const {
    // A higher degree counts as better if it reduces the error by a tenth.
    constexpr double nearer = 0.9;
    constexpr int patience = 2;  // symmetric paths improve only with every second degree
    const std::shared_ptr<const Samples> samples = samplesAt(parametrisation);
    EdgeFit best;
    for (int degree = 3; degree <= options_.most_degree; ++degree) {
      EdgeFit tried = measured(samples, fittedEdge(samples->fitted, ends, degree));
      if (tried.miss < nearer * best.miss) best = std::move(tried);
      if (best.miss <= 1 || degree - best.edge.degree() >= patience) break;
    }
    return best;
  }

  EdgeFit measured(std::shared_ptr<const Samples> samples, BezierCurve edge) const {
    EdgeFit fit;
    fit.samples = std::move(samples), fit.edge = std::move(edge);
    for (const SideSample& check : fit.samples->checked) {
      const CurveJet jet = fit.edge.jet(check.t);
      fit.gap_mm = std::max(fit.gap_mm, (jet.p - check.point).norm());
      fit.directions.push_back(jet.d1.normalized());
      fit.tilt_rad = std::max(fit.tilt_rad, angleToPlane(jet.d1, check.normal));
    }
    fit.miss = std::max(fit.gap_mm / options_.gap_mm, fit.tilt_rad / enough_rad_);
    return fit;
  }

  /// Fits the cross-boundary derivatives. A field that is nearly zero somewhere, compared with its
  /// largest value, may have the right planes but makes folds. So the evenness decides too.
  void fitCross(const EdgeFit& edge, const std::array<Vector3d, 2>& corner_normals,
                FittedSide& side) const {
    // Smaller weights trade angle for evenness, so large ones are tried first.
    constexpr std::array<double, 4> weights_of_normal_part = {1e6, 1e5, 1e4, 1e3};
    const double enough_rad = std::max(enough_rad_, rounding * edge.tilt_rad);
    const std::vector<SideSample>& samples = edge.samples->fitted;
    std::optional<CrossForm> best;
    const auto isEnough = [&](const Poles& cross, const CrossForm& form) {
      if (best &&
          (form.isEven() != best->isEven() ? best->isEven() : !(form.angle_rad < best->angle_rad)))
        return false;
      best = form, side.side.cross = cross, side.angle_rad = form.angle_rad;
      return form.isEven() && form.angle_rad <= enough_rad;
    };
    for (int degree = 2; degree <= options_.most_degree; ++degree) {
      const auto crossBy = [&](const Eigen::VectorXd& weights) {
        return fittedCross(samples, corner_normals, path_.length_mm(), degree, weights);
      };
      for (const double weight : weights_of_normal_part) {
        Eigen::VectorXd weights =
            Eigen::VectorXd::Constant(static_cast<Index>(samples.size()), weight);
        const Poles cross = crossBy(weights);
        const CrossForm form = formOf(edge, cross);
        if (isEnough(cross, form)) return;
        if (weight > weights_of_normal_part.back() || !form.isEven()) continue;
        weights.array() *= unevenness(samples, cross).array();
        const Poles evened = crossBy(weights);
        if (isEnough(evened, formOf(edge, evened))) return;
      }
    }
  }

  /// Weights that reduce the largest angle, as in Lawson's algorithm: the square root of the angle
  /// to the face at each sample over the mean of all.
  static Eigen::VectorXd unevenness(const std::vector<SideSample>& samples, const Poles& cross) {
    constexpr double least = 0.1;
    const BezierCurve field(cross);
    Eigen::VectorXd angles(static_cast<Index>(samples.size()));
    for (Index i = 0; i < angles.size(); ++i)
      angles(i) = angleToPlane(field.point(samples[i].t), samples[i].normal);
    if (!(angles.maxCoeff() > 0)) return Eigen::VectorXd::Ones(angles.size());
    return (angles / angles.mean()).cwiseSqrt().cwiseMax(least);
  }

  struct CrossForm {
    double angle_rad = 0;
    /// Smallest component across the edge, out of the hole, over the largest one.
    double evenness = 0;

    bool isEven() const { return evenness >= 0.7; }
  };

  static CrossForm formOf(const EdgeFit& edge, const Poles& cross) {
    const BezierCurve field(cross);
    double angle = 0, least = HUGE_VAL, most = 0;
    for (std::size_t i = 0; i < edge.directions.size(); ++i) {
      const SideSample& check = edge.samples->checked[i];
      const Vector3d here = field.point(check.t), area = here.cross(edge.directions[i]);
      const double across = here.dot(check.beyond);
      angle = std::max(
          angle, std::atan2(area.cross(check.normal).norm(), std::abs(area.dot(check.normal))));
      least = std::min(least, across);
      most = std::max(most, across);
    }
    return {angle, least / most};
  }

  void fitBend(const Samples& samples, FittedSide& fitted) const {
    constexpr double near_enough =
        1e-3;  // share of the largest curvature, or of the reciprocal length
    const BezierCurve cross(*fitted.side.cross);
    const auto bends = [&](const std::vector<SideSample>& at) {
      Eigen::VectorXd along(static_cast<Index>(at.size()));
      for (Index i = 0; i < along.size(); ++i) along(i) = bendAlong(at[i], cross.point(at[i].t));
      return along;
    };
    const Eigen::VectorXd wanted = bends(samples.fitted), checked = bends(samples.checked);
    Eigen::VectorXd squares(checked.size());
    for (Index i = 0; i < checked.size(); ++i)
      squares(i) = cross.point(samples.checked[i].t).squaredNorm();
    const double largest_per_mm =
        std::max(1 / path_.length_mm(), checked.cwiseQuotient(squares).cwiseAbs().maxCoeff());
    for (int degree = 0; degree <= options_.most_degree; ++degree) {
      const BezierCurve bend(fittedBend(samples.fitted, wanted, degree));
      double missed_per_mm = 0;
      for (Index i = 0; i < checked.size(); ++i)
        missed_per_mm = std::max(
            missed_per_mm,
            std::abs(samples.checked[i].normal.dot(bend.point(samples.checked[i].t)) - checked(i)) /
                squares(i));
      if (fitted.side.bend && !(missed_per_mm < fitted.curvature_per_mm)) continue;
      fitted.side.bend = bend.poles();
      fitted.curvature_per_mm = missed_per_mm;
      if (missed_per_mm <= near_enough * largest_per_mm) return;
    }
  }

  IntervalPath path_;
  SideFitOptions options_;
  std::array<double, 2> corner_rad_{};
  double enough_rad_ = 0;  ///< accepted angle, or the larger one that the corners allow
};

}  // namespace

std::vector<FittedSide> fitSides(const std::vector<HoleSide>& sides,
                                 const std::vector<SideInterval>& intervals,
                                 const SideFitOptions& options) {
  const std::size_t n = intervals.size();
  const auto before = [n](std::size_t k) { return (k + n - 1) % n; };
  const auto next = [n](std::size_t k) { return (k + 1) % n; };
  std::vector<std::shared_ptr<const SidePath>> paths;
  for (const HoleSide& side : sides)
    paths.push_back(std::make_shared<const SidePath>(side, options.gap_mm));
  std::vector<SideFit> fits;
  for (const SideInterval& interval : intervals)
    fits.emplace_back(paths.at(interval.side), interval, options);
  std::vector<FitCorner> corners;  // by side: the corner at its begin
  for (std::size_t k = 0; k < n; ++k) {
    const SideFit &in = fits[before(k)], &out = fits[k];
    corners.push_back(
        intervals[k].begins_smoothly
            ? smoothCorner(in.end(true), out.end(false))
            : sharpCorner(in.end(true), out.end(false), {in.mostTurn_rad(), out.mostTurn_rad()}));
  }
  std::vector<FittedSide> fitted;
  for (std::size_t k = 0; k < n; ++k)
    fitted.push_back(fits[k].fitted(corners[k], corners[next(k)]));
  return fitted;
}

}  // namespace seamwright::occ
