// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

/// The nearest solution of a sparse homogeneous system, and the best change of what the system
/// depends on; not a public header.
namespace seamwright::network {

/// min 1/2 sum pull |x - target|^2 subject to A x = 0, the columns of x independently; pull 0: the
/// row of x stays. A may have rows that depend on each other: with D = pull^(-1/2) (0 where a row
/// stays) the multipliers solve (A D^2 A' + shift) nu = A x, the shift being far below what counts
/// of A D^2 A'. Refinement, and after it an orthogonal factorisation of D A' (of up to 2000 rows)
/// where the square of A's condition hides what can be reached, end where A x is rounding, or is
/// what no move can reach.
struct Projection {
  Eigen::MatrixXd x;
  Eigen::MatrixXd multipliers;  ///< of the rows of A divided by their lengths
  Eigen::VectorXd row_scale;
  double cost = 0;         ///< sum of pull |x - target|^2
  double unreachable = 0;  ///< length of the scaled A x
  double rounding =
      0;  ///< largest length of a row of A x, relative to the sum of the row's coefficients
};

/// Factors one matrix after another. The order of elimination, which takes as long, is found again
/// only where the pattern changes.
class OrderedFactors {
 public:
  using Solver = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

  /// \param lower its lower triangle is read
  const Solver& factor(const Eigen::SparseMatrix<double>& lower);

 private:
  std::vector<int> begins_, rows_;
  Solver solver_;
};

Projection project(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& pull,
                   const Eigen::MatrixXd& target, OrderedFactors& factors);

/// The step of parameters that Gauss and Newton's method takes: A x + A D z + G dy = 0 to first
/// order with the smallest z, G being the derivative of A x by the parameters, its rows those of
/// x's first column, then of the second, .. The cost includes damping times |dy|^2, dy in units of
/// what it does to A x, its rows divided by their lengths.
struct Step {
  Eigen::VectorXd change;  ///< dy
  double decrease = 0;     ///< of the cost, that it promises
};
Step step(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& pull,
          const Eigen::MatrixXd& target, const Projection& at, const Eigen::SparseMatrix<double>& g,
          double damping, OrderedFactors& factors);

}  // namespace seamwright::network
