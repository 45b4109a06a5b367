// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <seamwright/core/linear/dense.hpp>

namespace seamwright::linear {

LeastSquares::LeastSquares(const Eigen::MatrixXd& a, std::optional<double> threshold) {
  if (threshold) decomposition_.setThreshold(*threshold);
  decomposition_.compute(a);
}

Eigen::VectorXd LeastSquares::solved(const Eigen::VectorXd& b) const {
  return decomposition_.solve(b);
}

Eigen::MatrixXd LeastSquares::solved(const Eigen::MatrixXd& b) const {
  return decomposition_.solve(b);
}

Eigen::MatrixXd LeastSquares::solveTransposed(const Eigen::MatrixXd& b) const {
  return decomposition_.transpose().solve(b);
}

PivotedQr::PivotedQr(const Eigen::MatrixXd& a) : decomposition_(a) {}

Eigen::VectorXd PivotedQr::solved(const Eigen::VectorXd& b) const {
  return decomposition_.solve(b);
}

Eigen::MatrixXd PivotedQr::solved(const Eigen::MatrixXd& b) const {
  return decomposition_.solve(b);
}

Eigen::MatrixXd PivotedQr::timesQ(const Eigen::MatrixXd& rows) const {
  return decomposition_.householderQ() * rows;
}

Eigen::MatrixXd PivotedQr::timesTransposedQ(const Eigen::MatrixXd& rows) const {
  return decomposition_.householderQ().adjoint() * rows;
}

SingularValues singularValues(const Eigen::MatrixXd& a, unsigned parts) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, parts);
  SingularValues result{svd.singularValues(), {}, {}};
  if (svd.computeU()) result.u = svd.matrixU();
  if (svd.computeV()) result.v = svd.matrixV();
  return result;
}

Eigenvalues symmetricEigenvalues(const Eigen::MatrixXd& a) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::MatrixXd nullSpace(const Eigen::MatrixXd& a, double threshold) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a.transpose());
  qr.setThreshold(threshold);
  const Eigen::MatrixXd basis = qr.householderQ();
  return basis.rightCols(a.cols() - qr.rank());
}

Eigen::MatrixXd kernel(const Eigen::MatrixXd& a, std::optional<double> threshold) {
  Eigen::FullPivLU<Eigen::MatrixXd> lu(a.rows(), a.cols());
  if (threshold) lu.setThreshold(*threshold);
  lu.compute(a);
  return lu.dimensionOfKernel() > 0 ? Eigen::MatrixXd(lu.kernel()) : Eigen::MatrixXd(a.cols(), 0);
}

}  // namespace seamwright::linear
