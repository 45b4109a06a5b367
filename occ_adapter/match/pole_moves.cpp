// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include <seamwright/core/linear/gauss_rule.hpp>
#include <seamwright/occ_adapter/match/least_moves.hpp>
#include <seamwright/occ_adapter/match/pole_moves.hpp>
#include <seamwright/occ_adapter/repair/hessian.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// Numbers of the poles of a zone among those that move; -1 for the others.
std::vector<int> numbersOf(const Zone& zone, const SurfaceBasis& basis) {
  std::vector<int> numbers(static_cast<std::size_t>(basis.u().poles) * basis.v().poles, -1);
  for (std::size_t k = 0; k < zone.poles.size(); ++k) numbers[zone.poles[k]] = static_cast<int>(k);
  return numbers;
}

/// A sum over poles of which only those that move count.
struct MovingSum {
  std::vector<int> points;
  Eigen::RowVectorXd factors;

  MovingSum() = default;
  MovingSum(const std::vector<int>& poles, const Eigen::RowVectorXd& all,
            const std::vector<int>& numbers) {
    std::vector<double> kept;
    for (std::size_t k = 0; k < poles.size(); ++k) {
      const int number = numbers[poles[k]];
      if (number < 0) continue;
      points.push_back(number);
      kept.push_back(all[static_cast<Eigen::Index>(k)]);
    }
    factors =
        Eigen::Map<const Eigen::RowVectorXd>(kept.data(), static_cast<Eigen::Index>(kept.size()));
  }
};

/// Sums over poles that are to be small.
struct Soft {
  std::vector<int> points;
  Eigen::MatrixXd factors;
  std::optional<Eigen::Vector3d> normal = {};  ///< the part of the sum along it counts
};

/// Rows whose squares add up to the bending energy of the moves in a pair of spans; no rows if
/// nothing moves there.
Soft bendingOf(const Zone& zone, const SurfaceBasis& basis, const PointRows& poles,
               const std::vector<int>& numbers, int span_u, int span_v) {
  // As Displacement::bending(): enough points for the curvature of a cubic, and a little energy
  // beyond the face.
  static const GaussRule rule = gaussRule(3);
  constexpr double share_outside = 0.03, share_of_metric = 1e-12;
  const SplineAxis &u = basis.u(), &v = basis.v();
  Soft soft;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const Eigen::Vector2d uv(u.knots[span_u] + rule.nodes[i] * u.length(span_u),
                               v.knots[span_v] + rule.nodes[j] * v.length(span_v));
      const PoleShares shares = basis.at(uv);
      const SurfaceJet jet = jetOf(shares, poles);
      const double least_metric =
          share_of_metric * std::max(jet.u.squaredNorm(), jet.v.squaredNorm());
      if (!(least_metric > 0)) continue;
      const bool is_within =
          (uv.array() >= zone.low.array()).all() && (uv.array() <= zone.high.array()).all();
      const double area = jet.u.cross(jet.v).norm() * rule.weights[i] * rule.weights[j] *
                          u.length(span_u) * v.length(span_v) * (is_within ? 1 : share_outside);
      const Eigen::MatrixXd hessian = std::sqrt(area) * hessianShares(shares, jet, least_metric);
      for (Eigen::Index row = 0; row < hessian.rows(); ++row) {
        const MovingSum moving(shares.poles, hessian.row(row), numbers);
        if (moving.points.empty()) return {};
        soft.points = moving.points;
        soft.factors.conservativeResize(soft.factors.rows() + 1, moving.factors.size());
        soft.factors.bottomRows<1>() = moving.factors;
      }
    }
  return soft;
}

class PoleSolver {
 public:
  PoleSolver(const Zone& zone, const std::vector<Station>& stations,
             const std::vector<ClosingPoints>& closing, const KeptEdges& kept)
      : zone_(zone),
        stations_(stations),
        closing_(closing),
        kept_(kept),
        basis_(*zone.surface),
        numbers_(numbersOf(zone, basis_)),
        given_(polesOf(*zone.surface)),
        poles_(given_) {
    for (const Station& station : stations_) shares_.push_back(basis_.at(station.uv, station.step));
    // Poles of one point differ by rounding only.
    collapsed_ = collapsedSides(basis_, poles_, 0);
    setRow();
    setBending();
  }

