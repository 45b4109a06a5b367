// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <Geom2dAdaptor_Curve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>

#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/match/follow.hpp>
#include <seamwright/occ_adapter/repair/move_conditions.hpp>
#include <seamwright/occ_adapter/repair/path_place.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;
using Surface = handle<Geom_BSplineSurface>;

constexpr double infinite = std::numeric_limits<double>::infinity();

Surface copyOf(const Surface& surface) {
  return Surface::DownCast(surface->Copy());
}

/// The worst place of a path.
struct Worst {
  double ratio = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  PairMeasure pair;
};

std::string at(const Eigen::Vector3d& point) {
  std::ostringstream text;
  text << "(" << point.x() << ", " << point.y() << ", " << point.z() << ")";
  return text.str();
}

/// Even, but twice as dense near the ends, where a clamped spline has more poles.
std::vector<double> sampleShares(int count, int dense) {
  std::vector<double> shares;
  for (int k = 0; k <= count; ++k) {
    shares.push_back(static_cast<double>(k) / count);
    if (k < count && (k < dense || count - 1 - k < dense)) shares.push_back((k + 0.5) / count);
  }
  return shares;
}

class FaceFollower {
 public:
  explicit FaceFollower(const FaceTask& task)
      : task_(&task),
        before_(copyOf(task.surface)),
        basis_(*before_),
        poles_(polesOf(*before_)),
        original_(poles_),
        spacing_u_(meanSpacing(basis_.u())),
        spacing_v_(meanSpacing(basis_.v())) {}

  FaceFollow run() {
    sample();
    judge();
    given_ = at_samples_;
    if (isMet()) return result(copyOf(task_->surface));
    if (refuse()) return result_;
    constexpr double within_reach = 5;
    raiseDegrees();
    markTouched();
    improve();
    if (worstRatio() > 1 && worstRatio() <= within_reach && was_held_back_) {
      gently_ = false;
      improve();
    }
    const Surface moved = copyOf(before_);
    setPoles(*moved, poles_);
    return result(moved);
  }

 private:
  FaceFollow result(const Surface& surface) {
    result_.surface = surface;
    result_.largest_move_mm = largestMove();
    result_.failure = whyNot();
    for (const double ratio : result_.ratios) result_.missed.push_back(ratio > 1);
    return result_;
  }

  /// Without a look at the poles: what a path asks for is beyond the moves allowed or turns the face over.
  bool refuse() {
    for (std::size_t i = 0; i < task_->paths.size(); ++i) {
      const std::string why = whyBeyondReach(i);
      result_.missed.push_back(!why.empty());
      if (result_.failure.empty()) result_.failure = why;
    }
    if (result_.failure.empty()) {
      result_.missed.clear();
      return false;
    }
    result_.surface = copyOf(task_->surface);
    return true;
  }

  std::string whyBeyondReach(std::size_t path) const {
    for (const std::vector<Place>* places : {&samples_[path], &checks_[path]})
      for (const Place& place : *places) {
        const SurfaceJet jet = jetOf(place.shares, original_);
        const double move_mm = (place.target.point - jet.p).norm();
        std::ostringstream text;
        if (move_mm > task_->max_move_mm + task_->tolerance.gap_mm)
          text << "path " << path + 1 << " asks for a move of " << move_mm << " mm at "
               << at(place.target.point) << ", more than " << task_->max_move_mm << " mm";
        else if (const auto normal = unitNormal(jet, noiseOf(jet, basis_));
                 place.order > 0 && normal &&
                 normal->dot(place.target.normal) < -std::sin(task_->tolerance.angle_rad))
          text << "path " << path + 1 << " is missed at " << at(place.target.point) << " by "
               << figuresText(measured(place), place.order, task_->tolerance)
               << ", with its normal turned over";
        if (!text.str().empty()) return text.str();
      }
    return {};
  }

  /// Moves and refines as long as that gains something; ends in the best that was found.
  void improve() {
    constexpr double better = 0.9;
    const int most_idle = gently_ ? 2 : 1;
    std::optional<FaceFollower> best;
    if (!gently_) best = *this;
    for (int idle = 0;;) {
      moveFairly();
      if (isMet()) return;
      const double now = excess();
      const bool gained = !best || (now < infinite && now <= std::max(1.0, better * best->excess()));
      idle = gained ? 0 : idle + 1;
      if (!best || now < best->excess()) best = *this;
      near_alone_ = idle == 0 || !isCurved();
      const bool may_refine = result_.refinements < task_->max_refinements && work_ < task_->max_work;
      if (idle == most_idle || !may_refine || !refine()) break;
    }
    const int work = work_;
    *this = *best;
    work_ = work;
  }

