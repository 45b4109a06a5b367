// SPDX-License-Identifier: LGPL-2.1-or-later
// Bounds of rounding against exact arithmetic.
#include <gtest/gtest.h>

#include <random>
#include <seamwright/core/bernstein/bounded.hpp>

#include "exact.hpp"
#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

using test::Dyadic;

/// A number of any size that is known to some digits, exactly, or not even its sign; and one that
/// it may be.
struct Sample {
  Bounded bounded;
  Dyadic truth;
};

Sample sampleOf(int kind, std::mt19937_64& random) {
  const double value = test::randomVector(random).x() * test::logUniform(random, -9, 9);
  if (kind == 0) return {Bounded(value), Dyadic(value)};
  if (kind == 1) return {Bounded(0), Dyadic(0)};
  const double radius = std::abs(value) * test::logUniform(random, -16, kind == 2 ? -1 : 1);
  const double share = std::uniform_real_distribution<double>(-1, 1)(random);
  return {Bounded(value, radius), Dyadic(value) + Dyadic(radius) * Dyadic(kind == 3 ? 1 : share)};
}

bool holds(const Bounded& bounded, const Dyadic& truth) {
  return std::isinf(bounded.error) ||
         (truth - Dyadic(bounded.value)).abs() <= Dyadic(bounded.error);
}

TEST(Bounded, HoldsTheExactResult) {
  std::mt19937_64 random(testSeed());
  int known = 0;
  for (int run = 0; run < 20000; ++run) {
    const auto [a, x] = sampleOf(run % 4, random);
    const auto [b, y] = sampleOf(run / 4 % 4, random);
    ASSERT_TRUE(holds(a + b, x + y)) << run;
    ASSERT_TRUE(holds(a - b, x - y)) << run;
    ASSERT_TRUE(holds(a * b, x * y)) << run;
    ASSERT_TRUE(holds(ldexp(a, run % 100 - 50), x * Dyadic(std::ldexp(1.0, run % 100 - 50))))
        << run;
    ASSERT_TRUE(Dyadic(a.sizeLower()) <= x.abs() && x.abs() <= Dyadic(a.sizeUpper())) << run;
    const Bounded quotient = a / b;
    if (std::isfinite(quotient.error)) {  // |v y - x| <= e |y|
      ++known;
      ASSERT_TRUE((Dyadic(quotient.value) * y - x).abs() <= Dyadic(quotient.error) * y.abs())
          << run;
    }
    const Bounded root = sqrt(x.sign() < 0 ? -a : a);
    const Dyadic low = Dyadic(root.value) - Dyadic(root.error),
                 high = Dyadic(root.value) + Dyadic(root.error);
    ASSERT_TRUE(high.sign() >= 0 && x.abs() <= high * high) << run;
    ASSERT_TRUE(low.sign() <= 0 || low * low <= x.abs()) << run;
  }
  EXPECT_GT(known, 8000);
}

TEST(Bounded, KnowsWhatIsExact) {
  const Bounded a(0.1), zero(0), one(1);
  EXPECT_EQ((a + zero).error, 0);
  EXPECT_EQ((a - a).error, 0);
  EXPECT_EQ((a * one).error, 0);
  EXPECT_EQ((a * zero).error, 0);
  EXPECT_EQ((a / one).error, 0);
  EXPECT_EQ(ldexp(a, 7).error, 0);
  EXPECT_GT((a + one).error, 0);
  EXPECT_LT((a * a).error, 1e-17);
}

TEST(Bounded, KnowsWhatIsUnknown) {
  const Bounded huge(1e300), vague(1, 2), zero(0);
  EXPECT_TRUE(std::isinf((huge * huge).error));
  EXPECT_TRUE(std::isinf((huge / vague).error)) << "may be a division by 0";
  EXPECT_TRUE(std::isinf((huge / zero).error));
  EXPECT_EQ((huge * huge).value, 0);
  EXPECT_TRUE(std::isinf((huge * huge - huge).sizeUpper()));
  EXPECT_EQ((huge * huge).sizeLower(), 0);
  EXPECT_GT(ldexp(Bounded(0x1.8p-1022), -10).error + ldexp(Bounded(0x1.8p-1022), -60).error, 0)
      << "underflow";
}

}  // namespace
}  // namespace seamwright
