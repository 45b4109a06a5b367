// SPDX-License-Identifier: LGPL-2.1-or-later
// One step of many points by least squares, against an orthogonal factorisation of the same
// conditions.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "dense_rows.hpp"
#include "match_pairs.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/repair/step_system.hpp>

namespace seamwright::test {
namespace {

using occ::PointRows;
using occ::StepSystem;

/// The system and what is asked of it, row by row.
struct Both {
  Both(int points, const std::vector<std::vector<int>>& cells)
      : step(points, cells), dense(points) {}

  StepSystem step;
  DenseRows dense;
};

std::vector<std::vector<int>> randomCells(std::mt19937& generator, int points, int cells) {
  std::vector<std::vector<int>> made;
  for (int c = 0; c < cells; ++c) {
    std::vector<int> all(points);
    std::iota(all.begin(), all.end(), 0);
    std::ranges::shuffle(all, generator);
    all.resize(1 + generator() % std::min(points, 5));
    std::ranges::sort(all);
    made.push_back(all);
  }
  return made;
}

Eigen::Vector3d randomVector(std::mt19937& generator) {
  return Eigen::Vector3d::NullaryExpr([&] { return random(generator, 1); });
}

Eigen::VectorXd randomFactors(std::mt19937& generator, std::size_t count) {
  return Eigen::VectorXd::NullaryExpr(static_cast<Eigen::Index>(count),
                                      [&] { return random(generator, 1); });
}

/// rows^T rows as an energy, and each row as a condition in each coordinate.
void addEnergy(std::mt19937& generator, int cell, Both& both) {
  const std::vector<int>& points = both.step.cell(cell);
  const auto size = static_cast<Eigen::Index>(points.size());
  const Eigen::MatrixXd rows =
      Eigen::MatrixXd::NullaryExpr(2, size, [&] { return random(generator, 1); });
  const PointRows at = PointRows::NullaryExpr(size, 3, [&] { return random(generator, 1); });
  both.step.addEnergy(cell, rows.transpose() * rows, rows.transpose() * rows * at);
  for (int r = 0; r < 2; ++r)
    both.dense.addPoint(points, rows.row(r), -(rows.row(r) * at).transpose());
}

void addAny(std::mt19937& generator, int cell, Both& both) {
  const std::vector<int>& points = both.step.cell(cell);
  Eigen::VectorXd factors = randomFactors(generator, points.size());
  if (generator() % 3 == 0) factors[0] = 0;
  switch (generator() % 4) {
    case 0:
      return addEnergy(generator, cell, both);
    case 1: {
      const Eigen::Vector3d value = randomVector(generator);
      both.step.addPoint(cell, factors, value);
      return both.dense.addPoint(points, factors.transpose(), value);
    }
    default: {
      const Eigen::Vector3d direction = randomVector(generator);
      const double value = random(generator, 1);
      both.step.add(cell, factors, direction, value);
      return both.dense.add(points, factors.transpose(), direction, value);
    }
  }
}

void addDamping(std::mt19937& generator, int point, double factor, Both& both) {
  const Eigen::Vector3d at = randomVector(generator);
  both.step.addDamping(point, factor, at);
  both.dense.addPoint({point}, Eigen::RowVectorXd::Constant(1, std::sqrt(factor)),
                      -std::sqrt(factor) * at);
}

Eigen::VectorXd flat(const PointRows& rows) {
  Eigen::VectorXd all(rows.size());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) all.segment<3>(3 * i) = rows.row(i).transpose();
  return all;
}

TEST(StepSystem, StepsAreThoseOfADenseFactorisation) {
  std::mt19937 generator(testSeed());
  for (int trial = 0; trial < 80; ++trial) {
    const int points = 1 + trial % 15, cells = 3 * points;
    Both both(points, randomCells(generator, points, cells));
    for (int cell = 0; cell < cells; ++cell) addAny(generator, cell, both);
    for (int point = 0; point < points; ++point)
      addDamping(generator, point, trial % 2 == 0 ? 0.1 : 1e-3, both);
    const Eigen::VectorXd oracle = both.dense.solve();
    EXPECT_LT((flat(both.step.solve()) - oracle).norm(), 1e-8 * (1 + oracle.norm())) << trial;
  }
}

TEST(StepSystem, ConditionsMayBeOthersForEachSolution) {
  std::mt19937 generator(testSeed());
  constexpr int points = 8, cells = 20;
  const std::vector<std::vector<int>> own = randomCells(generator, points, cells);
  StepSystem step(points, own);
  for (int solution = 0; solution < 5; ++solution) {
    Both both(points, own);
    both.step = step;
    both.step.clear();
    for (int cell = 0; cell < cells; ++cell) addAny(generator, cell, both);
    for (int point = 0; point < points; ++point) addDamping(generator, point, 0.01, both);
    const Eigen::VectorXd oracle = both.dense.solve();
    EXPECT_LT((flat(both.step.solve()) - oracle).norm(), 1e-8 * (1 + oracle.norm())) << solution;
    // The same once more without a change.
    EXPECT_EQ(both.step.solve(), both.step.solve());
    step = both.step;
  }
}

/// Points that stand in no condition, and conditions that say the same: a step of least squares
/// there is, though not one alone.
TEST(StepSystem, WhereStepsAreNotUniqueTheSumOfSquaresIsLeast) {
  std::mt19937 generator(testSeed());
  for (int trial = 0; trial < 30; ++trial) {
    const int points = 4 + trial % 9;
    // The last point stands in no cell, and there are fewer conditions than coordinates.
    Both both(points, randomCells(generator, points - 1, points));
    for (int cell = 0; cell < points; ++cell) {
      const std::vector<int>& own = both.step.cell(cell);
      const Eigen::VectorXd factors = randomFactors(generator, own.size());
      const Eigen::Vector3d direction = randomVector(generator);
      const double value = random(generator, 1);
      for (int twice = 0; twice < 2; ++twice) {
        both.step.add(cell, factors, direction, value);
        both.dense.add(own, factors.transpose(), direction, value);
      }
    }
    const Eigen::VectorXd step = flat(both.step.solve());
    ASSERT_TRUE(step.allFinite()) << trial;
    const double scale = both.dense.gradient(Eigen::VectorXd::Zero(3 * points)).norm();
    EXPECT_LT(both.dense.gradient(step).norm(), 1e-6 * scale) << trial;
    EXPECT_LT(step.tail<3>().norm(), 1e-9) << trial;
  }
}

/// Conditions of very different weights, as they become where samples are missed again and again.
TEST(StepSystem, HeavyConditionsAreMet) {
  std::mt19937 generator(testSeed());
  for (const double weight : {1e2, 1e4, 1e6}) {
    constexpr int points = 6;
    Both both(points, {{0, 1, 2, 3, 4, 5}, {1, 2}, {0, 4, 5}});
    for (int point = 0; point < points; ++point) addDamping(generator, point, 1, both);
    std::vector<std::pair<Eigen::VectorXd, Eigen::Vector3d>> asked;
    for (const int cell : {1, 2}) {
      const Eigen::VectorXd factors = randomFactors(generator, both.step.cell(cell).size());
      const Eigen::Vector3d value = randomVector(generator);
      both.step.addPoint(cell, weight * factors, weight * value);
      asked.emplace_back(factors, value);
    }
    const PointRows step = both.step.solve();
    for (const int k : {0, 1}) {
      const std::vector<int>& cell = both.step.cell(k + 1);
      Eigen::Vector3d is = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < cell.size(); ++i)
        is += asked[k].first[static_cast<Eigen::Index>(i)] * step.row(cell[i]).transpose();
      EXPECT_LT((is - asked[k].second).norm(), 100 / (weight * weight)) << weight;
    }
  }
}

}  // namespace
}  // namespace seamwright::test
