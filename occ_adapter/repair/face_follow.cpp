// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <sstream>

#include <seamwright/occ_adapter/repair/fair_move.hpp>
#include <seamwright/occ_adapter/repair/follow_reasons.hpp>

namespace seamwright::occ {

namespace {

using Surface = opencascade::handle<Geom_BSplineSurface>;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A surface on its way, and how far it misses its paths.
struct Stage {
  MovingSurface surface;
  std::shared_ptr<const TaskPlaces> places;
  Misses misses;
  std::size_t fairness = 0;  ///< the last one that was taken
  int refinements = 0;
};

/// The poles that have a part at places of the task.
std::vector<bool> polesBeside(const TaskPlaces& places, const MovingSurface& surface) {
  constexpr double least_share = 1e-9;
  constexpr std::array<int, 3> rows = {1, 3, 6};
  std::vector<bool> beside(static_cast<std::size_t>(surface.poles().rows()), false);
  for (const PathPlaces& path : places.paths)
    for (const std::vector<Place>* some : {&path.samples, &path.checks})
      for (const Place& place : *some)
        for (int row = 0; row < rows[std::clamp(place.order, 0, 2)]; ++row) {
          const auto share = place.shares.share.row(row);
          const double least = least_share * share.cwiseAbs().maxCoeff();
          for (int k = 0; k < share.size(); ++k)
            if (std::abs(share[k]) > least) beside[place.shares.poles[k]] = true;
        }
  return beside;
}

/// Middles of the knot spans that are to be halved.
std::array<std::set<double>, 2> middlesToInsert(const std::vector<const Place*>& missed,
                                                const SurfaceBasis& basis) {
  constexpr double lengthwise = 0.05, least = 1e-6;
  std::array<std::set<double>, 2> middles;
  const std::array<const SplineAxis*, 2> axes = {&basis.u(), &basis.v()};
  for (const Place* place : missed) {
    std::array<double, 2> crossing{};
    for (const int k : {0, 1}) crossing[k] = std::abs(place->along[k]) / spanLength(*axes[k], place->uv[k]);
    for (const int k : {0, 1}) {
      if (crossing[k] < lengthwise * crossing[1 - k]) continue;
      double t = place->uv[k];
      const int span = axes[k]->span(t, 0);
      if (axes[k]->length(span) > least * (axes[k]->last - axes[k]->first))
        middles[k].insert(axes[k]->middle(span));
    }
  }
  return middles;
}

/// Moves poles as fairly as can be, and refines where that does not do.
class FaceFollower {
 public:
  explicit FaceFollower(const FaceTask& task)
      : task_(task), now_(stageOf(MovingSurface(task.surface, task.tolerance.gap_mm / 100))) {
    for (const FollowPath& path : task.paths) order_ = std::max(order_, path.order);
  }

  FaceFollow run() {
    constexpr double within_reach = 5;
    look();
    given_ = now_.misses.atSamples();
    if (isMet()) return result(Surface::DownCast(task_.surface->Copy()));
    if (std::optional<FaceFollow> refused = refusal()) return std::move(*refused);
    // So that a knot inserted is no crease.
    if (now_.surface.raiseDegrees(order_ + 1)) now_ = stageOf(now_.surface);
    now_.surface.touch(polesBeside(*now_.places, now_.surface));
    improve();
    if (now_.misses.largest() > 1 && now_.misses.largest() <= within_reach && was_held_back_) {
      gently_ = false;
      improve();
    }
    return result(now_.surface.moved());
  }

 private:
  Stage stageOf(MovingSurface surface) const {
    const auto places = std::make_shared<const TaskPlaces>(task_, surface);
    Misses misses(task_, *places, surface);
    return {std::move(surface), places, std::move(misses)};
  }

  void lookAtSamples() { now_.misses = Misses(task_, *now_.places, now_.surface); }
  void lookBetween() { now_.misses.look(task_, *now_.places, now_.surface); }
  void look() {
    lookAtSamples();
    lookBetween();
  }

  /// \pre looked at all places, or at a sample that is missed
  bool isMet() const { return now_.misses.largest() <= task_.share; }

