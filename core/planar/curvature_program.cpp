// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <vector>

#include <seamwright/core/planar/curvature_program.hpp>

namespace seamwright {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Unknowns, slacks of the sides, and multipliers. Slacks and multipliers are above 0.
struct ProgramPoint {
  VectorXd curvatures, moves;
  ArrayXd slacks;               ///< of S k - margins
  ArrayXd shape, lower, upper;  ///< multipliers of the bounds
  VectorXd equations;           ///< multipliers of A k - J x = b
};

/// The largest step up to 1 that keeps 99.5 % off the bound.
double shareToBound(const ArrayXd& values, const ArrayXd& changes) {
  double step = 1;
  for (Index i = 0; i < values.size(); ++i)
    if (changes(i) < 0) step = std::min(step, -0.995 * values(i) / changes(i));
  return step;
}

/// Proves that a program has no solution. For multipliers z >= 0 of S k >= margins take y with
/// A' y = S' z. Then each solution has z' margins <= z' S k = y' A k = y' b + y' J x, which is at
/// most y' b + |J' y| summed up over the moves (Farkas).
class Refutation {
 public:
  explicit Refutation(const CurvatureProgram& program) : program_(program) {
    const SparseMatrix transposed = program.curvatures.transpose();
    factor_.compute(transposed);
  }

  bool refutes(const ArrayXd& multipliers) const {
    if (factor_.info() != Eigen::Success) return false;
    const VectorXd z = multipliers.matrix();
    const VectorXd y = factor_.solve(VectorXd(program_.shape.transpose() * z));
    const double demanded = z.dot(program_.margins), given = y.dot(program_.right);
    const double moved = (program_.moves.transpose() * y).lpNorm<1>();
    // Far above the rounding of the sums and of y.
    constexpr double rounding = 1e-6;
    const double size =
        z.dot(program_.margins.cwiseAbs()) + y.cwiseAbs().dot(program_.right.cwiseAbs()) + moved;
    return demanded - given - moved > rounding * size;
  }

 private:
  const CurvatureProgram& program_;
  Eigen::SparseLU<SparseMatrix> factor_;
};

class ProgramSteps {
 public:
  ProgramSteps(const CurvatureProgram& program, const VectorXd& curvatures, const VectorXd& moves)
      : program_(program) {
    // Off the bounds, so that the first steps are long.
    constexpr double inside = 0.9;
    at_.curvatures = curvatures;
    at_.moves = moves.cwiseMax(-inside).cwiseMin(inside);
    const Index n = curvatures.size(), m = moves.size();
    const double energy = std::max(energyOf(curvatures), least_energy);
    const double first = 0.1 * energy / static_cast<double>(2 * m + program.shape.rows());
    const double size = std::max(1e-3, curvatures.cwiseAbs().maxCoeff());
    at_.slacks = (slackOf(curvatures)).max(0.01 * size);
    at_.shape = first / at_.slacks;
    at_.lower = first / (1 + at_.moves.array());
    at_.upper = first / (1 - at_.moves.array());
    at_.equations = VectorXd::Zero(n);
  }

  const ProgramPoint& at() const { return at_; }

  double energyOf(const VectorXd& curvatures) const {
    return curvatures.dot(program_.energy * curvatures) / 2;
  }
  /// The sum of the products of slacks and multipliers: the energy is above the least one by it.
  double complementarity() const {
    return (at_.shape * at_.slacks).sum() + (at_.lower * (1 + at_.moves.array())).sum() +
           (at_.upper * (1 - at_.moves.array())).sum();
  }
  double bounds() const {
    return static_cast<double>(2 * at_.moves.size() + program_.shape.rows());
  }
  /// The largest miss of an equation or a slack.
  double miss() const {
    const VectorXd slacks = (at_.slacks - slackOf(at_.curvatures)).matrix();
    return std::max(slacks.lpNorm<Eigen::Infinity>(), equationMiss().lpNorm<Eigen::Infinity>());
  }

  /// \returns false if the equations are singular.
  bool step(double barrier) {
    const ArrayXd below = 1 + at_.moves.array(), above = 1 - at_.moves.array();
    const ArrayXd stiff = at_.lower / below + at_.upper / above;
    const ArrayXd shape_stiff = at_.shape / at_.slacks;
    const ArrayXd slack_miss = slackOf(at_.curvatures) - at_.slacks;
    // Gradients of the Lagrangian with the multipliers of the bounds eliminated.
    const VectorXd of_curvatures =
        program_.energy * at_.curvatures + program_.curvatures.transpose() * at_.equations -
        program_.shape.transpose() * (barrier / at_.slacks - shape_stiff * slack_miss).matrix();
    const VectorXd of_moves = -(program_.moves.transpose() * at_.equations) +
                              (barrier / above - barrier / below).matrix();
    const VectorXd of_equations = equationMiss();
    const Index n = at_.curvatures.size();
    if (!factorise(shape_stiff, stiff)) return false;
    const ArrayXd free_moves = -of_moves.array() / stiff;
    VectorXd right(2 * n);
    right << -of_curvatures, -of_equations + program_.moves * free_moves.matrix();
    const VectorXd change = solved(right);
    if (!change.allFinite()) return false;
    const VectorXd curvatures = change.head(n), equations = change.tail(n);
    const ArrayXd moves = free_moves + (program_.moves.transpose() * equations).array() / stiff;
    const ArrayXd slacks = slack_miss + (program_.shape * curvatures).array();
    take(curvatures, moves, slacks, equations, barrier);
    return true;
  }

