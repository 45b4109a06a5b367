// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include <seamwright/occ_adapter/repair/hessian.hpp>

namespace seamwright::occ {

Eigen::MatrixXd hessianShares(const PoleShares& shares, const SurfaceJet& jet,
                              double least_metric) {
  Eigen::Matrix2d metric;
  metric << jet.u.dot(jet.u), jet.u.dot(jet.v), jet.u.dot(jet.v), jet.v.dot(jet.v);
  metric.diagonal().array() += least_metric;
  const Eigen::Matrix2d inverse = metric.inverse();
  // Christoffel symbols of the second kind: the tangential part of the second derivatives.
  const auto covariant = [&](int row, const Eigen::Vector3d& second) -> Eigen::RowVectorXd {
    const Eigen::Vector2d gamma = inverse * Eigen::Vector2d(jet.u.dot(second), jet.v.dot(second));
    return shares.share.row(row) - gamma[0] * shares.share.row(1) - gamma[1] * shares.share.row(2);
  };
  const Eigen::RowVectorXd uu = covariant(3, jet.uu), uv = covariant(4, jet.uv),
                           vv = covariant(5, jet.vv);
  const Eigen::Matrix2d lower = metric.llt().matrixL();
  const Eigen::Matrix2d frame = lower.inverse();  // its rows are the frame's axes in parameters
  const auto along = [&](int a, int b) -> Eigen::RowVectorXd {
    return frame(a, 0) * frame(b, 0) * uu +
           (frame(a, 0) * frame(b, 1) + frame(a, 1) * frame(b, 0)) * uv +
           frame(a, 1) * frame(b, 1) * vv;
  };
  Eigen::MatrixXd rows(3, uu.size());
  rows << along(0, 0), along(1, 1), std::sqrt(2.0) * along(0, 1);
  return rows;
}

}  // namespace seamwright::occ
