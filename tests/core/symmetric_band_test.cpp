// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <seamwright/core/linear/symmetric_band.hpp>

#include "planar.hpp"

namespace seamwright::linear {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

struct Pair {
  SymmetricBand band;
  MatrixXd dense;
};

/// Positive definite, because its diagonal outweighs its rows.
Pair regular(Index size, Index width, std::mt19937_64& random) {
  Pair result{SymmetricBand(size, width), MatrixXd::Zero(size, size)};
  for (Index j = 0; j < size; ++j)
    for (Index i = j; i < std::min(size, j + width + 1); ++i) {
      const double value =
          i == j ? 2.0 * static_cast<double>(width) + 1 : test::uniform(random, -1, 1);
      result.band(i, j) = value;
      result.dense(i, j) = result.dense(j, i) = value;
    }
  return result;
}

TEST(SymmetricBand, ActsLikeTheDenseMatrix) {
  std::mt19937_64 random(testSeed());
  for (const Index size : {1, 2, 5, 40})
    for (const Index width : {0, 1, 3, 7}) {
      const auto [band, dense] = regular(size, width, random);
      const MatrixXd right = MatrixXd::Random(size, 3);
      const double rounding = 1e-13 * (static_cast<double>(width) + 1);
      EXPECT_LT((band.times(right) - dense * right).cwiseAbs().maxCoeff(), rounding);
      EXPECT_EQ(band.diagonal(), dense.diagonal());
      const BandCholesky factor(band);
      ASSERT_TRUE(factor.positive());
      EXPECT_LT((factor.solve(right) - dense.ldlt().solve(right)).cwiseAbs().maxCoeff(), 1e-13);
      const Eigen::VectorXd pivots = dense.llt().matrixL().toDenseMatrix().diagonal();
      EXPECT_NEAR(factor.leastPivot(), pivots.minCoeff() * pivots.minCoeff(), 1e-12);
      EXPECT_NEAR(factor.largestPivot(), pivots.maxCoeff() * pivots.maxCoeff(), 1e-12);
      const Index first = size / 3, count = size - first - size / 4;
      const MatrixXd part = dense.block(first, first, count, count) * right.topRows(count);
      EXPECT_LT((band.block(first, count).times(right.topRows(count)) - part).cwiseAbs().maxCoeff(),
                rounding);
      SymmetricBand twice = band;
      twice.add(1, band);
      EXPECT_EQ(twice.times(right), 2 * band.times(right));
    }
}

TEST(BandCholesky, TellsWhatIsNotPositive) {
  SymmetricBand matrix(3, 1);
  for (Index i = 0; i < 3; ++i) matrix(i, i) = 1;
  matrix(1, 0) = matrix(2, 1) = 0.9;
  EXPECT_FALSE(BandCholesky(matrix).positive());
}

}  // namespace
}  // namespace seamwright::linear
