// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <seamwright/core/fair/polish_curve.hpp>
#include <seamwright/core/fair/polynomial_curve.hpp>
#include <seamwright/core/fair/span_maps.hpp>
#include <seamwright/core/fair/spline_energy.hpp>
#include <seamwright/core/fair/variation_quadrature.hpp>
#include <seamwright/core/linear/gauss_rule.hpp>
#include <seamwright/core/linear/symmetric_band.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

void requireContinuousCurvature(const BSplineCurve& curve) {
  if (curve.degree < 3)
    refuse(
        fmt::format("the degree is {}: the curvature varies continuously from 3 on", curve.degree));
  const std::vector<double>& u = curve.knots;
  const std::size_t degree = curve.degree, last = u.size() - degree - 1;
  for (std::size_t i = degree + 1; i + degree - 2 < last; ++i)
    if (u[i] == u[i + degree - 2])
      refuse(fmt::format("the curvature may jump at the knot {}, of a multiplicity above {}", u[i],
                         degree - 2));
}

/// The root of the variation at a point, r with |r|^2 = |d(k N)/ds|^2 |a| across the tangent, and
/// its Jacobians by the derivatives a, b and c. Source: docs/theory/planar.md P11.3.
struct VariationRoot {
  Vector3d root;
  Matrix3d by_first, by_second, by_third;
};

VariationRoot linearisedRoot(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double s = a.squaredNorm(), m = a.dot(b), factor = 1 / (s * std::sqrt(std::sqrt(s)));
  const Matrix3d identity = Matrix3d::Identity();
  const Vector3d u = c - 3 * m / s * b;
  const Vector3d w = u - a.dot(u) / s * a;
  const Matrix3d across = identity - a * a.transpose() / s;
  const Matrix3d u_by_first = -3 / s * b * b.transpose() + 6 * m / (s * s) * b * a.transpose();
  const Matrix3d u_by_second = -3 / s * (b * a.transpose() + m * identity);
  const Matrix3d w_by_first = across * u_by_first - (a * u.transpose() + a.dot(u) * identity) / s +
                              2 * a.dot(u) / (s * s) * a * a.transpose();
  return {.root = factor * w,
          .by_first = factor * (w_by_first - 2.5 / s * w * a.transpose()),
          .by_second = factor * across * u_by_second,
          .by_third = factor * across};
}

/// The derivatives of the orders 1 to 3 at a point.
using PointDerivatives = std::array<Vector3d, 3>;

/// One coordinate of the root and its derivatives by a, b and c.
struct RootRow {
  double root = 0;
  PointDerivatives by;
};

/// In the plane the root has one coordinate, along the normal: (a x u) s^(-7/4).
RootRow planarRow(const PointDerivatives& at) {
  const auto& [a, b, c] = at;
  const auto turned = [](const Vector3d& v) { return Vector3d(v.y(), -v.x(), 0); };
  const double s = a.squaredNorm(), m = a.dot(b), root = std::sqrt(s);
  const double factor = 1 / (s * root * std::sqrt(root));
  const double y = a.dot(turned(b)), h = a.dot(turned(c)) - 3 * m * y / s;
  const Vector3d by_first = turned(c) - 3 / s * (y * b + m * turned(b)) + 6 * m * y / (s * s) * a;
  return {.root = factor * h,
          .by = {factor * (by_first - 3.5 * h / s * a), -3 * factor / s * (y * a - m * turned(a)),
                 -factor * turned(a)}};
}

/// The values and coordinates of the root at a point.
class RootRows {
 public:
  RootRows(const PointDerivatives& at, bool planar) : count_(planar ? 1 : 3) {
    if (planar) {
      rows_[0] = planarRow(at);
      return;
    }
    const VariationRoot found = linearisedRoot(at[0], at[1], at[2]);
    for (int k = 0; k < 3; ++k)
      rows_[k] = {.root = found.root(k),
                  .by = {found.by_first.row(k), found.by_second.row(k), found.by_third.row(k)}};
  }

  const RootRow* begin() const { return rows_.data(); }
  const RootRow* end() const { return rows_.data() + count_; }

 private:
  std::array<RootRow, 3> rows_;
  int count_;
};

/// The derivatives of the orders 1 to 3 of the Bernstein polynomials at the nodes of Gauss'
/// quadrature on a piece of [0, 1].
class PieceNodes {
 public:
  using Rows = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;
  static constexpr int count = 8;

