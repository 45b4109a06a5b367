// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <seamwright/core/join/nearest/nearest_solver.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::nearest {

namespace {

/// Share of the largest pivot below which a row of the condition depends on the others.
constexpr double rank_share = 1e-11;

using Matrices = std::vector<Eigen::MatrixXd>;

double dot(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.cwiseProduct(b).sum();
}

/// A point of the feasible set (or near it): the nearest poles for its coefficients.
struct Iterate {
  Eigen::VectorXd c;
  Eigen::MatrixXd matrix;  ///< M, its rows scaled
  linear::LeastSquares inverse;
  Eigen::MatrixXd x, z;
  Eigen::MatrixXd unreachable;  ///< part of the condition that no move can reach
  double cost = 0;              ///< |z|^2
  bool exact = false;           ///< the condition holds up to rounding

  double infeasibility() const { return unreachable.norm(); }
};

class Search {
 public:
  Search(const Unknowns& unknowns, const Condition& condition, const Family& family,
         double smallest_alpha)
      : unknowns_(unknowns),
        condition_(condition),
        family_(family),
        smallest_alpha_(smallest_alpha) {
    reach_ = (unknowns.move_weights.array() > 0).select(unknowns.move_weights.array().rsqrt(), 0.0);
    for (Eigen::Index i = 0; i < reach_.size(); ++i)
      if (reach_(i) > 0) movable_.push_back(i);
    noise_ = 16 * machine_epsilon * unknowns.largest * std::sqrt(unknowns.move_weights.sum());
  }

  Solution run(int max_iterations);

 private:
  struct Step {
    Eigen::VectorXd direction;   ///< of c
    Eigen::MatrixXd multiplier;  ///< part of the multipliers that belongs to unreachable rows
    double stationarity = 0;     ///< share of the move that lies along the feasible set
    double penalty = 0;          ///< weight of the infeasibility, above the size of the multipliers
    bool convex = true;
  };

  /// First-order changes by each coefficient.
  struct Linear {
    Matrices tangent;  ///< z
    /// Changes of z and of the unreachable rows, one column each.
    Eigen::MatrixXd along, conditions;
    Eigen::VectorXd gradient;  ///< of the cost
    Eigen::VectorXd length;    ///< of the change of the condition
  };
  struct Split {
    Eigen::MatrixXd basis;  ///< directions of the coefficients, in units that are alike
    Eigen::MatrixXd range,
        inverse;  ///< of the conditions on that basis: inverse * range' is their pseudo-inverse
    Eigen::MatrixXd open;  ///< directions that change no condition
  };

  Iterate project(const Eigen::VectorXd& c);
  Eigen::MatrixXd reached(const Iterate& at, const Eigen::MatrixXd& rows) const {
    return at.matrix * at.inverse.solve(rows);
  }
  Eigen::MatrixXd freeBasis(const Iterate& at, const Eigen::VectorXd& gradient) const;
  Eigen::MatrixXd hessian(const Iterate& at, const Matrices& tangent,
                          const Eigen::MatrixXd& nu) const;
  Linear linearized(const Iterate& at) const;
  Split split(const Linear& model, const Eigen::MatrixXd& basis) const;
  void descend(const Iterate& at, const Linear& model, const Eigen::MatrixXd& open,
               const Eigen::MatrixXd& curvature, Step& result) const;
  Step step(const Iterate& at, const Eigen::MatrixXd& multiplier) const;
  bool advance(Iterate& at, const Step& step);
  bool isRegular(const Eigen::MatrixXd& x) const;
  bool hasPositiveWeights(const Iterate& at) const {
    return !unknowns_.rational || at.x.col(3).minCoeff() > 0;
  }
  double moveSize(const Iterate& at) const { return std::sqrt(at.cost + unknowns_.seam_cost); }

