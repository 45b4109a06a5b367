// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>
#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <seamwright/occ_adapter/deform/block_cholesky.hpp>

#include "support/random.hpp"

namespace seamwright::occ {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
/// Pairs (i, j) with i < j.
using Pairs = std::set<std::pair<int, int>>;

/// A matrix of blocks, as both factorisations want it.
struct Blocks {
  BlockPattern pattern;
  std::vector<bool> is_multiple;
  std::vector<SymmetricBlock> blocks;
  Sparse matrix;
};

SymmetricBlock randomBlock(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  return SymmetricBlock::NullaryExpr([&] { return number(random); });
}

void addBlock(int i, int j, const SymmetricBlock& b, std::vector<Eigen::Triplet<double>>& entries) {
  constexpr std::array<std::array<int, 3>, 3> at = {{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}}};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      entries.emplace_back(3 * i + row, 3 * j + column, b[at.at(row).at(column)]);
}

/// Diagonal blocks so large beside the others of their row that the matrix is positive definite.
/// \param coupled share of the blocks that are no multiples of the unit matrix.
Blocks blocksOf(int size, const Pairs& pairs, std::mt19937& random, double coupled = 1) {
  std::bernoulli_distribution is_coupled(coupled);
  Blocks result;
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<int> degree(size, 1);
  for (const auto& [i, j] : pairs) {
    ++degree[i];
    ++degree[j];
  }
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i <= j; ++i) {
      if (i < j && pairs.count({i, j}) == 0) continue;
      SymmetricBlock block = randomBlock(random);
      result.is_multiple.push_back(!is_coupled(random));
      if (result.is_multiple.back()) block << block[0], block[0], block[0], 0, 0, 0;
      if (i == j) block.head<3>().array() += 3.5 * degree[j];
      result.pattern.rows.push_back(i);
      result.blocks.push_back(block);
      addBlock(i, j, block, entries);
      if (i < j) addBlock(j, i, block, entries);
    }
    result.pattern.begins.push_back(static_cast<int>(result.pattern.rows.size()));
  }
  result.matrix.resize(3 * size, 3 * size);
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  return result;
}

PointRows randomPoints(int size, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  return PointRows::NullaryExpr(size, 3, [&] { return number(random); });
}

void expectSolved(const Blocks& blocks, double diagonal, std::mt19937& random) {
  BlockCholesky own(blocks.pattern, blocks.is_multiple);
  ASSERT_TRUE(own.factor(blocks.blocks, diagonal));
  Sparse matrix = blocks.matrix;
  for (int k = 0; k < matrix.rows(); ++k) matrix.coeffRef(k, k) += diagonal;
  const Eigen::SimplicialLDLT<Sparse> other(matrix);
  ASSERT_EQ(other.info(), Eigen::Success);
  const PointRows right = randomPoints(blocks.pattern.size(), random);
  const PointRows solution = own.solve(right);
  const Eigen::VectorXd expected = other.solve(right.reshaped<Eigen::RowMajor>());
  EXPECT_LE((solution.reshaped<Eigen::RowMajor>() - expected).norm(), 1e-12 * expected.norm());
}

Pairs banded(int size, int width) {
  Pairs pairs;
  for (int j = 0; j < size; ++j)
    for (int i = std::max(0, j - width); i < j; ++i) pairs.insert({i, j});
  return pairs;
}

/// All with the last one or, the worst order as it stands, with the first.
Pairs arrow(int size, bool last) {
  Pairs pairs;
  for (int k = 1; k < size; ++k) pairs.insert(last ? std::pair(k - 1, size - 1) : std::pair(0, k));
  return pairs;
}

Pairs blockDiagonal(int size, int part) {
  Pairs pairs;
  for (int j = 0; j < size; ++j)
    for (int i = j - j % part; i < j; ++i) pairs.insert({i, j});
  return pairs;
}