  PoleMoves solved(const WorstShare& worst, const Nearness& nearness) {
    constexpr int most_solutions = 16;
    // Of what was missed before. What comes nearer more slowly needs less weight of bending.
    constexpr double slow = 0.5, least_softness = 0.0009;
    PointRows best = poles_;
    double least = std::numeric_limits<double>::infinity(), missed_mm = least, softness = 1,
           most_mm = least;
    for (int k = 0; k < most_solutions && least > nearness.enough; ++k) {
      step(softness);
      const double share = worst(poles_), now_mm = largestMissed_mm(),
                   move_mm = (poles_ - given_).rowwise().norm().maxCoeff();
      if (move_mm > most_mm) break;
      if (share <= least) best = poles_;
      least = std::min(least, share);
      const bool is_slow = !(now_mm < slow * missed_mm);
      missed_mm = now_mm;
      if (!is_slow) continue;
      if (softness == 1) most_mm = nearness.most_growth * move_mm;
      softness /= 10;
      if (softness < least_softness || least <= nearness.limit) break;
    }
    PoleMoves moves;
    moves.after = handle<Geom_BSplineSurface>::DownCast(zone_.surface->Copy());
    moves.largest_mm = (best - given_).rowwise().norm().maxCoeff();
    setPoles(*moves.after, best);
    return moves;
  }

