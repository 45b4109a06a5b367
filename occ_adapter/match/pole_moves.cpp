// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <seamwright/occ_adapter/match/least_moves.hpp>
#include <seamwright/occ_adapter/match/pole_moves.hpp>

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

/// Greville abscissae: where the poles of an axis act.
std::vector<double> placesOf(const SplineAxis& axis) {
  std::vector<double> places;
  for (int i = 0; i < axis.poles; ++i)
    places.push_back(
        std::accumulate(axis.knots.begin() + i + 1, axis.knots.begin() + i + 1 + axis.degree, 0.0) /
        axis.degree);
  return places;
}

class PoleSolver {
 public:
  PoleSolver(const Zone& zone, const std::vector<Station>& stations,
             const std::vector<ClosingPoints>& closing)
      : zone_(zone),
        stations_(stations),
        closing_(closing),
        basis_(*zone.surface),
        numbers_(numbersOf(zone, basis_)),
        poles_(polesOf(*zone.surface)) {
    for (const Station& station : stations_) shares_.push_back(basis_.at(station.uv, station.step));
    // Poles of one point differ by rounding only.
    collapsed_ = collapsedSides(basis_, poles_, 0);
  }

  PoleMoves solved() {
    // Each solution brings the conditions nearer by the square of the weight of bending, and the
    // curvature by the square of what is left: a few reach rounding.
    constexpr int most_solutions = 8;
    const PointRows before = poles_;
    double missed_mm = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most_solutions; ++k) {
      const double now_mm = step();
      // Rounding, or conditions that contradict each other.
      if (now_mm < 1e-12 || now_mm > 0.9 * missed_mm) break;
      missed_mm = now_mm;
    }
    PoleMoves moves;
    moves.after = handle<Geom_BSplineSurface>::DownCast(zone_.surface->Copy());
    moves.largest_mm = (poles_ - before).rowwise().norm().maxCoeff();
    setPoles(*moves.after, poles_);
    return moves;
  }

 private:
  Eigen::Vector3d sum(const PoleShares& shares, const Eigen::RowVectorXd& factors) const {
    Eigen::Vector3d total = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < shares.poles.size(); ++k)
      total += factors[static_cast<Eigen::Index>(k)] * poles_.row(shares.poles[k]).transpose();
    return total;
  }

  /// Solves once. \returns the largest value of a condition, as it was before, in mm.
  double step() {
    LeastMoves system(static_cast<int>(zone_.poles.size()));
    double missed_mm = 0;
    for (std::size_t i = 0; i < stations_.size(); ++i)
      missed_mm = std::max(missed_mm, addStation(stations_[i], shares_[i], system));
    for (const ClosingPoints& points : closing_) addClosing(points, system);
    for (const std::vector<int>& side : collapsed_) addCollapsed(side, system);
    addBending(0, system);
    addBending(1, system);
    // Bending decides among moves that meet the conditions, and the size of the moves among those
    // that bend alike. Both are squared: small against 1, and far above rounding.
    constexpr double damping = 1e-6, softness = 1e-3;
    const PointRows moves = system.solve(damping, softness);
    for (std::size_t k = 0; k < zone_.poles.size(); ++k)
      poles_.row(zone_.poles[k]) += moves.row(static_cast<Eigen::Index>(k));
    for (const std::vector<int>& side : collapsed_) {
      const Eigen::RowVector3d first = poles_.row(side.front());
      if (numbers_[side.front()] >= 0)
        for (const int pole : side) poles_.row(pole) = first;
    }
    return missed_mm;
  }

  double addStation(const Station& station, const PoleShares& shares, LeastMoves& system) const {
    const Eigen::RowVectorXd at = shares.share.row(0);
    const Eigen::Vector3d missing = station.target.point - sum(shares, at);
    const MovingSum point(shares.poles, at, numbers_);
    if (point.points.empty()) return 0;
    system.addPoint(point.points, point.factors, missing);
    double missed_mm = missing.norm();
    if (station.order < 1 || !station.target.normal) return missed_mm;
    const Eigen::Vector3d& n = *station.target.normal;
    const Eigen::RowVectorXd across = derivative(shares, station.step);
    const Eigen::Vector3d way = sum(shares, across);
    const auto add = [&](const Eigen::RowVectorXd& factors, double value) {
      const MovingSum moving(shares.poles, factors, numbers_);
      system.add(moving.points, moving.factors, n, Eigen::VectorXd::Constant(1, value));
      missed_mm = std::max(missed_mm, std::abs(value));
    };
    add(across, -n.dot(way));
    if (station.order < 2) return missed_mm;
    const Eigen::RowVectorXd second = secondDerivative(shares, station.step, station.step);
    add(second, way.dot(station.target.curvature * way) - n.dot(sum(shares, second)));
    return missed_mm;
  }

  void addClosing(const ClosingPoints& points, LeastMoves& system) const {
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
      factors /= std::max(factors.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
      const MovingSum sum(poles, factors, numbers_);
      if (!sum.points.empty()) system.addPoint(sum.points, sum.factors, Eigen::Vector3d::Zero());
    }
  }

  void addCollapsed(const std::vector<int>& side, LeastMoves& system) const {
    for (std::size_t k = 1; k < side.size(); ++k) {
      const MovingSum sum({side[0], side[k]}, Eigen::RowVector2d(1, -1), numbers_);
      if (!sum.points.empty()) system.addPoint(sum.points, sum.factors, Eigen::Vector3d::Zero());
    }
  }

  /// Second differences of the moves along one direction of the parameters, for equal steps as
  /// long as the mean of the two that there are.
  void addBending(int direction, LeastMoves& system) const {
    const SplineAxis &axis = direction == 0 ? basis_.u() : basis_.v(),
                     &other = direction == 0 ? basis_.v() : basis_.u();
    const std::vector<double> places = placesOf(axis);
    const auto number = [&](int i, int j) {
      return direction == 0 ? basis_.pole(i, j) : basis_.pole(j, i);
    };
    const int last = axis.periodic ? axis.poles : axis.poles - 1;
    for (int j = 0; j < other.poles; ++j)
      for (int i = axis.periodic ? 0 : 1; i < last; ++i) {
        const int before = (i + axis.poles - 1) % axis.poles, after = (i + 1) % axis.poles;
        const auto distance = [&](int from, int to) {
          const double way = places[to] - places[from];
          return way > 0 ? way : way + axis.last - axis.first;
        };
        const double a = distance(before, i), b = distance(i, after), h = (a + b) / 2;
        const std::vector<int> poles = {number(before, j), number(i, j), number(after, j)};
        const MovingSum sum(poles, Eigen::RowVector3d(h / a, -h / a - h / b, h / b), numbers_);
        if (!sum.points.empty()) system.addSoft(sum.points, sum.factors, Eigen::Vector3d::Zero());
      }
  }

  const Zone& zone_;
  const std::vector<Station>& stations_;
  const std::vector<ClosingPoints>& closing_;
  SurfaceBasis basis_;
  std::vector<int> numbers_;
  PointRows poles_;
  std::vector<PoleShares> shares_;
  std::vector<std::vector<int>> collapsed_;
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
                     const std::vector<ClosingPoints>& closing) {
  return PoleSolver(zone, stations, closing).solved();
}

}  // namespace seamwright::occ
