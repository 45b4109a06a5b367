// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <seamwright/core/fill/graph_boundary.hpp>
#include <seamwright/core/fill/graph_fill.hpp>
#include <seamwright/core/fill/graph_knots.hpp>
#include <seamwright/core/linear/gauss_rule.hpp>
#include <seamwright/core/linear/symmetric_band.hpp>
#include <stdexcept>

namespace seamwright {

namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::Vector3d;
using fill::graph_degree, fill::GraphKnots, fill::GraphPart, fill::GraphScale;

/// A choice: with less, cells beside the hole could follow nothing; with more, they would stiffen
/// the hole.
constexpr double weight_outside = 1e-4;

/// Knots are added until the boundary is met to this share of what is accepted, so that the sum of
/// all errors is within it.
constexpr double enough_share = 0.5;

/// The value and the derivatives of a graph at a point.
struct GraphJet {
  double height = 0;
  Vector2d slope = Vector2d::Zero();
};

/// Whether a point is inside of a closed polygon.
bool isInside(const std::vector<Vector2d>& polygon, const Vector2d& point) {
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2d &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
}

/// Twice the area over the length of the outline: the width of a long strip.
double widthOf(const std::vector<Vector2d>& polygon) {
  double twice_area = 0, length = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2d &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    twice_area += a.x() * b.y() - a.y() * b.x();
    length += (b - a).norm();
  }
  return std::abs(twice_area) / length;
}

/// A spline graph over a box, and its equations.
class Graph {
 public:
  Graph(GraphKnots u, GraphKnots v) : u_(std::move(u)), v_(std::move(v)) {}

  const GraphKnots& u() const { return u_; }
  const GraphKnots& v() const { return v_; }
  int poles() const { return u_.poles() * v_.poles(); }

  /// A derivative with a factor.
  struct Term {
    double factor;
    int order_u, order_v;
  };
  /// A row of the equations: a functional of the poles.
  struct Row {
    std::vector<Index> poles;  ///< increasing
    Eigen::VectorXd factors;
  };
  using Cell = std::array<int, 2>;
  Cell cellAt(const Vector2d& at) const { return {u_.spanAt(at.x()), v_.spanAt(at.y())}; }

  /// A sum of derivatives on a cell.
  template <std::size_t count>
  Row row(const Cell& cell, const Vector2d& at, const std::array<Term, count>& terms) const {
    constexpr int local = graph_degree + 1;
    Row result{{}, Eigen::VectorXd::Zero(local * local)};
    const Eigen::MatrixXd in_u = u_.basis(cell[0], at.x(), 3), in_v = v_.basis(cell[1], at.y(), 3);
    for (int i = 0; i < local; ++i) {
      for (const Term& term : terms)
        result.factors.segment<local>(local * i) +=
            term.factor * in_u(term.order_u, i) * in_v.row(term.order_v).transpose();
      for (int j = 0; j < local; ++j)
        result.poles.push_back(Index{u_.firstPole(cell[0]) + i} * v_.poles() +
                               v_.firstPole(cell[1]) + j);
    }
    return result;
  }
  template <std::size_t count>
  Row row(const Vector2d& at, const std::array<Term, count>& terms) const {
    return row(cellAt(at), at, terms);
  }
  /// The difference of two rows, without what cancels or vanishes.
  static Row difference(const Row& one, const Row& other) {
    std::map<Index, double> sum;
    for (std::size_t k = 0; k < one.poles.size(); ++k)
      sum[one.poles[k]] += one.factors(static_cast<Index>(k));
    for (std::size_t k = 0; k < other.poles.size(); ++k)
      sum[other.poles[k]] -= other.factors(static_cast<Index>(k));
    const double rounding =
        1e-12 * std::max(one.factors.cwiseAbs().maxCoeff(), other.factors.cwiseAbs().maxCoeff());
    std::erase_if(sum, [&](const auto& entry) { return std::abs(entry.second) <= rounding; });
    Row result{{}, Eigen::VectorXd(static_cast<Index>(sum.size()))};
    for (const auto& [pole, factor] : sum) {
      result.factors(static_cast<Index>(result.poles.size())) = factor;
      result.poles.push_back(pole);
    }
    return result;
  }