  /// What is missed, over the tolerance, or the move over the one allowed.
  double excess() const { return std::max(worstRatio(), largestMove() / task_->max_move_mm); }

  double worstRatio() const { return result_.ratios.empty() ? 0 : std::ranges::max(result_.ratios); }

  /// So that a knot inserted is no crease.
  void raiseDegrees() {
    int order = 1;
    for (const FollowPath& path : task_->paths) order = std::max(order, path.order);
    if (basis_.u().degree > order && basis_.v().degree > order) return;
    before_->IncreaseDegree(std::max(basis_.u().degree, order + 1), std::max(basis_.v().degree, order + 1));
    basis_ = SurfaceBasis(*before_);
    poles_ = original_ = polesOf(*before_);
    spacing_u_ = meanSpacing(basis_.u());
    spacing_v_ = meanSpacing(basis_.v());
    sample();
  }

  double largestMove() const { return (poles_ - original_).rowwise().norm().maxCoeff(); }

  void sample() {
    constexpr int per_pole = 3, between = 4;
    samples_.clear();
    checks_.clear();
    double length = 0, spans = 0;
    for (const FollowPath& path : task_->paths) {
      const PlanePath plane(path);
      const SpanMeasure measure(plane, basis_, before_);
      const double rate = per_pole * std::max({1.0, polesPerSpan(basis_.u()), polesPerSpan(basis_.v())});
      const int degree = std::max(basis_.u().degree, basis_.v().degree);
      const std::vector<double> shares =
          sampleShares(static_cast<int>(std::ceil(rate * measure.spans() - 1e-6)) + degree, per_pole);
      std::vector<Place> samples, checks;
      for (std::size_t k = 0; k < shares.size(); ++k) {
        samples.push_back(plane.place(basis_, measure.at(shares[k])));
        if (k == 0) continue;
        for (int m = 1; m <= between; ++m)
          checks.push_back(
              plane.place(basis_, measure.at(shares[k] - m * (shares[k] - shares[k - 1]) / (between + 1))));
        length += (samples[k].target.point - samples[k - 1].target.point).norm();
      }
      spans += measure.spans();
      samples_.push_back(std::move(samples));
      checks_.push_back(std::move(checks));
    }
    span_mm_ = spans > 0 ? length / spans : 0;
  }

  PairMeasure measured(const Place& place) const {
    SidePoint own;
    own.jet = jetOf(place.shares, poles_);
    own.noise = noiseOf(own.jet, basis_);
    return measurePair(sideOf(place.target), own);
  }

  double ratioAt(const Place& place, const PairMeasure& pair) const {
    const SurfaceJet jet = jetOf(place.shares, poles_);
    if (place.order > 0 && pair.angle_rad && place.target.normal.dot(jet.u.cross(jet.v)) < 0) return infinite;
    return ratioOf(pair, place.order, task_->tolerance);
  }

  void judge() {
    worst_.assign(task_->paths.size(), {});
    at_samples_ = 0;
    for (std::size_t i = 0; i < task_->paths.size(); ++i)
      for (const std::vector<Place>* places : {&samples_[i], &checks_[i]}) {
        for (const Place& place : *places) {
          const PairMeasure pair = measured(place);
          const double ratio = ratioAt(place, pair);
          if (ratio >= worst_[i].ratio) worst_[i] = {ratio, place.target.point, pair};
        }
        if (places == &samples_[i]) at_samples_ = std::max(at_samples_, worst_[i].ratio);
      }
    result_.ratios.clear();
    for (const Worst& worst : worst_) result_.ratios.push_back(worst.ratio);
  }

  bool isMet() const {
    return std::ranges::all_of(result_.ratios, [&](double ratio) { return ratio <= task_->share; });
  }