Pairs scattered(int size, double share, std::mt19937& random) {
  std::bernoulli_distribution any(share);
  Pairs pairs;
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < j; ++i)
      if (any(random)) pairs.insert({i, j});
  return pairs;
}

TEST(BlockCholesky, SolvesAsEigenDoes) {
  std::mt19937 random(testSeed());
  for (const int size : {1, 2, 3, 7, 20, 60}) {
    SCOPED_TRACE(size);
    for (const Pairs& pairs :
         {Pairs(), banded(size, 1), banded(size, 4), arrow(size, true), arrow(size, false),
          blockDiagonal(size, 5), scattered(size, 0.03, random), scattered(size, 0.2, random),
          banded(size, size)})
      expectSolved(blocksOf(size, pairs, random), 0, random);
  }
}

TEST(BlockCholesky, MultiplesOfTheUnitMatrixMayBeAnywhere) {
  std::mt19937 random(testSeed());
  for (const double coupled : {0.0, 0.03, 0.3, 1.0})
    for (const int size : {1, 3, 20, 60}) {
      SCOPED_TRACE(size);
      for (const Pairs& pairs : {Pairs(), banded(size, 4), arrow(size, false),
                                 blockDiagonal(size, 5), scattered(size, 0.1, random)})
        expectSolved(blocksOf(size, pairs, random, coupled), 0, random);
    }
}

TEST(BlockCholesky, NumbersOfPointsDoNotMatter) {
  std::mt19937 random(testSeed());
  constexpr int size = 40;
  const Pairs band = banded(size, 2);
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<int> number(size);
    std::iota(number.begin(), number.end(), 0);
    std::ranges::shuffle(number, random);
    Pairs pairs;
    for (const auto& [i, j] : band) pairs.insert(std::minmax(number[i], number[j]));
    expectSolved(blocksOf(size, pairs, random), 0, random);
  }
}

TEST(BlockCholesky, OnePatternServesManyMatrices) {
  std::mt19937 random(testSeed());
  const Pairs pairs = scattered(30, 0.1, random);
  const Blocks first = blocksOf(30, pairs, random), second = blocksOf(30, pairs, random);
  BlockCholesky factors(first.pattern);
  ASSERT_TRUE(factors.factor(first.blocks, 0));
  ASSERT_TRUE(factors.factor(second.blocks, 0));
  const PointRows right = randomPoints(30, random);
  const PointRows solution = factors.solve(right);
  const Eigen::VectorXd product = second.matrix * solution.reshaped<Eigen::RowMajor>();
  EXPECT_LE((product - right.reshaped<Eigen::RowMajor>()).norm(), 1e-13 * right.norm());
}

TEST(BlockCholesky, TheDiagonalIsAddedTo) {
  std::mt19937 random(testSeed());
  for (const double diagonal : {1e-9, 1.0, 1e9})
    expectSolved(blocksOf(25, scattered(25, 0.15, random), random), diagonal, random);
}

TEST(BlockCholesky, WhatIsNotPositiveDefiniteIsTold) {
  std::mt19937 random(testSeed());
  const Blocks good = blocksOf(20, banded(20, 3), random);
  for (int point = 0; point < 20; ++point) {
    Blocks bad = good;
    const int of_diagonal = bad.pattern.begins[point + 1] - 1;
    bad.blocks[of_diagonal][point % 3] = -1;
    BlockCholesky factors(bad.pattern);
    EXPECT_FALSE(factors.factor(bad.blocks, 0)) << point;
    EXPECT_TRUE(factors.factor(good.blocks, 0)) << point;
  }
  std::vector<SymmetricBlock> none(good.blocks.size(), SymmetricBlock::Zero());
  BlockCholesky factors(good.pattern);
  EXPECT_FALSE(factors.factor(none, 0));
  EXPECT_TRUE(factors.factor(none, 1));
}

}  // namespace
}  // namespace seamwright::occ
