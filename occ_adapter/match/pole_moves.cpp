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

/// Sums over poles of which only those that move count.
struct MovingSums {
  std::vector<int> points;
  Eigen::MatrixXd factors;  ///< a sum in each row
};

/// Parameters in a knot span and their weights in an integral over it.
struct SpanRule {
  std::vector<double> at, weights;
};

/// As many points as the degree: with fewer, moves of high degree would seem not to bend.
std::vector<SpanRule> rulesOf(const SplineAxis& axis) {
  const GaussRule rule = gaussRule(axis.degree);
  std::vector<SpanRule> rules;
  for (const int span : axis.spans()) {
    SpanRule own;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      own.at.push_back(axis.knots[span] + rule.nodes[i] * axis.length(span));
      own.weights.push_back(rule.weights[i] * axis.length(span));
    }
    rules.push_back(std::move(own));
  }
  return rules;
}

/// Rows whose squares add up to the bending energy of the moves in a pair of spans; no points if
/// nothing moves there.
MovingSums bendingOf(const Zone& zone, const SurfaceBasis& basis, const PointRows& poles,
                     const std::vector<int>& numbers, const SpanRule& span_u,
                     const SpanRule& span_v) {
  // A little energy beyond the face.
  constexpr double share_outside = 0.03, share_of_metric = 1e-12;
  MovingSums bending;
  std::vector<int> kept;
  Eigen::Index rows = 0;
  for (std::size_t i = 0; i < span_u.at.size(); ++i)
    for (std::size_t j = 0; j < span_v.at.size(); ++j) {
      const Eigen::Vector2d uv(span_u.at[i], span_v.at[j]);
      const PoleShares shares = basis.at(uv);
      if (kept.empty()) {
        for (std::size_t k = 0; k < shares.poles.size(); ++k) {
          if (numbers[shares.poles[k]] < 0) continue;
          kept.push_back(static_cast<int>(k));
          bending.points.push_back(numbers[shares.poles[k]]);
        }
        if (kept.empty()) return {};
        bending.factors.resize(3 * std::ssize(span_u.at) * std::ssize(span_v.at), std::ssize(kept));
      }
      const SurfaceJet jet = jetOf(shares, poles);
      const double least_metric =
          share_of_metric * std::max(jet.u.squaredNorm(), jet.v.squaredNorm());
      if (!(least_metric > 0)) continue;
      const bool is_within =
          (uv.array() >= zone.low.array()).all() && (uv.array() <= zone.high.array()).all();
      const double area = jet.u.cross(jet.v).norm() * span_u.weights[i] * span_v.weights[j] *
                          (is_within ? 1 : share_outside);
      const Eigen::MatrixXd hessian = hessianShares(shares, jet, least_metric);
      bending.factors.middleRows<3>(rows) = std::sqrt(area) * hessian(Eigen::indexing::all, kept);
      rows += 3;
    }
  bending.factors.conservativeResize(rows, Eigen::NoChange);
  return bending;
}

}  // namespace

/// A condition of a station, whose value changes with the poles.
struct PoleSolver::Condition {
  int number = 0;   ///< of the system
  int station = 0;  ///< its number
  int order = 0;
};

/// Points that close, as a sum over poles.
struct PoleSolver::Closing {
  std::vector<int> poles;
  Eigen::RowVectorXd factors;
  int number = 0;  ///< of the system
};

namespace {

/// The conditions of the system by what they weigh.
enum Part { Stations, Bending, Closings, Kept, Sliding, Parts };

/// What the conditions of a station miss: a point, and numbers for the derivatives.
Eigen::Vector3d missedPoint(const Station& station, const SurfaceJet& jet) {
  return station.target.point - jet.p;
}

double missedDerivative(const Station& station, const SurfaceJet& jet, int order) {
  const Eigen::Vector3d& n = *station.target.normal;
  const Eigen::Vector2d& s = station.step;
  const Eigen::Vector3d way = s[0] * jet.u + s[1] * jet.v;
  if (order == 1) return -n.dot(way);
  const Eigen::Vector3d second =
      s[0] * s[0] * jet.uu + 2 * s[0] * s[1] * jet.uv + s[1] * s[1] * jet.vv;
  return way.dot(station.target.curvature * way) - n.dot(second);
}

}  // namespace