  /// Only these poles and what knot insertion makes of them move.
  void markTouched() {
    constexpr double least_share = 1e-9;
    constexpr std::array<int, 3> rows = {1, 3, 6};
    TColgp_Array2OfPnt marks(1, before_->NbUPoles(), 1, before_->NbVPoles());
    for (std::size_t i = 0; i < task_->paths.size(); ++i)
      for (const std::vector<Place>* places : {&samples_[i], &checks_[i]})
        for (const Place& place : *places)
          for (int row = 0; row < rows[std::clamp(place.order, 0, 2)]; ++row) {
            const auto share = place.shares.share.row(row);
            const double least = least_share * share.cwiseAbs().maxCoeff();
            for (int k = 0; k < share.size(); ++k)
              if (const int pole = place.shares.poles[k]; std::abs(share[k]) > least)
                marks(pole / basis_.v().poles + 1, pole % basis_.v().poles + 1).SetX(1);
          }
    TColStd_Array1OfReal knots_u(1, before_->NbUKnots()), knots_v(1, before_->NbVKnots());
    TColStd_Array1OfInteger multiplicities_u(1, before_->NbUKnots()),
        multiplicities_v(1, before_->NbVKnots());
    before_->UKnots(knots_u);
    before_->VKnots(knots_v);
    before_->UMultiplicities(multiplicities_u);
    before_->VMultiplicities(multiplicities_v);
    touched_ = new Geom_BSplineSurface(marks, knots_u, knots_v, multiplicities_u, multiplicities_v,
                                       before_->UDegree(), before_->VDegree(), before_->IsUPeriodic(),
                                       before_->IsVPeriodic());
    settled_.assign(static_cast<std::size_t>(poles_.rows()), false);
  }

  /// The unknown of each pole, -1: it stays.
  std::vector<int> unknowns(int& count) const {
    const PointRows touched = polesOf(*touched_);
    std::vector<int> unknown(touched.rows(), -1);
    const auto moves = [&](int pole) { return touched(pole, 0) > 1e-12 && !settled_[pole]; };
    count = 0;
    for (const std::vector<int>& side : collapsedSides(basis_, original_, task_->tolerance.gap_mm / 100))
      if (std::ranges::any_of(side, moves)) {
        for (const int pole : side) unknown[pole] = count;
        ++count;
      }
    for (int pole = 0; pole < touched.rows(); ++pole)
      if (moves(pole) && unknown[pole] < 0) unknown[pole] = count++;
    return unknown;
  }

  /// Curvature that counts as none beside the target.
  double curvatureLimit(const TargetPoint& target) const {
    const double norm = Eigen::Matrix3d(target.curvature).norm(), flat = 1 / task_->tolerance.flat_radius_mm;
    return norm < flat ? flat : task_->tolerance.curvature_rel * norm;
  }

  void addPlace(const Place& place, MoveConditions& conditions) const {
    const ContinuityTolerance& tolerance = task_->tolerance;
    const TargetPoint& target = place.target;
    const PoleShares& shares = place.shares;
    if (!conditions.canChange(shares.poles)) return;
    conditions.addPoint(shares.poles, shares.share.row(0), target.point,
                        1 / (task_->share * tolerance.gap_mm));
    if (place.order < 1) return;
    const SurfaceJet jet = jetOf(shares, poles_);
    const auto normal = unitNormal(jet, noiseOf(jet, basis_));
    if (!normal) return;
    Eigen::Vector3d tangent = place.along[0] * jet.u + place.along[1] * jet.v;
    if (tangent.norm() == 0) tangent = jet.u;
    tangent.normalize();
    const std::array<Eigen::Vector3d, 2> ways = {tangent, normal->cross(tangent)};
    const std::array<Eigen::Vector2d, 2> steps = {parameterStep(jet, ways[0]), parameterStep(jet, ways[1])};
    Eigen::MatrixXd slopes(2, shares.share.cols());
    slopes << derivative(shares, steps[0]), derivative(shares, steps[1]);
    conditions.add(shares.poles, slopes, target.normal, Eigen::Vector2d::Zero(),
                   1 / (task_->share * tolerance.angle_rad));
    if (place.order < 2) return;
    Eigen::MatrixXd bends(3, shares.share.cols());
    bends << secondDerivative(shares, steps[0], steps[0]), secondDerivative(shares, steps[0], steps[1]),
        secondDerivative(shares, steps[1], steps[1]);
    const auto bend = [&](int k, int m) { return ways[k].dot(target.curvature * ways[m]); };
    conditions.add(shares.poles, bends, target.normal, Eigen::Vector3d(bend(0, 0), bend(0, 1), bend(1, 1)),
                   1 / (task_->share * curvatureLimit(target)));
  }