  /// Of the tolerance: what is met to that is met no closer by less fair moves.
  double enough() const {
    const bool has_cost_much = now_.refinements > 0 && work_ >= task_.fair_work;
    return has_cost_much ? std::max(task_.share, task_.fair_share) : task_.share;
  }

  /// What is missed, over the tolerance, or the move over the one allowed.
  double excess(const Stage& stage) const {
    return std::max(stage.misses.largest(), stage.surface.largestMove_mm() / task_.max_move_mm);
  }

  FaceFollow result(const Surface& surface) const {
    FaceFollow result;
    result.surface = surface;
    result.largest_move_mm = now_.surface.largestMove_mm();
    result.refinements = now_.refinements;
    result.ratios = now_.misses.ratios();
    for (const double ratio : result.ratios) result.missed.push_back(ratio > 1);
    result.failure = whyCornersContradict(task_, *now_.places, now_.surface);
    if (result.failure.empty())
      result.failure = whyMissed(task_, now_.misses, now_.surface, now_.refinements);
    if (result.failure.empty() && result.largest_move_mm > 0) result.failure = whyFolded(now_.surface);
    return result;
  }

  /// Without a look at the poles: what a path asks for is beyond the moves allowed or turns the face over.
  std::optional<FaceFollow> refusal() const {
    FaceFollow refused;
    for (std::size_t i = 0; i < task_.paths.size(); ++i) {
      const std::string why = whyBeyondReach(task_, *now_.places, now_.surface, i);
      refused.missed.push_back(!why.empty());
      if (refused.failure.empty()) refused.failure = why;
    }
    if (refused.failure.empty()) return std::nullopt;
    refused.ratios = now_.misses.ratios();
    refused.surface = Surface::DownCast(task_.surface->Copy());
    return refused;
  }

  /// Moves and refines as long as that gains something; ends in the best that was found.
  void improve() {
    constexpr double better = 0.9;
    const int most_idle = gently_ ? 3 : 2;
    std::optional<Stage> best;
    if (!gently_) best = now_;
    for (int idle = 0;;) {
      moveFairly();
      if (isMet()) return;
      const double reached = excess(now_);
      const bool gained = !best || (reached < infinite && reached <= std::max(1.0, better * excess(*best)));
      idle = gained ? 0 : idle + 1;
      if (!best || reached < excess(*best)) best = now_;
      const int max_work = reached <= task_.fair_share ? task_.fair_work : task_.max_work;
      const bool may_refine =
          now_.refinements < task_.max_refinements && work_ < max_work && canBeGained(reached);
      if (idle == most_idle || !may_refine || !refine(idle == 0 || order_ < 2)) break;
    }
    now_ = std::move(*best);
  }

  /// By the refinements that are left: of curvature each leaves a quarter or so.
  bool canBeGained(double reached) const {
    constexpr int tells = 2;
    return order_ < 2 || now_.refinements < tells ||
           reached <= std::pow(4.0, task_.max_refinements - now_.refinements);
  }

  /// As fair as can be: less so only as long as the samples can't be met, and, if gently, as the move stays of its size. After a refinement
  /// from one step fairer than before. The first step is for curvature alone: beside its soft rows the others may well be met by fairer moves.
  /// Where a step makes the move much longer and gains little, knots are what is missing.
  void moveFairly() {
    constexpr double better = 0.5, of_its_size = 2;
    constexpr std::array<double, 5> fairnesses = {3, 0.1, 0.01, 1e-3, 1e-4};
    constexpr std::size_t for_curvature = 1;
    double before = infinite, limit = infinite;
    was_held_back_ = false;
    std::optional<FairMove> conditions;
    const std::size_t first =
        std::max<std::size_t>(order_ > 1 ? 0 : for_curvature, now_.fairness > 0 ? now_.fairness - 1 : 0);
    for (std::size_t k = first; k < fairnesses.size(); ++k) {
      const PointRows fairer = now_.surface.poles();
      const double shorter = now_.surface.largestMove_mm();
      move(fairnesses[k], conditions);
      const double longer = now_.surface.largestMove_mm();
      if (longer > limit) return holdBack(fairer);
      lookAtSamples();
      const double missed = now_.misses.atSamples();
      const bool gains_nothing = missed > better * before || missed == infinite;
      const bool grows = longer > of_its_size * std::max(shorter, task_.tolerance.gap_mm);
      const bool was_near = before <= std::max(1.0, better * given_);
      if (gently_ && gains_nothing && grows && was_near) return holdBack(fairer);
      now_.fairness = k;
      const bool is_last = missed <= task_.share / 2 ||
                           (gains_nothing && k > std::max(first, for_curvature)) ||
                           k + 1 == fairnesses.size();
      if (is_last || missed <= enough()) lookBetween();
      if (is_last || now_.misses.largest() <= enough()) return;
      before = missed;
      if (gently_ && (k >= for_curvature || missed <= 1) && limit == infinite)
        limit = of_its_size * std::max(longer, task_.tolerance.gap_mm);
    }
  }

