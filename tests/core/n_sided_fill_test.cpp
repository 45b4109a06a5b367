// SPDX-License-Identifier: LGPL-2.1-or-later
// The laws of nSidedFill(), numbered as there.
#include <gmock/gmock.h>

#include <array>

#include <Eigen/Geometry>

#include "fills.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;
using test::Move, test::randomMove, test::reversed;

double difference(const BezierPatch& a, const BezierPatch& b) {
  return (a.poles() - b.poles()).cwiseAbs().maxCoeff();
}

double fairness(const std::vector<BezierPatch>& patches) {
  double sum = 0;
  for (const BezierPatch& patch : patches)
    for (int i = 0; i <= patch.degreeU(); ++i)
      for (int j = 0; j + 3 <= patch.degreeV(); ++j) {
        const auto third = [&](auto pole) {
          return (pole(3) - 3 * pole(2) + 3 * pole(1) - pole(0)).squaredNorm();
        };
        sum += third([&](int s) { return patch.pole(i, j + s); });
        sum += third([&](int s) { return patch.pole(j + s, i); });
      }
  return sum;
}

constexpr std::array all_laws = {SpokeLaw::Linear, SpokeLaw::Quadratic, SpokeLaw::G2};

std::string nameOf(SpokeLaw law) {
  return std::array{"linear", "quadratic", "g2"}.at(static_cast<std::size_t>(law));
}

/// Number of sides, law, ratio of sides.
class RandomFill : public testing::TestWithParam<std::tuple<int, SpokeLaw, double>> {
 protected:
  int n_ = std::get<0>(GetParam());
  SpokeLaw law_ = std::get<1>(GetParam());
  double ratio_ = std::get<2>(GetParam());
  // Not testSeed(): of other seeds some holes of ten or more sides have corners of over 180 degrees
  // or fills that are not regular.
  std::mt19937_64 random_{static_cast<std::uint64_t>(100 * n_ + static_cast<int>(law_))};
  std::vector<FillSide> sides_ = test::randomHole(n_, ratio_, random_);

  NSidedFill filled(const std::vector<FillSide>& sides, int order = 3) const {
    return nSidedFill(sides, {.law = law_, .fairness_order = order});
  }
};

TEST_P(RandomFill, Law1BoundariesAndSharedPoles) {
  const NSidedFill fill = filled(sides_);
  ASSERT_EQ(fill.patches.size(), static_cast<std::size_t>(n_));
  for (int k = 0; k < n_; ++k) {
    const BezierPatch &patch = fill.patches[k], &next = fill.patches[(k + 1) % n_];
    for (int s = 0; s <= patch.degreeU(); ++s) EXPECT_EQ(patch.pole(0, s), next.pole(s, 0));
    for (double t : {0.0, 0.1, 0.4, 0.5}) {
      EXPECT_LT((patch.point(1 - 2 * t, 1) - sides_[k].edge.point(t)).norm(), 1e-13);
      EXPECT_LT((next.point(1, 1 - 2 * t) - sides_[k].edge.point(1 - t)).norm(), 1e-13);
    }
  }
}

TEST_P(RandomFill, Law2JoinsAreCertified) {
  const NSidedFill fill = filled(sides_);
  EXPECT_TRUE(fill.regular);
  for (int k = 0; k < n_; ++k) {
    EXPECT_TRUE(fill.corners[k].exact);
    const SeamFigures spoke = test::spokeFigures(fill, k);
    EXPECT_TRUE(spoke.certified);
    EXPECT_LT(*spoke.gap_mm->upper, 1e-10);
    // In degree 6 enclosures widen along a side of a fiftieth: values are below 1e-13.
    EXPECT_LT(*spoke.angle_rad->upper, law_ == SpokeLaw::G2 && ratio_ > 1 ? 1e-7 : 1e-9);
    EXPECT_FALSE(spoke.fold_at);
    for (int half : {0, 1}) {
      const SeamFigures side = test::sideFigures(fill, sides_, k, half);
      EXPECT_TRUE(side.certified);
      EXPECT_LT(*side.angle_rad->upper, 1e-9) << k;
      EXPECT_FALSE(side.fold_at);
    }
  }
}

