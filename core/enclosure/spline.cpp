// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <seamwright/core/enclosure/path_products.hpp>
#include <seamwright/core/enclosure/spline.hpp>
#include <seamwright/core/enclosure/spline_matrices.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

/// The order of a jet of so many nets.
int orderOf(int nets) {
  int order = 0;
  while (netCount(order) < nets) ++order;
  return order;
}

void requireFit(const SplineDirection& direction, std::size_t poles, const char* name) {
  if (direction.degree < 0 || direction.degree > max_spline_degree ||
      direction.knots.size() != poles + direction.degree + 1)
    throw std::invalid_argument(std::string("spline in ") + name + ": " + std::to_string(poles) +
                                " poles of degree " + std::to_string(direction.degree) + " with " +
                                std::to_string(direction.knots.size()) + " knots");
  for (std::size_t i = 0; i < direction.knots.size(); ++i)
    if (!std::isfinite(direction.knots[i]) ||
        (i > 0 && direction.knots[i] < direction.knots[i - 1]))
      throw std::invalid_argument(fmt::format("knot {} in {} is {}", i, name, direction.knots[i]));
}

}  // namespace

SplineEvaluator::SplineEvaluator(SplineDirection u, SplineDirection v,
                                 std::vector<Eigen::Vector3d> poles, std::vector<double> weights)
    : directions_{std::move(u), std::move(v)},
      poles_(std::move(poles)),
      weights_(std::move(weights)) {
  const auto count_u = static_cast<int>(directions_[0].knots.size()) - directions_[0].degree - 1;
  if (count_u < 1 || poles_.size() % count_u != 0 ||
      (!weights_.empty() && weights_.size() != poles_.size()))
    throw std::invalid_argument("spline of " + std::to_string(poles_.size()) + " poles and " +
                                std::to_string(weights_.size()) + " weights in " +
                                std::to_string(count_u) + " rows");
  count_v_ = static_cast<int>(poles_.size()) / count_u;
  requireFit(directions_[0], count_u, "u");
  requireFit(directions_[1], count_v_, "v");
  for (const Eigen::Vector3d& pole : poles_)
    if (!pole.allFinite()) throw std::invalid_argument("a pole of the spline is not finite");
  for (const double weight : weights_)
    if (!(weight > 0) || !std::isfinite(weight))
      throw std::invalid_argument(fmt::format("a weight of the spline is {}", weight));
  for (const int d : {0, 1}) {
    const auto& [degree, knots, period] = directions_[d];
    for (int s = degree; s + degree + 1 < static_cast<int>(knots.size()); ++s)
      if (knots[s] < knots[s + 1]) spans_[d].push_back({s, knots[s], knots[s + 1]});
    if (spans_[d].empty()) throw std::invalid_argument("all knots of a spline are the same");
  }
}

SplineEvaluator::SpanMatrices SplineEvaluator::makeMatrices(int direction, int span,
                                                            int highest) const {
  const auto& [degree, knots, period] = directions_[direction];
  const int s = spans_[direction][span].knot;
  SpanMatrices matrices;
  matrices.order = highest;
  for (int order = 0; order <= highest; ++order) {
    const int lower = std::max(degree - order, 0);
    const SmallMatrix to_bezier = splineToBezier(knots, lower, s);
    const SplineMatrix& bezier = bezierToChebyshev(lower);
    const SmallRow terms = bezier.cwiseAbs().colwise().sum();
    const bool is_bezier = to_bezier.isIdentity(0);
    if (is_bezier) {
      matrices.to_chebyshev[order] = bezier;
      matrices.to_chebyshev_terms[order] = terms;
    } else {
      matrices.to_chebyshev[order] = bezier.lazyProduct(to_bezier);
      matrices.to_chebyshev_terms[order] = terms.lazyProduct(to_bezier);
    }
    matrices.roundings[order] = is_bezier ? lower + 3 : 8 * lower + 3;
    if (order < highest) matrices.factors[order] = derivativeFactors(knots, lower, s);
  }
  return matrices;
}

const SplineEvaluator::SpanMatrices& SplineEvaluator::matrices(int direction, int span,
                                                               int nets) const {
  // The first order is soon followed by the second. A path needs only positions.
  const int order = nets == 1 ? 0 : std::max(orderOf(nets), 2);
  const auto known = matrices_[direction].find(span);
  if (known != matrices_[direction].end()) {
    if (known->second.order < order) known->second = makeMatrices(direction, span, order);
    return known->second;
  }
  // A bound of memory: a path lies in one span after another, so old ones are not needed again.
  constexpr std::size_t most_kept = 1000;
  if (matrices_[direction].size() >= most_kept) matrices_[direction].clear();
  return matrices_[direction].emplace(span, makeMatrices(direction, span, order)).first->second;
}

