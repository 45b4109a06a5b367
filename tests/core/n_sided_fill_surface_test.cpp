// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes in surfaces that are known.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/core/fill/fill_fairing.hpp>

#include "fills.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using Eigen::Vector3d;

/// Largest distance in height.
double error(const std::vector<BezierPatch>& patches, const test::Graph& graph) {
  double worst = 0;
  for (const BezierPatch& patch : patches)
    for (int i = 0; i <= 16; ++i)
      for (int j = 0; j <= 16; ++j) {
        const Vector3d point = patch.point(i / 16.0, j / 16.0);
        worst = std::max(worst, std::abs(point.z() - test::at(graph, point.head<2>()).value));
      }
  return worst;
}

/// Coons patches between halves of the sides and straight lines from the mean of their middles.
double coonsError(const std::vector<FillSide>& sides, const test::Graph& graph) {
  const std::size_t n = sides.size();
  Vector3d centre = Vector3d::Zero();
  for (const FillSide& side : sides) centre += side.edge.point(0.5) / static_cast<double>(n);
  double worst = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const BezierCurve &right = sides[(k + n - 1) % n].edge, &top = sides[k].edge;
    const Vector3d corner = top.point(0), a = right.point(0.5), b = top.point(0.5);
    for (int i = 0; i <= 16; ++i)
      for (int j = 0; j <= 16; ++j) {
        const double u = i / 16.0, v = j / 16.0;
        const Vector3d ruled = (1 - v) * (centre + u * (a - centre)) + v * top.point((1 - u) / 2) +
                               (1 - u) * (centre + v * (b - centre)) + u * right.point((1 + v) / 2);
        const Vector3d point = ruled - ((1 - u) * (1 - v) * centre + u * (1 - v) * a +
                                        (1 - u) * v * b + u * v * corner);
        worst = std::max(worst, std::abs(point.z() - test::at(graph, point.head<2>()).value));
      }
  }
  return worst;
}

PrincipalCurvatures curvatureAtCentre(const NSidedFill& fill) {
  const SurfaceJet jet = fill.patches[0].jet(0, 0);
  return principalCurvatures(jet, jet.u.cross(jet.v).normalized());
}

class FillOfGraph : public testing::TestWithParam<int> {
 protected:
  int n_ = GetParam();
  std::vector<FillSide> hole(const test::Graph& graph) const {
    return test::graphHole(graph, test::polygon(n_, 10));
  }
  std::vector<FillSide> skew(const test::Graph& graph) const {
    std::mt19937_64 random(testSeed(n_));
    std::vector<Eigen::Vector2d> corners = test::polygon(n_, 10);
    for (Eigen::Vector2d& corner : corners) corner *= 1 + test::uniform(-0.6, 0.6, random) / n_;
    return test::graphHole(graph, corners);
  }
};

// The map of the unit squares to a regular polygon is bilinear, so these surfaces have vanishing
// third differences.
TEST_P(FillOfGraph, QuadraticSurfacesOverRegularPolygonsAreReproduced) {
  for (const test::Graph& graph :
       {test::plane(), test::paraboloid(-0.1, -0.1), test::paraboloid(0.1, -0.1)}) {
    const NSidedFill fill = nSidedFill(hole(graph));
    EXPECT_LT(error(fill.patches, graph), 1e-12);
    EXPECT_LT(fill.fairness_mm2, 1e-22);
    EXPECT_TRUE(fill.regular);
  }
}

TEST_P(FillOfGraph, PlanarSidesHaveAPlanarFill) {
  for (SpokeLaw law : {SpokeLaw::Linear, SpokeLaw::Quadratic})
    for (int order : {2, 3}) {
      const NSidedFill fill =
          nSidedFill(skew(test::plane()), {.law = law, .fairness_order = order});
      EXPECT_LT(error(fill.patches, test::plane()), 1e-12);
      EXPECT_TRUE(fill.regular);
    }
}

TEST_P(FillOfGraph, SphereAndTorusAreMetFarBetterThanByCoonsPatches) {
  for (const test::Graph& graph : {test::sphere(20), test::torus(20, 15)})
    for (const std::vector<FillSide>& sides : {hole(graph), skew(graph)}) {
      const double found = error(nSidedFill(sides).patches, graph),
                   coons = coonsError(sides, graph);
      RecordProperty("error_um", static_cast<int>(1000 * found));
      RecordProperty("coons_um", static_cast<int>(1000 * coons));
      EXPECT_LT(found, coons / 5);
      EXPECT_LT(found, 0.35);
    }
}

// The fill's normal points up; a cap is bent down.
TEST_P(FillOfGraph, NoDentAtTheCentre) {
  for (SpokeLaw law : {SpokeLaw::Linear, SpokeLaw::Quadratic}) {
    const NSidedFill cap = nSidedFill(hole(test::sphere(20)), {.law = law});
    const BezierPatch& patch = cap.patches[0];
    EXPECT_GT(patch.jet(0, 0).u.cross(patch.jet(0, 0).v).z(), 0);
    const double highest = patch.point(0, 0).z();
    for (const FillSide& side : hole(test::sphere(20)))
      EXPECT_LT(side.edge.point(0.5).z(), highest);
    EXPECT_TRUE(cap.regular);
  }
}

TEST_P(FillOfGraph, CurvatureAtTheCentreIsThatOfTheSurface) {
  const auto of = [&](const test::Graph& graph) {
    return curvatureAtCentre(nSidedFill(hole(graph)));
  };
  const PrincipalCurvatures cap = of(test::sphere(20));
  EXPECT_NEAR(cap.k1, -0.05, 0.011);
  EXPECT_NEAR(cap.k2, -0.05, 0.011);
  const PrincipalCurvatures ring = of(test::torus(20, 15));
  EXPECT_LT(std::max(ring.k1, ring.k2), -0.015);
  const PrincipalCurvatures saddle = of(test::paraboloid(0.1, -0.1));
  EXPECT_NEAR(std::max(saddle.k1, saddle.k2), 0.1, 1e-10);
  EXPECT_NEAR(std::min(saddle.k1, saddle.k2), -0.1, 1e-10);
}

// The spokes begin along a star of vectors sum_j cos(2 pi (k - j) / n) M_j, with M_j the middles of
// the sides.
TEST_P(FillOfGraph, SpokesMayBePrescribed) {
  const std::vector<FillSide> sides = skew(test::sphere(20));
  const fill::CrossBoundaryDerivatives fields =
      fill::crossBoundaryDerivatives(sides, SpokeLaw::Linear, 6, 0);
  const fill::FillSpace space = fill::fillSpace(sides, fields, SpokeLaw::Linear, 6);
  const fill::Fairest fairest = fill::fairest(space, 3, std::nullopt);
  for (double scale : {0.5, 1.4}) {
    const fill::Fairest best = fill::fairest(space, 3, scale);
    EXPECT_GT(best.fairness_mm2, fairest.fairness_mm2);
    const std::vector<BezierPatch> patches = fill::patchesOf(space, best.unknowns);
    for (int k = 0; k < n_; ++k) {
      Vector3d star = Vector3d::Zero();
      for (int j = 0; j < n_; ++j)
        star += std::cos(2 * std::numbers::pi * (k - j) / n_) * sides[j].edge.point(0.5) * 2 *
                scale / n_;
      EXPECT_LT((patches[k].jet(0, 0).v - star).norm(), 1e-11);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sides, FillOfGraph, testing::Range(3, 13));

}  // namespace
}  // namespace seamwright