  const Unknowns& unknowns_;
  const Condition& condition_;
  const Family& family_;
  double smallest_alpha_;
  Eigen::VectorXd reach_;  ///< D
  std::vector<Eigen::Index> movable_;
  double noise_ = 0;  ///< of z
  Eigen::VectorXd
      row_scale_;  ///< Scale that makes rows of the condition comparable, from the first iterate
};

Iterate Search::project(const Eigen::VectorXd& c) {
  Iterate at;
  at.c = c;
  const Eigen::MatrixXd a = condition_.matrix(c);
  // One column of zeros if no pole moves.
  at.matrix = Eigen::MatrixXd::Zero(a.rows(), std::max<Eigen::Index>(1, std::ssize(movable_)));
  for (std::size_t k = 0; k < movable_.size(); ++k)
    at.matrix.col(static_cast<Eigen::Index>(k)) = reach_(movable_[k]) * a.col(movable_[k]);
  if (row_scale_.size() == 0) {
    const Eigen::VectorXd length = at.matrix.rowwise().norm();
    // Rows beside fixed poles are short. A larger factor would enlarge their rounding.
    const double least = 1e-3 * length.maxCoeff();
    row_scale_ = least > 0 ? Eigen::VectorXd(length.cwiseMax(least).cwiseInverse())
                           : Eigen::VectorXd::Ones(length.size());
  }
  at.matrix = row_scale_.asDiagonal() * at.matrix;
  at.inverse = linear::LeastSquares(at.matrix, rank_share);
  at.x = unknowns_.target;
  at.z = Eigen::MatrixXd::Zero(at.matrix.cols(), at.x.cols());
  for (int pass = 0; pass < 3; ++pass) {
    const Eigen::MatrixXd residual = row_scale_.asDiagonal() * (a * at.x);
    at.z -= at.inverse.solve(residual);
    for (std::size_t k = 0; k < movable_.size(); ++k)
      at.x.row(movable_[k]) = unknowns_.target.row(movable_[k]) +
                              reach_(movable_[k]) * at.z.row(static_cast<Eigen::Index>(k));
  }
  at.unreachable = row_scale_.asDiagonal() * (a * at.x);
  at.cost = at.z.squaredNorm();
  at.exact = holds(a, at.x, unknowns_.largest);
  return at;
}

/// The free coefficients without those of alpha that are at their bound and would fall below it.
Eigen::MatrixXd Search::freeBasis(const Iterate& at, const Eigen::VectorXd& gradient) const {
  Eigen::MatrixXd basis = family_.basis;
  for (int i = 0; i <= condition_.degrees()[Alpha]; ++i)
    if (at.c(i) <= smallest_alpha_ && gradient(i) > 0) basis.row(i).setZero();
  return basis;
}

Eigen::MatrixXd Search::hessian(const Iterate& at, const Matrices& tangent,
                                const Eigen::MatrixXd& nu) const {
  const Eigen::MatrixXd scaled = row_scale_.asDiagonal() * nu;
  const Matrices by_multiplier = condition_.transposed(at.c, scaled);
  Matrices h, crosswise;
  for (const Eigen::MatrixXd& whole : by_multiplier) {
    Eigen::MatrixXd part = Eigen::MatrixXd::Zero(at.matrix.cols(), whole.cols());
    for (std::size_t k = 0; k < movable_.size(); ++k)
      part.row(static_cast<Eigen::Index>(k)) = reach_(movable_[k]) * whole.row(movable_[k]);
    crosswise.push_back(part - at.inverse.solve(at.matrix * part));
    h.push_back(std::move(part));
  }
  Eigen::MatrixXd result = condition_.curvature(at.c, scaled, at.x);
  const auto count = static_cast<Eigen::Index>(h.size());
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j)
      result(i, j) += dot(tangent[i], tangent[j]) - dot(tangent[i], h[j]) - dot(h[i], tangent[j]) -
                      dot(h[i], crosswise[j]);
  return result;
}

Search::Linear Search::linearized(const Iterate& at) const {
  Matrices by_c = condition_.derivatives(at.c, at.x);
  const auto count = static_cast<Eigen::Index>(by_c.size());
  Linear result;
  result.gradient.resize(count);
  result.length.resize(count);
  result.conditions.resize(at.unreachable.size(), count);
  result.along.resize(at.z.size(), count);
  for (Eigen::Index i = 0; i < count; ++i) {
    by_c[i] = (row_scale_.asDiagonal() * by_c[i]).eval();
    result.tangent.push_back(at.inverse.solve(by_c[i]));
    result.along.col(i) = result.tangent[i].reshaped();
    result.conditions.col(i) = (by_c[i] - at.matrix * result.tangent[i]).reshaped();
    result.gradient(i) = -dot(at.z, result.tangent[i]);
    result.length(i) = by_c[i].norm();
  }
  return result;
}