TEST_P(RandomFill, Law6CurvatureAcrossSpokes) {
  const NSidedFill fill = filled(sides_);
  for (int k = 0; k < n_; ++k) {
    const SeamFigures spoke = test::spokeFigures(fill, k);
    ASSERT_TRUE(spoke.certified);
    if (law_ == SpokeLaw::G2) {
      EXPECT_LT(*spoke.curvature_rel->upper, ratio_ > 1 ? 1e-4 : 1e-7) << k;
    } else {
      EXPECT_GT(spoke.curvature_rel->lower, 1e-3) << k;
    }
  }
}

TEST_P(RandomFill, ConnectionsAreThoseReported) {
  const NSidedFill fill = filled(sides_);
  for (int k = 0; k < n_; ++k)
    for (double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      const SurfaceJet a = fill.patches[k].jet(0, t), b = fill.patches[(k + 1) % n_].jet(t, 0);
      const Vector3d wanted =
          -test::value(fill.spoke.alpha, t) * a.u + test::value(fill.spoke.beta, t) * a.v;
      EXPECT_LT((b.v - wanted).norm(), 1e-11 * (b.v.norm() + wanted.norm()));
      for (int half : {0, 1}) {
        const ConnectionFunctions& join = (*fill.sides[k])[half];
        const SurfaceJet beyond = test::neighbourHalf(sides_[k], half).jet(0, t);
        const SurfaceJet ours =
            half == 0 ? fill.patches[k].jet(1 - t, 1) : fill.patches[(k + 1) % n_].jet(1, t);
        const Vector3d out = half == 0 ? ours.v : ours.u;
        const Vector3d into =
            -test::value(join.alpha, t) * beyond.u + test::value(join.beta, t) * beyond.v;
        EXPECT_LT((out + into).norm(), 1e-11 * (1 + out.norm()));
        EXPECT_GT(test::value(join.alpha, t), 0);
      }
    }
}

TEST_P(RandomFill, Law3MotionScaleAndNumbering) {
  const NSidedFill fill = filled(sides_);
  for (double scale : {1.0, 1e-3, 1e3}) {
    const Move move = randomMove(scale, random_);
    std::vector<FillSide> moved;
    for (int k = 0; k < n_; ++k) moved.push_back(move(sides_[(k + 1) % n_]));
    const NSidedFill other = filled(moved);
    EXPECT_EQ(other.spoke_scale, fill.spoke_scale);
    for (int k = 0; k < n_; ++k)
      EXPECT_LT((other.patches[k].poles() - move.points(fill.patches[(k + 1) % n_].poles()))
                    .cwiseAbs()
                    .maxCoeff(),
                1e-9 * scale);
    EXPECT_NEAR(other.fairness_mm2, fill.fairness_mm2 * scale * scale,
                1e-9 * fill.fairness_mm2 * scale * scale);
  }
}

TEST_P(RandomFill, Law3ReversalExchangesTheParameters) {
  std::vector<FillSide> back;
  for (int k = 0; k < n_; ++k) back.push_back(reversed(sides_[n_ - 1 - k]));
  const NSidedFill fill = filled(sides_), other = filled(back);
  for (int k = 0; k < n_; ++k)
    EXPECT_LT(difference(other.patches[k], fill.patches[(n_ - k) % n_].transposed()), 1e-9);
}

// The fills between this one and another of the same hole, and beyond, are fills of it too.
TEST_P(RandomFill, Law5NothingIsFairer) {
  const NSidedFill fill = filled(sides_, 3), other = filled(sides_, 2);
  if (fill.spoke_scale) {  // not chosen by fairness: fairer fills are not regular
    EXPECT_TRUE(fill.regular);
    return;
  }
  EXPECT_NEAR(fill.fairness_mm2, fairness(fill.patches), 1e-10 * fill.fairness_mm2);
  const auto between = [&](double share) {
    std::vector<BezierPatch> patches;
    for (int k = 0; k < n_; ++k)
      patches.emplace_back(
          fill.patches[k].degreeU(), fill.patches[k].degreeV(),
          fill.patches[k].poles() + share * (other.patches[k].poles() - fill.patches[k].poles()));
    return fairness(patches);
  };
  const double before = between(-0.5) - fill.fairness_mm2, after = between(0.5) - fill.fairness_mm2;
  EXPECT_GT(after, 0);
  EXPECT_NEAR(before, after, 1e-7 * fill.fairness_mm2);
}

