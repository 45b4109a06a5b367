// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/repair/fair_move.hpp>

namespace seamwright::occ {

namespace {

bool asksForCurvature(const FaceTask& task) {
  return std::ranges::any_of(task.paths, [](const FollowPath& path) { return path.order > 1; });
}

/// The original, but poles that stay as they are by now.
PointRows startOf(const MovingSurface& surface, const MoveNumbers& numbers) {
  PointRows start = surface.poles();
  for (int pole = 0; pole < start.rows(); ++pole)
    if (numbers.of_pole[pole] >= 0) start.row(pole) = surface.original().row(pole);
  return start;
}

}  // namespace

FairMove::FairMove(const FaceTask& task, const TaskPlaces& places, const MovingSurface& surface)
    : task_(task),
      places_(places),
      surface_(surface),
      numbers_(surface.numbers()),
      depends_on_move_(asksForCurvature(task) || surface.isCollapsed()),
      start_(startOf(surface, numbers_)),
      conditions_(numbers_.of_pole, numbers_.count, surface.original(), start_) {
  for (const PathPlaces& path : places.paths)
    for (const Place& place : path.samples) addPlace(place);
  addFairness();
}

void FairMove::addPlace(const Place& place) {
  const ContinuityTolerance& tolerance = task_.tolerance;
  const TargetPoint& target = place.target;
  const PoleShares& shares = place.shares;
  if (!conditions_.canChange(shares.poles)) return;
  conditions_.addPoint(shares.poles, shares.share.row(0), target.point, 1 / (task_.share * tolerance.gap_mm));
  if (place.order < 1) return;
  // Else the point is met more closely than the turn asks for.
  if (place.turn.norm() * tolerance.gap_mm > tolerance.angle_rad)
    conditions_.add(shares.poles, shares.share.row(0), place.turn,
                    Eigen::VectorXd::Constant(1, place.turn.dot(target.point)),
                    1 / (task_.share * tolerance.angle_rad));
  const SurfaceJet jet = firstOrderJetOf(shares, depends_on_move_ ? surface_.poles() : surface_.original());
  const auto normal = unitNormal(jet, noiseOf(jet, surface_.basis()));
  if (!normal) return;
  Eigen::Vector3d tangent = place.along[0] * jet.u + place.along[1] * jet.v;
  if (tangent.norm() == 0) tangent = jet.u;
  tangent.normalize();
  const std::array<Eigen::Vector3d, 2> ways = {tangent, normal->cross(tangent)};
  const std::array<Eigen::Vector2d, 2> steps = {parameterStep(jet, ways[0]), parameterStep(jet, ways[1])};
  Eigen::MatrixXd slopes(2, shares.share.cols());
  slopes << derivative(shares, steps[0]), derivative(shares, steps[1]);
  conditions_.add(shares.poles, slopes, target.normal, Eigen::Vector2d::Zero(),
                  1 / (task_.share * tolerance.angle_rad));
  if (place.order < 2) return;
  Eigen::MatrixXd bends(3, shares.share.cols());
  bends << secondDerivative(shares, steps[0], steps[0]), secondDerivative(shares, steps[0], steps[1]),
      secondDerivative(shares, steps[1], steps[1]);
  const auto bend = [&](int k, int m) { return ways[k].dot(target.curvature * ways[m]); };
  conditions_.add(shares.poles, bends, target.normal, Eigen::Vector3d(bend(0, 0), bend(0, 1), bend(1, 1)),
                  1 / (task_.share * curvatureLimit(target)));
}

void FairMove::addFairness() {
  const SurfaceBasis& basis = surface_.basis();
  const auto bending = [](double spacing, double mean) {
    return std::clamp(std::pow(mean / spacing, 1.5), 1e-2, 1e3);
  };
  for (const SecondDifference& difference : secondDifferences(basis.u()))
    for (int j = 0; j < basis.v().poles; ++j)
      conditions_.addFairness({basis.pole(difference.functions[0], j), basis.pole(difference.functions[1], j),
                               basis.pole(difference.functions[2], j)},
                              difference.factors, bending(difference.spacing, surface_.givenSpacing()[0]));
  for (const SecondDifference& difference : secondDifferences(basis.v()))
    for (int i = 0; i < basis.u().poles; ++i)
      conditions_.addFairness({basis.pole(i, difference.functions[0]), basis.pole(i, difference.functions[1]),
                               basis.pole(i, difference.functions[2])},
                              difference.factors, bending(difference.spacing, surface_.givenSpacing()[1]));
}

/// Curvature that counts as none beside the target.
double FairMove::curvatureLimit(const TargetPoint& target) const {
  const double norm = target.curvature.norm(), flat = 1 / task_.tolerance.flat_radius_mm;
  return norm < flat ? flat : task_.tolerance.curvature_rel * norm;
}

/// Of a move of one millimetre: so little that the rows are met to the square of the fairness times it.
double FairMove::fairnessWeight(double fairness) const {
  double softest = task_.tolerance.gap_mm;
  for (std::size_t i = 0; i < task_.paths.size(); ++i) {
    if (task_.paths[i].order > 0) softest = std::max(softest, task_.tolerance.angle_rad * places_.span_mm);
    if (task_.paths[i].order < 2) continue;
    double limit = 0;
    for (const Place& place : places_.paths[i].samples) limit = std::max(limit, curvatureLimit(place.target));
    softest = std::max(softest, limit * places_.span_mm * places_.span_mm);
  }
  return fairness / (task_.share * softest);
}

std::optional<PointRows> FairMove::poles(double fairness) const {
  // Beyond, the conditions contradict one another or the passes diverge.
  constexpr double largest_sense = 0.05;
  const PointRows& original = surface_.original();
  const double extent = (original.colwise().maxCoeff() - original.colwise().minCoeff()).norm();
  const double weight = fairnessWeight(fairness);
  const PointRows moves = conditions_.solve(weight, weight);
  if (moves.rows() > 0 && (!moves.allFinite() || moves.cwiseAbs().maxCoeff() > largest_sense * extent))
    return std::nullopt;
  PointRows moved = start_;
  for (int pole = 0; pole < moved.rows(); ++pole)
    if (const int number = numbers_.of_pole[pole]; number >= 0) moved.row(pole) += moves.row(number);
  return moved;
}

}  // namespace seamwright::occ