/// Splits these directions into those that the conditions fix and those that they leave open.
Search::Split Search::split(const Linear& model, const Eigen::MatrixXd& basis) const {
  // Coefficients are measured by their effect on the condition. Their effect on unreachable rows
  // separates the conditions from the free directions.
  Eigen::VectorXd unit =
      (model.length.cwiseAbs2().transpose() * basis.cwiseAbs2()).transpose().cwiseSqrt();
  unit = (unit.array() > 0).select(unit.array().inverse(), 0.0);
  Split result;
  result.basis = basis * unit.asDiagonal();
  const linear::SingularValues svd = linear::singularValues(
      model.conditions * result.basis, Eigen::ComputeThinU | Eigen::ComputeFullV);
  const Eigen::VectorXd& singular = svd.values;
  Eigen::Index rank = 0;
  // Columns have length 1. Directions that the conditions hold have singular values of about that
  // size, others have rounding of 1e-13 to 1e-11.
  constexpr double held = 1e-9;
  while (rank < singular.size() && singular(rank) > held) ++rank;
  result.range = svd.u.leftCols(rank);
  result.inverse = svd.v.leftCols(rank) * singular.head(rank).cwiseInverse().asDiagonal();
  result.open = result.basis * svd.v.rightCols(result.basis.cols() - rank);
  return result;
}

/// Newton's step along the free directions, reversed to descend where the cost is concave.
void Search::descend(const Iterate& at, const Linear& model, const Eigen::MatrixXd& open,
                     const Eigen::MatrixXd& curvature, Step& result) const {
  const Eigen::VectorXd slope = open.transpose() * (model.gradient + curvature * result.direction);
  const Eigen::MatrixXd reach = model.along * open;
  const Eigen::MatrixXd first_order = reach.transpose() * reach;
  // A curvature below the square root of rounding has no certain sign: it is a sum of squares that
  // cancel.
  const double least = 1e-10 * first_order.diagonal().maxCoeff();
  const linear::Eigenvalues eigen =
      linear::symmetricEigenvalues(open.transpose() * curvature * open);
  const Eigen::VectorXd& values = eigen.values;
  result.convex = values.minCoeff() >= -least;
  const Eigen::VectorXd in_eigen = eigen.vectors.transpose() * slope;
  // 1e-300 stands for zero: it keeps quotients from being undefined where all curvatures are zero.
  const Eigen::VectorXd size = values.cwiseAbs().cwiseMax(std::max(least, 1e-300));
  result.direction -= open * (eigen.vectors * in_eigen.cwiseQuotient(size));
  const Eigen::VectorXd share = linear::LeastSquares(reach).solve(at.z.reshaped());
  const double size_of_move = moveSize(at);
  result.stationarity = size_of_move > 0 ? (reach * share).norm() / size_of_move : 0;
}

Search::Step Search::step(const Iterate& at, const Eigen::MatrixXd& multiplier) const {
  const Linear model = linearized(at);
  Step result;
  result.direction = Eigen::VectorXd::Zero(model.length.size());
  result.multiplier = Eigen::MatrixXd::Zero(at.unreachable.rows(), at.unreachable.cols());
  const Eigen::MatrixXd basis = freeBasis(at, model.gradient);
  if (basis.cols() == 0) return result;

  const Split parts = split(model, basis);
  const Eigen::MatrixXd own = multiplier.size() == 0
                                  ? result.multiplier
                                  : Eigen::MatrixXd(multiplier - reached(at, multiplier));
  Eigen::MatrixXd nu = at.inverse.solveTransposed(at.z);
  nu = own - nu;
  const Eigen::MatrixXd curvature = hessian(at, model.tangent, nu);
  result.direction =
      -parts.basis * (parts.inverse * (parts.range.transpose() * at.unreachable.reshaped()));
  if (parts.open.cols() > 0) descend(at, model, parts.open, curvature, result);

  const Eigen::VectorXd forces =
      -parts.basis.transpose() * (model.gradient + curvature * result.direction);
  const Eigen::VectorXd mu = parts.range * (parts.inverse.transpose() * forces);
  // A step must not change the condition by much more than its terms in alpha.
  const int alphas = condition_.degrees()[Alpha] + 1;
  const double change = result.direction.cwiseProduct(model.length).norm();
  const double limit = 4 * at.c.head(alphas).cwiseProduct(model.length.head(alphas)).norm();
  if (change > limit) result.direction *= limit / change;
  result.multiplier = mu.reshaped(at.unreachable.rows(), at.unreachable.cols());
  // The step removes the infeasibility to first order. The penalty is so large that the step counts
  // as a descent.
  const double increase = result.direction.dot(model.gradient + curvature * result.direction / 2);
  result.penalty = 2 * mu.norm();
  if (!at.exact && increase > 0)
    result.penalty = std::max(result.penalty, 2 * increase / at.infeasibility());
  return result;
}

