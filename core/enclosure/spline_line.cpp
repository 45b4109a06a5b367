// SPDX-License-Identifier: LGPL-2.1-or-later
// Jets along parameter lines. Most seams run along a boundary of a surface, and a path in the
// parameter plane is a spline of degree 0 in v. There the spline is one of curves: its poles are
// summed up across the line first, and only curves are converted.
#include <algorithm>
#include <cmath>
#include <utility>

#include <seamwright/core/enclosure/path_products.hpp>
#include <seamwright/core/enclosure/spline.hpp>
#include <seamwright/core/enclosure/spline_matrices.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

constexpr int most_poles = max_spline_degree + 1;
/// Coordinate after coordinate, each with the poles along the line.
using Row = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, 4 * most_poles, 1>;
/// Across the line.
using Factors = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, most_poles, 1>;

/// The B-splines of degrees degree - orders + 1 to degree that do not vanish in a span.
struct Basis {
  std::array<Factors, 4> values;  ///< by how far the degree is lowered
  int roundings = 0;              ///< of a value of the highest degree; no term of it is negative
};

/// The values at a place of the span, -1..1.
Basis basisAt(const std::vector<double>& knots, int degree, int s, double place, int orders) {
  const double half = 0.5 * (knots[s + 1] - knots[s]);
  const double from_lower = half * (1 + place), to_upper = half * (1 - place);
  const bool is_bezier = knots[s - degree] == knots[s] && knots[s + 1] == knots[s + 1 + degree];
  Basis basis{{}, (is_bezier ? 3 : 12) * degree};
  Factors here = Factors::Ones(1), left(degree + 1), right(degree + 1);
  for (int j = 0;; ++j) {
    if (degree - j < orders) basis.values[degree - j] = here;
    if (j == degree) break;
    left[j] = (knots[s] - knots[s - j]) + from_lower;
    right[j] = (knots[s + 1 + j] - knots[s + 1]) + to_upper;
    Factors next = Factors::Zero(j + 2);
    for (int r = 0; r <= j; ++r) {
      // At an end of a clamped span the shares are 0 and 1, so that the values are exact.
      const double sum = right[r] + left[j - r];
      next[r] += here[r] * (is_bezier ? 0.5 * (1 - place) : right[r] / sum);
      next[r + 1] = here[r] * (is_bezier ? 0.5 * (1 + place) : left[j - r] / sum);
    }
    here = next;
  }
  for (int order = degree + 1; order < orders; ++order) basis.values[order] = Factors::Ones(1);
  return basis;
}

/// The place of a derivative among the nets.
int netAt(const std::array<int, 2>& orders) {
  return static_cast<int>(std::ranges::find(net_orders, orders) - net_orders.begin());
}

}  // namespace

/// The poles of all coordinates, a column for each across the line, with a bound of the errors of
/// each row.
struct SplineEvaluator::LineNet {
  using Values = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                              4 * most_poles, most_poles>;
  Values value;
  Row error;

  /// Largest absolute value of each row.
  Row largest() const {
    Row most = value.col(0).abs();
    for (Eigen::Index j = 1; j < value.cols(); ++j) most = most.max(value.col(j).abs());
    return most;
  }

  /// Bounds, for each row, of the derivative across.
  Row slope(const Factors& factors) const {
    Row most = Row::Zero(value.rows());
    for (Eigen::Index j = 0; j < factors.size(); ++j)
      most = most.max(factors[j] * (value.col(j + 1) - value.col(j)).abs());
    return factors.size() == 0 ? most : Row(most + 2 * factors.maxCoeff() * error);
  }

  /// The net of the derivative across. Difference, factor and product have 5 roundings together.
  LineNet across(const Factors& factors) const {
    const Eigen::Index columns = factors.size();
    if (columns == 0) return {Values::Zero(value.rows(), 1), Row::Zero(value.rows())};
    LineNet result{Values(value.rows(), columns), 2 * factors.maxCoeff() * error};
    for (Eigen::Index j = 0; j < columns; ++j)
      result.value.col(j) = factors[j] * (value.col(j + 1) - value.col(j));
    result.error += 3 * machine_epsilon * result.largest();
    return result;
  }