std::vector<double> SplineEvaluator::knotsInside(int direction, const Interval& range) const {
  const std::vector<Span>& spans = spans_[direction];
  const double period = directions_[direction].period;
  std::vector<double> inside;
  const auto collect = [&](double shift, int first) {
    auto span = std::partition_point(spans.begin() + first, spans.end(),
                                     [&](const Span& s) { return s.lower + shift <= range.lower; });
    for (; span != spans.end() && span->lower + shift < range.upper; ++span)
      inside.push_back(span->lower + shift);
  };
  if (period == 0) {
    collect(0, 1);
    return inside;
  }
  const double base = spans.front().lower;
  for (double k = std::floor((range.lower - base) / period); base + k * period < range.upper; ++k)
    collect(k * period, 0);
  return inside;
}

double SplineEvaluator::parameterSize(int direction) const {
  return std::max(std::abs(spans_[direction].front().lower),
                  std::abs(spans_[direction].back().upper));
}

SplineEvaluator::Local SplineEvaluator::localize(int direction, const ChebyshevModel& parameter,
                                                 double hint) const {
  const std::vector<Span>& spans = spans_[direction];
  const double period = directions_[direction].period;
  // These are the same numbers as in knotsInside(), so a hint next to a knot stays on its side of
  // the knot.
  const double base = spans.front().lower;
  double k = period == 0 ? 0 : std::floor((hint - base) / period);
  if (period != 0 && hint < base + k * period) --k;
  if (period != 0 && hint >= base + (k + 1) * period) ++k;
  const double shift = k * period;
  Local local;
  const auto next = std::partition_point(
      spans.begin() + 1, spans.end(), [&](const Span& span) { return span.lower + shift <= hint; });
  local.span = static_cast<int>(next - spans.begin()) - 1;
  const Span& span = spans[local.span];
  const double middle = span.lower + 0.5 * (span.upper - span.lower);
  const double half = 0.5 * (span.upper - span.lower);
  local.x = (1 / half) * (parameter - ChebyshevModel(shift) - ChebyshevModel(middle));
  local.x.widen(4 * machine_epsilon * ((std::abs(middle) + std::abs(shift)) / half + 2));
  return local;
}

const SplineEvaluator::Cell& SplineEvaluator::cell(int span_u, int span_v, int nets) const {
  // As in matrices(): a bound of memory.
  constexpr std::size_t most_kept = 1000;
  if (cells_.size() >= most_kept) cells_.clear();
  Cell& cell = cells_[{span_u, span_v}];
  if (cell.count < nets) extendCell(span_u, span_v, nets, cell);
  return cell;
}

/// The poles of one coordinate, with bounds of their errors.
struct SplineEvaluator::RoundedNet {
  SmallMatrix value, error;

  RoundedNet transposed() const { return {value.transpose(), error.transpose()}; }

  /// The net of the derivative down the rows. Difference, factor and product have 5 roundings
  /// together.
  RoundedNet derivativeDown(const Eigen::VectorXd& factors) const {
    const Eigen::Index rows = factors.size(), columns = value.cols();
    if (rows == 0) return {SmallMatrix::Zero(1, columns), SmallMatrix::Zero(1, columns)};
    RoundedNet result;
    result.value = factors.asDiagonal() * (value.bottomRows(rows) - value.topRows(rows));
    result.error = factors.asDiagonal() * (error.bottomRows(rows) + error.topRows(rows)) +
                   3 * machine_epsilon * result.value.cwiseAbs();
    return result;
  }

  /// The same along the rows.
  RoundedNet derivativeAcross(const Eigen::VectorXd& factors) const {
    const Eigen::Index columns = factors.size(), rows = value.rows();
    if (columns == 0) return {SmallMatrix::Zero(rows, 1), SmallMatrix::Zero(rows, 1)};
    RoundedNet result;
    result.value = (value.rightCols(columns) - value.leftCols(columns)) * factors.asDiagonal();
    result.error = (error.rightCols(columns) + error.leftCols(columns)) * factors.asDiagonal();
    result.error += 3 * machine_epsilon * result.value.cwiseAbs();
    return result;
  }