PoleSolver::PoleSolver(const Zone& zone, const std::vector<Station>& stations,
                       const std::vector<ClosingPoints>& closing, const KeptEdges& kept)
    : zone_(zone),
      stations_(stations),
      basis_(*zone.surface),
      numbers_(numbersOf(zone, basis_)),
      given_(polesOf(*zone.surface)),
      poles_(given_),
      system_(static_cast<int>(zone.poles.size()), Parts) {
  for (const Station& station : stations_) shares_.push_back(basis_.at(station.uv, station.step));
  // Poles of one point differ by rounding only.
  collapsed_ = collapsedSides(basis_, poles_, 0);
  const double row_mm = meanRow_mm();
  // Else curvatures would weigh the less against bending the denser the knots are.
  curvature_scale_ = std::max(1.0, zone.depth_mm / row_mm);
  for (std::size_t i = 0; i < stations_.size(); ++i) addStation(static_cast<int>(i));
  for (const ClosingPoints& points : closing) addClosing(points);
  for (const std::vector<int>& side : collapsed_) addCollapsed(side);
  addBending(row_mm);
  addKept(kept, row_mm / kept.size_mm);
}

PoleSolver::~PoleSolver() = default;

std::vector<SurfaceJet> PoleSolver::jetsOf(const PointRows& poles) const {
  std::vector<SurfaceJet> jets;
  jets.reserve(shares_.size());
  for (const PoleShares& shares : shares_) jets.push_back(jetOf(shares, poles));
  return jets;
}

PoleMoves PoleSolver::solved(double kept_weight, const WorstShare& worst,
                             const Nearness& nearness) {
  constexpr int most_solutions = 16;
  // Of what was missed before. What comes nearer more slowly needs less weight of bending.
  constexpr double slow = 0.5, least_softness = 0.0009;
  poles_ = given_;
  std::vector<SurfaceJet> jets = jetsOf(poles_);
  PointRows best = poles_;
  double least = std::numeric_limits<double>::infinity(), missed_mm = least, softness = 1,
         most_mm = least;
  for (int k = 0; k < most_solutions && least > nearness.enough; ++k) {
    step(jets, softness, kept_weight);
    jets = jetsOf(poles_);
    const double share = worst(jets), now_mm = largestMissed_mm(jets),
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

/// Solves once.
void PoleSolver::step(const std::vector<SurfaceJet>& jets, double softness, double kept_weight) {
  for (const Condition& condition : conditions_) {
    const Station& station = stations_[condition.station];
    const SurfaceJet& jet = jets[condition.station];
    if (condition.order == 0)
      system_.setValue(condition.number, missedPoint(station, jet));
    else
      system_.setValue(condition.number,
                       scaleOf(condition.order) * missedDerivative(station, jet, condition.order));
  }
  for (const Closing& closing : closing_) {
    Eigen::Vector3d opened = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < closing.poles.size(); ++i)
      opened += closing.factors[static_cast<Eigen::Index>(i)] *
                (poles_.row(closing.poles[i]) - given_.row(closing.poles[i])).transpose();
    system_.setValue(closing.number, Eigen::Vector3d(-opened));
  }
  // What closes is not to open by what the bending weighs. Edges slide no further than is needed:
  // little against the energy of a turn.
  constexpr double closing_weight = 100, sliding_weight = 10;
  std::vector<double> weights(Parts, 1);
  weights[Bending] = softness;
  weights[Closings] = std::max(1.0, closing_weight * softness);
  weights[Kept] = softness * std::sqrt(kept_weight);
  weights[Sliding] = kept_weight > 0 ? softness * std::sqrt(sliding_weight) : 0;
  // Bending decides among moves that meet the conditions, and the size of the moves among those
  // that bend alike. Both are squared: small against 1, and far above rounding.
  constexpr double damping = 1e-6;
  const PointRows moves = system_.solve(damping, weights);
  for (std::size_t k = 0; k < zone_.poles.size(); ++k)
    poles_.row(zone_.poles[k]) += moves.row(static_cast<Eigen::Index>(k));
  for (const std::vector<int>& side : collapsed_) {
    const Eigen::RowVector3d first = poles_.row(side.front());
    if (numbers_[side.front()] >= 0)
      for (const int pole : side) poles_.row(pole) = first;
  }
}

/// The largest value of a condition.
double PoleSolver::largestMissed_mm(const std::vector<SurfaceJet>& jets) const {
  double missed_mm = 0;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    const Station& station = stations_[i];
    missed_mm = std::max(missed_mm, missedPoint(station, jets[i]).norm());
    for (int order = 1; order <= station.order && station.target.normal; ++order)
      missed_mm =
          std::max(missed_mm, scaleOf(order) * std::abs(missedDerivative(station, jets[i], order)));
  }
  return missed_mm;
}

