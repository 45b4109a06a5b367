// SPDX-License-Identifier: LGPL-2.1-or-later
// Fills of holes whose neighbours disagree about the mixed derivative in the corners. Angles are of
// normals by cross products, at many points.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include <seamwright/core/fill/fill_corners.hpp>

#include "fills.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using Eigen::Vector3d;

/// A random hole of which every corner has a twist defect.
std::vector<FillSide> defectiveHole(int n, std::mt19937_64& random) {
  std::vector<FillSide> sides = test::randomHole(n, 1, random);
  for (FillSide& side : sides) {
    const Vector3d normal =
        side.cross->row(0).cross(side.edge.poles().row(1) - side.edge.poles().row(0)).normalized();
    side.cross->row(1) += test::uniform(0.3, 1, random) * normal.transpose();
  }
  return sides;
}

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

struct SideAngles {
  double near_corner = 0, elsewhere = 0;
};

/// Of the fill to the planes of E' and T along both halves at corner k, up to a share of a half
/// from the corner and beyond it.
SideAngles anglesAt(const BSplineSurface& surface, const std::vector<FillSide>& sides,
                    std::size_t k, double share) {
  SideAngles angles;
  const FillSide &before = sides[(k + sides.size() - 1) % sides.size()], &after = sides[k];
  constexpr int count = 4000;
  for (int i = 0; i <= count; ++i) {
    const double away =
        std::pow(static_cast<double>(i) / count, 3);  // of the corner, 0..1 of the half
    for (const bool first : {true, false}) {
      const double t = first ? 1 - away / 2 : away / 2;
      const FillSide& side = first ? before : after;
      const SurfaceJet jet =
          first ? seamwright::jet(surface, 1, 1 - away) : seamwright::jet(surface, 1 - away, 1);
      const Vector3d wanted = side.edge.jet(t).d1.cross(BezierCurve(*side.cross).point(t));
      double& worst = away <= share ? angles.near_corner : angles.elsewhere;
      worst = std::max(worst, angleBetween(jet.u.cross(jet.v), wanted));
    }
  }
  return angles;
}

class CornerKnots : public testing::TestWithParam<int> {
 protected:
  std::mt19937_64 random_{testSeed()};
};

// (1)
TEST_P(CornerKnots, EdgesAndSpokesStay) {
  const NSidedFill fill = nSidedFill(defectiveHole(GetParam(), random_));
  const std::vector<BSplineSurface> surfaces = withCornerKnots(fill, 1e-3);
  for (std::size_t k = 0; k < surfaces.size(); ++k)
    for (int i = 0; i <= 40; ++i) {
      const double t = i / 40.0;
      for (const auto& [u, v] : {std::pair(1.0, t), std::pair(t, 1.0)})
        EXPECT_LT((jet(surfaces[k], u, v).p - fill.patches[k].point(u, v)).norm(), 1e-12);
      for (const auto& [u, v] : {std::pair(0.0, t), std::pair(t, 0.0)}) {
        const SurfaceJet now = jet(surfaces[k], u, v), was = fill.patches[k].jet(u, v);
        EXPECT_LT((now.u - was.u).norm() + (now.v - was.v).norm(), 1e-10);
        EXPECT_LT((now.uu - was.uu).norm() + (now.uv - was.uv).norm() + (now.vv - was.vv).norm(),
                  1e-8);
      }
    }
}

// (2)
TEST_P(CornerKnots, PlanesAreMetButForTheLastPieceBesideTheCorner) {
  const std::vector<FillSide> sides = defectiveHole(GetParam(), random_);
  const NSidedFill fill = nSidedFill(sides);
  for (const double allowed_rad : {1e-2, 1e-3, 1e-4}) {
    const std::vector<BSplineSurface> surfaces = withCornerKnots(fill, allowed_rad);
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
      const SideAngles before = anglesAt(splineSurface(fill.patches[k]), sides, k, 1);
      const int levels = std::max(0, (surfaces[k].countU() - surfaces[k].degree_u - 1) / 2 - 2);
      const SideAngles after = anglesAt(surfaces[k], sides, k, std::ldexp(1.0, -levels));
      EXPECT_LE(after.near_corner, allowed_rad);
      if (levels == 0) continue;
      EXPECT_LT(after.elsewhere, 1e-9);
      EXPECT_GT(before.near_corner, 4 * after.near_corner * std::ldexp(1.0, levels - 4));
    }
  }
}

TEST_P(CornerKnots, SecondDerivativesStayBounded) {
  const NSidedFill fill = nSidedFill(defectiveHole(GetParam(), random_));
  const auto largest = [&](double allowed_rad) {
    double bend = 0;
    for (const BSplineSurface& surface : withCornerKnots(fill, allowed_rad))
      for (int i = 0; i <= 60; ++i)
        for (int j = 0; j <= 60; ++j) {
          const SurfaceJet at = jet(surface, 1 - std::pow(i / 60.0, 4), 1 - std::pow(j / 60.0, 4));
          bend = std::max({bend, at.uu.norm(), at.uv.norm(), at.vv.norm()});
        }
    return bend;
  };
  EXPECT_LT(largest(1e-5), 1.5 * largest(1e-2));
}

/// x (1 - x)^(N - 1) at the scale 2^-k, beside the corner.
double bump(int degree, int k, double away) {
  const double x = std::ldexp(away, k);
  return x < 1 ? std::ldexp(x * std::pow(1 - x, degree - 1), -k) : 0;
}

// (4)
TEST_P(CornerKnots, CurvatureAcrossTheSidesStaysBesideTheCorner) {
  const NSidedFill fill = nSidedFill(defectiveHole(GetParam(), random_));
  const std::vector<BSplineSurface> surfaces = withCornerKnots(fill, 1e-4);
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    const BezierPatch& patch = fill.patches[k];
    const int degree = patch.degreeU();
    const SurfaceJet corner = patch.jet(1, 1);
    const Vector3d normal = corner.u.cross(corner.v).normalized();
    for (int i = 0; i <= 200; ++i) {
      const double away = std::pow(i / 200.0, 4);
      const Vector3d change = (degree - 1) / 2.0 * fill.corners[k].twist_defect_mm *
                              (2 * bump(degree, 1, away) - bump(degree, 2, away)) * normal;
      EXPECT_LT((jet(surfaces[k], 1, 1 - away).uu - patch.jet(1, 1 - away).uu - change).norm(),
                1e-6)
          << away;
      EXPECT_LT((jet(surfaces[k], 1 - away, 1).vv - patch.jet(1 - away, 1).vv + change).norm(),
                1e-6)
          << away;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sides, CornerKnots, testing::Values(3, 4, 5, 6));

// (3)
TEST(CornerKnotsOfCompatibleCorners, ArePatches) {
  std::mt19937_64 random(testSeed());
  const NSidedFill fill = nSidedFill(test::randomHole(5, 1, random));
  const std::vector<BSplineSurface> surfaces = withCornerKnots(fill, 1e-4);
  for (std::size_t k = 0; k < surfaces.size(); ++k)
    EXPECT_EQ(surfaces[k], splineSurface(fill.patches[k]));
}

TEST(CornerKnotsOfCompatibleCorners, RefuseAnAngleThatIsNotPositive) {
  std::mt19937_64 random(testSeed());
  const NSidedFill fill = nSidedFill(test::randomHole(3, 1, random));
  for (const double angle_rad : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(withCornerKnots(fill, angle_rad), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