  /// The Bézier points of h / tau, down the rows, for a polynomial h that vanishes where tau
  /// vanishes. With x = tau / width, B_j(x) of degree n is x n / j times B_(j - 1)(x) of degree n -
  /// 1. At the end of the range tau and the order of the points are reversed.
  RoundedNet quotient(const SmallMatrix& to_bezier, double width, bool at_end) const {
    const Eigen::Index degree = value.rows() - 1;
    const SmallMatrix bezier = to_bezier * value;
    // This is a convex combination, with as many roundings as in makeMatrices().
    SmallMatrix bezier_error = to_bezier * error;
    if (!to_bezier.isIdentity(0))
      bezier_error += 0.5 * machine_epsilon * static_cast<double>(8 * degree + 3) *
                      (to_bezier * value.cwiseAbs());
    RoundedNet result{SmallMatrix(degree, value.cols()), SmallMatrix(degree, value.cols())};
    for (Eigen::Index j = 0; j < degree; ++j) {
      const Eigen::Index row = at_end ? j : j + 1;
      const double factor =
          static_cast<double>(degree) / (width * static_cast<double>(at_end ? j - degree : row));
      result.value.row(j) = factor * bezier.row(row);
      result.error.row(j) = std::abs(factor) * bezier_error.row(row) +
                            2 * machine_epsilon * result.value.row(j).cwiseAbs();
    }
    return result;
  }
};

/// The nets of one coordinate in Chebyshev form, from the first one that the cell lacks.
/// Derivatives come from \p poles, positions from \p local.
void SplineEvaluator::addNets(const RoundedNet& poles, const RoundedNet& local,
                              const SpanMatrices& mu, const SpanMatrices& mv, int coordinate,
                              int first_net, Cell& cell) const {
  const auto along_u = [&](const RoundedNet& net, int order) {
    return net.derivativeDown(mu.factors[order]);
  };
  const auto along_v = [&](const RoundedNet& net, int order) {
    return net.derivativeAcross(mv.factors[order]);
  };
  std::array<RoundedNet, 10> nets = {local};
  if (cell.count > 1) nets[1] = along_u(poles, 0), nets[2] = along_v(poles, 0);
  if (cell.count > 3)
    nets[3] = along_u(nets[1], 1), nets[4] = along_v(nets[1], 0), nets[5] = along_v(nets[2], 1);
  if (cell.count > 6) {
    nets[6] = along_u(nets[3], 2), nets[7] = along_v(nets[3], 0);
    nets[8] = along_v(nets[4], 1), nets[9] = along_v(nets[5], 2);
  }
  for (int k = first_net; k < cell.count; ++k) {
    const auto [du, dv] = net_orders[k];
    const SmallMatrix& net = nets[k].value;
    const SmallMatrix across = net.lazyProduct(mv.to_chebyshev[dv].transpose());
    cell.nets[k].coefficients[coordinate] = mu.to_chebyshev[du].lazyProduct(across);
    // The errors of the poles change the polynomial nowhere by more than the largest of these
    // errors.
    const double of_terms =
        mu.to_chebyshev_terms[du].lazyProduct(net.cwiseAbs()).dot(mv.to_chebyshev_terms[dv]);
    // The last factor covers the rounding of this bound itself: a sum of up to some thousand terms.
    cell.nets[k].error[coordinate] =
        (nets[k].error.maxCoeff() +
         0.5 * machine_epsilon * (mu.roundings[du] + mv.roundings[dv]) * of_terms) *
        (1 + 1e-12);
  }
}

SplineEvaluator::RoundedNet SplineEvaluator::localNet(int span_u, int span_v, int coordinate,
                                                      const Eigen::Vector3d& origin) const {
  const int p = directions_[0].degree;
  const int q = directions_[1].degree;
  const int first_u = spans_[0][span_u].knot - p;
  const int first_v = spans_[1][span_v].knot - q;
  RoundedNet net{SmallMatrix(p + 1, q + 1), SmallMatrix::Zero(p + 1, q + 1)};
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j) {
      const int index = (first_u + i) * count_v_ + first_v + j;
      const double weight = weights_.empty() ? 1 : weights_[index];
      net.value(i, j) =
          coordinate == 3 ? weight : weight * (poles_[index][coordinate] - origin[coordinate]);
    }
  if (coordinate != 3) net.error = machine_epsilon * net.value.cwiseAbs();
  return net;
}

