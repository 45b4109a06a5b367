// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

/// The nearest solution of a sparse homogeneous system, and the best step of the parameters that
/// the system depends on; not a public header.
namespace seamwright::network {

/// The solution of min 1/2 sum w |x - target|^2 subject to A x = 0, for each column of x
/// independently. \p weights holds the weight w of each row of x; if it is 0, the row stays. Rows
/// of A may be linearly dependent. With D = w^(-1/2) (0 where a row stays) the multipliers solve (A
/// D^2 A' + shift) nu = A x, where the shift is far below the significant part of A D^2 A'.
/// Iterative refinement follows. If the square of A's condition hides what can be reached, an
/// orthogonal factorisation of D A' (of up to 2000 rows) is used after it. Both end when A x is
/// rounding or is unreachable by any move.
struct Projection {
  Eigen::MatrixXd x;
  Eigen::MatrixXd multipliers;  ///< for the rows of A divided by their lengths
  Eigen::VectorXd row_scale;
  double cost = 0;         ///< sum of weight |x - target|^2
  double unreachable = 0;  ///< length of the scaled A x that no move can reach
  double rounding =
      0;  ///< largest length of a row of A x, relative to the sum of the row's coefficients
};

/// Factors one matrix after another. The order of elimination takes as long as the factorisation
/// itself, so it is computed again only if the pattern changes.
class OrderedFactors {
 public:
  using Solver = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

  /// \param lower only the lower triangle is read
  const Solver& factor(const Eigen::SparseMatrix<double>& lower);

 private:
  std::vector<int> begins_, rows_;
  Solver solver_;
};

Projection project(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& weights,
                   const Eigen::MatrixXd& target, OrderedFactors& factors);

/// The Gauss-Newton step of the parameters: A x + A D z + G dy = 0 to first order with the smallest
/// z. G is the derivative of A x by the parameters; its rows belong to the first column of x, then
/// to the second, and so on. The cost includes damping times |dy|^2, where dy is measured by the
/// change it makes in A x with rows divided by their lengths.
struct Step {
  Eigen::VectorXd change;  ///< dy
  double decrease = 0;     ///< predicted decrease of the cost
};
Step step(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& weights,
          const Eigen::MatrixXd& target, const Projection& at, const Eigen::SparseMatrix<double>& g,
          double damping, OrderedFactors& factors);

}  // namespace seamwright::network
