// SPDX-License-Identifier: LGPL-2.1-or-later
// Umbrellas inside a boundary.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "support/random.hpp"
#include "umbrellas.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::uniform;
using test::whole;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// A closed boundary over a regular polygon; inner poles up to the given length off.
std::vector<BezierCurve> sidesOf(int n, int degree, double off, std::mt19937_64& random) {
  const auto corner = [&](int i) {
    return Eigen::RowVector3d(10 * std::cos(2 * pi * i / n), 10 * std::sin(2 * pi * i / n), 0);
  };
  std::vector<BezierCurve> sides;
  for (int i = 0; i < n; ++i) {
    Poles poles(degree + 1, 3);
    for (int k = 0; k <= degree; ++k) {
      poles.row(k) = corner(i) + (corner((i + 1) % n) - corner(i)) * k / degree;
      if (k > 0 && k < degree)
        for (double& x : poles.row(k)) x += uniform(-off, off, random);
    }
    poles.row(degree) = corner((i + 1) % n);
    sides.emplace_back(poles);
  }
  return sides;
}

TEST(UmbrellaInside, KeepsTheBoundaryAndJoinsAcrossEverySpoke) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 60; ++run) {
    const int n = whole(3, 9, random), degree = whole(1, 5, random);
    const std::vector<BezierCurve> sides = sidesOf(n, degree, 1.5, random);
    const Umbrella found = umbrellaInside(sides, {.spoke_degree = whole(3, 4, random)});
    EXPECT_LE(test::worstLaw(found), 1e-12) << run;
    for (int i = 0; i < n; ++i) {
      const BezierPatch& patch = std::get<BezierPatch>(found.members[i]);
      for (int k = 0; k <= 8; ++k) {
        const double t = k / 8.0;
        EXPECT_LE((patch.point(1, t) - sides[i].point((1 + t) / 2)).norm(), 1e-13) << run;
        EXPECT_LE((patch.point(t, 1) - sides[(i + 1) % n].point((1 - t) / 2)).norm(), 1e-13) << run;
      }
    }
    EXPECT_LE((found.vertex.sectors.array() / found.vertex.sectors(0) - 1).abs().maxCoeff(), 1e-10)
        << run;
  }
}

TEST(UmbrellaInside, MembersMeetWithCertainty) {
  std::mt19937_64 random(testSeed());
  for (int n = 3; n <= 8; ++n)
    EXPECT_LE(test::certifiedAngle(umbrellaInside(sidesOf(n, 3, 1, random))), 1e-9) << n;
}

TEST(UmbrellaInside, OfAPlaneBoundaryIsThePlaneAndOfARegularOneIsRegular) {
  std::mt19937_64 random(testSeed());
  for (int n = 3; n <= 12; ++n) {
    const Umbrella found = umbrellaInside(sidesOf(n, 2, 0, random));
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(2 * pi / n, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    EXPECT_LE(found.spokes[0].point(0).norm(), 1e-12) << n;
    for (int i = 0; i < n; ++i) {
      const Poles here = test::polesOf(found.members[i]),
                  next = test::polesOf(found.members[(i + 1) % n]);
      EXPECT_LE(here.col(2).cwiseAbs().maxCoeff(), 1e-12) << n;
      EXPECT_LE((here * turn.transpose() - next).cwiseAbs().maxCoeff(), 1e-11) << n;
      // No member folds: all turn to the same side.
      const BezierPatch& patch = std::get<BezierPatch>(found.members[i]);
      for (double u = 0; u <= 1; u += 0.125)
        for (double v = 0; v <= 1; v += 0.125) {
          const SurfaceJet jet = patch.jet(u, v);
          EXPECT_GT(jet.u.cross(jet.v).z(), 0) << n << " " << u << " " << v;
        }
    }
  }
}

TEST(UmbrellaInside, OrderSenseMotionAndScaleDoNotMatter) {
  std::mt19937_64 random(testSeed());
  for (int n = 3; n <= 8; ++n) {
    const std::vector<BezierCurve> sides = sidesOf(n, 3, 1.5, random);
    const Umbrella found = umbrellaInside(sides);
    std::vector<BezierCurve> turned = sides;
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    EXPECT_LE(test::largestDifference(umbrellaInside(turned), found, 1), 1e-10) << n;
    std::vector<BezierCurve> back;
    for (int i = n - 1; i >= 0; --i) back.push_back(sides[i].reversed());
    const Umbrella reversed = umbrellaInside(back);
    for (int i = 0; i < n; ++i)
      EXPECT_LE((test::polesOf(test::exchanged(reversed.members[i])) -
                 test::polesOf(found.members[(2 * n - 2 - i) % n]))
                    .cwiseAbs()
                    .maxCoeff(),
                1e-10)
          << n;
    const Eigen::Matrix3d linear = 0.2 * test::randomRotation(random);
    const Eigen::RowVector3d move(3, 1, 4);
    std::vector<BezierCurve> there;
    for (const BezierCurve& side : sides) there.push_back(test::mapped(side, linear, move));
    const Umbrella elsewhere = umbrellaInside(there);
    for (int i = 0; i < n; ++i)
      EXPECT_LE((test::polesOf(elsewhere.members[i]) -
                 test::polesOf(test::mapped(found.members[i], linear, move)))
                    .cwiseAbs()
                    .maxCoeff(),
                1e-10)
          << n;
  }
}

/// The members of an umbrella inside, given once more with their spokes, cannot be the same
/// umbrella with less energy; a higher degree can.
TEST(UmbrellaInside, AHigherDegreeIsNoLessFair) {
  std::mt19937_64 random(testSeed());
  const std::vector<BezierCurve> sides = sidesOf(5, 3, 1.5, random);
  const auto bending = [](const Umbrella& umbrella) {
    double sum = 0;  // of |X_uu|^2 + 2 |X_uv|^2 + |X_vv|^2 at points
    for (const UmbrellaMember& member : umbrella.members)
      for (double u = 0.05; u < 1; u += 0.1)
        for (double v = 0.05; v < 1; v += 0.1) {
          const SurfaceJet jet = std::get<BezierPatch>(member).jet(u, v);
          sum += jet.uu.squaredNorm() + 2 * jet.uv.squaredNorm() + jet.vv.squaredNorm();
        }
    return sum;
  };
  const double cubic = bending(umbrellaInside(sides));
  EXPECT_LT(bending(umbrellaInside(sides, {.spoke_degree = 5})), cubic);
}

TEST(UmbrellaInside, RefusesWhatIsNoBoundary) {
  std::mt19937_64 random(testSeed());
  const std::vector<BezierCurve> sides = sidesOf(5, 3, 0.5, random);
  const auto fails = [](const std::vector<BezierCurve>& curves,
                        const UmbrellaInsideOptions& options, const char* why) {
    EXPECT_THAT([&] { umbrellaInside(curves, options); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(why)));
  };
  fails({sides[0], sides[1]}, {}, "2 sides: 3 to 12 are needed");
  fails(sides, {.spoke_degree = 2}, "spoke_degree is 2");
  fails(sides, {.degree = 2}, "degree 2 of the members");
  std::vector<BezierCurve> other = sides;
  std::swap(other[1], other[2]);
  fails(other, {}, "side 0 ends ");
  other = sides;
  other[4] = BezierCurve(sides[4].poles(), Eigen::Vector4d(1, 2, 1, 1));
  fails(other, {}, "side 4 is rational");
}

}  // namespace
}  // namespace seamwright
