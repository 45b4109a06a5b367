// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/match/follow.hpp>
#include <seamwright/occ_adapter/repair/task_places.hpp>

namespace seamwright::occ {

namespace {

/// Even, but twice as dense near the ends, where a clamped spline has more poles.
std::vector<double> sampleShares(int count, int dense) {
  std::vector<double> shares;
  for (int k = 0; k <= count; ++k) {
    shares.push_back(static_cast<double>(k) / count);
    if (k < count && (k < dense || count - 1 - k < dense)) shares.push_back((k + 0.5) / count);
  }
  return shares;
}

/// From one target to another: in their direction, by what angle the normal turns over a length, 1 / mm.
Eigen::Vector3d turnBetween(const TargetPoint& from, const TargetPoint& to) {
  const Eigen::Vector3d way = to.point - from.point;
  const double length = way.norm();
  const double turn = from.normal.isZero() || to.normal.isZero() ? 0 : (to.normal - from.normal).norm();
  return length > 0 ? Eigen::Vector3d(turn / (length * length) * way) : Eigen::Vector3d::Zero();
}

/// The angle that is not seen because the point is elsewhere along the path than its target. Who sets the two sides against one another by
/// their nearest points, as readers of STEP do, finds it.
double slidAngle(const Place& place, const Eigen::Vector3d& point) {
  return std::abs(place.turn.dot(point - place.target.point));
}

}  // namespace

TaskPlaces::TaskPlaces(const FaceTask& task, const MovingSurface& surface) {
  constexpr int per_pole = 3;
  const SurfaceBasis& basis = surface.basis();
  const Eigen::Vector2d poles(std::max(1.0, polesPerSpan(basis.u())), std::max(1.0, polesPerSpan(basis.v())));
  const int degree = std::max(basis.u().degree, basis.v().degree);
  double length = 0, spans = 0;
  const bool asks_for_curvature =
      std::ranges::any_of(task.paths, [](const FollowPath& path) { return path.order > 1; });
  for (const FollowPath& path : task.paths) {
    const PlanePath plane(path);
    const SpanMeasure measure(plane, basis, surface.before(), poles);
    const std::vector<double> shares =
        sampleShares(static_cast<int>(std::ceil(per_pole * measure.crossed() - 1e-6)) + degree, per_pole);
    // Curvature varies most.
    const int between = path.order > 1 ? 4 : 2;
    PathPlaces& places = paths.emplace_back();
    for (const double share : shares) places.samples.push_back(plane.place(basis, measure.at(share)));
    const auto turn = [&](std::size_t from, std::size_t to) -> Eigen::Vector3d {
      if (asks_for_curvature) return Eigen::Vector3d::Zero();
      return turnBetween(places.samples[from].target, places.samples[to].target);
    };
    const std::size_t last = shares.size() - 1;
    for (std::size_t k = 0; k <= last; ++k)
      places.samples[k].turn = turn(k == 0 ? 0 : k - 1, std::min(k + 1, last));
    for (std::size_t k = 1; k <= last; ++k) {
      for (int m = 1; m <= between; ++m) {
        places.checks.push_back(
            plane.place(basis, measure.at(shares[k] - m * (shares[k] - shares[k - 1]) / (between + 1))));
        places.checks.back().turn = turn(k - 1, k);
      }
      length += (places.samples[k].target.point - places.samples[k - 1].target.point).norm();
    }
    spans += measure.spans();
  }
  span_mm = spans > 0 ? length / spans : 0;
}

PairMeasure measureAt(const Place& place, const MovingSurface& surface) {
  SidePoint own;
  const bool has_second = place.shares.share.rows() > 3;
  own.jet =
      has_second ? jetOf(place.shares, surface.poles()) : firstOrderJetOf(place.shares, surface.poles());
  own.noise = noiseOf(own.jet, surface.basis());
  PairMeasure pair = measurePair(sideOf(place.target), own);
  if (pair.angle_rad) *pair.angle_rad += slidAngle(place, own.jet.p);
  return pair;
}

double ratioAt(const Place& place, const MovingSurface& surface, const ContinuityTolerance& tolerance) {
  const SurfaceJet jet = firstOrderJetOf(place.shares, surface.poles());
  const bool is_turned = place.order > 0 && place.target.normal.dot(jet.u.cross(jet.v)) < 0;
  if (place.order > 1) {
    const PairMeasure pair = measureAt(place, surface);
    return is_turned && pair.angle_rad ? std::numeric_limits<double>::infinity()
                                       : ratioOf(pair, place.order, tolerance);
  }
  PairMeasure pair;
  if (const double gap = (jet.p - place.target.point).norm(); std::isfinite(gap)) pair.gap_mm = gap;
  if (place.order > 0)
    if (const auto normal = unitNormal(jet, noiseOf(jet, surface.basis()))) {
      if (is_turned) return std::numeric_limits<double>::infinity();
      pair.angle_rad =
          std::atan2(normal->cross(place.target.normal).norm(), normal->dot(place.target.normal)) +
          slidAngle(place, jet.p);
    }
  return ratioOf(pair, place.order, tolerance);
}

Misses::Misses(const FaceTask& task, const TaskPlaces& places, const MovingSurface& surface)
    : ratios_(places.paths.size(), 0), worst_(places.paths.size(), nullptr) {
  for (std::size_t i = 0; i < ratios_.size(); ++i) take(task, places.paths[i].samples, surface, i);
  at_samples_ = largest();
}

void Misses::look(const FaceTask& task, const TaskPlaces& places, const MovingSurface& surface) {
  for (std::size_t i = 0; i < ratios_.size(); ++i) take(task, places.paths[i].checks, surface, i);
}

void Misses::take(const FaceTask& task, const std::vector<Place>& places, const MovingSurface& surface,
                  std::size_t path) {
  for (const Place& place : places) {
    const double ratio = ratioAt(place, surface, task.tolerance);
    if (ratio > task.share) missed_.push_back(&place);
    if (ratio <= ratios_[path]) continue;
    ratios_[path] = ratio;
    worst_[path] = &place;
  }
}

double Misses::largest() const {
  return ratios_.empty() ? 0 : std::ranges::max(ratios_);
}

}  // namespace seamwright::occ
