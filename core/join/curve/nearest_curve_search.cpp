// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <seamwright/core/join/curve/bell.hpp>
#include <seamwright/core/join/curve/beta.hpp>
#include <seamwright/core/join/curve/nearest_curve_search.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::nearest_curve {

namespace {

/// Share of the largest singular value below which an equation does not depend on the movable
/// poles.
constexpr double rank_share = 1e-13;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double dot(const MatrixXd& a, const MatrixXd& b) {
  return a.cwiseProduct(b).sum();
}

double binomial(Index n, Index k) {
  double result = 1;
  for (Index i = 1; i <= k; ++i) result *= static_cast<double>(n - k + i) / static_cast<double>(i);
  return result;
}

/// d B / d beta_q, B being the matrix of beta: C(k, q) B_(k-q)(j-1).
MatrixXd betaDerivative(const MatrixXd& B, Index q) {
  MatrixXd result = MatrixXd::Zero(B.rows(), B.cols());
  for (Index k = q; k < B.rows(); ++k)
    for (Index j = 1; j <= k; ++j) result(k, j) = binomial(k, q) * B(k - q, j - 1);
  return result;
}

/// The equations C(beta) x = 0 of the join and the nearest x that solves them. Rows of C are scaled
/// to length 1. The orthogonal combinations \c upper depend on the movable poles; the others, \c
/// lower, are conditions on beta.
struct Iterate {
  VectorXd log_beta;  ///< log beta_1, beta_2, .., beta_n
  MatrixXd B, C;
  VectorXd row_scale;
  MatrixXd upper, lower;  ///< combinations, one a column
  linear::PivotedQr qr;   ///< of the transposed of upper' C G, G being the reach
  MatrixXd x, y;          ///< the poles; their move z by the orthonormal columns of qr
  MatrixXd open;          ///< lower' C x
  double noise = 0;       ///< of y

  MatrixXd Q(const MatrixXd& rows) const { return qr.timesQ(padded(rows, qr.rows())); }
  MatrixXd transposedQ(const MatrixXd& rows) const {
    return qr.timesTransposedQ(rows).topRows(qr.cols());
  }
  /// The y of the smallest z with upper' C G z = rhs.
  MatrixXd least(const MatrixXd& rhs) const {
    if (rhs.rows() == 0) return rhs;
    return triangle().transpose().triangularView<Eigen::Lower>().solve(
        qr.permutation().transpose() * rhs);
  }
  /// The m with G' C' upper m = z, where z has these y.
  MatrixXd multipliers(const MatrixXd& y_of_z) const {
    return qr.permutation() * triangle().triangularView<Eigen::Upper>().solve(y_of_z);
  }
  double cost() const { return y.squaredNorm() / 2; }
  double infeasibility() const { return open.norm(); }
  bool isFinite() const { return x.allFinite() && open.allFinite(); }

 private:
  static MatrixXd padded(const MatrixXd& rows, Index count) {
    MatrixXd result = MatrixXd::Zero(count, rows.cols());
    result.topRows(rows.rows()) = rows;
    return result;
  }
  MatrixXd triangle() const { return qr.matrixQR().topRows(qr.cols()); }
};

/// First-order changes by each entry of log_beta.
struct Linear {
  std::vector<MatrixXd> by_beta;  ///< C
  std::vector<MatrixXd> tangent;  ///< y
  MatrixXd along, conditions;     ///< y and the open equations, a column each
  VectorXd gradient;              ///< of the cost
  /// Unit of each beta: the inverse of its effect on the poles or, if it has none, on the
  /// equations.
  VectorXd unit;
  bool bounded = false;  ///< beta_1 stays at a bound, its unit is 0
};

struct Restoration {
  VectorXd direction;
  MatrixXd open;         ///< directions that keep all equations, one per column
  MatrixXd multipliers;  ///< of the equations
  double penalty = 0;
};

struct Step {
  VectorXd direction;
  double stationarity = 0;
  double penalty = 0;  ///< weight of the infeasibility, above the size of the multipliers
  bool convex = true;
  bool bounded = false;
};

class Search {
 public:
  explicit Search(const Problem& problem) : p_(problem), count_(problem.beta.size() + 1) {
    given_.resize(2 * count_, 3);
    given_ << p_.a.points, p_.b.points;
    VectorXd reach(2 * count_);
    reach << p_.a.reach, p_.b.reach;
    for (Index i = 0; i < reach.size(); ++i)
      if (reach(i) > 0) movable_.push_back(i);
    reach_.resize(std::ssize(movable_));
    for (Index i = 0; i < reach_.size(); ++i) reach_(i) = reach(movable_[i]);
    if (reach_.size() > 0) reach_ /= reach_.maxCoeff();
  }