  /// As fair as can be: less so only as long as the samples can't be met, and, if gently, as the move stays of its size. After a refinement
  /// from one step fairer than before. The first steps are for curvature alone: beside its soft rows the others may well be met by fairer moves.
  /// Where a step makes the move much longer and gains little, knots are what is missing.
  void moveFairly() {
    constexpr double better = 0.5, of_its_size = 2;
    constexpr std::array<double, 6> fairnesses = {10, 1, 0.1, 0.01, 1e-3, 1e-4};
    constexpr std::size_t for_curvature = 2;
    double before = infinite, limit = infinite;
    was_held_back_ = false;
    const std::size_t first = std::max(isCurved() ? 0 : for_curvature, fairness_ > 0 ? fairness_ - 1 : 0);
    for (std::size_t k = first; k < fairnesses.size(); ++k) {
      const PointRows fairer = poles_;
      const double shorter = largestMove();
      move(fairnesses[k]);
      if (largestMove() > limit) return holdBack(fairer);
      judge();
      const bool gains_nothing = at_samples_ > better * before || at_samples_ == infinite;
      const bool grows = largestMove() > of_its_size * std::max(shorter, task_->tolerance.gap_mm);
      const bool was_near = before <= std::max(1.0, better * given_);
      if (gently_ && gains_nothing && grows && was_near) return holdBack(fairer);
      fairness_ = k;
      if (isMet() || at_samples_ <= task_->share / 2) return;
      if (gains_nothing && k > std::max(first, for_curvature)) return;
      before = at_samples_;
      if (gently_ && (k >= for_curvature || at_samples_ <= 1) && limit == infinite)
        limit = of_its_size * std::max(largestMove(), task_->tolerance.gap_mm);
    }
  }

  void holdBack(const PointRows& fairer) {
    poles_ = fairer;
    was_held_back_ = true;
    judge();
  }

  /// Of a move of one millimetre: so little that the rows are met to the square of the fairness times it.
  double fairnessWeight(double fairness) const {
    double softest = task_->tolerance.gap_mm;
    for (std::size_t i = 0; i < task_->paths.size(); ++i) {
      if (task_->paths[i].order > 0) softest = std::max(softest, task_->tolerance.angle_rad * span_mm_);
      if (task_->paths[i].order < 2) continue;
      double limit = 0;
      for (const Place& place : samples_[i]) limit = std::max(limit, curvatureLimit(place.target));
      softest = std::max(softest, limit * span_mm_ * span_mm_);
    }
    return fairness / (task_->share * softest);
  }

  void addFairness(MoveConditions& conditions, double weight) const {
    const std::vector<SecondDifference> u = secondDifferences(basis_.u()), v = secondDifferences(basis_.v());
    const auto bending = [](double spacing, double mean) {
      return std::clamp(std::pow(mean / spacing, 1.5), 1e-2, 1e3);
    };
    for (const SecondDifference& difference : u)
      for (int j = 0; j < basis_.v().poles; ++j)
        conditions.addFairness(
            {basis_.pole(difference.functions[0], j), basis_.pole(difference.functions[1], j),
             basis_.pole(difference.functions[2], j)},
            difference.factors, weight * bending(difference.spacing, spacing_u_));
    for (const SecondDifference& difference : v)
      for (int i = 0; i < basis_.u().poles; ++i)
        conditions.addFairness(
            {basis_.pole(i, difference.functions[0]), basis_.pole(i, difference.functions[1]),
             basis_.pole(i, difference.functions[2])},
            difference.factors, weight * bending(difference.spacing, spacing_v_));
  }

  bool isCurved() const {
    return std::ranges::any_of(task_->paths, [](const FollowPath& path) { return path.order > 1; });
  }

