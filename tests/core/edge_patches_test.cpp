// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <seamwright/core/bspline/edge_patches.hpp>

#include "spline_surfaces.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::strip, test::Vec;

/// Knots 0.2, 0.5 (double), 0.9 along v, and 0.25, 0.75 along u.
BSplineSurface example(std::mt19937_64& random, bool rational) {
  BSplineSurface surface = strip({3, 3, {0.2, 0.5, 0.5, 0.9}, rational}, 1, 0.5, random);
  surface = withKnot(surface, SurfaceDirection::U, 0.25);
  return withKnot(surface, SurfaceDirection::U, 0.75);
}

/// The point at a share along an edge and a share of the span beside it.
Vec ofSurface(const BSplineSurface& s, PatchEdge edge, double share, double across) {
  switch (edge) {
    case PatchEdge::U0:
      return jet(s, 0.25 * across, share).p;
    case PatchEdge::U1:
      return jet(s, 0.75 + 0.25 * across, share).p;
    case PatchEdge::V0:
      return jet(s, share, 0.2 * across).p;
    case PatchEdge::V1:
      return jet(s, share, 0.9 + 0.1 * across).p;
  }
  return {};
}

Vec ofPatch(const BezierPatch& patch, PatchEdge edge, double t, double across) {
  return along(edge) == SurfaceDirection::U ? patch.jet(t, across).p : patch.jet(across, t).p;
}

constexpr std::array edges{PatchEdge::U0, PatchEdge::U1, PatchEdge::V0, PatchEdge::V1};

std::vector<double> withEnds(std::vector<double> breaks) {
  breaks.insert(breaks.begin(), 0);
  breaks.push_back(1);
  std::ranges::sort(breaks);
  return breaks;
}

TEST(EdgePatches, PointsAreThoseOfTheSurface) {  // (1)
  std::mt19937_64 random(testSeed());
  for (const bool rational : {false, true}) {
    const BSplineSurface surface = example(random, rational);
    for (const PatchEdge edge : edges) {
      const std::vector<double> own = edgeBreaks(surface, edge);
      EXPECT_EQ(own.size(), along(edge) == SurfaceDirection::V ? 3u : 2u);
      std::vector<double> all = own;
      all.push_back(0.4);
      const std::vector<double> ends = withEnds(all);
      const std::vector<BezierPatch> patches = edgePatches(surface, edge, {0.4, own[0]});
      ASSERT_EQ(patches.size(), ends.size() - 1);
      for (std::size_t i = 0; i < patches.size(); ++i)
        for (const double t : {0.0, 0.3, 1.0})
          for (const double across : {0.0, 0.6, 1.0})
            EXPECT_LT((ofPatch(patches[i], edge, t, across) -
                       ofSurface(surface, edge, ends[i] + t * (ends[i + 1] - ends[i]), across))
                          .norm(),
                      1e-13);
    }
  }
}

TEST(EdgePatches, OfPairsEqualSharesCorrespond) {  // (2)
  std::mt19937_64 random(testSeed());
  const BSplineSurface a = example(random, false),
                       b = strip({2, 4, {0.1, 0.5}, true}, 1, 0.5, random);
  for (const bool reversed : {false, true}) {
    // 0.1 is 0.9 of the other one if it runs the other way.
    const std::vector<double> ends = withEnds(reversed ? std::vector<double>{0.2, 0.5, 0.9}
                                                       : std::vector<double>{0.1, 0.2, 0.5, 0.9});
    const auto pairs = edgePairs(a, PatchEdge::U1, b, PatchEdge::U0, reversed);
    ASSERT_EQ(pairs.size(), ends.size() - 1);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (const double t : {0.0, 0.7, 1.0}) {
        const double share = ends[i] + t * (ends[i + 1] - ends[i]);
        EXPECT_LT((pairs[i].first.jet(1, t).p - jet(a, 1, share).p).norm(), 1e-13);
        EXPECT_LT((pairs[i].second.jet(0, reversed ? 1 - t : t).p -
                   jet(b, 0, reversed ? 1 - share : share).p)
                      .norm(),
                  1e-13);
      }
  }
}

TEST(EdgePatches, KnotsFarFromZeroAreTheSame) {
  std::mt19937_64 random(testSeed());
  const BSplineSurface a = strip({3, 3, {0.1, 0.3, 0.7}, false}, 1, 0.5, random);
  BSplineSurface far = a;
  for (double& knot : far.knots_v) knot += 1e6;
  EXPECT_EQ(edgePairs(a, PatchEdge::U1, far, PatchEdge::U0, false).size(), 4u);
}

TEST(EdgePatches, OfOneSpanItIsThePatch) {
  std::mt19937_64 random(testSeed());
  const BSplineSurface surface = strip({4, 2, {}, true}, 1, 0.5, random);
  EXPECT_THAT(edgeBreaks(surface, PatchEdge::V1), testing::IsEmpty());
  const std::vector<BezierPatch> patches = edgePatches(surface, PatchEdge::V1);
  ASSERT_EQ(patches.size(), 1u);
  EXPECT_EQ(patches[0].homogeneousPoles(), bezierPatch(surface).homogeneousPoles());
}

// In time that grows with their number, not with its square.
TEST(EdgePatches, ThousandsOfBreaks) {
  std::mt19937_64 random(testSeed());
  const BSplineSurface surface = strip({3, 3, {0.3, 0.6}, true}, 1, 0.5, random);
  constexpr int count = 20000;
  std::vector<double> breaks;
  for (int k = count - 1; k > 0; --k) breaks.push_back(static_cast<double>(k) / count);
  const std::vector<BezierPatch> patches = edgePatches(surface, PatchEdge::U0, breaks);
  ASSERT_EQ(patches.size(), static_cast<std::size_t>(count));
  for (const int k : {0, 5999, 6000, 11999, 12000, count - 1})
    EXPECT_LE((patches[static_cast<std::size_t>(k)].jet(0.5, 0.25).p -
               jet(surface, 0.5, (k + 0.25) / count).p)
                  .norm(),
              1e-12)
        << k;
}

TEST(EdgePatches, BreaksOutsideAreRefused) {
  std::mt19937_64 random(testSeed());
  const BSplineSurface surface = strip({3, 3, {}, false}, 1, 0.5, random);
  for (const double share : {0.0, 1.0, -0.5, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(edgePatches(surface, PatchEdge::U0, {share}), std::invalid_argument) << share;
  BSplineSurface broken = surface;
  broken.poles(0, 0) = HUGE_VAL;
  EXPECT_THROW(edgePatches(broken, PatchEdge::U0), std::invalid_argument);
  EXPECT_THROW(edgeBreaks(broken, PatchEdge::U0), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