  Iterate at(const VectorXd& log_beta) const;
  /// \param most_log of log beta_1; the search stops above it.
  Found run(double most_log) const;
  bool holds(const Iterate& at, const MatrixXd& x) const {
    return ((at.C * x).cwiseAbs().array() <= 32 * rounding(at, x).array()).all();
  }
  VectorXd first() const {
    VectorXd log_beta = p_.beta;
    log_beta(0) = std::log(log_beta(0));
    return log_beta;
  }
  const MatrixXd& given() const { return given_; }

 private:
  MatrixXd moving(const MatrixXd& rows) const {
    MatrixXd result(reach_.size(), rows.cols());
    for (Index i = 0; i < reach_.size(); ++i) result.row(i) = rows.row(movable_[i]);
    return result;
  }
  /// Of the equations.
  MatrixXd rounding(const Iterate& at, const MatrixXd& x) const {
    return machine_epsilon *
           (at.C.cwiseAbs() * (x.cwiseAbs().array() + p_.rounding / machine_epsilon).matrix());
  }
  std::vector<MatrixXd> matrixDerivatives(const Iterate& at) const;
  MatrixXd curvature(const Iterate& at, const MatrixXd& multipliers) const;
  Linear linearized(const Iterate& at) const;
  Restoration restoration(const Iterate& at, const Linear& model) const;
  MatrixXd hessian(const Iterate& at, const Linear& model, const MatrixXd& multipliers) const;
  Step step(const Iterate& at) const;
  bool advance(Iterate& from, const Step& step) const;

