// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <seamwright/core/differential/path_length.hpp>

namespace seamwright {
namespace {

/// The length of a parabola y = a t^2 / 2, x = t, from 0 to t, in closed form.
double parabolaLength(double a, double t) {
  const double slope = a * t;
  return 0.5 * (t * std::hypot(1, slope) + std::asinh(slope) / a);
}

TEST(PathLength, OfParabolasInClosedForm) {
  for (const double a : {0.1, 1.0, 10.0, 300.0}) {
    const PathLength length([&](double t) { return std::hypot(1, a * t); });
    for (double t = 0; t <= 1; t += 1.0 / 64) {
      EXPECT_NEAR(length.lengthTo(t), parabolaLength(a, t), 1e-11 * parabolaLength(a, 1)) << a;
      EXPECT_NEAR(length.parameterAt(parabolaLength(a, t)), t, 1e-10) << a;
    }
  }
}

TEST(PathLength, Identity1TheInverseGoesBack) {
  const PathLength length([](double t) { return 2 + std::sin(40 * t); }, {0.3});
  for (double t = 0; t <= 1; t += 1.0 / 256)
    EXPECT_NEAR(length.parameterAt(length.lengthTo(t)), t, 1e-13);
  EXPECT_EQ(length.parameterAt(-1), 0);
  EXPECT_EQ(length.parameterAt(2 * length.length_mm()), 1);
}

TEST(PathLength, Identity2JumpsAtBreaksSpoilNoDigit) {
  const double at = 0.3711, before = 1, after = 5;
  const auto speed = [&](double t) { return t < at ? before : after; };
  for (const std::vector<double>& breaks :
       {std::vector{at}, std::vector{0.9, at, -1.0, 0.0, 1.0, 7.0, at + 1e-15}}) {
    const PathLength length(speed, breaks);
    for (double t = 0; t <= 1; t += 1.0 / 128)
      EXPECT_NEAR(length.lengthTo(t), before * std::min(t, at) + after * std::max(0.0, t - at),
                  1e-14 * length.length_mm());
  }
  // Not told, a jump costs digits; no more than its share of the shortest piece.
  EXPECT_NEAR(PathLength(speed).length_mm(), before * at + after * (1 - at), 0.02);
}

TEST(PathLength, PathsThatStandStill) {
  const PathLength length([](double t) { return 3 * t * t; });
  for (double t = 0; t <= 1; t += 1.0 / 64) {
    EXPECT_NEAR(length.lengthTo(t), t * t * t, 1e-14);
    EXPECT_NEAR(length.parameterAt(t * t * t), t, 1e-5);
  }
  EXPECT_EQ(PathLength([](double) { return 0; }).length_mm(), 0);
}

TEST(PathLength, CountsSpeeds) {
  int count = 0;
  const PathLength circle([&](double) { return ++count, 2 * std::numbers::pi; });
  EXPECT_LT(count, 20);
  count = 0;
  const auto noisy = [&](double t) { return 1 + 1e-9 * std::sin(1e9 * t + 3.0 * ++count); };
  EXPECT_NEAR(PathLength(noisy).length_mm(), 1, 1e-9);
  EXPECT_LT(count, 1000);
}

TEST(PathLength, NotFinite) {
  const PathLength length(
      [](double t) { return t < 0.5 ? 1 : std::numeric_limits<double>::quiet_NaN(); });
  EXPECT_FALSE(std::isfinite(length.length_mm()));
}

}  // namespace
}  // namespace seamwright
