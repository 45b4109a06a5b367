// SPDX-License-Identifier: LGPL-2.1-or-later
// Ribbons against jets, and orientation against nets turned by hand.
#include <gmock/gmock.h>

#include "joins.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::gentlePatch;
using test::gentleTriangle;
using test::value;

struct Cross {
  Eigen::Vector3d position, first, second, third;
};

/// Position and derivatives of the surface that a ribbon stands for, by the quotient rule.
Cross at(const Ribbon& ribbon, double t) {
  const Eigen::Vector4d h = value(ribbon.position, t), h1 = value(ribbon.first, t),
                        h2 = value(ribbon.second, t), h3 = value(ribbon.third, t);
  Cross x;
  x.position = h.head<3>() / h(3);
  x.first = (h1.head<3>() - h1(3) * x.position) / h(3);
  x.second = (h2.head<3>() - 2 * h1(3) * x.first - h2(3) * x.position) / h(3);
  x.third = (h3.head<3>() - 3 * h1(3) * x.second - 3 * h2(3) * x.first - h3(3) * x.position) / h(3);
  return x;
}

void expectNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  EXPECT_LE((a - b).norm(), 2e-12 * (b.norm() + 100));
}

TEST(Ribbon, Identity1And3TakesTheDerivativesOfAPatch) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 200; ++run) {
    const BezierPatch patch = gentlePatch(run % 5 + 1, run % 4 + 1, run % 2 == 1, random);
    for (const PatchEdge edge : test::patch_edges)
      for (const bool reversed : {false, true}) {
        const Ribbon into = ribbon(patch, edge, reversed, Across::Into);
        const double t = test::uniform(0, 1, random), along = reversed ? 1 - t : t;
        const bool along_u = edge == PatchEdge::V0 || edge == PatchEdge::V1;
        const bool at_end = edge == PatchEdge::U1 || edge == PatchEdge::V1;
        const SurfaceJet jet = along_u ? patch.jet(along, at_end) : patch.jet(at_end, along);
        const Cross x = at(into, t);
        expectNear(x.position, jet.p);
        expectNear(x.first, (at_end ? -1 : 1) * (along_u ? jet.v : jet.u));
        expectNear(x.second, along_u ? jet.vv : jet.uu);
        expectNear(x.third, (at_end ? -1 : 1) * (along_u ? jet.vvv : jet.uuu));
        EXPECT_EQ(into.degree_across, along_u ? patch.degreeV() : patch.degreeU());
      }
  }
}

TEST(Ribbon, Identity1And3TakesTheDerivativesOfATriangle) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 200; ++run) {
    const BezierTriangle triangle = gentleTriangle(run % 6 + 1, run % 2 == 1, random);
    for (const TriangleEdge edge : test::triangle_edges)
      for (const bool reversed : {false, true}) {
        const int opposite = static_cast<int>(edge);
        int begin = (opposite + 1) % 3, end = (opposite + 2) % 3;
        if (reversed) std::swap(begin, end);
        const double t = test::uniform(0, 1, random);
        Barycentric place = Barycentric::Zero(), step = Barycentric::Zero();
        place(begin) = 1 - t;
        place(end) = t;
        step(opposite) = 1;
        step(begin) = -1;
        const SurfaceJet jet = triangle.jet(place(0), place(1));
        const Cross x = at(ribbon(triangle, edge, reversed, Across::Into), t);
        expectNear(x.position, jet.p);
        expectNear(x.first, step(0) * jet.u + step(1) * jet.v);
        expectNear(x.second, step(0) * step(0) * jet.uu + 2 * step(0) * step(1) * jet.uv +
                                 step(1) * step(1) * jet.vv);
      }
  }
}

TEST(Ribbon, Identity2OutOfRunsTheOtherWay) {
  std::mt19937_64 random(testSeed());
  const BezierPatch patch = gentlePatch(3, 2, true, random);
  const BezierTriangle triangle = gentleTriangle(3, true, random);
  const auto expectOpposite = [](const Ribbon& into, const Ribbon& out) {
    EXPECT_EQ(into.position, out.position);
    EXPECT_EQ(into.first, -out.first);
    EXPECT_EQ(into.second, out.second);
    EXPECT_EQ(into.third, -out.third);
  };
  expectOpposite(ribbon(patch, PatchEdge::V1, true, Across::Into),
                 ribbon(patch, PatchEdge::V1, true, Across::OutOf));
  expectOpposite(ribbon(triangle, TriangleEdge::L1, true, Across::Into),
                 ribbon(triangle, TriangleEdge::L1, true, Across::OutOf));
}

