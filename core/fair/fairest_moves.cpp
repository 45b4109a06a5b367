// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <seamwright/core/fair/fairest_moves.hpp>
#include <seamwright/core/fair/polynomial_curve.hpp>
#include <seamwright/core/fair/span_maps.hpp>
#include <seamwright/core/fair/spline_energy.hpp>
#include <seamwright/core/linear/symmetric_band.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

/// Beside more than 2^40 times the energy rounding of the energy comes near to the mass.
constexpr double least_mass = 0x1p-40;

/// The Bézier poles of a spline that bound it, each a mean of degree + 1 poles of the spline.
struct BoundingPoles {
  Eigen::MatrixXd shares;    ///< one column for each Bézier pole
  std::vector<Index> first;  ///< the pole of the first share

  Index count() const { return shares.cols(); }
};

/// All but those at knots where the spline has a derivative: they are means of their neighbours.
BoundingPoles boundingPoles(const BSplineCurve& curve) {
  const int degree = curve.degree;
  const std::vector<double>& u = curve.knots;
  BoundingPoles result;
  std::vector<Eigen::RowVectorXd> rows;
  for (int span = degree; span < curve.count(); ++span) {
    if (!(u[span] < u[span + 1])) continue;
    const Eigen::MatrixXd map = bezierMap(degree, u, span);
    const bool corner = span == degree || u[span] == u[span - degree + 1];
    for (int i = corner ? 0 : 1; i < degree + (span + 1 == curve.count() ? 1 : 0); ++i) {
      rows.emplace_back(map.row(i));
      result.first.push_back(span - degree);
    }
  }
  result.shares.resize(degree + 1, static_cast<Index>(rows.size()));
  for (std::size_t j = 0; j < rows.size(); ++j)
    result.shares.col(static_cast<Index>(j)) = rows[j].transpose();
  return result;
}

/// The energy of a curve and the squared distance of its moves, in units in which the tolerance is
/// 1 and both forms have the same size for a single pole.
class MovedEnergy {
 public:
  MovedEnergy(const BSplineCurve& curve, double tolerance_mm, HeldEnds ends)
      : degree_(curve.degree),
        tolerance_mm_(tolerance_mm),
        poles_(polynomialPoles(curve)),
        free_(poles_.rows(), ends),
        energy_(curve.degree, curve.knots, energyOrder(curve.degree)),
        mass_(derivativeProducts(curve.degree, curve.knots, 0)) {
    scale_ = mass_.diagonal().segment(free_.first, free_.count).sum() /
             energy_.products().diagonal().segment(free_.first, free_.count).sum();
    form_ = linear::SymmetricBand(poles_.rows(), degree_);
    form_.add(scale_, energy_.products());
    form_.add(least_mass, mass_);
  }

  int degree() const { return degree_; }
  const FreePoles& free() const { return free_; }
  /// Half of the second derivatives by one coordinate of the poles.
  const linear::SymmetricBand& form() const { return form_; }

  double of(const Poles& moves) const {
    return scale_ * energy_.of(moved(moves)) / (tolerance_mm_ * tolerance_mm_) +
           least_mass * moves.cwiseProduct(mass_.times(moves)).sum();
  }
  /// Half of the derivatives by the moves.
  Poles gradient(const Poles& moves) const {
    return scale_ / tolerance_mm_ * energy_.gradient(moved(moves)) +
           least_mass * mass_.times(moves);
  }
  /// The energy of the rounding of the poles.
  double rounding() const {
    const double size = machine_epsilon / tolerance_mm_;
    return scale_ * size * size * energy_.products().diagonal().dot(poles_.rowwise().squaredNorm());
  }

 private:
  Poles moved(const Poles& moves) const { return poles_ + tolerance_mm_ * moves; }

  int degree_;
  double tolerance_mm_;
  Poles poles_;
  FreePoles free_;
  SplineEnergy energy_;
  linear::SymmetricBand mass_, form_;
  double scale_ = 0;
};

/// The largest t up to 1 for which |from + t change| is at most 1.
double shareToSphere(const Eigen::RowVector3d& from, const Eigen::RowVector3d& change) {
  const double square = change.squaredNorm(), half = from.dot(change);
  const double inside = 1 - from.squaredNorm();
  if (2 * half + square <= inside) return 1;
  // The root of square t^2 + 2 half t - inside, without a difference of numbers of one sign.
  const double root = std::sqrt(half * half + square * inside);
  return half > 0 ? inside / (half + root) : (root - half) / square;
}

Poles sidesOf(const BoundingPoles& bounds, const Poles& moves) {
  Poles result(bounds.count(), 3);
  for (Index j = 0; j < bounds.count(); ++j)
    result.row(j) =
        bounds.shares.col(j).transpose() * moves.middleRows(bounds.first[j], bounds.shares.rows());
  return result;
}