  void move(double fairness) {
    int count = 0;
    const std::vector<int> unknown = unknowns(count);
    const double weight = fairnessWeight(fairness);
    PointRows start = poles_;
    for (int pole = 0; pole < start.rows(); ++pole)
      if (unknown[pole] >= 0) start.row(pole) = original_.row(pole);
    // Beyond, the conditions contradict one another or the passes diverge.
    constexpr double largest_sense = 0.05;
    const double extent = (original_.colwise().maxCoeff() - original_.colwise().minCoeff()).norm();
    for (int pass = 0; pass < (isCurved() ? 4 : 1); ++pass) {
      if (task_->is_cancelled && task_->is_cancelled()) throw Cancelled();
      work_ += count;
      MoveConditions conditions(unknown, count, original_, start);
      for (std::size_t i = 0; i < task_->paths.size(); ++i)
        for (const Place& place : samples_[i]) addPlace(place, conditions);
      addFairness(conditions, weight);
      const PointRows moves = conditions.solve(weight);
      if (!moves.allFinite() || moves.cwiseAbs().maxCoeff() > largest_sense * extent) return;
      PointRows moved = start;
      for (int pole = 0; pole < moved.rows(); ++pole)
        if (unknown[pole] >= 0) moved.row(pole) += moves.row(unknown[pole]);
      const double change = (moved - poles_).cwiseAbs().maxCoeff();
      poles_ = moved;
      if (change <= 1e-2 * task_->share * task_->tolerance.gap_mm) break;
    }
  }

  std::vector<const Place*> missedPlaces() const {
    std::vector<const Place*> missed;
    for (std::size_t i = 0; i < task_->paths.size(); ++i)
      for (const std::vector<Place>* places : {&samples_[i], &checks_[i]})
        for (const Place& place : *places)
          if (ratioAt(place, measured(place)) > task_->share) missed.push_back(&place);
    return missed;
  }

  /// Middles of the spans that are to be halved.
  std::array<std::set<double>, 2> middlesToInsert(const std::vector<const Place*>& missed) const {
    std::array<std::set<double>, 2> middles;
    const std::array<const SplineAxis*, 2> axes = {&basis_.u(), &basis_.v()};
    for (const Place* place : missed) {
      std::array<double, 2> crossing{};
      for (const int k : {0, 1}) crossing[k] = std::abs(place->along[k]) / spanLength(*axes[k], place->uv[k]);
      for (const int k : {0, 1}) {
        constexpr double lengthwise = 0.05, least = 1e-6;
        if (crossing[k] < lengthwise * crossing[1 - k]) continue;
        double t = place->uv[k];
        const int span = axes[k]->span(t, 0);
        if (axes[k]->length(span) > least * (axes[k]->last - axes[k]->first))
          middles[k].insert(axes[k]->middle(span));
      }
    }
    return middles;
  }

  /// All but the poles near these places, unless moving those alone gained nothing.
  void settle(const std::vector<Eigen::Vector2d>& missed) {
    settled_.assign(static_cast<std::size_t>(poles_.rows()), near_alone_);
    for (const Eigen::Vector2d& uv : missed) {
      const std::vector<int> near_u = basis_.u().polesNear(uv[0]), near_v = basis_.v().polesNear(uv[1]);
      for (const int i : near_u)
        for (const int j : near_v) settled_[basis_.pole(i, j)] = false;
    }
  }

  bool refine() {
    const std::vector<const Place*> missed = missedPlaces();
    const auto middles = middlesToInsert(missed);
    const auto total = (static_cast<double>(basis_.u().poles) + static_cast<double>(middles[0].size())) *
                       (static_cast<double>(basis_.v().poles) + static_cast<double>(middles[1].size()));
    if ((middles[0].empty() && middles[1].empty()) || total > task_->max_poles) return false;
    std::vector<Eigen::Vector2d> missed_at;
    for (const Place* place : missed) missed_at.push_back(place->uv);
    const Surface moved = copyOf(before_);
    setPoles(*moved, poles_);
    before_ = copyOf(before_);
    touched_ = copyOf(touched_);
    for (const Surface& surface : {before_, moved, touched_})
      for (const int k : {0, 1}) {
        if (middles[k].empty()) continue;
        TColStd_Array1OfReal knots(1, static_cast<int>(middles[k].size()));
        std::ranges::copy(middles[k], knots.begin());
        TColStd_Array1OfInteger multiplicities(1, knots.Length());
        multiplicities.Init(1);
        if (k == 0)
          surface->InsertUKnots(knots, multiplicities);
        else
          surface->InsertVKnots(knots, multiplicities);
      }
    basis_ = SurfaceBasis(*before_);
    original_ = polesOf(*before_);
    poles_ = polesOf(*moved);
    settle(missed_at);
    ++result_.refinements;
    sample();
    return true;
  }

  std::string whyNot() const {
    for (const std::string& reason : {whyCornersContradict(), whyMissed(), whyFolded()})
      if (!reason.empty()) return reason;
    return {};
  }