/// Adds the nets that the cell lacks.
void SplineEvaluator::extendCell(int span_u, int span_v, int nets, Cell& cell) const {
  const SpanMatrices& mu = matrices(0, span_u, nets);
  const SpanMatrices& mv = matrices(1, span_v, nets);
  const int first_u = spans_[0][span_u].knot - directions_[0].degree;
  const int first_v = spans_[1][span_v].knot - directions_[1].degree;
  const int first_net = cell.count;
  cell.count = nets;
  cell.origin = poles_[first_u * count_v_ + first_v];
  const int dimension = weights_.empty() ? 3 : 4;
  for (int c = 0; c < dimension; ++c) {
    const RoundedNet local = localNet(span_u, span_v, c, cell.origin);
    if (!weights_.empty()) {
      addNets(local, local, mu, mv, c, first_net, cell);
      continue;
    }
    // Differences of the original poles do not depend on the origin and are rounded once.
    RoundedNet poles = localNet(span_u, span_v, c, Eigen::Vector3d::Zero());
    poles.error.setZero();
    addNets(poles, local, mu, mv, c, first_net, cell);
  }
}

JetModel SplineEvaluator::jet(const ChebyshevModel& u, const ChebyshevModel& v, double hint_u,
                              double hint_v, int order) const {
  return jet(u, v, hint_u, hint_v, order, Second::Whole);
}

JetModel SplineEvaluator::curvatureJet(const ChebyshevModel& u, const ChebyshevModel& v,
                                       double hint_u, double hint_v) const {
  return jet(u, v, hint_u, hint_v, 2, Second::UpToTangents);
}

JetModel SplineEvaluator::jet(const ChebyshevModel& u, const ChebyshevModel& v, double hint_u,
                              double hint_v, int order, Second second) const {
  const std::array<Local, 2> at = {localize(0, u, hint_u), localize(1, v, hint_v)};
  if (const auto line = lineOf(at))
    return jetOnLine(*line, at[1 - line->key.across].x, order, second);
  const Cell& c = cell(at[0].span, at[1].span, netCount(order));
  JetModel jet = evaluated(c, at[0].x, at[1].x, order, second);
  jet.p = jet.p + constantModel(c.origin);
  return jet;
}

/// The jet relative to the origin of the cell.
JetModel SplineEvaluator::evaluated(const Cell& c, const ChebyshevModel& x, const ChebyshevModel& y,
                                    int order, Second second) const {
  const PathProducts products(chebyshevPolynomials(x, directions_[0].degree),
                              chebyshevPolynomials(y, directions_[1].degree));
  const double outside = products.outside();
  std::array<HomogeneousModel, 10> h;
  const int dimension = weights_.empty() ? 3 : 4;
  for (int k = 0; k < netCount(order); ++k)
    for (int d = 0; d < dimension; ++d)
      h[k][d] = products.sum(c.nets[k].coefficients[d], c.nets[k].error[d] * outside);
  return jetFrom(h, !weights_.empty(), order, second == Second::UpToTangents);
}

/// The common point of all poles of the boundary; nothing if they differ.
std::optional<Eigen::Vector3d> SplineEvaluator::collapsedPoint(int span_u, int span_v,
                                                               const Boundary& boundary) const {
  const int d = boundary.direction;
  const bool at_end = boundary.at_end;
  const int degree = directions_[d].degree;
  const int knot = spans_[d][d == 0 ? span_u : span_v].knot;
  const std::vector<double>& knots = directions_[d].knots;
  if (degree == 0) return std::nullopt;
  const bool clamped =
      at_end ? knots[knot + 1] == knots[knot + degree] : knots[knot + 1 - degree] == knots[knot];
  if (!clamped) return std::nullopt;
  const int across = at_end ? knot : knot - degree;
  const int other_degree = directions_[1 - d].degree;
  const int first = spans_[1 - d][d == 0 ? span_v : span_u].knot - other_degree;
  const auto pole = [&](int i) {
    return poles_[d == 0 ? across * count_v_ + first + i : (first + i) * count_v_ + across];
  };
  for (int i = 1; i <= other_degree; ++i)
    if (pole(i) != pole(0)) return std::nullopt;
  return pole(0);
}