/// The moves without bounds, if they keep the bounds. They have the least energy then.
std::optional<Poles> freeMoves(const MovedEnergy& energy, const BoundingPoles& bounds) {
  const FreePoles& free = energy.free();
  const linear::BandCholesky factor(energy.form().block(free.first, free.count));
  // Beside the energy rounding may extinguish the squared distance.
  if (!factor.positive()) return std::nullopt;
  Poles moves = Poles::Zero(energy.form().size(), 3);
  moves.middleRows(free.first, free.count) =
      -factor.solve(energy.gradient(moves).middleRows(free.first, free.count));
  if (!(sidesOf(bounds, moves).rowwise().squaredNorm().maxCoeff() <= 1)) return std::nullopt;
  return moves;
}

/// Interior-point steps for moves in the first coordinates, as many as there are dimensions.
template <int dimensions>
class FairingSteps {
 public:
  FairingSteps(const MovedEnergy& energy, const BoundingPoles& bounds)
      : energy_(energy), bounds_(bounds) {
    moves_ = Poles::Zero(energy.form().size(), 3);
    sides_ = Poles::Zero(bounds.count(), 3);
    // The largest force of the energy, so that the first steps stay off the bounds.
    const double first = energy.gradient(moves_).rowwise().norm().maxCoeff();
    multipliers_ = ArrayXd::Constant(bounds.count(), first);
  }

  const Poles& moves() const { return moves_; }
  /// The share that the bounds let the last step take.
  double lastShare() const { return last_share_; }

  double complementarity() const { return (multipliers_ * slacks()).sum(); }

  /// A bound of what the gradient that is left can change, for moves of the size of the bounds.
  double miss() const {
    Poles rest = energy_.gradient(moves_);
    addGradient(multipliers_, rest);
    const FreePoles& free = energy_.free();
    return 2 * rest.middleRows(free.first, free.count).cwiseAbs().sum();
  }

  /// \returns false if the equations are singular.
  bool step(double barrier) {
    const ArrayXd slack = slacks();
    const ArrayXd stiffness = multipliers_ / slack;
    const std::optional<Poles> change = changeFor(barrier / slack, stiffness);
    if (!change) return false;
    const Poles sides = sidesOf(bounds_, *change);
    const ArrayXd multipliers = barrier / slack - multipliers_ +
                                2 * stiffness * sides_.cwiseProduct(sides).rowwise().sum().array();
    constexpr double off_bound = 0.995;
    double primal = 1, dual = 1;
    for (Index j = 0; j < bounds_.count(); ++j) {
      if (const double share = shareToSphere(sides_.row(j), sides.row(j)); share < 1)
        primal = std::min(primal, off_bound * share);
      if (multipliers(j) < 0) dual = std::min(dual, -off_bound * multipliers_(j) / multipliers(j));
    }
    last_share_ = std::min(primal, dual);
    moves_ += primal * *change;
    sides_ += primal * sides;
    multipliers_ += dual * multipliers;
    return true;
  }

 private:
  ArrayXd slacks() const { return 1 - sides_.rowwise().squaredNorm().array(); }

  /// Adds half of the derivatives of the sum of the weights times |side|^2.
  void addGradient(const ArrayXd& weights, Poles& gradient) const {
    for (Index j = 0; j < bounds_.count(); ++j)
      gradient.middleRows(bounds_.first[j], energy_.degree() + 1) +=
          weights(j) * bounds_.shares.col(j) * sides_.row(j);
  }

  /// The step of Newton with the changes of the multipliers eliminated; nothing if it is singular.
  std::optional<Poles> changeFor(const ArrayXd& weights, const ArrayXd& stiffness) const {
    const FreePoles& free = energy_.free();
    Poles gradient = energy_.gradient(moves_);
    addGradient(weights, gradient);
    VectorXd right(free.count * dimensions);
    for (Index i = 0; i < free.count; ++i)
      right.segment<dimensions>(i * dimensions) =
          -gradient.row(free.first + i).head<dimensions>().transpose();
    const linear::BandCholesky factor(equations(stiffness));
    if (!factor.positive()) return std::nullopt;
    const VectorXd solved = factor.solve(right);
    if (!solved.allFinite()) return std::nullopt;
    Poles change = Poles::Zero(moves_.rows(), 3);
    for (Index i = 0; i < free.count; ++i)
      change.row(free.first + i).head<dimensions>() =
          solved.segment<dimensions>(i * dimensions).transpose();
    return change;
  }