  PieceNodes(int degree, const DyadicPiece& piece) {
    const GaussRule gauss = gaussRule(count);
    const double width = std::ldexp(1.0, -piece.halvings);
    for (int k = 0; k < count; ++k) {
      weights_[k] = width * gauss.weights[k];
      rows_[k] = bernsteinDerivatives(degree, piece.start + width * gauss.nodes[k]).bottomRows<3>();
    }
  }

  double weight(int node) const { return weights_[node]; }
  const Rows& rows(int node) const { return rows_[node]; }

 private:
  std::array<double, count> weights_ = {};
  std::array<Rows, count> rows_;
};

/// The spans of a curve, each with the parameter 0..1: the variation does not depend on it.
class VariationSpans {
 public:
  explicit VariationSpans(const BSplineCurve& curve)
      : degree_(curve.degree), knots_(curve.knots), quadrature_(curve.degree) {
    const std::vector<double> inner(knots_.begin() + 1, knots_.end() - 1);
    for (int span = degree_; span < curve.count(); ++span) {
      const double length = knots_[span + 1] - knots_[span];
      if (!(length > 0)) continue;
      first_.push_back(span - degree_);
      maps_.push_back(bezierMap(degree_, knots_, span));
      hodograph_maps_.push_back(length * bezierMap(degree_ - 1, inner, span - 1));
    }
    for (int halvings = 0; halvings <= kept_halvings; ++halvings)
      for (int i = 0; i < 1 << halvings; ++i)
        kept_.emplace_back(degree_,
                           DyadicPiece{.start = std::ldexp(i, -halvings), .halvings = halvings});
  }

  Index count() const { return static_cast<Index>(first_.size()); }
  /// The pole of the first basis function on the span.
  Index first(Index span) const { return first_[span]; }

  /// The poles of the derivative of the curve, 3 by poles - 1.
  Eigen::Matrix3Xd derivativePoles(const Poles& poles) const {
    Eigen::Matrix3Xd result(3, poles.rows() - 1);
    for (Index i = 0; i + 1 < poles.rows(); ++i) {
      const double support = knots_[i + 1 + degree_] - knots_[i + 1];
      result.col(i) = degree_ / support * (poles.row(i + 1) - poles.row(i)).transpose();
    }
    return result;
  }

  SegmentVariation variation(Index span, const Eigen::Matrix3Xd& derivative_poles) const {
    return quadrature_(derivative_poles.middleCols(first_[span], degree_)
                           .lazyProduct(hodograph_maps_[span].transpose()));
  }

  /// The derivatives of the basis functions of the span at a node. \p basis has their size.
  void fillBasis(PieceNodes::Rows& basis, Index span, const PieceNodes& nodes, int node) const {
    basis.noalias() = nodes.rows(node).lazyProduct(maps_[span]);
  }

  /// Calls visit(nodes) for each piece.
  template <class Visit>
  void forNodes(std::span<const DyadicPiece> pieces, const Visit& visit) const {
    for (const DyadicPiece& piece : pieces) {
      if (piece.halvings > kept_halvings) {
        visit(PieceNodes(degree_, piece));
        continue;
      }
      const int pieces_of_less = (1 << piece.halvings) - 1;
      visit(kept_[pieces_of_less + static_cast<int>(std::ldexp(piece.start, piece.halvings))]);
    }
  }

 private:
  /// Most pieces of noisy curves have no more; each further number doubles what is kept.
  static constexpr int kept_halvings = 4;

  int degree_;
  std::vector<double> knots_;
  VariationQuadrature quadrature_;
  std::vector<Index> first_;
  std::vector<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> maps_;
  std::vector<Eigen::MatrixXd> hodograph_maps_;
  std::vector<PieceNodes> kept_;
};

/// The part of a span in the equations: sums over the rows of the nodes of products of their
/// entries.
class SpanEquations {
 public:
  /// \param rows the most that newRow() begins before addRows().
  SpanEquations(Index width, Index rows)
      : products_(padded(width), padded(width)),
        slope_(padded(width)),
        rows_(Eigen::MatrixXd::Zero(padded(width), rows)),
        weights_(rows),
        roots_(rows) {}

  void clear() {
    products_.setZero();
    slope_.setZero();
  }

  /// The entries of a row, to be filled from the first one on.
  Eigen::Ref<Eigen::VectorXd> newRow(double weight, double root) {
    weights_(count_) = weight;
    roots_(count_) = root;
    return rows_.col(count_++);
  }