  /// Adds the squared difference of a functional from a value.
  void add(const Row& row, double value, double weight) {
    for (std::size_t k = 0; k < row.poles.size(); ++k)
      for (std::size_t m = 0; m <= k; ++m)
        matrix_(row.poles[k], row.poles[m]) +=
            weight * row.factors(static_cast<Index>(k)) * row.factors(static_cast<Index>(m));
    addRight(row, value, weight);
  }
  void addRight(const Row& row, double value, double weight) {
    for (std::size_t k = 0; k < row.poles.size(); ++k)
      right_(row.poles[k]) += weight * row.factors(static_cast<Index>(k)) * value;
  }
  double valueOf(const Row& row) const {
    double sum = 0;
    for (std::size_t k = 0; k < row.poles.size(); ++k)
      sum += row.factors(static_cast<Index>(k)) * heights_(row.poles[k]);
    return sum;
  }

  void clear() {
    matrix_ = linear::SymmetricBand(poles(), Index{graph_degree} * (v_.poles() + 1));
    right_ = Eigen::VectorXd::Zero(poles());
  }

  bool factorise() {
    factors_ = linear::BandCholesky(std::move(matrix_));
    return factors_.positive();
  }
  /// \pre factorise() returned true.
  bool solve() {
    const Eigen::VectorXd heights = factors_.solve(right_);
    if (!heights.allFinite()) return false;
    heights_ = heights;
    return true;
  }

  GraphJet jet(const Vector2d& at) const {
    return {valueOf(row(at, std::array{Term{1, 0, 0}})),
            Vector2d(valueOf(row(at, std::array{Term{1, 1, 0}})),
                     valueOf(row(at, std::array{Term{1, 0, 1}})))};
  }

  /// The integral of the squared third derivatives.
  void addVariation(const std::vector<Vector2d>& hole) {
    static const GaussRule rule = gaussRule(3);
    for (int a = 0; a < u_.spans(); ++a)
      for (int b = 0; b < v_.spans(); ++b)
        for (std::size_t i = 0; i < rule.nodes.size(); ++i)
          for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
            const Vector2d at(u_.begin(a) + rule.nodes[i] * u_.width(a),
                              v_.begin(b) + rule.nodes[j] * v_.width(b));
            const double weight = rule.weights[i] * rule.weights[j] * u_.width(a) * v_.width(b) *
                                  (isInside(hole, at) ? 1 : weight_outside);
            for (int order = 0; order <= 3; ++order)
              add(row({a, b}, at, std::array{Term{1, order, 3 - order}}), 0,
                  (order % 3 == 0 ? 1 : 3) * weight);
          }
    addJumps(hole, 0);
    addJumps(hole, 1);
  }

  /// At a knot of multiplicity 4 the second derivative on one side has three functions. Rounding
  /// leaves factors of others there.
  static void keepFrom(int first, int direction, Row& row) {
    constexpr int local = graph_degree + 1;
    for (int i = 0; i < local; ++i)
      for (int j = 0; j < local; ++j) {
        const int across = direction == 0 ? i : j;
        if (across < first || across > first + 2) row.factors(local * i + j) = 0;
      }
  }

  /// Squared jumps of the second derivative across the lines where it may jump, as if it changed
  /// over a quarter of the hole.
  void addJumps(const std::vector<Vector2d>& hole, int direction) {
    static const GaussRule rule = gaussRule(3);
    const GraphKnots &across = direction == 0 ? u_ : v_, &along = direction == 0 ? v_ : u_;
    const Term term = direction == 0 ? Term{1, 2, 0} : Term{1, 0, 2};
    for (const double bend : across.bends()) {
      const int after = across.spanAt(bend);
      constexpr double width = 0.5;  // a choice, as the hole is about 2 wide: it keeps jumps local
      for (int k = 0; k < along.spans(); ++k)
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
          const double t = along.begin(k) + rule.nodes[i] * along.width(k);
          const Vector2d at = direction == 0 ? Vector2d(bend, t) : Vector2d(t, bend);
          const auto bendOn = [&](int span, int first) {
            Row rate = row(direction == 0 ? Cell{span, k} : Cell{k, span}, at, std::array{term});
            keepFrom(first, direction, rate);
            return rate;
          };
          const Row jump = difference(bendOn(after, 0), bendOn(after - 1, graph_degree - 2));
          add(jump, 0,
              rule.weights[i] * along.width(k) / width * (isInside(hole, at) ? 1 : weight_outside));
        }
    }
  }

  BSplineSurface surface(const GraphScale& scale) const {
    const auto knots = [&](const GraphKnots& one, double centre) {
      std::vector<double> result = one.flat();
      for (double& knot : result) knot = centre + scale.unit_mm * knot;
      return result;
    };
    BSplineSurface result{.degree_u = graph_degree,
                          .degree_v = graph_degree,
                          .knots_u = knots(u_, scale.centre.x()),
                          .knots_v = knots(v_, scale.centre.y()),
                          .poles = HomogeneousPoles(poles(), 4)};
    const auto abscissa = [](const std::vector<double>& flat, int pole) {
      double sum = 0;
      for (int k = 1; k <= graph_degree; ++k) sum += flat[static_cast<std::size_t>(pole + k)];
      return sum / graph_degree;
    };
    for (int i = 0; i < u_.poles(); ++i)
      for (int j = 0; j < v_.poles(); ++j) {
        const Index row = Index{i} * v_.poles() + j;
        result.poles.row(row) << abscissa(result.knots_u, i), abscissa(result.knots_v, j),
            scale.middle_mm + scale.unit_mm * heights_(row), 1;
      }
    return result;
  }

 private:
  GraphKnots u_, v_;
  linear::SymmetricBand matrix_;
  linear::BandCholesky factors_{linear::SymmetricBand()};
  Eigen::VectorXd right_, heights_;
};