 private:
  static constexpr double least_energy = 1e-12;

  ArrayXd slackOf(const VectorXd& curvatures) const {
    return (program_.shape * curvatures - program_.margins).array();
  }
  VectorXd equationMiss() const {
    return program_.curvatures * at_.curvatures - program_.moves * at_.moves - program_.right;
  }

  bool factorise(const ArrayXd& shape_stiff, const ArrayXd& stiff) {
    // The matrix [D + S' S stiff, A'; A, -J J' / stiff] is quasi-definite, so that no pivots are
    // needed; D is singular for a constant, which the small diagonal mends.
    constexpr double small = 1e-11;
    const Index n = at_.curvatures.size();
    const SparseMatrix scaled = program_.moves * (1 / stiff).matrix().asDiagonal();
    const SparseMatrix lower = scaled * program_.moves.transpose();
    const SparseMatrix shaped = shape_stiff.matrix().asDiagonal() * program_.shape;
    const SparseMatrix upper = program_.shape.transpose() * shaped;
    std::vector<Eigen::Triplet<double>> entries;
    const auto append = [&](const SparseMatrix& block, Index row, Index column, double factor) {
      for (Index outer = 0; outer < block.outerSize(); ++outer)
        for (SparseMatrix::InnerIterator it(block, outer); it; ++it)
          entries.emplace_back(row + it.row(), column + it.col(), factor * it.value());
    };
    append(program_.energy, 0, 0, 1);
    append(upper, 0, 0, 1);
    append(program_.curvatures, n, 0, 1);
    append(lower, n, n, -1);
    for (Index i = 0; i < n; ++i) {
      entries.emplace_back(i, i, small);
      entries.emplace_back(n + i, n + i, -small);
    }
    matrix_.resize(2 * n, 2 * n);
    matrix_.setFromTriplets(entries.begin(), entries.end());
    // All steps have the same pattern.
    if (factor_.rows() == 0) factor_.analyzePattern(matrix_);
    factor_.factorize(matrix_);
    return factor_.info() == Eigen::Success;
  }

  /// With one correction, which removes the rounding of a factorisation without pivots.
  VectorXd solved(const VectorXd& right) const {
    const VectorXd first = factor_.solve(right);
    const VectorXd rest = right - matrix_.selfadjointView<Eigen::Lower>() * first;
    return first + factor_.solve(rest);
  }

  void take(const VectorXd& curvatures, const ArrayXd& moves, const ArrayXd& slacks,
            const VectorXd& equations, double barrier) {
    const ArrayXd below = 1 + at_.moves.array(), above = 1 - at_.moves.array();
    const ArrayXd shape = (barrier - at_.shape * slacks) / at_.slacks - at_.shape;
    const ArrayXd lower = (barrier - at_.lower * moves) / below - at_.lower;
    const ArrayXd upper = (barrier + at_.upper * moves) / above - at_.upper;
    const double primal = std::min({shareToBound(below, moves), shareToBound(above, -moves),
                                    shareToBound(at_.slacks, slacks)});
    const double dual = std::min({shareToBound(at_.lower, lower), shareToBound(at_.upper, upper),
                                  shareToBound(at_.shape, shape)});
    at_.curvatures += primal * curvatures;
    at_.moves += primal * moves.matrix();
    at_.slacks += primal * slacks;
    at_.equations += dual * equations;
    at_.lower += dual * lower;
    at_.upper += dual * upper;
    at_.shape += dual * shape;
  }

  const CurvatureProgram& program_;
  ProgramPoint at_;
  SparseMatrix matrix_;
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> factor_;
};

}  // namespace

CurvatureSolution solve(const CurvatureProgram& program, const Eigen::VectorXd& curvatures,
                        const Eigen::VectorXd& moves) {
  // Four digits of the energy: the program is linearised, and solved again.
  constexpr double precision = 1e-5, centring = 0.2, equation_precision = 1e-8;
  constexpr int most_steps = 80;
  const Refutation refutation(program);
  ProgramSteps steps(program, curvatures, moves);
  CurvatureSolution result;
  while (result.steps < most_steps) {
    const double energy = steps.energyOf(steps.at().curvatures);
    const double gap = steps.complementarity();
    const double small = precision * energy + 1e-14;
    if (gap < small && steps.miss() < equation_precision) {
      result.converged = true;
      break;
    }
    const double barrier = std::max(centring * gap, small / 4) / steps.bounds();
    if (!steps.step(barrier)) break;
    ++result.steps;
    if (refutation.refutes(steps.at().shape)) break;
  }
  result.curvatures = steps.at().curvatures;
  result.moves = steps.at().moves;
  return result;
}

}  // namespace seamwright