  linear::SymmetricBand equations(const ArrayXd& stiffness) const {
    const FreePoles& free = energy_.free();
    const Index degree = energy_.degree();
    linear::SymmetricBand matrix(free.count * dimensions, (degree + 1) * dimensions - 1);
    for (Index j = 0; j < free.count; ++j)
      for (Index i = j; i <= std::min(j + degree, free.count - 1); ++i)
        for (int k = 0; k < dimensions; ++k)
          matrix(i * dimensions + k, j * dimensions + k) =
              energy_.form()(free.first + i, free.first + j);
    for (Index b = 0; b < bounds_.count(); ++b) {
      const Eigen::Matrix<double, dimensions, 1> side =
          sides_.row(b).template head<dimensions>().transpose();
      const Eigen::Matrix<double, dimensions, dimensions> block =
          multipliers_(b) * Eigen::Matrix<double, dimensions, dimensions>::Identity() +
          2 * stiffness(b) * side * side.transpose();
      const Index first = bounds_.first[b] - free.first;
      for (Index j = std::max<Index>(0, -first); j <= degree && first + j < free.count; ++j)
        for (Index i = j; i <= degree && first + i < free.count; ++i) {
          const double share = bounds_.shares(i, b) * bounds_.shares(j, b);
          if (share != 0) addBlock(matrix, first + i, first + j, share * block);
        }
    }
    return matrix;
  }

  static void addBlock(linear::SymmetricBand& matrix, Index i, Index j,
                       const Eigen::Matrix<double, dimensions, dimensions>& block) {
    for (int l = 0; l < dimensions; ++l)
      for (int k = i == j ? l : 0; k < dimensions; ++k)
        matrix(i * dimensions + k, j * dimensions + l) += block(k, l);
  }

  const MovedEnergy& energy_;
  const BoundingPoles& bounds_;
  Poles moves_, sides_;  ///< in tolerances
  ArrayXd multipliers_;
  double last_share_ = 1;
};

/// Whether rounding alone is left of the gradient. A whole step of Newton makes the rest of the
/// gradient that of second order, so that one which stays is the rounding of a large energy form:
/// that of knots whose distances differ by factors of hundreds, or of the steepest parts of a curve
/// whose energy falls by many powers of ten.
class RoundingCheck {
 public:
  bool isReached(double miss, double last_share) {
    // A choice: a quarter is usual far from the rounding.
    constexpr double still = 0.5;
    const bool reached = last_share == 1 && miss > still * before_;
    before_ = miss;
    return reached;
  }

 private:
  double before_ = infinite;
};

template <int dimensions>
FairestMoves leastEnergy(const MovedEnergy& energy, const BoundingPoles& bounds,
                         const Progress& progress) {
  // Where ends that are held need most of the energy, the waves between them have a small share.
  constexpr double precision = 1e-6;
  // Choices: a barrier that falls faster, or below what is missing, makes steps short. After a
  // short step it falls by less: otherwise moves stick at their bounds, and all later steps are
  // short.
  constexpr double centring = 0.2, behind = 0.5;
  constexpr int most_steps = 60;
  FairingSteps<dimensions> steps(energy, bounds);
  RoundingCheck rounding;
  FairestMoves result;
  while (result.steps < most_steps) {
    checkProgress(progress, shareAfter(result.steps));
    const double gap = steps.complementarity(), miss = steps.miss();
    const double small = precision * energy.of(steps.moves()) + energy.rounding();
    const double share = steps.lastShare();
    result.converged = gap <= small && (miss <= small || rounding.isReached(miss, share));
    if (result.converged) break;
    const double falls_to = std::max(centring, 1 - share);
    const double aim = std::max({falls_to * gap, behind * std::min(gap, miss), small / 4});
    const double barrier = aim / static_cast<double>(bounds.count());
    if (!steps.step(barrier)) break;
    ++result.steps;
  }
  result.moves = steps.moves();
  return result;
}

}  // namespace

FairestMoves fairestMoves(const BSplineCurve& curve, double tolerance_mm, HeldEnds ends,
                          const Progress& progress) {
  const MovedEnergy energy(curve, tolerance_mm, ends);
  const BoundingPoles bounds = boundingPoles(curve);
  const bool planar = (curve.poles.col(2).array() == 0).all();
  FairestMoves result;
  checkProgress(progress, 0);
  if (const std::optional<Poles> moves = freeMoves(energy, bounds))
    result = {.moves = *moves, .steps = 1, .converged = true};
  else
    result = planar ? leastEnergy<2>(energy, bounds, progress)
                    : leastEnergy<3>(energy, bounds, progress);
  result.moves *= tolerance_mm;
  return result;
}

}  // namespace seamwright