Vector3d normalOf(const Vector2d& slope) {
  return Vector3d(-slope.x(), -slope.y(), 1).normalized();
}

/// Where the boundary is missed, by which share of what is accepted.
struct Miss {
  Vector2d at, across;
  double height = 0, gap = 0, angle_rad = 0, share = 0;
};

double worstShare(const std::vector<Miss>& misses) {
  return std::ranges::max_element(misses, {}, &Miss::share)->share;
}

class GraphFilling {
 public:
  GraphFilling(const std::vector<GraphBoundary>& boundary, const GraphFillOptions& options)
      : options_(options) {
    scale_ = fill::scaleOf(boundary);
    for (const GraphBoundary& part : boundary) parts_.emplace_back(part, scale_);
    constexpr int count = 64;  // a choice: cells across the outline are counted by their middles
    Vector2d low = Vector2d::Constant(HUGE_VAL), high = -low;
    for (GraphPart& part : parts_)
      for (int k = 0; k < count; ++k) {
        hole_.push_back(part.at((k + 0.5) / count).at);
        low = low.cwiseMin(hole_.back());
        high = high.cwiseMax(hole_.back());
      }
    // The box is a little larger, because between samples and at ends the outline may be outside.
    constexpr double margin = 0.02;
    low.array() -= margin, high.array() += margin;
    // Choices. Spans wider than the hole would leave waves across it.
    constexpr int least_spans = 4, most_spans = 32;
    const double span = std::min((high - low).minCoeff() / least_spans, widthOf(hole_));
    const auto spansOf = [&](double range) {
      return std::clamp(static_cast<int>(std::lround(range / span)), least_spans, most_spans);
    };
    const fill::GraphBends bends = fill::bendsOf(fill::jointsOf(parts_), low, high);
    graph_.emplace(GraphKnots(low.x(), high.x(), spansOf(high.x() - low.x()), bends[0]),
                   GraphKnots(low.y(), high.y(), spansOf(high.y() - low.y()), bends[1]));
  }