 private:
  Eigen::Vector3d sum(const PoleShares& shares, const Eigen::RowVectorXd& factors) const {
    Eigen::Vector3d total = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < shares.poles.size(); ++k)
      total += factors[static_cast<Eigen::Index>(k)] * poles_.row(shares.poles[k]).transpose();
    return total;
  }

  /// Solves once.
  void step(double softness) {
    LeastMoves system(static_cast<int>(zone_.poles.size()));
    for (std::size_t i = 0; i < stations_.size(); ++i) addStation(stations_[i], shares_[i], system);
    for (const ClosingPoints& points : closing_) addClosing(points, softness, system);
    for (const std::vector<int>& side : collapsed_) addCollapsed(side, system);
    for (const Soft& soft : bending_)
      if (soft.normal)
        system.add(soft.points, softness * soft.factors, *soft.normal, Eigen::VectorXd::Zero(1));
      else
        system.addSoft(soft.points, soft.factors);
    // Bending decides among moves that meet the conditions, and the size of the moves among those
    // that bend alike. Both are squared: small against 1, and far above rounding.
    constexpr double damping = 1e-6;
    const PointRows moves = system.solve(damping, softness);
    for (std::size_t k = 0; k < zone_.poles.size(); ++k)
      poles_.row(zone_.poles[k]) += moves.row(static_cast<Eigen::Index>(k));
    for (const std::vector<int>& side : collapsed_) {
      const Eigen::RowVector3d first = poles_.row(side.front());
      if (numbers_[side.front()] >= 0)
        for (const int pole : side) poles_.row(pole) = first;
    }
  }

  /// The largest value of a condition.
  double largestMissed_mm() const {
    double missed_mm = 0;
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      const Station& station = stations_[i];
      const PoleShares& shares = shares_[i];
      const auto include = [&](double value) { missed_mm = std::max(missed_mm, std::abs(value)); };
      include((station.target.point - sum(shares, shares.share.row(0))).norm());
      if (station.order < 1 || !station.target.normal) continue;
      const Eigen::Vector3d& n = *station.target.normal;
      const Eigen::Vector3d way = sum(shares, derivative(shares, station.step));
      include(n.dot(way));
      if (station.order < 2) continue;
      const Eigen::RowVectorXd second = secondDerivative(shares, station.step, station.step);
      include(way.dot(station.target.curvature * way) - n.dot(sum(shares, second)));
    }
    return missed_mm;
  }

  void addStation(const Station& station, const PoleShares& shares, LeastMoves& system) const {
    const Eigen::RowVectorXd at = shares.share.row(0);
    const Eigen::Vector3d missing = station.target.point - sum(shares, at);
    const MovingSum point(shares.poles, at, numbers_);
    if (point.points.empty()) return;
    system.addPoint(point.points, point.factors, missing);
    if (station.order < 1 || !station.target.normal) return;
    const Eigen::Vector3d& n = *station.target.normal;
    const Eigen::RowVectorXd across = derivative(shares, station.step);
    const Eigen::Vector3d way = sum(shares, across);
    const auto add = [&](const Eigen::RowVectorXd& factors, double value) {
      const MovingSum moving(shares.poles, factors, numbers_);
      system.add(moving.points, moving.factors, n, Eigen::VectorXd::Constant(1, value));
    };
    add(across, -n.dot(way));
    if (station.order < 2) return;
    const Eigen::RowVectorXd second = secondDerivative(shares, station.step, station.step);
    add(second, way.dot(station.target.curvature * way) - n.dot(sum(shares, second)));
  }

  void addClosing(const ClosingPoints& points, double softness, LeastMoves& system) const {
    // What closes is not to open by what the bending weighs.
    const double weight = std::max(1.0, 100 * softness);
    Eigen::Vector2d into = Eigen::Vector2d::Zero();
    into[points.direction] = points.into;
    const PoleShares one = basis_.at(points.uv, into), other = basis_.at(points.other_uv, -into);
    const std::array<int, 3> rows = {0, 1 + points.direction, points.direction == 0 ? 3 : 5};
    double ratio = 1;
    for (int k = 0; k <= points.order; ++k, ratio *= points.ratio) {
      std::vector<int> poles = one.poles;
      poles.insert(poles.end(), other.poles.begin(), other.poles.end());
      Eigen::RowVectorXd factors(static_cast<Eigen::Index>(poles.size()));
      factors << ratio * one.share.row(rows[k]), -other.share.row(rows[k]);
      factors *=
          weight / std::max(factors.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
      const MovingSum moving(poles, factors, numbers_);
      if (moving.points.empty()) continue;
      Eigen::Vector3d opened = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < poles.size(); ++i)
        opened += factors[static_cast<Eigen::Index>(i)] *
                  (poles_.row(poles[i]) - given_.row(poles[i])).transpose();
      system.addPoint(moving.points, moving.factors, -opened);
    }
  }

  void addCollapsed(const std::vector<int>& side, LeastMoves& system) const {
    for (std::size_t k = 1; k < side.size(); ++k) {
      const MovingSum sum({side[0], side[k]}, Eigen::RowVector2d(1, -1), numbers_);
      if (!sum.points.empty()) system.addPoint(sum.points, sum.factors, Eigen::Vector3d::Zero());
    }
  }

  /// The mean distance of the rows of poles at the stations. Conditions on derivatives are as long
  /// as it, so energies in its square compare with them for any size of the model.
  void setRow() {
    int count = 0;
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      if (stations_[i].order < 1) continue;
      row_mm_ += sum(shares_[i], derivative(shares_[i], stations_[i].step)).norm();
      ++count;
    }
    row_mm_ = count > 0 ? row_mm_ / count : 1;
  }

  /// Rows whose squares add up to the bending energy of the moves, times the square of the row.
  void setBending() {
    for (const int span_u : basis_.u().spans())
      for (const int span_v : basis_.v().spans()) {
        Soft soft = bendingOf(zone_, basis_, poles_, numbers_, span_u, span_v);
        soft.factors *= row_mm_;
        if (!soft.points.empty()) bending_.push_back(std::move(soft));
      }
    if (kept_.weight == 0) return;
    for (const KeptPoint& point : kept_.points) {
      const PoleShares shares = basis_.at(point.uv);
      const double factor = row_mm_ / kept_.size_mm * std::sqrt(point.share);
      const MovingSum moving(shares.poles, factor * shares.share.row(0), numbers_);
      if (moving.points.empty()) continue;
      bending_.push_back({moving.points, std::sqrt(kept_.weight) * moving.factors, point.normal});
      // Edges slide no further than is needed: little against the energy of a turn.
      constexpr double sliding_weight = 10;
      if (point.normal)
        bending_.push_back({moving.points, std::sqrt(sliding_weight) * moving.factors});
    }
  }

  const Zone& zone_;
  const std::vector<Station>& stations_;
  const std::vector<ClosingPoints>& closing_;
  const KeptEdges& kept_;
  SurfaceBasis basis_;
  std::vector<int> numbers_;
  PointRows given_, poles_;
  std::vector<PoleShares> shares_;
  std::vector<std::vector<int>> collapsed_;
  double row_mm_ = 0;
  std::vector<Soft> bending_;
};