  void addRows() {
    for (Index r = 0; r < count_; ++r) slope_ += weights_(r) * roots_(r) * rows_.col(r);
    for (Index j = 0; j < rows_.rows(); j += tile)
      for (Index i = j; i < rows_.rows(); i += tile) addProducts(i, j);
    count_ = 0;
  }

  /// The part below the diagonal and on it.
  const Eigen::MatrixXd& products() const { return products_; }
  const Eigen::VectorXd& slope() const { return slope_; }

 private:
  /// A square of sums that fits into the registers of processors.
  static constexpr Index tile = 4;
  static Index padded(Index width) { return (width + tile - 1) / tile * tile; }

  void addProducts(Index i, Index j) {
    Eigen::Matrix4d sums = products_.block<tile, tile>(i, j);
    for (Index r = 0; r < count_; ++r) {
      const Eigen::Vector4d left = rows_.col(r).segment<tile>(i),
                            right = weights_(r) * rows_.col(r).segment<tile>(j);
      sums.noalias() += left * right.transpose();
    }
    products_.block<tile, tile>(i, j) = sums;
  }

  Eigen::MatrixXd products_;
  Eigen::VectorXd slope_;
  Eigen::MatrixXd rows_;  ///< one column for each row
  Eigen::VectorXd weights_, roots_;
  Index count_ = 0;
};

/// Poles with the variation of their curve and the pieces of the spans on which its quadrature was
/// accurate, one span after the other: what the equations of a step at these poles need again.
struct MeasuredPoles {
  Poles poles;
  double variation_per_mm3 = 0;
  std::vector<DyadicPiece> pieces;
  std::vector<std::size_t> ends = {};  ///< for each span, where its pieces end
};

/// The variation of curves with given knots as a sum of squares, and the squared distance from the
/// curve that is given.
class VariationProblem {
 public:
  VariationProblem(const BSplineCurve& curve, HeldEnds ends)
      : degree_(curve.degree),
        given_(polynomialPoles(curve)),
        free_(given_.rows(), ends),
        dimensions_((given_.col(2).array() == 0).all() ? 2 : 3),
        mass_(derivativeProducts(curve.degree, curve.knots, 0)),
        spans_(curve) {}

  Index freeCount() const { return free_.count; }
  const Poles& given() const { return given_; }

  /// The variation up to the share variation_accuracy. If it is not finite, pieces are missing.
  MeasuredPoles measured(Poles poles) const {
    MeasuredPoles result{.poles = std::move(poles), .pieces = {}};
    const Eigen::Matrix3Xd derivative = spans_.derivativePoles(result.poles);
    for (Index span = 0; span < spans_.count() && result.variation_per_mm3 < infinite; ++span) {
      const SegmentVariation found = spans_.variation(span, derivative);
      result.variation_per_mm3 += found.energy_per_mm3;
      result.pieces.insert(result.pieces.end(), found.pieces.begin(), found.pieces.end());
      result.ends.push_back(result.pieces.size());
    }
    return result;
  }
  double squaredDistance(const Poles& poles) const {
    const Poles moves = poles - given_;
    return moves.cwiseProduct(mass_.times(moves)).sum();
  }

  /// Half of the second derivatives of Gauss-Newton and of the gradient of the variation.
  struct Equations {
    linear::SymmetricBand matrix;
    Eigen::VectorXd gradient;
  };

  /// \pre the variation is finite.
  Equations equations(const MeasuredPoles& at_poles) const {
    const Index size = dimensions_ * free_.count, width = dimensions_ * (degree_ + 1);
    Equations result{.matrix = linear::SymmetricBand(size, width - 1),
                     .gradient = Eigen::VectorXd::Zero(size)};
    SpanEquations of_span(width, PieceNodes::count * (dimensions_ == 2 ? 1 : 3));
    PieceNodes::Rows basis(3, degree_ + 1);
    for (Index span = 0; span < spans_.count(); ++span) {
      of_span.clear();
      spans_.forNodes(piecesOf(at_poles, span), [&](const PieceNodes& nodes) {
        for (int node = 0; node < PieceNodes::count; ++node) {
          spans_.fillBasis(basis, span, nodes, node);
          const PointDerivatives at = derivativesAt(basis, at_poles.poles, spans_.first(span));
          for (const RootRow& root : RootRows(at, dimensions_ == 2))
            fillRow(of_span.newRow(nodes.weight(node), root.root), root, basis);
        }
        of_span.addRows();
      });
      addSpan(result, of_span, width, dimensions_ * (spans_.first(span) - free_.first));
    }
    return result;
  }