/// The matrices of the quotient, which has one degree less and is in Bézier form over the span.
SplineEvaluator::SpanMatrices SplineEvaluator::quotientMatrices(int direction, int span,
                                                                int highest) const {
  const double width = spans_[direction][span].upper - spans_[direction][span].lower;
  SpanMatrices matrices;
  matrices.order = highest;
  for (int order = 0; order <= highest; ++order) {
    const int degree = std::max(directions_[direction].degree - 1 - order, 0);
    matrices.to_chebyshev[order] = bezierToChebyshev(degree);
    matrices.to_chebyshev_terms[order] = matrices.to_chebyshev[order].cwiseAbs().colwise().sum();
    matrices.roundings[order] = degree + 3;
    if (order < highest)
      matrices.factors[order] = Eigen::VectorXd::Constant(degree, degree / width);
  }
  return matrices;
}

SplineEvaluator::RoundedNet SplineEvaluator::quotientNet(const RoundedNet& net, int span,
                                                         const Boundary& boundary) const {
  const auto& [degree, knots, period] = directions_[boundary.direction];
  const SmallMatrix to_bezier =
      splineToBezier(knots, degree, spans_[boundary.direction][span].knot);
  const Span& s = spans_[boundary.direction][span];
  const RoundedNet rows = boundary.direction == 0 ? net : net.transposed();
  const RoundedNet quotient = rows.quotient(to_bezier, s.upper - s.lower, boundary.at_end);
  return boundary.direction == 0 ? quotient : quotient.transposed();
}

SplineEvaluator::Cell SplineEvaluator::makeCollapsedCell(const CollapsedKey& key,
                                                         const Eigen::Vector3d& point,
                                                         int nets) const {
  const int d = key.boundary.direction;
  const int span = d == 0 ? key.span_u : key.span_v;
  const SpanMatrices& mu = matrices(0, key.span_u, nets);
  const SpanMatrices& mv = matrices(1, key.span_v, nets);
  const SpanMatrices divided = quotientMatrices(d, span, std::max(orderOf(nets), 2));
  Cell cell;
  cell.count = nets;
  cell.origin = point;
  for (const int c : {0, 1, 2}) {
    const RoundedNet net =
        quotientNet(localNet(key.span_u, key.span_v, c, point), span, key.boundary);
    addNets(net, net, d == 0 ? divided : mu, d == 1 ? divided : mv, c, 0, cell);
  }
  if (!weights_.empty()) {
    const RoundedNet weights = localNet(key.span_u, key.span_v, 3, point);
    addNets(weights, weights, mu, mv, 3, 0, cell);
  }
  return cell;
}

std::optional<CollapsedJetModel> SplineEvaluator::collapsedJet(const ChebyshevModel& u,
                                                               const ChebyshevModel& v,
                                                               double hint_u, double hint_v,
                                                               int order) const {
  constexpr double near = 0x1p-4;  // of the span; further away the jet itself is as accurate
  constexpr double rounding =
      0x1p-36;  // of the span, or of the parameter if the path is only known to that
  // As in matrices(): a bound of memory.
  constexpr std::size_t most_kept = 1000;
  const std::array<Local, 2> local = {localize(0, u, hint_u), localize(1, v, hint_v)};
  for (const int d : {0, 1})
    for (const bool at_end : {false, true}) {
      const CollapsedKey key{local[0].span, local[1].span, {d, at_end}};
      const std::optional<Eigen::Vector3d> point =
          collapsedPoint(key.span_u, key.span_v, key.boundary);
      if (!point) continue;
      const Span& span = spans_[d][local[d].span];
      const ChebyshevModel from_end =
          at_end ? local[d].x - ChebyshevModel(1) : local[d].x + ChebyshevModel(1);
      const Interval range = from_end.range();
      const double nearest = at_end ? -range.upper : range.lower;
      const double half = 0.5 * (span.upper - span.lower);
      const double unknown = 2 * from_end.radius();
      const double beyond =
          unknown * half <= rounding * parameterSize(d) ? std::max(rounding, unknown) : rounding;
      if (!(nearest >= -beyond && nearest < near)) continue;
      if (collapsed_cells_.size() >= most_kept) collapsed_cells_.clear();
      Cell& cell = collapsed_cells_[key];
      if (cell.count < netCount(order)) cell = makeCollapsedCell(key, *point, netCount(order));
      return CollapsedJetModel{*point,
                               evaluated(cell, local[0].x, local[1].x, order, Second::Whole),
                               half * from_end, d, at_end ? -1.0 : 1.0};
    }
  return std::nullopt;
}

}  // namespace seamwright
