// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <seamwright/core/linear/gauss_rule.hpp>

namespace seamwright {

/// The roots of the Legendre polynomial by Newton's method, which doubles the digits in each step.
GaussRule gaussRule(int count) {
  // The start has at least two digits, so four steps reach 16 of them. The other four change only
  // the last digit.
  constexpr int steps = 8;
  const int n = count;
  GaussRule rule;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 0;
    for (int step = 0; step < steps; ++step) {
      double before = 1, value = x;
      for (int k = 2; k <= n; ++k)
        before = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * before) / k);
      slope = n * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    rule.nodes.push_back((1 + x) / 2);
    rule.weights.push_back(1 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

}  // namespace seamwright