  /// The form of the squared distance for all coordinates of the free poles.
  linear::SymmetricBand distanceForm() const {
    linear::SymmetricBand form(dimensions_ * free_.count, dimensions_ * (degree_ + 1) - 1);
    for (Index j = 0; j < free_.count; ++j)
      for (Index i = j; i <= std::min(j + degree_, free_.count - 1); ++i)
        for (Index k = 0; k < dimensions_; ++k)
          form(dimensions_ * i + k, dimensions_ * j + k) = mass_(free_.first + i, free_.first + j);
    return form;
  }

  /// The moves of the free poles, one coordinate after the other, and back.
  Eigen::VectorXd unknowns(const Poles& poles) const {
    const Poles moves = (poles - given_).middleRows(free_.first, free_.count);
    Eigen::VectorXd result(dimensions_ * free_.count);
    for (Index i = 0; i < free_.count; ++i)
      result.segment(dimensions_ * i, dimensions_) = moves.row(i).head(dimensions_).transpose();
    return result;
  }
  Poles moved(Poles poles, const Eigen::VectorXd& step) const {
    for (Index i = 0; i < free_.count; ++i)
      poles.row(free_.first + i).head(dimensions_) +=
          step.segment(dimensions_ * i, dimensions_).transpose();
    return poles;
  }

 private:
  static std::span<const DyadicPiece> piecesOf(const MeasuredPoles& at, Index span) {
    const std::size_t begin = span > 0 ? at.ends[span - 1] : 0;
    return std::span(at.pieces).subspan(begin, at.ends[span] - begin);
  }

  /// \param start where the poles of the span begin among the unknowns; negative if they are held.
  static void addSpan(Equations& sum, const SpanEquations& of_span, Index width, Index start) {
    const Index size = sum.gradient.size();
    for (Index j = std::max<Index>(0, -start); j < width && start + j < size; ++j) {
      sum.gradient(start + j) += of_span.slope()(j);
      for (Index i = j; i < width && start + i < size; ++i)
        sum.matrix(start + i, start + j) += of_span.products()(i, j);
    }
  }

  PointDerivatives derivativesAt(const PieceNodes::Rows& basis, const Poles& poles,
                                 Index first) const {
    PointDerivatives result{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
    for (Index i = 0; i <= degree_; ++i) {
      const Vector3d pole = poles.row(first + i);
      for (int order = 0; order < 3; ++order) result[order] += basis(order, i) * pole;
    }
    return result;
  }

  /// The derivatives of a coordinate of the root by the coordinates of the poles of a span.
  void fillRow(Eigen::Ref<Eigen::VectorXd> row, const RootRow& root,
               const PieceNodes::Rows& basis) const {
    for (Index i = 0; i <= degree_; ++i)
      for (Index k = 0; k < dimensions_; ++k)
        row(dimensions_ * i + k) =
            basis(0, i) * root.by[0](k) + basis(1, i) * root.by[1](k) + basis(2, i) * root.by[2](k);
  }

  int degree_;
  Poles given_;
  FreePoles free_;
  Index dimensions_;
  linear::SymmetricBand mass_;
  VariationSpans spans_;
};

/// Minimises the variation plus a weight times the squared distance, for one weight after another.
class VariationDescent {
 public:
  VariationDescent(const VariationProblem& problem, const MeasuredPoles& given)
      : problem_(problem), distance_(problem.distanceForm()) {
    const VariationProblem::Equations start = problem.equations(given);
    // Both forms have the same size for this weight.
    middle_ = start.matrix.diagonal().sum() / distance_.diagonal().sum();
  }

  double middle() const { return middle_; }
  int steps() const { return steps_; }

  MeasuredPoles least(MeasuredPoles at, double weight) {
    double objective = objectiveOf(at, weight);
    // Steps converge quadratically near a minimum without residual, linearly elsewhere; what twelve
    // leave is removed for the next weight.
    for (int i = 0; i < 12; ++i) {
      const Eigen::VectorXd step = stepFrom(at, weight);
      if (!step.allFinite()) return at;
      ++steps_;
      const double before = objective;
      if (!descend(at, objective, step, weight) || before - objective < 1e-6 * before) return at;
    }
    return at;
  }

