// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/QR>
#include <optional>
#include <type_traits>

/// Decompositions of dense matrices; not a public header. They are Eigen's, compiled once: each
/// file that names one of Eigen's templates compiles it again, for seconds.
namespace seamwright::linear {

/// An expression as the vector or matrix that it is.
template <class Values>
using Plain = std::conditional_t<Values::ColsAtCompileTime == 1, Eigen::VectorXd, Eigen::MatrixXd>;

/// The x of least length among those that make |a x - b| least, by a complete orthogonal
/// decomposition.
class LeastSquares {
 public:
  LeastSquares() = default;
  /// \param threshold share of the largest pivot up to which a pivot counts as 0; Eigen's choice if
  /// none is given.
  explicit LeastSquares(const Eigen::MatrixXd& a, std::optional<double> threshold = {});

  /// One right side a column: an Eigen::VectorXd for a vector, else an Eigen::MatrixXd.
  template <class Right>
  auto solve(const Eigen::MatrixBase<Right>& b) const {
    return solved(Plain<Right>(b));
  }
  /// For the transposed of a.
  Eigen::MatrixXd solveTransposed(const Eigen::MatrixXd& b) const;

 private:
  Eigen::VectorXd solved(const Eigen::VectorXd& b) const;
  Eigen::MatrixXd solved(const Eigen::MatrixXd& b) const;

  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition_;
};

/// a P = Q R, the columns chosen by size.
class PivotedQr {
 public:
  PivotedQr() = default;
  explicit PivotedQr(const Eigen::MatrixXd& a);

  Eigen::Index rows() const { return decomposition_.rows(); }
  Eigen::Index cols() const { return decomposition_.cols(); }
  /// Least squares, right sides as of LeastSquares; where columns are dependent some unknowns are
  /// 0.
  template <class Right>
  auto solve(const Eigen::MatrixBase<Right>& b) const {
    return solved(Plain<Right>(b));
  }

  Eigen::MatrixXd timesQ(const Eigen::MatrixXd& rows) const;            ///< Q rows
  Eigen::MatrixXd timesTransposedQ(const Eigen::MatrixXd& rows) const;  ///< Q' rows
  const Eigen::MatrixXd& matrixQR() const {
    return decomposition_.matrixQR();
  }  ///< R is its upper triangle
  const auto& permutation() const { return decomposition_.colsPermutation(); }  ///< P

 private:
  Eigen::VectorXd solved(const Eigen::VectorXd& b) const;
  Eigen::MatrixXd solved(const Eigen::MatrixXd& b) const;

  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition_;
};

/// a = u diag(values) v', by Jacobi's method; values fall.
struct SingularValues {
  Eigen::VectorXd values;
  Eigen::MatrixXd u, v;  ///< empty unless asked for
};
/// \param parts which of u and v: Eigen::ComputeFullU, ComputeThinU, ComputeFullV, ComputeThinV; 0
/// for none.
SingularValues singularValues(const Eigen::MatrixXd& a, unsigned parts = 0);

/// Of a symmetric matrix; values rise, vectors are columns.
struct Eigenvalues {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
Eigenvalues symmetricEigenvalues(const Eigen::MatrixXd& a);

/// Orthonormal columns span the x with a x = 0, by the pivoted QR of the transposed; there may be
/// none.
/// \param threshold share of the largest pivot up to which a pivot counts as 0.
Eigen::MatrixXd nullSpace(const Eigen::MatrixXd& a, double threshold);

/// Columns span the x with a x = 0, by Gauss's elimination; there may be none.
/// \param threshold as of LeastSquares.
Eigen::MatrixXd kernel(const Eigen::MatrixXd& a, std::optional<double> threshold = {});

}  // namespace seamwright::linear