INSTANTIATE_TEST_SUITE_P(Holes, RandomFill,
                         testing::Combine(testing::Range(3, 13), testing::ValuesIn(all_laws),
                                          testing::Values(1.0, 50.0)),
                         [](const auto& hole) {
                           return std::to_string(std::get<0>(hole.param)) +
                                  nameOf(std::get<1>(hole.param)) +
                                  (std::get<2>(hole.param) > 1 ? "short" : "");
                         });

TEST(NSidedFill, Law4ASymmetricHoleHasASymmetricFill) {
  for (int n : {3, 4, 5, 6, 9, 12}) {
    const std::vector<FillSide> sides = test::graphHole(test::sphere(20), test::polygon(n, 10));
    const NSidedFill fill = nSidedFill(sides);
    const double angle = 2 * std::numbers::pi / n;
    const Move turn{Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix()};
    for (int k = 0; k < n; ++k) {
      const BezierPatch &patch = fill.patches[k], &next = fill.patches[(k + 1) % n];
      EXPECT_LT((next.poles() - turn.points(patch.poles())).cwiseAbs().maxCoeff(), 1e-11) << n;
      // The mirror through the z axis and corner k exchanges u and v.
      const Vector3d normal =
          Eigen::AngleAxisd(angle * (k + 0.5), Vector3d::UnitZ()) * Vector3d::UnitY();
      const Move mirror{Matrix3d::Identity() - 2 * normal * normal.transpose()};
      EXPECT_LT((patch.transposed().poles() - mirror.points(patch.poles())).cwiseAbs().maxCoeff(),
                1e-11)
          << n;
    }
  }
}

TEST(NSidedFill, MovedPoleIsSeen) {
  std::mt19937_64 random(testSeed());
  const std::vector<FillSide> sides = test::randomHole(5, 1, random);
  const NSidedFill fill = nSidedFill(sides);
  const int degree = fill.patches[0].degreeU();
  const auto moved = [&](int i, int j) {
    NSidedFill bad = fill;
    Poles poles = bad.patches[0].poles();
    poles(i * (degree + 1) + j, 2) += 1e-6;
    bad.patches[0] = BezierPatch(degree, degree, poles);
    return bad;
  };
  EXPECT_GT(test::spokeFigures(moved(1, 2), 0).angle_rad->lower, 1e-8);
  EXPECT_GT(test::spokeFigures(moved(2, 1), 4).angle_rad->lower, 1e-8);
  EXPECT_GT(test::sideFigures(moved(degree - 1, 2), sides, 4, 1).angle_rad->lower, 1e-8);
  EXPECT_GT(test::sideFigures(moved(2, degree - 1), sides, 0, 0).angle_rad->lower, 1e-8);
}

// The third row of poles beside a spoke holds the curvature alone.
TEST(NSidedFill, PoleThatSpoilsTheCurvatureIsSeen) {
  std::mt19937_64 random(testSeed());
  NSidedFill fill = nSidedFill(test::randomHole(5, 1, random), {.law = SpokeLaw::G2});
  const int degree = fill.patches[0].degreeU();
  Poles poles = fill.patches[0].poles();
  poles(2 * (degree + 1) + 3, 2) += 1e-4;
  fill.patches[0] = BezierPatch(degree, degree, poles);
  EXPECT_LT(*test::spokeFigures(fill, 0).angle_rad->upper, 1e-9);
  EXPECT_GT(test::spokeFigures(fill, 0).curvature_rel->lower, 1e-5);
}