 private:
  double objectiveOf(const MeasuredPoles& at, double weight) const {
    return at.variation_per_mm3 + weight * problem_.squaredDistance(at.poles);
  }

  /// Not finite if the equations are singular.
  Eigen::VectorXd stepFrom(const MeasuredPoles& at, double weight) const {
    VariationProblem::Equations equations = problem_.equations(at);
    equations.matrix.add(weight, distance_);
    const Eigen::VectorXd right =
        -equations.gradient - weight * distance_.times(problem_.unknowns(at.poles));
    const linear::BandCholesky factor(std::move(equations.matrix));
    if (!factor.positive()) return Eigen::VectorXd::Constant(right.size(), infinite);
    return factor.solve(right);
  }

  /// Shortens the step until the objective falls. \returns whether it does.
  bool descend(MeasuredPoles& at, double& objective, const Eigen::VectorXd& step,
               double weight) const {
    for (double share = 1; share > 1e-3; share /= 2) {
      MeasuredPoles trial = problem_.measured(problem_.moved(at.poles, share * step));
      const double value = objectiveOf(trial, weight);
      if (!(value < objective)) continue;
      at = std::move(trial);
      objective = value;
      return true;
    }
    return false;
  }

  const VariationProblem& problem_;
  linear::SymmetricBand distance_;
  double middle_ = 0;
  int steps_ = 0;
};

struct Polished {
  MeasuredPoles at;
  double moved_mm = 0, weight_per_mm5 = 0;
};

/// Lowers the weight until the tolerance stops it, then bisects.
Polished smallestWeight(const BSplineCurve& curve, MeasuredPoles given, VariationDescent& descent,
                        double tolerance_mm) {
  Polished best{.at = std::move(given)};
  const auto attempt = [&](double exponent) {
    const double weight = descent.middle() * std::exp2(exponent);
    MeasuredPoles found = descent.least(best.at, weight);
    const double moved_mm = boundOfMoves_mm(curve, withPoles(curve, found.poles));
    if (!(moved_mm <= tolerance_mm)) return false;
    if (found.variation_per_mm3 < best.at.variation_per_mm3)
      best = {.at = std::move(found), .moved_mm = moved_mm, .weight_per_mm5 = weight};
    return true;
  };
  // Waves of the lowest frequency in n poles have n^-6 of the energy of the highest: 2^-80 for
  // 10000 poles. Above 2^8 the moves are small beside the waves of the highest frequency, and above
  // 2^64 they are rounding.
  constexpr double least = -80, first = 8, most = 64;
  constexpr double stride = 4;  // weights whose minima are near enough for a warm start
  double high = first;
  while (!attempt(high))
    if ((high += stride) > most) return best;
  double low = high - stride;
  for (; low >= least && attempt(low); low -= stride) high = low;
  if (low < least) return best;
  while (high - low > 0x1p-6 && best.moved_mm < 0.99 * tolerance_mm) {
    const double middle = (low + high) / 2;
    (attempt(middle) ? high : low) = middle;
  }
  return best;
}

}  // namespace

PolishedCurve polishCurve(const BSplineCurve& curve, double tolerance_mm,
                          const CurveFairingOptions& options) {
  PolishedCurve result;
  result.before = fairnessOf(curve);
  requireContinuousCurvature(curve);
  requireFairingTolerance(tolerance_mm);
  result.curve = curve;
  result.after = result.before;
  const VariationProblem problem(curve, options.ends);
  MeasuredPoles given = problem.measured(problem.given());
  const double variation = given.variation_per_mm3;
  if (!std::isfinite(variation))
    throw std::domain_error(fmt::format(
        "the curve stops, so the variation of its curvature is {}: it can't be polished",
        variation));
  result.variation_before_per_mm3 = result.variation_after_per_mm3 = variation;
  if (tolerance_mm == 0 || problem.freeCount() == 0 || variation == 0) return result;
  VariationDescent descent(problem, given);
  const Polished found = smallestWeight(curve, std::move(given), descent, tolerance_mm);
  result.steps = descent.steps();
  // Both figures have an error of this share.
  if (!(found.at.variation_per_mm3 < (1 - 2 * variation_accuracy) * variation)) return result;
  result.curve = withPoles(curve, found.at.poles);
  result.moved_mm = found.moved_mm;
  result.weight_per_mm5 = found.weight_per_mm5;
  result.variation_after_per_mm3 = found.at.variation_per_mm3;
  result.after = fairnessOf(result.curve);
  return result;
}

}  // namespace seamwright