TEST(Ribbon, DegreesAreThoseOfTheContract) {
  std::mt19937_64 random(testSeed());
  for (int n = 1; n <= 4; ++n) {
    const Ribbon r =
        ribbon(gentleTriangle(n, false, random), TriangleEdge::L2, false, Across::Into);
    EXPECT_EQ(r.position.rows(), n + 1);
    EXPECT_EQ(r.first.rows(), n);
    EXPECT_EQ(r.second.rows(), std::max(n - 2, 0) + 1);
    EXPECT_EQ(r.third.rows(), std::max(n - 3, 0) + 1);
  }
  EXPECT_TRUE(ribbon(gentlePatch(1, 3, false, random), PatchEdge::U0, false, Across::Into)
                  .second.isZero(0));
  EXPECT_TRUE(ribbon(gentleTriangle(1, false, random), TriangleEdge::L0, false, Across::Into)
                  .second.isZero(0));
  EXPECT_TRUE(
      ribbon(gentlePatch(2, 3, false, random), PatchEdge::V1, false, Across::Into).degree_across ==
      3);
  EXPECT_TRUE(
      ribbon(gentlePatch(2, 3, false, random), PatchEdge::U1, false, Across::Into).third.isZero(0));
  EXPECT_THROW(
      ribbon(BezierTriangle(Poles(Poles::Ones(1, 3))), TriangleEdge::L0, false, Across::Into),
      std::invalid_argument);
}

TEST(Ribbon, TurningIsUndone) {
  std::mt19937_64 random(testSeed());
  const BezierPatch patch = gentlePatch(3, 2, true, random);
  for (const PatchEdge edge : test::patch_edges)
    for (const bool reversed : {false, true})
      EXPECT_EQ(turnedFromU0(turnedToU0(patch, edge, reversed), edge, reversed), patch);
}

TEST(Orient, TheCaseOfTheDataFile) {
  const auto cases = test::dataCases("tensor_joins.json", "orient");
  ASSERT_EQ(cases.size(), 1u);
  const auto& entry = cases[0];
  const CanonicalPair pair = orient(test::patch(entry["input"]["A"]), *patchEdgeFromName("v1"),
                                    test::patch(entry["input"]["B"]), *patchEdgeFromName("u1"));
  EXPECT_EQ(pair.a, test::patch(entry["expected"]["P"]));
  EXPECT_EQ(pair.b, test::patch(entry["expected"]["Q"]));
  EXPECT_EQ(pair.reversed, entry["expected"]["B_reversed"].get<bool>());
}

TEST(Orient, AnyTwoEdgesInAnySense) {
  std::mt19937_64 random(testSeed());
  const BezierPatch a = gentlePatch(3, 2, false, random);
  const BezierPatch b = continuation(ribbon(a, PatchEdge::U1, false, Across::OutOf), {}, 1, 2);
  for (const PatchEdge edge_a : test::patch_edges)
    for (const PatchEdge edge_b : test::patch_edges)
      for (const bool reversed : {false, true}) {
        const BezierPatch other_a = turnedFromU0(a.reversedU(), edge_a, false);
        const BezierPatch other_b = turnedFromU0(b, edge_b, reversed);
        const CanonicalPair pair = orient(other_a, edge_a, other_b, edge_b);
        EXPECT_EQ(pair.reversed, reversed);
        EXPECT_EQ(pair.a, a);
        EXPECT_EQ(pair.b, b);
      }
}

TEST(Orient, AClosedSeamIsDecidedInBetween) {
  Poles poles(10, 3);  // a closed seam at u = 1 in a plane across x
  poles << -1, 0, 0, -1, 3, 1, -1, 2, 4, -1, -3, 2, -1, 0, 0, 0, 0, 0, 0, 3, 1, 0, 2, 4, 0, -3, 2,
      0, 0, 0;
  const BezierPatch a(1, 4, poles);
  const BezierPatch b = continuation(ribbon(a, PatchEdge::U1, false, Across::OutOf), {}, 1, 1);
  for (const bool reversed : {false, true}) {
    const CanonicalPair pair =
        orient(a, PatchEdge::U1, turnedFromU0(b, PatchEdge::V0, reversed), PatchEdge::V0);
    EXPECT_EQ(pair.reversed, reversed);
    EXPECT_EQ(pair.b, b);
  }
}

}  // namespace
}  // namespace seamwright