/// How far the derivatives on both sides of a line are alike: the order, 0 to \p order. Sets the
/// ratio of their lengths.
int alikeTo(int order, const PoleShares& one, const PoleShares& other, const PointRows& poles,
            ClosingPoints& points) {
  // Files round poles and knots; a crease is far larger.
  constexpr double rounding = 1e-5;
  const SurfaceJet a = jetOf(one, poles), b = jetOf(other, poles);
  const Eigen::Vector3d first = points.direction == 0 ? a.u : a.v,
                        first_other = points.direction == 0 ? b.u : b.v;
  if (!(first.norm() > 0)) return 0;
  points.ratio = first_other.norm() / first.norm();
  if ((points.ratio * first - first_other).norm() > rounding * first_other.norm()) return 0;
  if (order < 2) return 1;
  const Eigen::Vector3d second =
                            points.ratio * points.ratio * (points.direction == 0 ? a.uu : a.vv),
                        second_other = points.direction == 0 ? b.uu : b.vv;
  const double longest = std::max(second.norm(), second_other.norm());
  return (second - second_other).norm() <= rounding * longest ? 2 : 1;
}

/// Adds points of the line at two parameters across, which are equal at a knot.
void addLine(const SurfaceBasis& basis, const PointRows& poles, int order, ClosingPoints line,
             std::vector<ClosingPoints>& closing) {
  const SplineAxis& along = line.direction == 0 ? basis.v() : basis.u();
  Eigen::Vector2d into = Eigen::Vector2d::Zero();
  into[line.direction] = line.into;
  // As many in a span as a polynomial has coefficients.
  for (const int span : along.spans())
    for (int k = 0; k <= along.degree; ++k) {
      const double t = along.knots[span] + along.length(span) * (k + 0.5) / (along.degree + 1);
      line.uv[1 - line.direction] = line.other_uv[1 - line.direction] = t;
      ClosingPoints points = line;
      points.order =
          alikeTo(order, basis.at(line.uv, into), basis.at(line.other_uv, -into), poles, points);
      closing.push_back(points);
    }
}

}  // namespace

std::vector<ClosingPoints> closingPoints(const Geom_BSplineSurface& surface, int order) {
  const SurfaceBasis basis(surface);
  const PointRows poles = polesOf(surface);
  std::vector<ClosingPoints> closing;
  for (const int direction : {0, 1}) {
    const SplineAxis& axis = direction == 0 ? basis.u() : basis.v();
    const bool is_closed = direction == 0 ? surface.IsUClosed() : surface.IsVClosed();
    const int count = direction == 0 ? surface.NbUKnots() : surface.NbVKnots();
    ClosingPoints line;
    line.direction = direction;
    for (int k = axis.periodic ? 1 : 2; k < count; ++k) {
      const int multiplicity = direction == 0 ? surface.UMultiplicity(k) : surface.VMultiplicity(k);
      if (axis.degree - multiplicity >= order) continue;
      line.uv[direction] = line.other_uv[direction] =
          direction == 0 ? surface.UKnot(k) : surface.VKnot(k);
      addLine(basis, poles, order, line, closing);
    }
    if (!is_closed || axis.periodic) continue;
    line.uv[direction] = axis.first;
    line.other_uv[direction] = axis.last;
    addLine(basis, poles, order, line, closing);
  }
  return closing;
}

PoleMoves movedPoles(const Zone& zone, const std::vector<Station>& stations,
                     const std::vector<ClosingPoints>& closing, const KeptEdges& kept,
                     const WorstShare& worst, const Nearness& nearness) {
  return PoleSolver(zone, stations, closing, kept).solved(worst, nearness);
}

}  // namespace seamwright::occ