  GraphFill run(const Progress& progress) {
    // A step counts as one that helps if the largest miss falls by a tenth.
    constexpr double helps = 0.9;
    constexpr int most_rounds = 18, patience = 4;
    std::optional<GraphFill> best;
    double least = HUGE_VAL;
    int idle = 0;
    for (int round = 0; round < most_rounds && idle < patience; ++round) {
      checkProgress(progress, shareAfter(round));
      const std::vector<Miss> misses = solve();
      if (misses.empty()) break;
      const double worst = worstShare(misses);
      idle = worst < helps * least ? 0 : idle + 1;
      if (worst < least || !best) best = result(misses), least = std::min(least, worst);
      if (worst <= enough_share) break;
      refine(misses, worst, idle > 0);
      if (graph_->poles() > options_.most_poles) break;
    }
    if (!best) throw std::invalid_argument("the boundary of the graph does not determine it");
    return *best;
  }

 private:
  /// A condition along the boundary.
  struct Condition {
    Graph::Row row;
    double value, accepted, weight;
  };

  /// What is accepted, in units of the scale.
  double gap() const { return options_.gap_mm / scale_.unit_mm; }

  /// The graph with the present knots. \returns what it misses; nothing if the equations determine
  /// none.
  std::vector<Miss> solve() {
    // What is missed weighs as much as these shares of what is accepted. Smaller ones are met more
    // closely, but where spans are too long for the boundary the graph would wave between them.
    std::vector<Miss> misses;
    for (const double share : {0.02, 2e-3, 1e-4}) {
      const std::optional<double> missed = solve(share);
      if (!missed) break;
      misses = missesOf();
      constexpr double near = 0.1;  // so that what lies between the samples decides
      if (worstShare(misses) <= enough_share || *missed <= near) break;
    }
    return misses;
  }

  /// \returns the largest miss of a condition, as a share of what is accepted; nothing if the
  /// equations determine no graph. The graph is then as before.
  std::optional<double> solve(double met_share) {
    graph_->clear();
    graph_->addVariation(hole_);
    std::vector<Condition> conditions;
    for (GraphPart& part : parts_) {
      const std::vector<double> parameters = part.parameters(graph_->u(), graph_->v());
      for (std::size_t k = 0; k + 1 < parameters.size(); ++k) {
        const double from = parameters[k], to = parameters[k + 1];
        addConditions(part.at(0.5 * (from + to)), to - from, met_share, conditions);
        if (k == 0) addConditions(part.at(from), to - from, met_share, conditions);
        if (k + 2 == parameters.size())
          addConditions(part.at(to), to - from, met_share, conditions);
      }
    }
    for (const Condition& one : conditions) graph_->add(one.row, one.value, one.weight);
    if (!graph_->factorise() || !graph_->solve()) return std::nullopt;
    // Each step adds what is missed to the right side, which makes the penalty exact in the limit
    // (the method of multipliers).
    constexpr int steps = 4;
    double missed = 0;
    for (int step = 0; step <= steps; ++step) {
      missed = 0;
      for (const Condition& one : conditions) {
        const double rest = one.value - graph_->valueOf(one.row);
        missed = std::max(missed, std::abs(rest) / one.accepted);
        graph_->addRight(one.row, rest, one.weight);
      }
      if (step < steps && !graph_->solve()) return std::nullopt;
    }
    return missed;
  }

  /// The conditions at a sample that stands for \p step of the parameter.
  void addConditions(const GraphSample& sample, double step, double met_share,
                     std::vector<Condition>& conditions) {
    using Term = Graph::Term;
    const double length = sample.speed_mm * step;
    const double steepness = normalOf(sample.slope).z();
    const auto weight = [&](double accepted) {
      return length * std::pow(steepness / (met_share * accepted), 2);
    };
    conditions.push_back({graph_->row(sample.at, std::array{Term{1, 0, 0}}), sample.height_mm,
                          gap(), weight(gap())});
    if (!(options_.angle_rad > 0)) return;
    const double a = sample.across.x(), b = sample.across.y();
    // The slope along the boundary follows from the heights, but on short spans not closely enough.
    for (const Vector2d& direction : {sample.across, Vector2d(-b, a)})
      conditions.push_back(
          {graph_->row(sample.at, std::array{Term{direction.x(), 1, 0}, Term{direction.y(), 0, 1}}),
           direction.dot(sample.slope), options_.angle_rad, weight(options_.angle_rad)});
    graph_->add(graph_->row(sample.at, std::array{Term{a * a, 2, 0}, Term{2 * a * b, 1, 1},
                                                  Term{b * b, 0, 2}}),
                sample.bend_per_mm, length * options_.bend_weight);
  }