// Over a regular polygon the fill is the surface itself, so the law costs nothing there.
TEST(NSidedFill, G2ReproducesParaboloids) {
  for (int n = 3; n <= 12; ++n) {
    const NSidedFill fill = nSidedFill(
        test::graphHole(test::paraboloid(0.1, -0.07), test::polygon(n, 10)), {.law = SpokeLaw::G2});
    for (const BezierPatch& patch : fill.patches)
      for (double u : {0.0, 0.3, 0.9})
        for (double v : {0.0, 0.4, 1.0}) {
          const Vector3d p = patch.point(u, v);
          EXPECT_NEAR(p.z(), 0.05 * p.x() * p.x() - 0.035 * p.y() * p.y(), 1e-11) << n;
        }
  }
}

TEST(NSidedFill, SideOfAPatchIsItsCrossDerivative) {
  std::mt19937_64 random(testSeed());
  const BezierPatch patch = test::gentlePatch(3, 2, false, random);
  for (PatchEdge edge : test::patch_edges)
    for (bool against : {false, true}) {
      const FillSide side = fillSide(patch, edge, against);
      for (double t : {0.0, 0.3, 1.0}) {
        const double s = against ? 1 - t : t;
        const bool along_v = edge == PatchEdge::U0 || edge == PatchEdge::U1;
        const double fixed = edge == PatchEdge::U1 || edge == PatchEdge::V1 ? 1 : 0;
        const SurfaceJet jet = along_v ? patch.jet(fixed, s) : patch.jet(s, fixed);
        const Vector3d into = (along_v ? jet.u : jet.v) * (fixed == 0 ? 1 : -1);
        EXPECT_LT((side.edge.point(t) - jet.p).norm(), 1e-13);
        EXPECT_LT((BezierCurve(*side.cross).point(t) - into).norm(), 1e-12);
      }
    }
}

// Some sides, then all, ask for position alone.
TEST(NSidedFill, SidesOfPositionAlone) {
  for (int n = 3; n <= 12; ++n)
    for (SpokeLaw law : all_laws) {
      std::mt19937_64 random(testSeed(n));
      const std::vector<FillSide> sides = test::randomHole(n, 1, random);
      double last = nSidedFill(sides, {.law = law}).fairness_mm2;
      for (int free : {1, 2, n}) {
        std::vector<FillSide> some = sides;
        for (int k = 0; k < free; ++k) some[k].cross.reset();
        const NSidedFill fill = nSidedFill(some, {.law = law});
        // With G2 the other sum of squares may have been made least.
        if (!fill.spoke_scale && law != SpokeLaw::G2) {
          EXPECT_LE(fill.fairness_mm2, last * (1 + 1e-9)) << n;
          last = fill.fairness_mm2;
        }
        for (int k = 0; k < n; k += 2) {
          const SeamFigures spoke = test::spokeFigures(fill, k);
          EXPECT_LT(*spoke.angle_rad->upper, 1e-9) << n;
          if (law == SpokeLaw::G2) {
            EXPECT_LT(*spoke.curvature_rel->upper, 1e-6) << n;
          }
        }
        for (int k = 0; k < n; ++k) {
          EXPECT_EQ(fill.sides[k].has_value(), k >= free);
          EXPECT_TRUE(fill.corners[k].exact);
          EXPECT_LT((fill.patches[k].point(0.5, 1) - sides[k].edge.point(0.25)).norm(), 1e-13);
        }
        if (free < n) {
          EXPECT_LT(*test::sideFigures(fill, sides, n - 1, 1).angle_rad->upper, 1e-9) << n;
        }
      }
    }
}

TEST(NSidedFill, PositionAloneKeepsSymmetry) {
  std::vector<FillSide> sides = test::graphHole(test::sphere(20), test::polygon(4, 10));
  for (FillSide& side : sides) side.cross.reset();
  const NSidedFill fill = nSidedFill(sides);
  EXPECT_TRUE(fill.regular);
  for (int k = 0; k < 4; ++k)
    EXPECT_LT(
        difference(fill.patches[k],
                   BezierPatch(6, 6,
                               Move{Eigen::AngleAxisd(k * std::numbers::pi / 2, Vector3d::UnitZ())
                                        .toRotationMatrix()}
                                   .points(fill.patches[0].poles()))),
        1e-10);
}

}  // namespace
}  // namespace seamwright