/// Halves the step until it lowers cost plus penalty times infeasibility. False if no share of the
/// step does.
bool Search::advance(Iterate& at, const Step& step) {
  const int alphas = condition_.degrees()[Alpha] + 1;
  const double before = at.cost / 2 + step.penalty * at.infeasibility();
  const double rounding = noise_ * (noise_ + std::sqrt(at.cost) + step.penalty);
  // A direction of descent helps long before; a step of less is rounding.
  for (double share = 1; share > 1e-6; share /= 2) {
    Eigen::VectorXd c = at.c + share * step.direction;
    c.head(alphas) = c.head(alphas).cwiseMax(smallest_alpha_);
    Iterate trial = project(c);
    const double after = trial.cost / 2 + step.penalty * trial.infeasibility();
    if ((hasPositiveWeights(trial) || !hasPositiveWeights(at)) && after <= before + rounding) {
      at = std::move(trial);
      return true;
    }
  }
  return false;
}

/// Whether the normals are kept. Where a given side has a normal, it must keep a share of its
/// length. Where a has a normal with its seam at the target, the normal must not turn by a right
/// angle or lose nearly all of its length relative to that one.
bool Search::isRegular(const Eigen::MatrixXd& x) const {
  // As docs/nearest_joins.md states them.
  constexpr double collapsed = 1e-3, lost = 1e-6, none = 1e-6;
  const Eigen::MatrixXd target = condition_.normals(unknowns_.target, false);
  const Eigen::VectorXd length = target.rowwise().norm();
  for (const bool of_b : {false, true}) {
    Eigen::MatrixXd given = unknowns_.target;
    given.topRows(unknowns_.count()) = of_b ? unknowns_.seam_b : unknowns_.seam_a;
    const Eigen::VectorXd before = condition_.normals(given, of_b).rowwise().norm();
    const Eigen::MatrixXd after = condition_.normals(x, of_b);
    for (Eigen::Index i = 0; i < after.rows(); ++i) {
      if (before(i) <= none * before.maxCoeff()) continue;
      if (after.row(i).norm() < lost * before(i)) return false;
      if (!of_b && length(i) > none * length.maxCoeff() &&
          target.row(i).dot(after.row(i)) < collapsed * length(i) * length(i))
        return false;
    }
  }
  return true;
}

Solution Search::run(int max_iterations) {
  Solution result;
  const bool free = family_.basis.cols() > 0;
  Iterate at = project(
      free ? condition_.fitted(unknowns_.target, family_.basis, family_.held, smallest_alpha_)
           : family_.held);
  Iterate best = at;
  Step now = step(at, {});
  double best_stationarity = now.stationarity;
  bool convex = now.convex;
  const auto resolved = [&](const Iterate& i, double stationarity) {
    return stationarity * moveSize(i) <= noise_ + 1e-14 * moveSize(i);
  };
  // Above this Newton's method is still far from quadratic convergence, and a step that makes the
  // stationarity larger is not a stall. Below 1e-10 the square of it is below the rounding of
  // a cost.
  constexpr double far = 1e-7, stationary = 1e-10;
  int stalls = 0;
  while (free && result.iterations < max_iterations && stalls < 3) {
    if (resolved(at, now.stationarity) && at.exact) break;
    ++result.iterations;
    if (!advance(at, now)) break;
    now = step(at, now.multiplier);
    const bool closer = !at.exact || !best.exact ? at.infeasibility() <= best.infeasibility()
                                                 : now.stationarity < 0.5 * best_stationarity;
    stalls = closer || now.stationarity > far ? 0 : stalls + 1;
    if (closer || now.stationarity < best_stationarity || now.stationarity > far) {
      best = at;
      best_stationarity = now.stationarity;
      convex = now.convex;
    }
  }
  result.c = best.c;
  result.x = best.x;
  result.cost = best.cost;
  result.stationarity = best_stationarity;
  result.stationary =
      convex && (best_stationarity <= stationary || resolved(best, best_stationarity));
  result.exact = best.exact && hasPositiveWeights(best) && isRegular(best.x);
  return result;
}

}  // namespace

bool holds(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& x, double rounding) {
  const Eigen::VectorXd allowed =
      32 * machine_epsilon * rounding * matrix.cwiseAbs().rowwise().sum();
  return ((matrix * x).rowwise().norm().array() <= allowed.array()).all();
}

Solution solve(const Unknowns& unknowns, const Condition& condition, const Family& family,
               double smallest_alpha, int max_iterations) {
  return Search(unknowns, condition, family, smallest_alpha).run(max_iterations);
}

}  // namespace seamwright::nearest