  std::string whyMissed() const {
    const auto worst = std::ranges::max_element(worst_, {}, &Worst::ratio);
    if (worst == worst_.end() || worst->ratio <= task_->share) return {};
    const auto number = worst - worst_.begin();
    std::ostringstream text;
    text << "path " << number + 1 << " is missed at " << at(worst->point) << " by "
         << figuresText(worst->pair, task_->paths[number].order, task_->tolerance);
    if (worst->ratio == infinite) text << ", with its normal turned over";
    text << ", after " << result_.refinements << " refinements to " << basis_.u().poles << " by "
         << basis_.v().poles << " poles";
    return text.str();
  }

  /// Where ends of paths meet they have to ask for the same.
  std::string whyCornersContradict() const {
    struct End {
      std::size_t path;
      const Place* place;
    };
    std::vector<End> ends;
    for (std::size_t i = 0; i < samples_.size(); ++i)
      for (const Place* place : {&samples_[i].front(), &samples_[i].back()}) ends.push_back({i, place});
    for (std::size_t a = 0; a < ends.size(); ++a)
      for (std::size_t b = a + 1; b < ends.size(); ++b) {
        const Eigen::Vector3d here = jetOf(ends[a].place->shares, original_).p,
                              there = jetOf(ends[b].place->shares, original_).p;
        if ((here - there).norm() > std::max(task_->tolerance.gap_mm / 10, Precision::Confusion())) continue;
        const int order = std::min(ends[a].place->order, ends[b].place->order);
        SidePoint first = sideOf(ends[a].place->target), second = sideOf(ends[b].place->target);
        const PairMeasure pair = measurePair(first, second);
        if (ratioOf(pair, order, task_->tolerance) <= 1) continue;
        std::ostringstream text;
        text << "paths " << ends[a].path + 1 << " and " << ends[b].path + 1
             << " ask for different things where they meet at " << at(ends[a].place->target.point) << ": "
             << figuresText(pair, order, task_->tolerance) << " apart";
        return text.str();
      }
    return {};
  }

  /// The normal turned by 90 degrees or more, at points of the spans in which something moved.
  std::string whyFolded() const {
    constexpr int points = 4;
    for (const int span_u : basis_.u().spans())
      for (const int span_v : basis_.v().spans()) {
        if (!isMoved(span_u, span_v)) continue;
        for (int k = 0; k < points * points; ++k) {
          const auto within = [](const SplineAxis& axis, int span, int step) {
            return axis.knots[span] + axis.length(span) * (step + 0.5) / points;
          };
          const PoleShares shares =
              basis_.at({within(basis_.u(), span_u, k / points), within(basis_.v(), span_v, k % points)});
          const SurfaceJet old = jetOf(shares, original_), now = jetOf(shares, poles_);
          if (old.u.cross(old.v).dot(now.u.cross(now.v)) >= 0) continue;
          return "the surface folds at " + at(now.p);
        }
      }
    return {};
  }

  bool isMoved(int span_u, int span_v) const {
    for (int i = span_u - basis_.u().degree; i <= span_u; ++i)
      for (int j = span_v - basis_.v().degree; j <= span_v; ++j) {
        const int pole = basis_.pole(basis_.u().pole(i), basis_.v().pole(j));
        if (poles_.row(pole) != original_.row(pole)) return true;
      }
    return false;
  }

  const FaceTask* task_;
  bool gently_ = true;
  bool was_held_back_ = false;
  bool near_alone_ = true;    ///< refined for poles near what is missed; false: that gained nothing
  std::size_t fairness_ = 0;  ///< the last one that was taken
  Surface before_;            ///< as given, with the knots of now
  Surface touched_;           ///< one where a pole that a path touches has a share in the pole of now
  SurfaceBasis basis_;
  PointRows poles_, original_;
  std::vector<bool> settled_;  ///< by pole: it stays where it is by now
  double spacing_u_, spacing_v_;
  double span_mm_ = 0;  ///< mean length of path in a span
  std::vector<std::vector<Place>> samples_, checks_;
  std::vector<Worst> worst_;
  double at_samples_ = 0;  ///< largest ratio there
  double given_ = 0;       ///< the same of the surface given
  int work_ = 0;           ///< moves solved for so far
  FaceFollow result_;
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
