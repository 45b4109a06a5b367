// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>
#include <random>

#include <seamwright/core/join/network/network_projection.hpp>

#include "support/random.hpp"

namespace seamwright {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Few entries a row; half of the rows differ from an earlier one by no more than `apart`, others
/// are sums of two.
Eigen::MatrixXd system(Eigen::Index rows, Eigen::Index columns, double apart,
                       std::mt19937& random) {
  std::uniform_real_distribution<double> value(-1, 1);
  std::uniform_int_distribution<Eigen::Index> column(0, columns - 1);
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (int k = 0; k < 4; ++k) a(i, column(random)) = value(random);
    if (i % 4 == 1) a.row(i) = a.row(i - 1) + apart * a.row(i);
    if (i % 8 == 7) a.row(i) = a.row(i - 2) - a.row(i - 3);
  }
  return a;
}

TEST(NetworkProjection, NearestSolutionsWhereRowsDependOnEachOther) {
  std::mt19937 random(testSeed());
  std::uniform_real_distribution<double> value(-1, 1);
  for (int trial = 0; trial < 60; ++trial) {
    const double apart = std::pow(10.0, -trial % 5);
    SCOPED_TRACE(apart);
    const Eigen::MatrixXd a = system(40, 70, apart, random);
    const Eigen::MatrixXd target =
        Eigen::MatrixXd::NullaryExpr(70, 3, [&] { return value(random); });
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(70);
    network::OrderedFactors factors;
    const network::Projection found =
        network::project(Sparse(a.sparseView()), weights, target, factors);

    Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(1e-12);
    const Eigen::MatrixXd range = svd.matrixV().leftCols(svd.rank());
    const Eigen::MatrixXd nearest = target - range * (range.transpose() * target);
    EXPECT_LT((found.x - nearest).cwiseAbs().maxCoeff(), 1e-15 / apart / apart + 1e-12);
    EXPECT_LT((a * found.x).cwiseAbs().maxCoeff(), 1e-13);
  }
}

}  // namespace
}  // namespace seamwright