  /// Between the samples of the conditions, and at the ends.
  std::vector<Miss> missesOf() {
    std::vector<Miss> misses;
    for (GraphPart& part : parts_) {
      const std::vector<double> parameters = part.parameters(graph_->u(), graph_->v());
      for (std::size_t k = 0; k + 1 < parameters.size(); ++k)
        for (const double share : {0.0, 0.25, 0.75})
          misses.push_back(missAt(part.at(std::lerp(parameters[k], parameters[k + 1], share))));
      misses.push_back(missAt(part.at(parameters.back())));
    }
    return misses;
  }

  Miss missAt(const GraphSample& sample) const {
    const GraphJet jet = graph_->jet(sample.at);
    const Vector3d given = normalOf(sample.slope), made = normalOf(jet.slope);
    Miss miss{.at = sample.at,
              .across = sample.across,
              .height = sample.height_mm,
              .gap = std::abs(jet.height - sample.height_mm) * given.z(),
              .angle_rad = std::atan2(given.cross(made).norm(), given.dot(made))};
    miss.share = miss.gap / gap();
    if (options_.angle_rad > 0)
      miss.share = std::max(miss.share, miss.angle_rad / options_.angle_rad);
    return miss;
  }

  GraphFill result(const std::vector<Miss>& misses) const {
    GraphFill fill{.surface = graph_->surface(scale_)};
    for (const Miss& miss : misses) {
      fill.gap_mm = std::max(fill.gap_mm, miss.gap * scale_.unit_mm);
      if (!(miss.angle_rad > fill.angle_rad)) continue;
      fill.angle_rad = miss.angle_rad;
      fill.worst_mm << scale_.centre + scale_.unit_mm * miss.at,
          scale_.middle_mm + scale_.unit_mm * miss.height;
    }
    return fill;
  }

  /// Halves the spans where the boundary is missed. Where it runs along a direction, spans of the
  /// other one are halved only if that did not help.
  void refine(const std::vector<Miss>& misses, double worst, bool both) {
    constexpr double poor = 0.3;      // of the largest miss
    constexpr double aligned = 0.99;  // cosine
    std::vector<bool> in_u(static_cast<std::size_t>(graph_->u().spans())),
        in_v(static_cast<std::size_t>(graph_->v().spans()));
    for (const Miss& miss : misses) {
      if (miss.share < std::max(poor * worst, enough_share)) continue;
      if (both || std::abs(miss.across.x()) < aligned)
        in_u[static_cast<std::size_t>(graph_->u().spanAt(miss.at.x()))] = true;
      if (both || std::abs(miss.across.y()) < aligned)
        in_v[static_cast<std::size_t>(graph_->v().spanAt(miss.at.y()))] = true;
    }
    GraphKnots u = graph_->u(), v = graph_->v();
    u.halve(in_u);
    v.halve(in_v);
    graph_.emplace(std::move(u), std::move(v));
  }

  GraphFillOptions options_;
  GraphScale scale_;
  std::vector<GraphPart> parts_;
  std::vector<Vector2d> hole_;
  std::optional<Graph> graph_;
};

}  // namespace
GraphFill graphFill(const std::vector<GraphBoundary>& boundary, const GraphFillOptions& options,
                    const Progress& progress) {
  if (boundary.empty()) throw std::invalid_argument("a graph needs a boundary");
  if (!(options.gap_mm > 0) || !(options.angle_rad >= 0) || options.most_poles < 1 ||
      !(options.bend_weight >= 0))
    throw std::invalid_argument(
        "a graph needs a gap above 0, an angle, a weight and a number of "
        "poles that are not negative");
  return GraphFilling(boundary, options).run(progress);
}

}  // namespace seamwright