  /// The net of the derivative along. The factor is zero for the last pole of each coordinate.
  LineNet along(const Row& factors) const {
    const Eigen::Index rows = value.rows();
    LineNet result{Values(rows, value.cols()), Row::Zero(rows)};
    for (Eigen::Index j = 0; j < value.cols(); ++j) {
      result.value.col(j).head(rows - 1) =
          factors.head(rows - 1) * (value.col(j).tail(rows - 1) - value.col(j).head(rows - 1));
      result.value(rows - 1, j) = 0;
    }
    result.error.head(rows - 1) =
        factors.head(rows - 1) * (error.tail(rows - 1) + error.head(rows - 1));
    result.error += 3 * machine_epsilon * result.largest();
    return result;
  }

  /// The poles of the curve at a point of the span, with their errors.
  std::pair<Row, Row> summed(const Factors& basis, int basis_roundings) const {
    Row sum = basis[0] * value.col(0);
    for (Eigen::Index j = 1; j < value.cols(); ++j) sum += basis[j] * value.col(j);
    const bool is_exact = (basis == 0 || basis == 1).all();
    if (is_exact) return {sum, error};
    // A term has one rounding of its product, and one for each sum. The values of the basis add up
    // to 1.
    const auto roundings = static_cast<double>(basis_roundings + value.cols() + 1);
    return {sum, error + 0.5 * machine_epsilon * roundings * largest()};
  }
};

std::optional<SplineEvaluator::Line> SplineEvaluator::lineOf(const std::array<Local, 2>& at) {
  // A path that is further from the line than rounding is evaluated in two parameters.
  constexpr double rounding = 0x1p-26;
  constexpr double constant = 0x1p-48;
  for (const int across : {1, 0}) {
    const ChebyshevModel& x = at[across].x;
    const double varies = x.degree() == 0 ? 0 : x.magnitude() - std::abs(x.coefficient(0));
    const double place = std::clamp(x.coefficient(0), -1.0, 1.0);
    const double radius = std::max(x.radius(), varies) + std::abs(x.coefficient(0) - place);
    if (radius <= rounding && varies <= x.radius() + constant)
      return Line{{across, at[across].span, at[1 - across].span, place}, radius};
  }
  return std::nullopt;
}

/// The poles of the cell relative to a point, multiplied by their weights.
SplineEvaluator::LineNet SplineEvaluator::lineNet(const LineKey& line,
                                                  const Eigen::Vector3d& origin) const {
  const int rows = directions_[1 - line.across].degree + 1;
  const int columns = directions_[line.across].degree + 1;
  const bool rational = !weights_.empty();
  LineNet net;
  net.value.resize((rational ? 4 : 3) * rows, columns);
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i) {
      const int index = poleIndex(line, i, j);
      const double weight = rational ? weights_[index] : 1;
      for (int d = 0; d < 3; ++d)
        net.value(d * rows + i, j) = weight * (poles_[index][d] - origin[d]);
      if (rational) net.value(3 * rows + i, j) = weight;
    }
  net.error = machine_epsilon * net.largest();
  if (rational) net.error.tail(rows) = 0;
  return net;
}

int SplineEvaluator::poleIndex(const LineKey& line, int i, int j) const {
  const int along = 1 - line.across;
  const int a = spans_[along][line.span_along].knot - directions_[along].degree + i;
  const int b = spans_[line.across][line.span].knot - directions_[line.across].degree + j;
  return line.across == 1 ? a * count_v_ + b : b * count_v_ + a;
}

