// SPDX-License-Identifier: LGPL-2.1-or-later
// Fills with small jumps of curvature: holes in surfaces that are known, whose curvature they
// should continue.
#include <gmock/gmock.h>

#include "ring_holes.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using Eigen::Vector2d;

/// The sides of a hole with the second derivatives of the graph along T, interpolated.
std::vector<FillSide> curvedHole(const test::Graph& graph, const std::vector<Vector2d>& corners) {
  constexpr int degree = 8;
  std::vector<FillSide> sides = test::graphHole(graph, corners);
  for (FillSide& side : sides) {
    Eigen::MatrixXd matrix(degree + 1, degree + 1);
    Poles values = Poles::Zero(degree + 1, 3);
    for (int i = 0; i <= degree; ++i) {
      const double t = static_cast<double>(i) / degree;
      const Vector2d out = BezierCurve(*side.cross).point(t).head<2>();
      values(i, 2) = out.dot(test::at(graph, side.edge.point(t).head<2>()).bend * out);
      for (int j = 0; j <= degree; ++j)
        matrix(i, j) =
            BezierCurve(Poles(Eigen::VectorXd::Unit(degree + 1, j) * Eigen::RowVector3d::UnitX()))
                .point(t)
                .x();
    }
    side.bend = Poles(matrix.fullPivLu().solve(values));
  }
  return sides;
}

double error(const std::vector<BezierPatch>& patches, const test::Graph& graph) {
  double worst = 0;
  for (const BezierPatch& patch : patches)
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 8; ++j) {
        const Eigen::Vector3d point = patch.point(i / 8.0, j / 8.0);
        worst = std::max(worst, std::abs(point.z() - test::at(graph, point.head<2>()).value));
      }
  return worst;
}

std::vector<SeamFigures> seamsOf(const NSidedFill& fill, const std::vector<FillSide>& sides) {
  std::vector<SeamFigures> seams;
  const int n = static_cast<int>(sides.size());
  for (int k = 0; k < n; ++k) {
    seams.push_back(test::spokeFigures(fill, k));
    const auto [first, second] = test::curvedNeighbour(sides[k]).transposed().splitU(0.5);
    seams.push_back(encloseSeam(seamSide(fill.patches[k], PatchEdge::V1, true),
                                seamSide(first.transposed(), PatchEdge::U0), test::fine()));
    seams.push_back(encloseSeam(seamSide(fill.patches[(k + 1) % n], PatchEdge::U1),
                                seamSide(second.transposed(), PatchEdge::U0), test::fine()));
  }
  return seams;
}

class FillCurvature : public testing::TestWithParam<int> {};

TEST_P(FillCurvature, JumpsBecomeSmallAndTheSurfaceIsMet) {
  const int n = GetParam();
  std::mt19937_64 random(testSeed(n));
  std::vector<Vector2d> corners = test::polygon(n, 10);
  for (Vector2d& corner : corners) corner *= 1 + test::uniform(-0.6, 0.6, random) / n;
  for (const test::Graph& graph : {test::sphere(20), test::torus(20, 15)}) {
    const std::vector<FillSide> sides = curvedHole(graph, corners);
    const NSidedFill plain = nSidedFill(sides),
                     curved = nSidedFill(sides, {.curvature_degrees = 0});
    const std::vector<SeamFigures> before = seamsOf(plain, sides), after = seamsOf(curved, sides);
    EXPECT_LT(test::largestAngle_rad(after), 1.01 * test::largestAngle_rad(before) + 1e-10);
    const double jump = test::largestCurvature_per_mm(after);
    RecordProperty("jump_per_km", static_cast<int>(1e6 * jump));
    EXPECT_LT(jump, 0.3 * test::largestCurvature_per_mm(before));
    EXPECT_LE(*curved.curvature_jump_per_mm, jump * (1 + 1e-6) + 1e-9);
    EXPECT_FALSE(plain.curvature_jump_per_mm.has_value());
    EXPECT_LT(error(curved.patches, graph), 2.5 * error(plain.patches, graph));
    EXPECT_TRUE(curved.regular);
  }
}

// Nothing but fairness decides here, which leaves many fills equal.
TEST_P(FillCurvature, PlanarSidesOfPositionAloneStayPlanar) {
  std::vector<FillSide> sides;
  const std::vector<Vector2d> corners = test::polygon(GetParam(), 10);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector2d &a = corners[k], &b = corners[(k + 1) % corners.size()];
    Poles edge(2, 3);
    edge << a.x() + 30, a.y() - 20, 10, b.x() + 30, b.y() - 20, 10;
    sides.push_back({BezierCurve(edge)});
  }
  for (const SpokeLaw law : {SpokeLaw::Linear, SpokeLaw::G2})
    for (const int degrees : {0, 2})
      for (const BezierPatch& patch :
           nSidedFill(sides, {.law = law, .curvature_degrees = degrees}).patches) {
        const Poles poles = patch.poles();
        EXPECT_LT((poles.col(2).array() - 10).abs().maxCoeff(), 1e-10);
        EXPECT_LT((poles.rowwise() - Eigen::RowVector3d(30, -20, 10)).rowwise().norm().maxCoeff(),
                  11);
      }
}

INSTANTIATE_TEST_SUITE_P(Sides, FillCurvature, testing::Values(3, 4, 5, 6));

// What is exact already stays so.
TEST(FillCurvature, AParaboloidIsReproduced) {
  const test::Graph graph = test::paraboloid(0.1, -0.1);
  const NSidedFill fill =
      nSidedFill(curvedHole(graph, test::polygon(5, 10)), {.curvature_degrees = 1});
  EXPECT_EQ(fill.patches[0].degreeU(), 7);
  EXPECT_LT(*fill.curvature_jump_per_mm, 1e-11);
  EXPECT_LT(error(fill.patches, graph), 1e-11);
}

// Random neighbours agree about nothing of second order: the jump is not worse than without asking.
TEST(FillCurvature, IsNeverWorse) {
  std::mt19937_64 random(testSeed());
  for (int n = 3; n <= 6; ++n) {
    std::vector<FillSide> sides = test::randomHole(n, 1, random);
    for (FillSide& side : sides) side.bend = Poles::Random(4, 3);
    const NSidedFill plain = nSidedFill(sides, {.curvature_degrees = 1});
    FillOptions none{.curvature_degrees = 1};
    std::vector<FillSide> without = sides;
    for (FillSide& side : without) side.bend.reset();
    const double jump = test::largestCurvature_per_mm(seamsOf(plain, sides));
    const double fair = [&] {
      const NSidedFill fill = nSidedFill(sides);
      return test::largestCurvature_per_mm(seamsOf(fill, sides));
    }();
    EXPECT_LT(jump, 1.05 * fair) << n;
    EXPECT_LT(*nSidedFill(without, none).curvature_jump_per_mm, *plain.curvature_jump_per_mm) << n;
  }
}

}  // namespace
}  // namespace seamwright
