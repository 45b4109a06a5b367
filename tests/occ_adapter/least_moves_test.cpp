// SPDX-License-Identifier: LGPL-2.1-or-later
// The least squares by which a face follows.
#include <gtest/gtest.h>

#include "dense_rows.hpp"
#include "match_pairs.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/match/least_moves.hpp>

namespace seamwright::test {
namespace {

using occ::LeastMoves;
using occ::PointRows;

TEST(LeastMoves, AreThoseOfADenseFactorisation) {
  std::mt19937 generator(testSeed());
  for (int trial = 0; trial < 60; ++trial) {
    const int points = 1 + trial % 12;
    LeastMoves system(points);
    DenseRows dense(points);
    Eigen::VectorXd fixed = Eigen::VectorXd::Constant(3 * points, std::nan(""));
    if (trial % 3 == 1) {
      const Eigen::Vector3d move =
          Eigen::Vector3d::NullaryExpr([&] { return random(generator, 1); });
      system.fix(points / 2, move);
      fixed.segment<3>(3 * (points / 2)) = move;
    }
    for (int group = 0; group < 2 * points; ++group) {
      // The same point may stand in a list more than once.
      std::vector<int> list(1 + generator() % 4);
      for (int& point : list) point = static_cast<int>(generator() % points);
      const auto size = static_cast<Eigen::Index>(list.size());
      const Eigen::MatrixXd factors =
          Eigen::MatrixXd::NullaryExpr(1 + group % 3, size, [&] { return random(generator, 1); });
      const Eigen::VectorXd values =
          Eigen::VectorXd::NullaryExpr(factors.rows(), [&] { return random(generator, 1); });
      const Eigen::Vector3d direction =
          Eigen::Vector3d::NullaryExpr([&] { return random(generator, 1); });
      if (group % 4 == 0) {
        system.addPoint(list, factors.row(0), direction);
        dense.addPoint(list, factors.row(0), direction);
        continue;
      }
      system.add(list, factors, direction, values);
      for (Eigen::Index row = 0; row < factors.rows(); ++row)
        dense.add(list, factors.row(row), direction, values[row]);
    }
    const double damping = trial % 2 == 0 ? 0.1 : 1e-3;
    const PointRows moves = system.solve(damping);
    const Eigen::VectorXd oracle = dense.solve(fixed, damping);
    const Eigen::Map<const Eigen::VectorXd> found(moves.data(), moves.size());
    EXPECT_LT((found - oracle).norm(), 1e-8 * (1 + oracle.norm())) << trial;
  }
}

TEST(LeastMoves, PartsHaveWeightsAndValuesMayChange) {
  std::mt19937 generator(testSeed());
  const auto number = [&] { return random(generator, 1); };
  constexpr int points = 9;
  constexpr double damping = 0.01;
  LeastMoves system(points, 3);
  bool is_built = false;
  for (int round = 0; round < 2; ++round)
    for (const std::vector<double>& weights :
         {std::vector<double>{1, 0.1, 0}, {1, 0.1, 0}, {1, 0.01, 3}, {1, 0.1, 0}}) {
      DenseRows dense(points);
      for (int k = 0; k < points; ++k) {
        const std::vector<int> list = {k, (k + 4) % points, (k + 1) % points};
        const Eigen::MatrixXd factors = Eigen::Matrix3d{{1, 2, -1}, {0.5, k * 1.0, 1}, {2, 1, 1}};
        const Eigen::Vector3d direction(1, k * 0.1, -1), value(number(), number(), number());
        const double along = number();
        if (!is_built) {
          system.addPoint(list, factors.row(0), Eigen::Vector3d::Zero());
          system.addZero(list, factors, 1);
          system.add(list, factors.row(2), direction, Eigen::VectorXd::Zero(1), 2);
        }
        system.setValue(3 * k, value);
        system.setValue(3 * k + 2, along);
        dense.addPoint(list, factors.row(0), value);
        for (Eigen::Index row = 0; row < 3; ++row)
          dense.addPoint(list, weights[1] * factors.row(row), Eigen::Vector3d::Zero());
        dense.add(list, weights[2] * factors.row(2), direction, weights[2] * along);
      }
      is_built = true;
      const PointRows moves = system.solve(damping, weights);
      const Eigen::VectorXd oracle =
          dense.solve(Eigen::VectorXd::Constant(3 * points, std::nan("")), damping);
      const Eigen::Map<const Eigen::VectorXd> found(moves.data(), moves.size());
      EXPECT_LT((found - oracle).norm(), 1e-8 * (1 + oracle.norm())) << round;
    }
}

}  // namespace
}  // namespace seamwright::test