  void holdBack(const PointRows& fairer) {
    now_.surface.setPoles(fairer);
    was_held_back_ = true;
    look();
  }

  /// Conditions of order 2 are linear about a surface that has to be found. \param conditions those of the fairness before, if they hold still.
  void move(double fairness, std::optional<FairMove>& conditions) {
    const int most_passes = order_ > 1 ? 4 : 1;
    for (int pass = 0; pass < most_passes; ++pass) {
      if (task_.is_cancelled && task_.is_cancelled()) throw Cancelled();
      if (!conditions || conditions->dependsOnMove()) conditions.emplace(task_, *now_.places, now_.surface);
      work_ += conditions->count();
      std::optional<PointRows> moved = conditions->poles(fairness);
      if (!moved) return;
      const double change_mm = (*moved - now_.surface.poles()).cwiseAbs().maxCoeff();
      now_.surface.setPoles(std::move(*moved));
      if (change_mm <= 1e-2 * task_.share * task_.tolerance.gap_mm) return;
    }
  }

  /// \param near_alone poles near what is missed; false: moving those alone gained nothing.
  bool refine(bool near_alone) {
    const std::vector<const Place*>& missed = now_.misses.missed();
    const SurfaceBasis& basis = now_.surface.basis();
    const std::array<std::set<double>, 2> middles = middlesToInsert(missed, basis);
    const auto total = (static_cast<double>(basis.u().poles) + static_cast<double>(middles[0].size())) *
                       (static_cast<double>(basis.v().poles) + static_cast<double>(middles[1].size()));
    if ((middles[0].empty() && middles[1].empty()) || total > task_.max_poles) return false;
    std::vector<Eigen::Vector2d> missed_at;
    for (const Place* place : missed) missed_at.push_back(place->uv);
    now_.surface.insert(middles, missed_at, near_alone);
    now_.places = std::make_shared<const TaskPlaces>(task_, now_.surface);
    ++now_.refinements;
    return true;
  }

  const FaceTask& task_;
  int order_ = 1;  ///< the highest of a path, at least 1
  bool gently_ = true;
  bool was_held_back_ = false;
  double given_ = 0;  ///< the largest ratio at samples of the surface given
  int work_ = 0;      ///< moves solved for so far
  Stage now_;
};

}  // namespace

SidePoint sideOf(const TargetPoint& target) {
  const Eigen::Vector3d x = target.normal.unitOrthogonal(), y = target.normal.cross(x);
  SidePoint side;
  side.jet.p = target.point;
  side.jet.u = x;
  side.jet.v = y;
  side.jet.uu = x.dot(target.curvature * x) * target.normal;
  side.jet.uv = x.dot(target.curvature * y) * target.normal;
  side.jet.vv = y.dot(target.curvature * y) * target.normal;
  return side;
}

std::string figuresText(const PairMeasure& pair, int order, const ContinuityTolerance& tolerance) {
  std::ostringstream text;
  text << pair.gap_mm.value_or(infinite) << " mm";
  if (order > 0 && pair.angle_rad) text << ", " << *pair.angle_rad * 180 / std::numbers::pi << " degrees";
  if (order > 1 && pair.curvature)
    text << ", " << 100 * relativeDifference(*pair.curvature, tolerance.flat_radius_mm) << " % of curvature";
  return text.str();
}

FaceFollow followPaths(const FaceTask& task) {
  return FaceFollower(task).run();
}

}  // namespace seamwright::occ