  const Problem& p_;
  Index count_;  ///< of equations
  MatrixXd given_;
  std::vector<Index> movable_;
  VectorXd reach_;  ///< of the movable
};

Iterate Search::at(const VectorXd& log_beta) const {
  Iterate at;
  at.log_beta = log_beta;
  VectorXd beta = log_beta;
  beta(0) = std::exp(beta(0));
  at.B = bellMatrix<double>(beta);
  at.C.resize(count_, 2 * count_);
  at.C << -at.B * p_.a.jet, p_.b.jet;
  at.row_scale = at.C.rowwise().norm().cwiseInverse();
  at.C = at.row_scale.asDiagonal() * at.C;

  const MatrixXd reached = moving(at.C.transpose()).transpose();
  Index rank = 0;
  at.upper = MatrixXd::Identity(count_, count_);
  if (reached.cols() > 0) {
    linear::SingularValues svd = linear::singularValues(reached, Eigen::ComputeFullU);
    while (rank < svd.values.size() && svd.values(rank) > rank_share * svd.values(0)) ++rank;
    at.upper = std::move(svd.u);
  }
  at.lower = at.upper.rightCols(count_ - rank);
  at.upper = at.upper.leftCols(rank).eval();
  at.x = given_;
  at.y = MatrixXd::Zero(rank, 3);
  if (rank > 0) {
    at.qr = linear::PivotedQr(reach_.asDiagonal() * (reached.transpose() * at.upper));
    for (int pass = 0; pass < 3; ++pass) {
      at.y -= at.least(at.upper.transpose() * (at.C * at.x));
      const MatrixXd z = at.Q(at.y);
      for (Index i = 0; i < reach_.size(); ++i)
        at.x.row(movable_[i]) = given_.row(movable_[i]) + reach_(i) * z.row(i);
    }
  }
  at.open = at.lower.transpose() * (at.C * at.x);
  at.noise = 4 * at.least(MatrixXd::Identity(rank, rank)).norm() * rounding(at, at.x).norm();
  return at;
}

/// Of B by log_beta, its rows scaled.
std::vector<MatrixXd> Search::matrixDerivatives(const Iterate& at) const {
  std::vector<MatrixXd> result;
  for (Index q = 1; q < count_; ++q)
    result.push_back(at.row_scale.asDiagonal() * betaDerivative(at.B, q));
  result[0] *= std::exp(at.log_beta(0));
  return result;
}

/// The second derivatives by log_beta of multipliers' C x.
MatrixXd Search::curvature(const Iterate& at, const MatrixXd& multipliers) const {
  const MatrixXd jet = p_.a.jet * at.x.topRows(count_);
  const MatrixXd pairs = at.row_scale.asDiagonal() * multipliers * jet.transpose();
  const double beta1 = std::exp(at.log_beta(0));
  MatrixXd result = MatrixXd::Zero(count_ - 1, count_ - 1);
  for (Index q = 1; q < count_; ++q)
    for (Index r = 1; r < count_; ++r) {
      double sum = 0;
      for (Index k = q + r; k < count_; ++k)
        for (Index j = 2; j <= k; ++j)
          sum -= binomial(k, q) * binomial(k - q, r) * at.B(k - q - r, j - 2) * pairs(k, j);
      result(q - 1, r - 1) = sum * (q == 1 ? beta1 : 1) * (r == 1 ? beta1 : 1);
    }
  result(0, 0) -= beta1 * betaDerivative(at.B, 1).cwiseProduct(pairs).sum();
  return result;
}

Linear Search::linearized(const Iterate& at) const {
  const Index n = count_ - 1;
  const MatrixXd jet = p_.a.jet * at.x.topRows(count_);
  Linear result;
  result.by_beta = matrixDerivatives(at);
  result.conditions.resize(at.open.size(), n);
  result.along.resize(3 * at.y.rows(), n);
  result.gradient.resize(n);
  result.unit.resize(n);
  for (Index q = 0; q < n; ++q) {
    const MatrixXd change = -result.by_beta[q] * jet;
    result.tangent.push_back(at.least(at.upper.transpose() * change));
    result.conditions.col(q) = (at.lower.transpose() * change).reshaped();
    result.along.col(q) = result.tangent[q].reshaped();
    result.gradient(q) = -dot(at.y, result.tangent[q]);
    const double size = std::max(result.along.col(q).norm(), result.conditions.col(q).norm());
    result.unit(q) = size > 0 ? 1 / size : 0;
  }
  const double u = at.log_beta(0);
  if ((u <= p_.least_log && result.gradient(0) > 0) ||
      (u >= p_.most_log && result.gradient(0) < 0)) {
    result.bounded = result.unit(0) > 0;
    result.unit(0) = 0;
  }
  return result;
}

/// The smallest step that satisfies all equations to first order, and the directions that keep
/// them.
Restoration Search::restoration(const Iterate& at, const Linear& model) const {
  const Index n = count_ - 1;
  const VectorXd& unit = model.unit;
  Restoration result;
  result.direction = VectorXd::Zero(n);
  result.multipliers =
      at.y.rows() > 0 ? MatrixXd(-at.upper * at.multipliers(at.y)) : MatrixXd::Zero(count_, 3);
  result.open = unit.asDiagonal() * MatrixXd::Identity(n, n);
  if (model.conditions.rows() == 0) return result;

  const linear::SingularValues svd = linear::singularValues(
      model.conditions * unit.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeFullV);
  const VectorXd& singular = svd.values;
  Index held = 0;
  // Columns have length 1. Others than held directions have rounding of 1e-13 to 1e-11.
  constexpr double least_held = 1e-9;
  while (held < singular.size() && singular(held) > least_held) ++held;
  const VectorXd inverse = singular.head(held).cwiseInverse();
  const MatrixXd range = svd.u.leftCols(held), fixed = svd.v.leftCols(held);
  result.direction.array() =
      -unit.array() *
      (fixed * inverse.asDiagonal() * (range.transpose() * at.open.reshaped())).array();
  const VectorXd mu =
      -range * inverse.asDiagonal() * (fixed.transpose() * unit.asDiagonal() * model.gradient);
  result.multipliers += at.lower * mu.reshaped(at.lower.cols(), 3);
  result.penalty = 2 * mu.norm();
  result.open = unit.asDiagonal() * svd.v.rightCols(n - held);
  return result;
}

/// Of the cost, by the betas.
MatrixXd Search::hessian(const Iterate& at, const Linear& model,
                         const MatrixXd& multipliers) const {
  MatrixXd result = curvature(at, multipliers);
  if (at.y.rows() == 0) return result;
  const Index n = count_ - 1;
  const std::vector<MatrixXd>& tangent = model.tangent;
  std::vector<MatrixXd> bent_along, bent_across;
  for (Index q = 0; q < n; ++q) {
    MatrixXd rows = MatrixXd::Zero(2 * count_, 3);
    rows.topRows(count_) = -p_.a.jet.transpose() * (model.by_beta[q].transpose() * multipliers);
    const MatrixXd bent = reach_.asDiagonal() * moving(rows);
    bent_along.push_back(at.transposedQ(bent));
    bent_across.push_back(bent - at.Q(bent_along[q]));
  }
  for (Index q = 0; q < n; ++q)
    for (Index r = 0; r < n; ++r)
      result(q, r) += dot(tangent[q], tangent[r]) - dot(bent_along[q], tangent[r]) -
                      dot(tangent[q], bent_along[r]) - dot(bent_across[q], bent_across[r]);
  return result;
}

/// Newton's step for the smallest cost among the betas that satisfy all equations.
Step Search::step(const Iterate& at) const {
  const Linear model = linearized(at);
  const Restoration restored = restoration(at, model);
  const MatrixXd hessian = this->hessian(at, model, restored.multipliers);
  Step result{
      .direction = restored.direction, .penalty = restored.penalty, .bounded = model.bounded};

  const MatrixXd& open = restored.open;
  const MatrixXd reach = model.along * open;
  const double move = at.y.norm();
  if (open.cols() > 0 && at.y.rows() > 0) {
    const linear::Eigenvalues eigen =
        linear::symmetricEigenvalues(open.transpose() * hessian * open);
    const VectorXd& values = eigen.values;
    // Smaller eigenvalues are rounding. The sign of one is certain only far above that.
    const double least = 1e-12 * values.cwiseAbs().maxCoeff();
    result.convex = values(0) >= -1e-9 * std::max(1.0, values.cwiseAbs().maxCoeff());
    const VectorXd slope = open.transpose() * (model.gradient + hessian * result.direction);
    // 1e-300 stands for zero: it keeps quotients from being undefined where all eigenvalues are
    // zero.
    const VectorXd size = values.cwiseAbs().cwiseMax(std::max(least, 1e-300));
    const VectorXd share = linear::LeastSquares(reach).solve(at.y.reshaped());
    result.stationarity = move > 0 ? (reach * share).norm() / move : 0;
    VectorXd newton = -(eigen.vectors.transpose() * slope).cwiseQuotient(size);
    // At a saddle the cost falls on both sides, so any direction works.
    if (!result.convex && result.stationarity < 1e-6)
      newton(0) = newton(0) < 0 ? -0.1 * move : 0.1 * move;
    result.direction += open * (eigen.vectors * newton);
  }
  // The nearest join of all is no farther from the given poles than this one: no step needs to
  // change the move by more than twice its size; and beta_1 not by more than a factor of ten.
  const double change = (model.along * result.direction).norm();
  constexpr double log_of_ten = 2.3;  // rounded, as the factor is a choice
  double share = std::min(1.0, log_of_ten / std::max(std::abs(result.direction(0)), 1e-300));
  if (at.lower.cols() == 0 && change > 2 * move) share = std::min(share, 2 * move / change);
  result.direction *= share;
  const double increase = result.direction.dot(model.gradient + hessian * result.direction / 2);
  if (at.infeasibility() > 0 && increase > 0)
    result.penalty = std::max(result.penalty, 2 * increase / at.infeasibility());
  return result;
}

/// Halves the step until it lowers cost plus penalty times infeasibility. False if no share of the
/// step does.
bool Search::advance(Iterate& from, const Step& step) const {
  const double before = from.cost() + step.penalty * from.infeasibility();
  const double rounding = from.noise * (from.noise + from.y.norm() + step.penalty);
  // Smaller shares change the cost by less than its rounding.
  for (double share = 1; share > 1e-9; share /= 2) {
    VectorXd log_beta = from.log_beta + share * step.direction;
    if (!log_beta.allFinite()) continue;
    log_beta(0) = std::clamp(log_beta(0), p_.least_log, p_.most_log);
    Iterate trial = at(log_beta);
    if (!trial.isFinite()) continue;
    if (trial.cost() + step.penalty * trial.infeasibility() <= before + rounding) {
      from = std::move(trial);
      return true;
    }
  }
  return false;
}

Found Search::run(double most_log) const {
  Found result;
  Iterate now = at(first()), best = now;
  if (!p_.held) {
    Step next = step(now), best_step = next;
    const auto resolved = [&](const Iterate& i, double stationarity) {
      return stationarity * i.y.norm() <= i.noise + 1e-14 * i.y.norm();
    };
    int stalls = 0;
    while (result.iterations < p_.max_iterations && stalls < 3 && now.log_beta(0) <= most_log) {
      // Continue below rounding as long as it helps, because Newton's last step gives beta its last
      // digits.
      if (next.convex && stalls > 0 && resolved(now, next.stationarity) && holds(now, now.x)) break;
      ++result.iterations;
      if (!advance(now, next)) break;
      next = step(now);
      const bool better = now.infeasibility() < 0.5 * best.infeasibility() ||
                          next.stationarity < 0.5 * best_step.stationarity;
      stalls = better || next.stationarity > 1e-7 || !next.convex ? 0 : stalls + 1;
      if (better || next.stationarity > 1e-7 || next.stationarity < best_step.stationarity) {
        best = now;
        best_step = next;
      }
    }
    result.stationarity = best_step.stationarity;
    result.bounded = best_step.bounded;
    result.stationary = best_step.convex && !best_step.bounded &&
                        (best_step.stationarity <= 1e-10 || resolved(best, best_step.stationarity));
  } else {
    result.stationary = true;
  }
  result.beta = best.log_beta;
  result.beta(0) = std::exp(result.beta(0));
  result.moves = best.x - given_;
  result.cost = best.cost();
  result.exact = holds(best, best.x);
  return result;
}

/// Whether any pole of that side moves.
bool moves(const Side& side) {
  return (side.reach.array() > 0).any();
}

/// The problem with both curves reversed and exchanged.
Problem mirrored(const Problem& problem) {
  Problem result = problem;
  std::swap(result.a, result.b);
  for (Side* side : {&result.a, &result.b})
    for (Index k = 1; k < side->jet.rows(); k += 2) side->jet.row(k) *= -1;
  result.beta = reversedBeta(problem.beta);
  result.least_log = -problem.most_log;
  result.most_log = -problem.least_log;
  return result;
}

}  // namespace