/// The mean distance of the rows of poles at the stations. Conditions on derivatives are as long as
/// it, so energies in its square compare with them for any size of the model.
double PoleSolver::meanRow_mm() const {
  const std::vector<SurfaceJet> jets = jetsOf(given_);
  double sum_mm = 0;
  int count = 0;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    if (stations_[i].order < 1) continue;
    sum_mm += (stations_[i].step[0] * jets[i].u + stations_[i].step[1] * jets[i].v).norm();
    ++count;
  }
  return count > 0 ? sum_mm / count : 1;
}

void PoleSolver::addStation(int number) {
  const Station& station = stations_[number];
  const PoleShares& shares = shares_[number];
  const MovingSum point(shares.poles, shares.share.row(0), numbers_);
  if (point.points.empty()) return;
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  conditions_.push_back({system_.addPoint(point.points, point.factors, zero, Stations), number, 0});
  for (int order = 1; order <= station.order && station.target.normal; ++order) {
    const MovingSum moving(shares.poles,
                           order == 1 ? derivative(shares, station.step)
                                      : secondDerivative(shares, station.step, station.step),
                           numbers_);
    const Eigen::VectorXd value = Eigen::VectorXd::Zero(1);
    conditions_.push_back({system_.add(moving.points, scaleOf(order) * moving.factors,
                                       *station.target.normal, value, Stations),
                           number, order});
  }
}

void PoleSolver::addClosing(const ClosingPoints& points) {
  Eigen::Vector2d into = Eigen::Vector2d::Zero();
  into[points.direction] = points.into;
  const PoleShares one = basis_.at(points.uv, into), other = basis_.at(points.other_uv, -into);
  const std::array<int, 3> rows = {0, 1 + points.direction, points.direction == 0 ? 3 : 5};
  double ratio = 1;
  for (int k = 0; k <= points.order; ++k, ratio *= points.ratio) {
    Closing closing;
    closing.poles = one.poles;
    closing.poles.insert(closing.poles.end(), other.poles.begin(), other.poles.end());
    closing.factors.resize(std::ssize(closing.poles));
    closing.factors << ratio * one.share.row(rows[k]), -other.share.row(rows[k]);
    closing.factors /=
        std::max(closing.factors.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
    const MovingSum moving(closing.poles, closing.factors, numbers_);
    if (moving.points.empty()) continue;
    closing.number =
        system_.addPoint(moving.points, moving.factors, Eigen::Vector3d::Zero(), Closings);
    closing_.push_back(std::move(closing));
  }
}

void PoleSolver::addCollapsed(const std::vector<int>& side) {
  for (std::size_t k = 1; k < side.size(); ++k) {
    const MovingSum sum({side[0], side[k]}, Eigen::RowVector2d(1, -1), numbers_);
    if (!sum.points.empty()) system_.addZero(sum.points, sum.factors, Stations);
  }
}

/// The bending energy of the moves, times the square of the row.
void PoleSolver::addBending(double row_mm) {
  const std::vector<SpanRule> rules_v = rulesOf(basis_.v());
  for (const SpanRule& span_u : rulesOf(basis_.u()))
    for (const SpanRule& span_v : rules_v) {
      const MovingSums bending = bendingOf(zone_, basis_, given_, numbers_, span_u, span_v);
      if (!bending.points.empty())
        system_.addZero(bending.points, row_mm * bending.factors, Bending);
    }
}

void PoleSolver::addKept(const KeptEdges& kept, double rows) {
  for (const KeptPoint& point : kept.points) {
    const PoleShares shares = basis_.at(point.uv);
    const MovingSum moving(shares.poles, rows * std::sqrt(point.share) * shares.share.row(0),
                           numbers_);
    if (moving.points.empty()) continue;
    if (!point.normal) {
      system_.addZero(moving.points, moving.factors, Kept);
      continue;
    }
    const Eigen::VectorXd value = Eigen::VectorXd::Zero(1);
    system_.add(moving.points, moving.factors, *point.normal, value, Kept);
    system_.addZero(moving.points, moving.factors, Sliding);
  }
}

namespace {

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

}  // namespace seamwright::occ
