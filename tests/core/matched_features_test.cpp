// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <seamwright/core/blend/frame_features.hpp>

#include "frames.hpp"

namespace seamwright::match {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

double alone(const Feature& feature) {
  if (feature.kind == FeatureKind::Corner) return 2;
  return feature.kind == FeatureKind::Rise || feature.kind == FeatureKind::Fall ? 1 : 0.5;
}

/// What C12.2 says that a pair costs.
double together(const Feature& a, const Feature& b, double reach) {
  const double moved = std::abs(a.share - b.share);
  if (a.kind != FeatureKind::Corner) return moved / reach;
  const double distance = std::min(1.5, (a.from_middle - b.from_middle).norm());
  return 2 * (moved + distance + (a.side == -b.side && a.side != 0 ? 1 : 0));
}

/// What C12.2 says that pairs cost.
double costOf(const std::vector<Feature>& a, const std::vector<Feature>& b, const Pairs& pairs,
              double reach) {
  double cost = 0;
  for (const Feature& feature : a) cost += alone(feature);
  for (const Feature& feature : b) cost += alone(feature);
  for (const auto& [i, j] : pairs) cost += together(a[i], b[j], reach) - alone(a[i]) - alone(b[j]);
  return cost;
}

/// All pairs in order of features of one kind within the reach, from i and j on.
void visitAll(const std::vector<Feature>& a, const std::vector<Feature>& b, double reach,
              std::size_t i, std::size_t j, Pairs& pairs,
              const std::function<void(const Pairs&)>& visit) {
  visit(pairs);
  for (std::size_t k = i; k < a.size(); ++k)
    for (std::size_t l = j; l < b.size(); ++l) {
      if (a[k].kind != b[l].kind || std::abs(a[k].share - b[l].share) > reach) continue;
      pairs.emplace_back(static_cast<int>(k), static_cast<int>(l));
      visitAll(a, b, reach, k + 1, l + 1, pairs, visit);
      pairs.pop_back();
    }
}

std::vector<Feature> randomFeatures(int count, std::mt19937_64& random) {
  std::vector<Feature> result;
  for (int i = 0; i < count; ++i)
    result.push_back({static_cast<FeatureKind>(static_cast<int>(test::drawn(0, 5, random))),
                      {},
                      test::drawn(0, 1, random),
                      {test::drawn(-1, 1, random), test::drawn(-1, 1, random), 0},
                      static_cast<int>(test::drawn(0, 3, random)) - 1});
  std::ranges::sort(result, {}, &Feature::share);
  return result;
}

TEST(MatchedFeatures, CostTheLeastOfAllPairs) {
  std::mt19937_64 random(testSeed());
  constexpr double reach = 0.4;
  for (int i = 0; i < 300; ++i) {
    const std::vector<Feature> a = randomFeatures(i % 10, random),
                               b = randomFeatures((i / 10) % 8, random);
    double least = infinite;
    Pairs pairs;
    visitAll(a, b, reach, 0, 0, pairs,
             [&](const Pairs& one) { least = std::min(least, costOf(a, b, one, reach)); });
    EXPECT_NEAR(costOf(a, b, matchedFeatures(a, b, reach), reach), least, 1e-12) << i;
    EXPECT_NEAR(matchingCost(a, b, reach), least, 1e-12) << i;
  }
}

// A row of costs for each feature would take 800 MB.
TEST(MatchedFeatures, ThousandsThatCorrespond) {
  std::mt19937_64 random(testSeed());
  constexpr int count = 10'000;
  std::vector<Feature> a, b;
  for (int i = 0; i < count; ++i) {
    const double share = (i + test::drawn(0.1, 0.9, random)) / count;
    a.push_back({i % 2 == 0 ? FeatureKind::Maximum : FeatureKind::Minimum, {}, share});
    // Every hundredth is missing in the other one, with its neighbour.
    if (i % 100 < 98) b.push_back(a.back());
  }
  Pairs expected;
  for (int i = 0; i < count; ++i)
    if (i % 100 < 98) expected.emplace_back(i, static_cast<int>(expected.size()));
  EXPECT_EQ(matchedFeatures(a, b, 0.2), expected);
}

}  // namespace
}  // namespace seamwright::match