/// Sums the nets up at the line and converts the curves.
SplineEvaluator::LineCell SplineEvaluator::makeLineCell(const LineKey& line, int order) const {
  const int along = 1 - line.across, rows = directions_[along].degree + 1;
  const int columns = directions_[line.across].degree + 1;
  const int dimension = weights_.empty() ? 3 : 4;
  const Span& across = spans_[line.across][line.span];
  const double half = 0.5 * (across.upper - across.lower);
  const std::vector<double>& knots = directions_[line.across].knots;
  const SpanMatrices& m = matrices(along, line.span_along, netCount(order));
  const Basis basis = basisAt(knots, columns - 1, across.knot, line.place, order + 1);
  LineCell cell;
  cell.order = order;
  cell.origin = poles_[poleIndex(line, 0, 0)];
  cell.coefficients.setZero(rows, static_cast<Eigen::Index>(4) * netCount(order));
  const auto convert = [&](const LineNet& net, int da, int db, const Row& slope) {
    const auto [poles, error] = net.summed(basis.values[db], basis.roundings);
    const int count = std::max(rows - da, 1);
    const int k = netAt(line.across == 1 ? std::array{da, db} : std::array{db, da});
    for (int d = 0; d < dimension; ++d) {
      const auto own = poles.segment(d * rows, count).matrix();
      cell.coefficients.col(4 * k + d).head(count) = m.to_chebyshev[da].lazyProduct(own);
      const double of_terms = m.to_chebyshev_terms[da].dot(own.cwiseAbs());
      cell.error[k][d] = (error.segment(d * rows, count).maxCoeff() +
                          0.5 * machine_epsilon * m.roundings[da] * of_terms) *
                         (1 + 1e-12);
      // Beyond the end of the span by rounding the slope may be a little larger.
      cell.slope[k][d] = 1.001 * half * slope.segment(d * rows, count).maxCoeff();
    }
  };
  std::array<Row, 3> along_factors;
  for (int k = 0; k < order; ++k) {
    along_factors[k] = Row::Zero(dimension * rows);
    for (int d = 0; d < dimension; ++d)
      along_factors[k].segment(d * rows, m.factors[k].size()) = m.factors[k];
  }
  LineNet net = lineNet(line, cell.origin);
  for (int db = 0; db <= order; ++db) {
    const Factors factors =
        derivativeFactors(knots, std::max(columns - 1 - db, 0), across.knot).array();
    if (db == 0) {
      convert(net, 0, 0, net.slope(factors));
      if (order == 0) break;
      if (weights_.empty()) {
        // Differences of the original poles do not depend on the origin and are rounded once.
        net = lineNet(line, Eigen::Vector3d::Zero());
        net.error.setZero();
      }
    }
    LineNet derived = net;
    for (int da = 0; da + db <= order; ++da) {
      if (da > 0) derived = derived.along(along_factors[da - 1]);
      if (da + db > 0) convert(derived, da, db, derived.slope(factors));
    }
    if (db < order) net = net.across(factors);
  }
  return cell;
}

const SplineEvaluator::LineCell& SplineEvaluator::lineCell(const LineKey& line, int order) const {
  // As in matrices(): a bound of memory.
  constexpr std::size_t most_kept = 1000;
  const auto known = line_cells_.find(line);
  if (known != line_cells_.end()) {
    if (known->second.order < order) known->second = makeLineCell(line, order);
    return known->second;
  }
  if (line_cells_.size() >= most_kept) line_cells_.clear();
  return line_cells_.emplace(line, makeLineCell(line, order)).first->second;
}

/// Source: docs/theory/enclosures.md E2.5.
JetModel SplineEvaluator::jetOnLine(const Line& line, const ChebyshevModel& along, int order,
                                    Second second) const {
  const LineCell& cell = lineCell(line.key, order);
  const PathProducts products(
      chebyshevPolynomials(along, static_cast<int>(cell.coefficients.rows()) - 1),
      {ChebyshevModel(1)});
  const double outside = products.outside();
  std::array<HomogeneousModel, 10> h;
  const int dimension = weights_.empty() ? 3 : 4;
  for (int k = 0; k < netCount(order); ++k)
    for (int d = 0; d < dimension; ++d) {
      const double error = cell.error[k][d] + line.radius * cell.slope[k][d];
      if (error > 0) h[k][d] = products.sum(cell.coefficients.col(4 * k + d), error * outside);
    }
  JetModel jet = jetFrom(h, !weights_.empty(), order, second == Second::UpToTangents);
  jet.p = jet.p + constantModel(cell.origin);
  return jet;
}

}  // namespace seamwright
