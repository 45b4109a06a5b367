// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include <seamwright/core/linear/gauss_rule.hpp>

namespace seamwright {
namespace {

TEST(GaussRule, IntegratesPowersUpToItsDegree) {
  for (int count = 1; count <= 30; ++count) {
    const GaussRule rule = gaussRule(count);
    ASSERT_EQ(rule.nodes.size(), std::size_t(count));
    ASSERT_EQ(rule.weights.size(), std::size_t(count));
    for (int power = 0; power < 2 * count; ++power) {
      double sum = 0;
      for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        sum += rule.weights[i] * std::pow(rule.nodes[i], power);
      EXPECT_NEAR(sum, 1.0 / (power + 1), 1e-14) << count << " nodes, power " << power;
    }
  }
}

TEST(GaussRule, HasFallingNodesAndPositiveWeights) {
  for (int count = 1; count <= 30; ++count) {
    const GaussRule rule = gaussRule(count);
    double before = 1;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      EXPECT_LT(rule.nodes[i], before);
      EXPECT_GT(rule.weights[i], 0);
      EXPECT_NEAR(rule.nodes[i] + rule.nodes[rule.nodes.size() - 1 - i], 1, 1e-15);
      before = rule.nodes[i];
    }
    EXPECT_GT(before, 0);
  }
}

}  // namespace
}  // namespace seamwright
