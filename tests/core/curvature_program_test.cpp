// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/SparseLU>

#include <seamwright/core/planar/curvature_program.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

/// Curvatures of a wave along a band of points, which moves of the points change; all of them are
/// to be above 0.01.
CurvatureProgram waveAboveZero(Index count, double largest_move) {
  CurvatureProgram program;
  std::vector<Eigen::Triplet<double>> energy, curvatures, moves, shape;
  const auto add = [count](auto& entries, Index row, Index column, double value) {
    if (column >= 0 && column < count) entries.emplace_back(row, column, value);
  };
  for (Index i = 0; i < count; ++i) {
    add(curvatures, i, i - 1, 1.0 / 6);
    add(curvatures, i, i, 4.0 / 6);
    add(curvatures, i, i + 1, 1.0 / 6);
    add(moves, i, i - 1, largest_move);
    add(moves, i, i, -2 * largest_move);
    add(moves, i, i + 1, largest_move);
    add(shape, i, i, 1);
    add(energy, i, i, i == 0 || i + 1 == count ? 1 : 2);
    add(energy, i, i - 1, -1);
    add(energy, i, i + 1, -1);
  }
  for (auto [matrix, entries] :
       {std::pair{&program.energy, &energy}, std::pair{&program.curvatures, &curvatures},
        std::pair{&program.moves, &moves}, std::pair{&program.shape, &shape}}) {
    matrix->resize(count, count);
    matrix->setFromTriplets(entries->begin(), entries->end());
  }
  program.right = (VectorXd::LinSpaced(count, 0, 4 * pi).array().sin() + 0.5).matrix();
  program.margins = VectorXd::Constant(count, 0.01);
  return program;
}

/// From the curvatures of points that did not move, as fairClothoids() starts.
CurvatureSolution solved(const CurvatureProgram& program) {
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> equations(program.curvatures);
  return solve(program, equations.solve(program.right), VectorXd::Zero(program.right.size()));
}

TEST(CurvatureProgram, FindsCurvaturesWithinBounds) {
  // The wave is one of the points with the height 1 / (4 pi / 100)^2 = 63; about half of it goes.
  const Index count = 100;
  const CurvatureProgram program = waveAboveZero(count, 60);
  const CurvatureSolution found = solved(program);
  ASSERT_TRUE(found.converged);
  EXPECT_LE(found.moves.cwiseAbs().maxCoeff(), 1);
  EXPECT_GE((program.shape * found.curvatures - program.margins).minCoeff(), -1e-7);
  EXPECT_LE((program.curvatures * found.curvatures - program.moves * found.moves - program.right)
                .cwiseAbs()
                .maxCoeff(),
            1e-7);
}

/// For any number of points; a search without a proof takes up to 80 steps.
TEST(CurvatureProgram, SoonProvesThatThereIsNoSolution) {
  for (const Index count : {50, 500, 5000}) {
    const CurvatureProgram program = waveAboveZero(count, 0.1);
    const CurvatureSolution found = solved(program);
    EXPECT_FALSE(found.converged) << count;
    EXPECT_LE(found.steps, 5) << count;
  }
}

}  // namespace
}  // namespace seamwright