bool holds(const Problem& problem) {
  const Search search(problem);
  return search.holds(search.at(search.first()), search.given());
}

namespace {

/// Searches from one side. Derivatives of b are polynomials in beta, those of a have beta_1 in the
/// denominator. So a is the curve that stays or, if both move, the curve whose first derivative
/// does not become much shorter than that of the other. Then beta is small and the valleys of the
/// cost are straight.
Found searchFrom(const Problem& problem, bool is_mirrored) {
  constexpr double turning_log = 0.7;  // beta_1 = 2
  const bool both = moves(problem.a) && moves(problem.b);
  Problem now = is_mirrored ? mirrored(problem) : problem;
  Found found = Search(now).run(both ? turning_log : now.most_log);
  int iterations = found.iterations;
  while (both && std::log(found.beta(0)) > turning_log && iterations < problem.max_iterations) {
    now.beta = found.beta;
    now = mirrored(now);
    is_mirrored = !is_mirrored;
    now.max_iterations = problem.max_iterations - iterations;
    found = Search(now).run(turning_log);
    iterations += found.iterations;
  }
  found.iterations = iterations;
  if (is_mirrored) {
    const Index count = found.moves.rows() / 2;
    const MatrixXd of_b = found.moves.topRows(count), of_a = found.moves.bottomRows(count);
    found.moves << of_a, of_b;
    found.beta = reversedBeta(found.beta);
  }
  return found;
}

}  // namespace

Found search(const Problem& problem) {
  if (problem.held) return Search(problem).run(problem.most_log);
  if (!moves(problem.b)) return searchFrom(problem, true);
  Found found = searchFrom(problem, false);
  if (!moves(problem.a)) return found;
  // The search runs from both sides, so that both have the same role. If the joins differ, the
  // nearer one is taken.
  Found other = searchFrom(problem, true);
  const auto rank = [](const Found& f) { return 2 * f.exact + f.stationary; };
  const bool better =
      rank(other) != rank(found) ? rank(other) > rank(found) : other.cost < found.cost;
  return better ? other : found;
}

}  // namespace seamwright::nearest_curve
