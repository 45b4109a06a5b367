// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>

#include "follow_seams.hpp"

#include <seamwright/occ_adapter/match/least_moves.hpp>
#include <seamwright/occ_adapter/repair/surface_basis.hpp>

/// What a face is not asked to follow, and the least squares by which it follows.
namespace seamwright::test {
namespace {

using occ::FaceFollow;
using occ::FaceTask;
using occ::followPaths;
using occ::LeastMoves;
using occ::PointRows;
using occ::TargetPoint;
using testing::HasSubstr;

handle<Geom2d_Curve> lineAcross(double at) {
  return curvedPath({{0, at}, {1, at + 0.05}});
}

/// Two paths that a face shows already, the second one lifted.
FaceTask liftedTask(const Spline& face, double lift_mm) {
  const auto low = lineAcross(0.2), high = lineAcross(0.7);
  FaceTask task{face, {pathTo({face, low}, {face, low}, 1), pathTo({face, high}, {face, high}, 1)}, fine()};
  task.paths[1].target = [=](double s) {
    TargetPoint target = shownBy(face, high->Value(s));
    target.point += lift_mm * target.normal;
    return target;
  };
  return task;
}

TEST(FollowLimits, WhatIsBeyondTheMovesAllowedIsRefusedWithItsPathAlone) {
  std::mt19937 generator(91);
  for (int trial = 0; trial < 5; ++trial) {
    const Spline face = sheet(generator, 12, 12, 3, 3);
    FaceTask task = liftedTask(face, 0.25);
    task.max_move_mm = 0.2;
    const FaceFollow refused = followPaths(task);
    EXPECT_THAT(refused.failure, HasSubstr("path 2 asks for a move of 0.25 mm at ("));
    EXPECT_THAT(refused.failure, HasSubstr("more than 0.2 mm"));
    EXPECT_EQ(refused.missed, (std::vector<bool>{false, true}));
    EXPECT_EQ(refused.largest_move_mm, 0);
    EXPECT_EQ(refused.refinements, 0);
    EXPECT_EQ(occ::polesOf(*refused.surface), occ::polesOf(*face));
    task.max_move_mm = 1;
    const FaceFollow met = followPaths(task);
    EXPECT_EQ(met.failure, "");
    EXPECT_EQ(met.missed, (std::vector<bool>{false, false}));
    EXPECT_GE(met.largest_move_mm, 0.25 - fine().gap_mm);
  }
}

TEST(FollowLimits, StopsWhereItIsAskedTo) {
  std::mt19937 generator(92);
  const Spline face = sheet(generator, 12, 12, 3, 3);
  FaceTask task = liftedTask(face, 0.01);
  int solutions = 0;
  task.is_cancelled = [&solutions] { return ++solutions > 1'000'000; };
  EXPECT_EQ(followPaths(task).failure, "");
  const int all = solutions;
  ASSERT_GT(all, 0);
  for (int stop = 1; stop <= all; ++stop) {
    solutions = 0;
    task.is_cancelled = [&solutions, stop] { return ++solutions >= stop; };
    EXPECT_THROW(followPaths(task), occ::Cancelled);
    EXPECT_EQ(solutions, stop);
  }
}

/// Conditions row by row as a dense matrix.
struct DenseRows {
  explicit DenseRows(int points) : unknowns(3 * points) {}

  void add(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
           const Eigen::Vector3d& direction, double value) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(unknowns);
    for (std::size_t k = 0; k < points.size(); ++k)
      row.segment<3>(3 * points[k]) += factors[static_cast<Eigen::Index>(k)] * direction.transpose();
    rows.push_back(row);
    values.push_back(value);
  }

  /// \param fixed by unknown, NaN: free.
  Eigen::VectorXd solve(const Eigen::VectorXd& fixed, double damping) const {
    std::vector<int> free;
    for (int k = 0; k < unknowns; ++k)
      if (std::isnan(fixed[k])) free.push_back(k);
    const auto count = static_cast<Eigen::Index>(rows.size()),
               columns = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(count + columns, columns);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(count + columns);
    for (Eigen::Index r = 0; r < count; ++r) {
      a.row(r).head(columns) = rows[r](free);
      b[r] = values[r];
      for (int k = 0; k < unknowns; ++k)
        if (!std::isnan(fixed[k])) b[r] -= rows[r][k] * fixed[k];
    }
    a.bottomRows(columns).diagonal().setConstant(damping);
    const Eigen::VectorXd found = a.colPivHouseholderQr().solve(b);
    Eigen::VectorXd all = fixed;
    for (Eigen::Index k = 0; k < columns; ++k) all[free[k]] = found[k];
    return all;
  }

  int unknowns;
  std::vector<Eigen::RowVectorXd> rows;
  std::vector<double> values;
};

TEST(LeastMoves, AreThoseOfADenseFactorisation) {
  std::mt19937 generator(93);
  for (int trial = 0; trial < 60; ++trial) {
    const int points = 1 + trial % 12;
    LeastMoves system(points);
    DenseRows dense(points);
    Eigen::VectorXd fixed = Eigen::VectorXd::Constant(3 * points, std::nan(""));
    if (trial % 3 == 1) {
      const Eigen::Vector3d move = Eigen::Vector3d::NullaryExpr([&] { return random(generator, 1); });
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
      const Eigen::Vector3d direction = Eigen::Vector3d::NullaryExpr([&] { return random(generator, 1); });
      if (group % 4 == 0) {
        system.addPoint(list, factors.row(0), direction);
        for (int c = 0; c < 3; ++c) dense.add(list, factors.row(0), Eigen::Vector3d::Unit(c), direction[c]);
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

}  // namespace
}  // namespace seamwright::test
